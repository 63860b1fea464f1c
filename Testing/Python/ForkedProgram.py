# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program by forking one process that has loaded its libraries: see ForkServer.cxx."""

import os
import pathlib
import resource
import socket
import struct
import subprocess
import tempfile

LIBRARY = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "Testing/Python/RelevoForkServer.so"


class ForkedProgram:
    """Runs of a program, one after the other."""

    def __init__(self, program):
        self.program = str(program)
        self.socket = None
        if not LIBRARY.exists():
            return
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        environment = {
            **os.environ,
            "LD_PRELOAD": str(LIBRARY),
            "RELEVO_FORK_SERVER": str(theirs.fileno()),
        }
        with theirs:
            self.server = subprocess.Popen(
                [self.program],
                env=environment,
                pass_fds=[theirs.fileno()],
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
        if ours.recv(1):
            self.socket = ours
        else:  # a sanitizer must be the first library
            ours.close()
            self.server.wait()

    def close(self):
        if self.socket:
            self.socket.close()
            self.socket = None
            self.server.wait()

    def start(self, arguments, folder, environment, outputs):
        """Starts a process and returns its id. finish() returns the exit code."""
        strings = [
            os.fspath(folder),
            str(1 + len(arguments)),
            self.program,
            *arguments,
            *(f"{name}={value}" for name, value in environment.items()),
        ]
        message = b"".join(os.fsencode(string) + b"\0" for string in strings)
        socket.send_fds(self.socket, [message], [output.fileno() for output in outputs])
        return struct.unpack("i", self.socket.recv(4))[0]

    def finish(self):
        return os.waitstatus_to_exitcode(struct.unpack("i", self.socket.recv(4))[0])

    def run(self, arguments, folder, environment, largest_file=resource.RLIM_INFINITY):
        """Like subprocess.run() with capture_output and text. `largest_file` limits files in
        bytes."""
        command = [self.program, *arguments]
        limits = (largest_file, resource.getrlimit(resource.RLIMIT_FSIZE)[1])
        if not self.socket:
            return subprocess.run(
                command,
                cwd=folder,
                env=environment,
                capture_output=True,
                encoding="utf-8",
                check=False,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limits),
            )
        resource.prlimit(self.server.pid, resource.RLIMIT_FSIZE, limits)
        with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
            self.start(arguments, folder, environment, (output, errors))
            code = self.finish()
            texts = []
            for file in (output, errors):
                file.seek(0)
                text = file.read().decode()
                texts.append(text.replace("\r\n", "\n").replace("\r", "\n"))
        return subprocess.CompletedProcess(command, code, *texts)
