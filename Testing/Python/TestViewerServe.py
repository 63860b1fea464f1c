# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on --serve: the picture of --output, the mouse and keys, sessions, and Ctrl-C."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
import unittest

import relevo
from ViewerProgram import PROGRAM, ViewerProgram
from ViewerScenes import write_hill, write_sphere
from WindowClient import WindowClient
from WindowScene import read_picture

if not hasattr(relevo, "vtkWindowServer"):
    print("skipped: built without civetweb")
    sys.exit(125)

SIZE = "--size=160x120"
STUDIO = PROGRAM.with_name("relevo-studio")
WAIT = 60  # seconds until a test gives up


class TestViewerServe(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.mesh = write_sphere(cls.folder)

    def serve(self, *arguments, name=PROGRAM):
        """The program and its URL."""
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        program = subprocess.Popen(
            [name, *map(str, arguments)], cwd=self.folder, env=environment, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        )
        self.addCleanup(program.kill)
        for line in program.stdout:
            found = re.fullmatch(r"open (http://127\.0\.0\.1:\d+/\?token=[0-9a-f]{32})\n", line)
            if found:
                return program, found[1]
        output, errors = program.communicate()
        if "Cannot create threads" in errors:
            self.skipTest("civetweb's threads have too little memory, see remote.md")
        raise AssertionError(output, errors)

    def end(self, program, number=signal.SIGINT, warning=""):
        program.send_signal(number)
        output, errors = program.communicate(timeout=WAIT)
        self.assertEqual(program.returncode, 0)
        self.assertRegex(errors, rf"\A{warning}\Z")
        return output

    def await_still(self, client, differs_from=None):
        end = time.monotonic() + WAIT
        while not (client.is_still() and read_picture(client.pictures[-1]) != differs_from):
            self.assertLess(time.monotonic(), end)
            client.update(0.05)
        return read_picture(client.pictures[-1])

    def assert_alike(self, first, second):
        """The pictures have one size, and at most a tenth of their values differ: those of the scale
        bar and of edges."""
        self.assertEqual(first[0], second[0])
        different = sum(abs(a - b) > 8 for a, b in zip(first[1], second[1]))
        self.assertLess(different, 0.1 * len(second[1]))

    def test_mesh(self):
        arguments = [self.mesh, SIZE, "--level=3", "--view=30,20"]
        self.view(*arguments, "--output=own.png", "--save-session=first.json")
        expected = read_picture((self.folder / "own.png").read_bytes())
        program, url = self.serve(*arguments, "--serve", "--save-session=served.json")
        client = WindowClient(url)
        first = self.await_still(client)
        # The window also has a scale bar, and smoother edges.
        self.assert_alike(first, expected)
        client.send("press", 0, 80, 60, 0, 1)
        client.send("move", 100, 50, 0)
        client.send("release", 0, 100, 50, 0)
        turned = self.await_still(client, first)
        # A key of the viewer draws a plane that cuts the mesh.
        client.send("keydown", 0, "m")
        client.send("keyup", 0, "m")
        self.await_still(client, turned)
        client.close()
        self.assertIn("--clip", self.end(program, warning=r"[^\n]*so the cut is hollow\n"))
        # What the browser has changed is in the session.
        session = json.loads((self.folder / "served.json").read_text())
        self.assertIn("clip", session["options"])
        first = json.loads((self.folder / "first.json").read_text())
        self.assertNotEqual(session["camera"]["position"], first["camera"]["position"])
        self.assertEqual(session["camera"]["view-angle"], first["camera"]["view-angle"])
        run = self.run_program("--session=served.json", "--output=again.png")
        self.assertEqual(run.returncode, 0, run.stderr)
        again = read_picture((self.folder / "again.png").read_bytes())
        self.assertNotEqual(again, expected)

    def test_terrain(self):
        program, url = self.serve(self.heights, SIZE, "--serve=0")
        client = WindowClient(url)
        first = self.await_still(client)
        client.send("wheel", 3, 80, 60, 0)
        self.await_still(client, first)
        client.close()
        self.end(program, signal.SIGTERM)

    @unittest.skipUnless(STUDIO.exists(), "relevo-studio was not built")
    def test_studio(self):
        program, url = self.serve(self.mesh, "--size=640x400", "--serve", name=STUDIO)
        client = WindowClient(url)
        first = self.await_still(client)
        client.send("press", 0, 150, 300, 0, 1)
        client.send("move", 200, 250, 0)
        client.send("release", 0, 200, 250, 0)
        turned = self.await_still(client, first)
        client.send("resize", 500, 300, 100)
        self.assertEqual(self.await_still(client, turned)[0], (500, 300))
        client.close()
        self.end(program)

    def test_bad_arguments(self):
        for option in ("--output=x.png", "--export=x.vtp", "--capture=folder"):
            self.assert_error(2, ["--serve cannot be combined", option.split("=")[0]], self.mesh,
                              "--serve", option)
        self.assert_error(2, ["--serve needs a whole number from 0 to 65535", "70000"], self.mesh,
                          "--serve=70000")
        with socket.socket() as used:
            used.bind(("127.0.0.1", 0))
            used.listen()
            port = used.getsockname()[1]
            run = self.view(self.mesh, SIZE, "--serve", port, code=1)
            self.assertRegex(
                run.stderr,
                rf"\Arelevo-view: error: [^\n]*port {port} of 127.0.0.1[^\n]*another program uses"
                r" it[^\n]*\n\Z",
            )


if __name__ == "__main__":
    unittest.main(argv=["TestViewerServe"])
