# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves terrain.md on relevo-pyramid: its arguments, and files after a kill or with a full disk."""

import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy

BINARIES = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin"
PROGRAM = BINARIES / "relevo-pyramid"
if not PROGRAM.exists():
    print("skipped: relevo-pyramid was not built")
    sys.exit(125)

SIZE = 2000
HEADER = f"""ENVI
samples = {SIZE}
lines = {SIZE}
bands = 1
data type = 2
interleave = bsq
byte order = 0
map info = {{Geographic Lat/Lon, 1, 1, 10, 50, 0.001, 0.001, WGS-84}}
"""


def height(column, row):
    return (7 * column + 13 * row) % 3000


class TestPyramidProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.input = cls.folder / "in.dat"
        rows, columns = numpy.mgrid[0:SIZE, 0:SIZE]
        height(columns, rows).astype("<i2").tofile(cls.input)
        (cls.folder / "in.hdr").write_text(HEADER)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_program(self, *arguments, **settings):
        return subprocess.run(
            [PROGRAM, *arguments], capture_output=True, text=True, check=False, **settings
        )

    def assert_whole(self, name):
        """A few heights, as relevo-view prints them."""
        for column, row in ((0, 0), (1234, 777), (SIZE - 1, SIZE - 1)):
            place = f"{10 + 0.001 * (column + 0.5)},{50 - 0.001 * (row + 0.5)}"
            run = subprocess.run(
                [BINARIES / "relevo-view", name, "--height-at", place],
                capture_output=True,
                text=True,
                check=True,
            )
            self.assertAlmostEqual(float(run.stdout), height(column, row), delta=1e-3)

    def hidden(self):
        return [path for path in self.folder.iterdir() if path.name.startswith(".")]

    def test_usage(self):
        self.assertIn("Usage:", self.run_program("--help").stdout)
        self.assertIn("relevo-pyramid", self.run_program("--version").stdout)
        for arguments in ((), ("a",), ("a", "b", "c"), ("--bad", "a", "b"),
                          ("a", "b", "--compression", "jpeg"), ("a", "b", "--compression")):
            with self.subTest(arguments):
                run = self.run_program(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertRegex(run.stderr, r"\Arelevo-pyramid: error: [^\n]+\n\Z")

    def test_errors(self):
        for name, words in (("missing.tif", "does not exist"), (self.folder, "folder")):
            output = self.folder / "error.tif"
            run = self.run_program(name, output)
            self.assertEqual(run.returncode, 1)
            self.assertIn(words, run.stderr)
            self.assertFalse(output.exists())

    def test_write(self):
        output = self.folder / "out.tif"
        for compression in ("deflate", "none"):
            run = self.run_program(self.input, output, f"--compression={compression}")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assert_whole(output)
            self.assertEqual(self.hidden(), [])
        output.unlink()

    def test_kill(self):
        """After kill -9 there is no half file, and the next run completes it."""
        output = self.folder / "killed.tif"
        for delay in (0.02, 0.2, 0.5):
            with subprocess.Popen([PROGRAM, self.input, output]) as process:
                time.sleep(delay)
                process.kill()
            if process.returncode != -signal.SIGKILL:
                continue  # the machine was faster
            self.assertFalse(output.exists())
        run = self.run_program(self.input, output)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assert_whole(output)
        self.assertEqual(self.hidden(), [])
        output.unlink()

    def test_full_disk(self):
        output = self.folder / "full.tif"

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 20, 1 << 20))

        run = self.run_program(self.input, output, "--compression", "none", preexec_fn=limit)
        self.assertEqual(run.returncode, 1)
        self.assertIn("full.tif", run.stderr)
        self.assertFalse(output.exists())
        run = self.run_program(self.input, output, "--compression", "none")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assert_whole(output)
        output.unlink()

    def test_two_processes(self):
        """A second process reports that the first one is writing."""
        output = self.folder / "two.tif"
        lock = self.folder / ".two.tif.relevo-lock"
        for _ in range(20):
            output.unlink(missing_ok=True)
            with subprocess.Popen([PROGRAM, self.input, output], stderr=subprocess.PIPE) as first:
                while first.poll() is None and not lock.exists():
                    time.sleep(0.001)
                first.send_signal(signal.SIGSTOP)
                is_writing = first.poll() is None and lock.exists()
                run = self.run_program(self.input, output)
                first.send_signal(signal.SIGCONT)
                first.wait()
            if is_writing:  # on a busy computer, the process can end before the signal
                break
        self.assertEqual(first.returncode, 0)
        self.assertEqual(run.returncode, 1)
        self.assertIn("another process is writing", run.stderr)
        self.assert_whole(output)


if __name__ == "__main__":
    unittest.main(argv=["TestPyramidProgram"])
