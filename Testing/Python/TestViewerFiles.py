# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that files written by relevo-view have either the old or the complete new content,
also on full disks and after signals.

RELEVO_TEST_MOMENTS=50 sends each signal at this many moments for every kind of file."""

import errno
import os
import random
import shutil
import signal
import subprocess
import time
import unittest

import relevo

from ViewerProgram import PROGRAM, ViewerProgram
from ViewerScenes import write_sphere

MOMENTS = int(os.environ.get("RELEVO_TEST_MOMENTS", "1"))
OLD = b"old"
FILES = {  # more than 12 kB each
    ".obj": ("--export", "--level=1"),
    ".ply": ("--export", "--level=2"),
    ".stl": ("--export", "--level=2"),
    ".vtp": ("--export", "--level=2"),
    ".png": ("--output", "--size=400x300"),
}


def is_temporary(name):
    """Whether SIGKILL may leave such a file."""
    return name.startswith(".") and ".part" in name


class TestViewerFiles(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sphere = write_sphere(cls.folder)

    def arguments(self, path):
        option, *others = FILES[path.suffix]
        return [str(self.sphere), f"{option}={path}", *others]

    def assert_not_written(self, path, error, **limits):
        run = self.view(*self.arguments(path), code=1, **limits)
        self.assertEqual(
            run.stderr, f"relevo-view: error: cannot write {path}: {os.strerror(error)}\n"
        )
        self.assertEqual(path.read_bytes(), OLD)
        self.assertEqual([file.name for file in path.parent.iterdir()], [path.name])

    def test_files_that_are_too_large(self):
        folder = self.folder / "large"
        folder.mkdir()
        for extension in FILES:
            path = folder / ("a" + extension)
            path.write_bytes(OLD)
            for size in (1000, 8000):
                self.assert_not_written(path, errno.EFBIG, largest_file=size)
            path.unlink()

    def test_full_disk(self):
        """The same on a small disk, where the second file would fit without the first."""
        folder = self.folder / "disk"
        folder.mkdir()
        mount = ["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", str(folder)]
        if not shutil.which("mount") or subprocess.run(mount, capture_output=True).returncode:
            self.skipTest("no disk can be mounted")
        try:
            for extension in FILES:
                path = folder / ("a" + extension)
                path.write_bytes(OLD)
                self.assert_not_written(path, errno.ENOSPC)
                path.unlink()
        finally:
            subprocess.run(["umount", str(folder)], check=True)

    def test_signals(self):
        for extension in FILES if MOMENTS > 1 else [".vtp"]:
            folder = self.folder / ("signals" + extension)
            folder.mkdir()
            path = folder / ("a" + extension)
            start = time.monotonic()
            subprocess.run([PROGRAM, *self.arguments(path)], check=True)
            duration = time.monotonic() - start
            new = path.read_bytes()
            path.write_bytes(OLD)
            path.chmod(0o640)
            number_of_old = number_of_temporaries = 0
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
                for _ in range(MOMENTS):
                    with subprocess.Popen(
                        [PROGRAM, *self.arguments(path)],
                        stdout=subprocess.DEVNULL,
                        stderr=subprocess.DEVNULL,
                    ) as process:
                        # Most of the time passes before anything is written.
                        time.sleep(duration * random.uniform(0.3, 1.0))
                        process.send_signal(number)
                        self.assertIn(process.wait(60), (0, -number))
                    written = path.read_bytes()
                    self.assertTrue(written in (OLD, new), (extension, number, len(written)))
                    self.assertEqual(path.stat().st_mode & 0o777, 0o640)
                    number_of_old += written == OLD
                    names = {file.name for file in folder.iterdir()} - {path.name}
                    if number == signal.SIGKILL:
                        number_of_temporaries += len(names)
                        self.assertTrue(all(map(is_temporary, names)), names)
                        for name in names:
                            (folder / name).unlink()
                    else:
                        self.assertEqual(names, set())
                    path.write_bytes(OLD)
            print(
                f"{extension}: {3 * MOMENTS} signals, {number_of_old} times the old file, "
                f"{3 * MOMENTS - number_of_old} times the new one, "
                f"{number_of_temporaries} temporary files after SIGKILL"
            )

    def read_reliefs(self, folder):
        """The number of reliefs, all of which must be complete."""
        reader = relevo.vtkReliefDatabaseReader()
        errors = []
        reader.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
        reader.SetFileName(str(folder))
        reader.Update()
        self.assertEqual(errors, [])
        return reader.GetOutput().GetNumberOfBlocks()

    def test_captures(self):
        """A folder has the old captures or all of the new ones."""
        folder = self.folder / "captures"
        old, new = ("--relief=box",), ("--relief=view",)
        capture = [str(PROGRAM), str(self.sphere), f"--capture={folder}"]

        def run(options):
            start = time.monotonic()
            subprocess.run([*capture, *options], capture_output=True, check=True)
            return time.monotonic() - start

        run(old)
        kept = self.folder / "kept"
        shutil.copytree(folder, kept)
        number_of_old = 0
        duration = run(new)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            for _ in range(MOMENTS):
                shutil.rmtree(folder)
                shutil.copytree(kept, folder)
                self.assertEqual(self.read_reliefs(folder), 6)
                with subprocess.Popen(
                    [*capture, *new], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
                ) as process:
                    time.sleep(duration * random.uniform(0.3, 1.0))
                    process.send_signal(number)
                    self.assertIn(process.wait(60), (0, -number))
                reliefs = self.read_reliefs(folder)
                self.assertIn(reliefs, (1, 6))
                number_of_old += reliefs == 6
                names = {file.name for file in folder.iterdir()}
                if number == signal.SIGKILL:
                    for name in filter(is_temporary, names):
                        (folder / name).unlink()
                else:
                    self.assertFalse(any(map(is_temporary, names)), names)
        print(
            f"captures: {3 * MOMENTS} signals, {number_of_old} times the old ones, "
            f"{3 * MOMENTS - number_of_old} times the new ones"
        )
        run(new)  # the next run removes all remains
        self.assertEqual(len(list(folder.iterdir())), 3)

    def test_captures_in_other_folders(self):
        folder = self.folder / "mine"
        folder.mkdir()
        for name in ("data.csv", "notes.txt"):
            (folder / name).write_text("a,b\n1,2\n")
            self.assert_error(
                1, [str(folder), f"It holds {name},"], self.sphere, f"--capture={folder}"
            )
            self.assertEqual([file.name for file in folder.iterdir()], [name])
            self.assertEqual((folder / name).read_text(), "a,b\n1,2\n")
            (folder / name).unlink()
        self.view(self.sphere, f"--capture={folder}", "--relief=view")
        self.assertEqual(self.read_reliefs(folder), 1)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerFiles"])
