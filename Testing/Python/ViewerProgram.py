# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs relevo-view for tests."""

import atexit
import os
import pathlib
import re
import sys
import tempfile
import unittest

from ForkedProgram import ForkedProgram

PROGRAM = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin" / "relevo-view"
if not PROGRAM.exists():
    print("skipped: relevo-view was not built")
    sys.exit(125)
FORKED = ForkedProgram(PROGRAM)
atexit.register(FORKED.close)


class ViewerProgram(unittest.TestCase):
    """A folder for files, runs of the program in it, and its errors."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)

    @classmethod
    def write_data(cls, name, kind, data, *calls):
        """Writes a file in the folder, after these calls of the writer. Returns its bytes."""
        writer = kind()
        for call in calls:
            getattr(writer, call)()
        writer.SetInputData(data)
        writer.SetFileName(str(cls.folder / name))
        writer.Write()
        return (cls.folder / name).read_bytes()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_program(self, *arguments, display=False, **limits):
        environment = dict(os.environ)
        if not display:
            environment.pop("DISPLAY", None)
        return FORKED.run([*map(str, arguments)], self.folder, environment, **limits)

    def view(self, *arguments, code=0, **settings):
        run = self.run_program(*arguments, **settings)
        self.assertEqual(run.returncode, code, run.stderr)
        if code == 0:
            self.assertEqual(run.stderr, "")
        return run

    def assert_error(self, code, words, *arguments):
        run = self.view(*arguments, code=code)
        self.assertRegex(run.stderr, r"\Arelevo-view: error: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertEqual(run.stdout, "")

    def statistic(self, name, *arguments):
        """An integer in the output of --stats for a small picture."""
        run = self.view(*arguments, "--stats", "--output", "s.png", "--size=160x100")
        return int(re.search(rf"{name}: (\d+)", run.stdout)[1])
