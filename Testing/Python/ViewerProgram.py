# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs relevo-view, for the tests of it."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin" / "relevo-view"
if not PROGRAM.exists():
    print("skipped: relevo-view was not built")
    sys.exit(125)


class ViewerProgram(unittest.TestCase):
    """A folder for files, the program in it, and its errors."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def view(self, *arguments, code=0, display=False):
        environment = dict(os.environ)
        if not display:
            environment.pop("DISPLAY", None)
        run = subprocess.run(
            [str(PROGRAM), *map(str, arguments)],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
        )
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
        """A whole number that --stats prints, of a small picture."""
        run = self.view(*arguments, "--stats", "--output", "s.png", "--size=160x100")
        return int(re.search(rf"{name}: (\d+)", run.stdout)[1])
