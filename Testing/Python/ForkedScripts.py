# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs Python scripts in processes forked from one that has imported relevo."""

import importlib
import json
import os
import pathlib
import runpy
import socket
import subprocess
import sys
import tempfile
import traceback

import relevo

# Imported once for all scripts.
for extension in set(relevo._classes.EXTENSIONS.values()):
    importlib.import_module("relevo." + extension)


class ForkedScripts:
    """Create it before anything is drawn: threads of a graphics driver do not survive a fork."""

    def __init__(self):
        self.socket, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        sys.stdout.flush()
        self.server = os.fork()
        if self.server == 0:
            self.socket.close()
            self.serve(theirs)
        theirs.close()

    def close(self):
        self.socket.close()
        os.waitpid(self.server, 0)

    def serve(self, requests):
        """Never returns."""
        while True:
            message, outputs, _, _ = socket.recv_fds(requests, 1 << 17, 2)
            if not message:
                os._exit(0)
            process = os.fork()
            if process == 0:
                requests.close()
                code = self.run_here(json.loads(message), outputs)
                sys.stdout.flush()
                sys.stderr.flush()
                # Not exit(): libraries may wait for threads that do not exist after the fork.
                os._exit(code or 0)
            for output in outputs:
                os.close(output)
            status = os.waitpid(process, 0)[1]
            requests.send(str(os.waitstatus_to_exitcode(status)).encode())

    @staticmethod
    def run_here(request, outputs):
        """Runs a script like the interpreter. Returns the exit code."""
        for number, output in enumerate(outputs):
            os.dup2(output, 1 + number)
        os.chdir(request["folder"])
        os.environ.pop("DISPLAY", None)
        sys.argv = request["arguments"]
        try:
            if request["program"]:
                exec(compile(request["program"], "<program>", "exec"), {"__name__": "__main__"})
            else:
                sys.path.insert(0, str(pathlib.Path(sys.argv[0]).parent))
                runpy.run_path(sys.argv[0], run_name="__main__")
        except SystemExit as end:
            if isinstance(end.code, str):
                print(end.code, file=sys.stderr)
                return 1
            return end.code
        except BaseException:
            traceback.print_exc()
            return 1
        return 0

    def run(self, arguments, folder, program=""):
        """Runs a script with arguments, or the text of a program. Returns the same as
        subprocess.run()."""
        request = {
            "folder": str(folder),
            "arguments": [str(argument) for argument in arguments],
            "program": program,
        }
        with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
            socket.send_fds(
                self.socket, [json.dumps(request).encode()], [output.fileno(), errors.fileno()]
            )
            code = int(self.socket.recv(16))
            texts = []
            for file in (output, errors):
                file.seek(0)
                texts.append(file.read().decode())
        return subprocess.CompletedProcess(arguments, code, *texts)
