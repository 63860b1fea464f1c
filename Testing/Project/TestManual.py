#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Manual pages and completions have all options of --help: TestManual.py FOLDER PROGRAM..."""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

FOLDER = pathlib.Path(sys.argv[1])
PROGRAMS = [pathlib.Path(own) for own in sys.argv[2:]]


def read_options(program):
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"^  (--[a-z-]+)(?: |$)", text, re.MULTILINE))


def complete(name, *words):
    """Return the completions of bash for the last of the words."""
    script = (
        'source "$1"; COMP_WORDS=("${@:2}"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1));'
        ' "_${COMP_WORDS[0]//-/_}"; printf "%s\\n" "${COMPREPLY[@]}"'
    )
    command = ["bash", "-c", script, "bash", str(FOLDER / name), name, *words]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()


class TestManual(unittest.TestCase):
    def test_options(self):
        for program in PROGRAMS:
            options = read_options(program)
            self.assertGreater(len(options), 3)
            page = (FOLDER / f"{program.name}.1").read_text().replace("\\-", "-")
            self.assertEqual(set(re.findall(r"^\\fB(--[a-z-]+)\\fR", page, re.MULTILINE)), options)
            self.assertEqual(set(complete(program.name, "--")), options)
            zsh = (FOLDER / f"_{program.name}").read_text()
            self.assertEqual(set(re.findall(r"^  '(--[a-z-]+)[=\[]", zsh, re.MULTILINE)), options)

    def test_no_text_is_lost(self):
        """The words of the page are those of --help."""
        for program in PROGRAMS:
            run = subprocess.run([program, "--help"], capture_output=True, text=True, check=True)
            text = run.stdout.partition("\n\n")[2]
            text = re.sub(r"^(\S.*):(?=\n  )", r"\1", text, flags=re.MULTILINE)  # titles
            text = re.sub(r"^Exit codes?:", "Exit status", text, flags=re.MULTILINE)
            page = (FOLDER / f"{program.name}.1").read_text().partition(".SH DESCRIPTION")[2]
            page = re.sub(r"\\f[BIR]|\\&|^\.[A-Z]+|\\(?=-)", "", page, flags=re.MULTILINE)
            words = [re.sub(r'[`"]', "", own).lower().split() for own in (text, page)]
            self.assertEqual(*words)

    def test_values(self):
        """The names that an option accepts are completed, after a space and after =."""
        if not any(program.name == "relevo-view" for program in PROGRAMS):
            self.skipTest("built without relevo-view")
        self.assertEqual(complete("relevo-view", "--surface", "p"), ["pn", "phong", "procedural", "patch"])
        self.assertEqual(complete("relevo-view", "--up", "=", ""), ["x", "y", "z"])
        self.assertEqual(complete("relevo-view", "--up", "="), ["x", "y", "z"])
        self.assertEqual(complete("relevo-view", "--no-data", "h"), ["hole"])
        self.assertLessEqual({"level", "slope"}, set(complete("relevo-view", "--color-by", "")))
        self.assertEqual(complete("relevo-view", "--zoom", ""), [])
        self.assertIn("/dev/null", complete("relevo-view", "--image", "/dev/nul"))

    def test_syntax(self):
        """Programs that read the files accept them."""
        for program in PROGRAMS:
            name = program.name
            checks = [
                ["man", "--warnings", "--local-file", FOLDER / f"{name}.1"],
                ["zsh", "-n", FOLDER / f"_{name}"],
            ]
            for command in checks:
                if shutil.which(command[0]):
                    run = subprocess.run(command, capture_output=True, text=True)
                    self.assertEqual((run.returncode, run.stderr), (0, ""), command)


if __name__ == "__main__":
    unittest.main(argv=["TestManual"])
