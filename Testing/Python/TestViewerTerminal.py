# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that relevo-view shows progress in a terminal and clears it at the end, and that errors
are one line. The version and outputs that cannot be written are tested too; the latter are reported
before anything is read."""

import os
import pty
import re
import subprocess
import unittest

import relevo
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from ViewerProgram import PROGRAM, ViewerProgram


def screen(written):
    """The lines that a terminal shows after this output."""
    lines = [""]
    column = 0
    for letter in written:
        if letter == "\r":
            column = 0
        elif letter == "\n":
            lines.append("")
        else:
            lines[-1] = lines[-1][:column].ljust(column) + letter + lines[-1][column + 1 :]
            column += 1
    return [line.rstrip() for line in lines]


class TestViewerTerminal(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        writer = vtkXMLPolyDataWriter()
        sphere = vtkSphereSource()
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(str(cls.folder / "sphere.vtp"))
        writer.Write()
        (cls.folder / "heights.pgm").write_bytes(b"P5 8 8 255\n" + bytes(range(64)))
        (cls.folder / "picture.ppm").write_bytes(b"P6 4 4 255\n" + bytes(range(48)))

    def watch(self, *arguments, code=0):
        """The output to a terminal."""
        terminal, end = pty.openpty()
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        with subprocess.Popen(
            [str(PROGRAM), *arguments], cwd=self.folder, env=environment, stderr=end
        ) as run:
            os.close(end)
            written = b""
            try:
                while part := os.read(terminal, 4096):
                    written += part
            except OSError:  # the end of a terminal's output
                pass
        os.close(terminal)
        self.assertEqual(run.returncode, code, written)
        return written.decode()

    def assert_progress(self, words, *arguments):
        """Expects these texts in this order, and nothing that remains."""
        written = self.watch(*arguments)
        self.assertRegex(written, ".*".join(words))
        self.assertEqual(screen(written), [""])

    def test_screen(self):
        self.assertEqual(screen("abc\rx\r\n12\r"), ["xbc", "12"])

    def test_terrain(self):
        self.assert_progress(
            [r"\rreading heights \d+ %", r"\rdraping imagery \d+ %", r"\rwriting"],
            "heights.pgm", "--image=picture.ppm", "--resolution=8", "--output=p.png", "--size=64x64",
        )

    def test_mesh(self):
        self.assert_progress(
            [r"\rreading", r"\rrefining \d+ %", r"\rwriting"],
            "sphere.vtp", "--level=2", "--export=e.vtp",
        )
        # These heights are read in several parts.
        (self.folder / "large.pgm").write_bytes(b"P5 2048 3000 255\n" + bytes(2048 * 3000))
        self.assert_progress(
            [r"\rreading", r"\rreading heights \d+ %", r"\rrefining", r"\rwriting"],
            "sphere.vtp", "--level=2", "--height=large.pgm", "--export=e.stl",
        )

    def test_errors_are_whole_lines(self):
        """Errors after the work has started and after warnings."""
        (self.folder / "cut.pgm").write_bytes(b"P5 8 8 255\n12345")
        (self.folder / "cut.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
        for name in ("cut.pgm", "cut.obj", "missing.vtp"):
            written = self.watch(name, "--output=p.png", code=1)
            lines = [line for line in screen(written) if line]
            self.assertEqual(len(lines), 1, written)
            self.assertRegex(lines[0], r"\Arelevo-view: error: [^%]+\Z")
        lines = screen(self.watch("heights.pgm", "--image=cut.pgm", "--output=p.png", code=1))
        self.assertRegex(lines[0], r"\Arelevo-view: error: .*cut\.pgm")
        flat = self.folder / "flat.obj"
        flat.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\nf 1 2 4\n")
        lines = screen(self.watch("flat.obj", "--export=e.vtp", "--level=1"))
        self.assertRegex(lines[0], r"\Arelevo-view: warning: 1 degenerate")
        self.assertEqual(lines[1:], [""])

    def test_version(self):
        self.assertRegex(relevo.__version__, r"\A\d+\.\d+\.\d+\Z")
        self.assertEqual(self.view("--version").stdout, f"relevo-view {relevo.__version__}\n")
        self.assertIn("--version", self.view("--help").stdout)
        self.view("missing.tif", "--version")

    def test_disk_is_full(self):
        """A full disk gives an error, for each format and every amount of free space."""
        if os.path.exists("/dev/full"):
            for extension in (".ply", ".obj", ".stl", ".vtp"):
                name = "full" + extension
                (self.folder / name).symlink_to("/dev/full")
                self.assert_error(
                    1, ["cannot write " + name, os.strerror(28)],  # ENOSPC
                    "sphere.vtp", "--surface=linear", "--export=" + name)
        for extension in (".ply", ".obj", ".stl", ".vtp"):
            self.view("sphere.vtp", "--export=whole" + extension, "--level=1")
            name = "large" + extension
            # 4 blocks of 512 or 1024 bytes. Without the signal, writing fails.
            run = subprocess.run(
                ["sh", "-c", "trap '' XFSZ; ulimit -f 4; exec \"$@\"", "sh", str(PROGRAM),
                 "sphere.vtp", "--export=" + name, "--level=4"],
                cwd=self.folder, capture_output=True, text=True, timeout=60)
            self.assertEqual(run.returncode, 1, name)
            self.assertRegex(run.stderr, r"\Arelevo-view: error: [^\n]+\n\Z")
            self.assertIn(name, run.stderr)

    def test_output_comes_first(self):
        """The output's error comes before the input's: nothing has been read."""
        (self.folder / "file").write_text("")
        (self.folder / "folder.png").mkdir()
        (self.folder / "folder.vtp").mkdir()
        long = "a" * 300
        for words, name in (
            (["the folder nowhere does not exist"], "nowhere/a"),
            (["the folder file does not exist"], "file/a"),
            (["it is a folder"], "folder"),
            ([os.strerror(36)], long),  # ENAMETOOLONG
        ):
            for option, extension in (("--output", ".png"), ("--export", ".vtp")):
                self.assert_error(
                    1, ["cannot write " + name + extension, *words],
                    "missing.tif", option, name + extension,
                )
        self.assert_error(1, ["cannot write nowhere"], "sphere.vtp", "--export=nowhere/a.stl")
        # Outputs that could be written are unchanged.
        kept = self.folder / "kept.png"
        kept.write_text("kept")
        self.assert_error(1, ["missing.tif"], "missing.tif", "--output=kept.png")
        self.assertEqual(kept.read_text(), "kept")
        self.assert_error(1, ["missing.tif"], "missing.tif", "--output=new.png")
        self.assertFalse((self.folder / "new.png").exists())

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_permissions(self):
        (self.folder / "locked").mkdir(mode=0o500)
        self.assert_error(1, ["locked/a.png", "denied"], "missing.tif", "--output=locked/a.png")
        (self.folder / "locked.png").touch(mode=0o400)
        self.assert_error(1, ["locked.png", "denied"], "missing.tif", "--output=locked.png")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTerminal"])
