# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""relevo.files promises that a file has either the old or the complete new content, also on full
disks and after signals."""

import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import unittest

from relevo import files
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

OLD, NEW = b"old", bytes(20000)


def make_image():
    """An image with noise, so that it does not compress."""
    image = vtkImageData()
    image.SetDimensions(90, 60, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
    scalars = image.GetPointData().GetScalars()
    for i, value in enumerate(os.urandom(scalars.GetNumberOfValues())):
        scalars.SetValue(i, value)
    return image


class TestFiles(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.path = self.folder / "a.bin"
        self.path.write_bytes(OLD)

    def tearDown(self):
        self.temporary.cleanup()

    def assert_left(self, contents, *names):
        self.assertEqual(self.path.read_bytes(), contents)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"a.bin", *names})

    def test_replaced(self):
        self.path.chmod(0o640)
        files.write(self.path, NEW)
        self.assert_left(NEW)
        self.assertEqual(self.path.stat().st_mode & 0o777, 0o640)
        (self.folder / "link").symlink_to("a.bin")
        files.write(self.folder / "link", "ü\n")
        self.assert_left(b"\xc3\xbc\n", "link")
        self.assertTrue((self.folder / "link").is_symlink())
        files.write(str(self.folder / "new"), b"")
        self.assert_left(b"\xc3\xbc\n", "link", "new")
        files.write("/dev/null", NEW)
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())

    def test_full_disk(self):
        old = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (10000, old[1]))
        try:
            with self.assertRaises(OSError):
                files.write(self.path, NEW)
            with self.assertRaises(OSError):
                files.write_picture(self.folder / "a.png", make_image())
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, old)
        self.assert_left(OLD)
        for path in (self.folder, self.folder / "none" / "a.bin"):
            with self.assertRaises(OSError):
                files.write(path, NEW)
        self.assert_left(OLD)

    def test_signals(self):
        """Sends the signal while the new file has its temporary name."""
        program = (
            "import os, signal, sys\n"
            "from relevo import files\n"
            "number = int(sys.argv[2])\n"
            "if number == signal.SIGINT and len(sys.argv) > 3:\n"
            "    signal.signal(number, signal.SIG_DFL)\n"
            "os.fsync = lambda file: os.kill(os.getpid(), number)\n"
            "files.write(sys.argv[1], b'new')\n"
        )
        for number, *mode in (
            (signal.SIGINT,), (signal.SIGINT, "default"), (signal.SIGTERM,), (signal.SIGHUP,),
        ):
            arguments = [sys.executable, "-c", program, self.path, str(int(number)), *mode]
            run = subprocess.run(arguments, stderr=subprocess.DEVNULL)
            self.assertEqual(run.returncode, -number)
            self.assert_left(OLD)

    def test_pictures(self):
        image = make_image()
        for name, reader in (("a.png", vtkPNGReader()), ("a.JPG", vtkJPEGReader())):
            files.write_picture(self.folder / name, image)
            reader.SetFileName(str(self.folder / name))
            reader.Update()
            self.assertEqual(reader.GetOutput().GetDimensions(), image.GetDimensions())
        with self.assertRaisesRegex(ValueError, "'.*a.bin' must end with .png"):
            files.write_picture(self.path, image)
        self.assert_left(OLD, "a.png", "a.JPG")


if __name__ == "__main__":
    unittest.main(argv=["TestFiles"])
