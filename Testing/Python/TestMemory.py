# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that data that do not fit into memory give an error, and that the program continues."""

import contextlib
import ctypes
import pathlib
import re
import resource
import sys
import tempfile
import unittest

import relevo
from ErrorMessages import catch_errors
from vtkmodules.util.vtkConstants import VTK_FLOAT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

MEBIBYTE = 1 << 20
STATUS = pathlib.Path("/proc/self/status")
if not STATUS.exists():
    print("skipped: how much memory is in use is not known")
    sys.exit(125)
LIBC = ctypes.CDLL(None)
LIBC.malloc.restype = ctypes.c_void_p
LIBC.free.argtypes = [ctypes.c_void_p]
# Freed memory returns to the system at once.
MMAP_THRESHOLD = -3
LIBC.mallopt(MMAP_THRESHOLD, 16384)


@contextlib.contextmanager
def little_memory(size):
    """
    Limits the address space to this many additional bytes. Small objects, but not arrays, can also
    use the gaps between blocks, because VTK and expat end the program if they get no memory.
    """
    blocks = [LIBC.malloc(8000) for _ in range(1024)]
    for block in blocks[::2]:
        LIBC.free(block)
    old = resource.getrlimit(resource.RLIMIT_AS)
    in_use = 1024 * int(re.search(r"VmSize:\s+(\d+)", STATUS.read_text())[1])
    resource.setrlimit(resource.RLIMIT_AS, (in_use + size, old[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, old)
        for block in blocks[1::2]:
            LIBC.free(block)


def make_image(width, height, scalar_type, components=1):
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.AllocateScalars(scalar_type, components)
    array = image.GetPointData().GetScalars()
    for c in range(components):
        array.FillComponent(c, 1.0)
    array.SetName("Values")
    return image


class TestMemory(unittest.TestCase):
    def test_imagery(self):
        """Requires 12 GiB for a small picture in a large terrain."""
        with tempfile.TemporaryDirectory() as folder:
            for name, step in (("terrain", 100.0), ("imagery", 0.001)):
                writer = vtkPNGWriter()
                writer.SetInputData(make_image(8, 8, VTK_UNSIGNED_CHAR))
                writer.SetFileName(f"{folder}/{name}.png")
                writer.Write()
                place = f"{step}\n0\n0\n{-step}\n400\n400\n"
                pathlib.Path(folder, name + ".pgw").write_text(place)
            source = relevo.vtkTerrainSource()
            errors = catch_errors(source)
            catch_errors(source.GetExecutive())
            source.SetFileName(f"{folder}/terrain.png")
            source.Update()
            if source.GetOutput().GetBounds()[1] < 100:
                self.skipTest("without GDAL nothing is georeferenced")
            source.SetImageryFileName(f"{folder}/imagery.png")
            source.SetMaximumImagerySize(65536)
            with little_memory(2048 * MEBIBYTE):
                source.Update()
            self.assertIn("Not enough memory for a mesh of Resolution 128 and imagery", errors[-1])
            self.assertEqual(source.GetOutput().GetNumberOfPoints(), 0)
            source.SetImageryFileName(None)
            source.Update()
            self.assertGreater(source.GetOutput().GetNumberOfPoints(), 0)

    def test_heights(self):
        heights = relevo.vtkHeightMap()
        errors = catch_errors(heights)
        heights.SetImageData(make_image(6000, 6000, VTK_UNSIGNED_CHAR))
        with little_memory(32 * MEBIBYTE):
            self.assertFalse(heights.Update())
        self.assertIn("not enough memory for 6000 x 6000 heights", errors[-1])

    def test_streaks(self):
        streaks = relevo.vtkLineIntegralConvolution()
        errors = catch_errors(streaks)
        catch_errors(streaks.GetExecutive())
        streaks.SetInputData(make_image(4000, 4000, VTK_FLOAT, 2))
        with little_memory(32 * MEBIBYTE):
            streaks.Update()
        self.assertIn("Not enough memory for 16000000 points", errors[-1])
        streaks.SetInputData(make_image(40, 40, VTK_FLOAT, 2))
        streaks.Update()
        self.assertEqual(streaks.GetOutput().GetNumberOfPoints(), 1600)

    def test_databases(self):
        """Reading and writing a database succeeds or gives an error, and leaves nothing behind."""
        image = make_image(400, 300, VTK_FLOAT)
        camera = relevo.vtkDepthImageToRelief()
        camera.SetIntrinsics(300, 300, 199.5, 149.5)
        camera.SetInputData(image)
        writer = relevo.vtkReliefDatabaseWriter()
        writer.SetInputConnection(camera.GetOutputPort())
        reader = relevo.vtkReliefDatabaseReader()
        errors = catch_errors(reader)
        of_writer = catch_errors(writer)
        catch_errors(reader.GetExecutive())
        with tempfile.TemporaryDirectory() as folder:
            database = pathlib.Path(folder, "a.cdb")
            reader.SetFileName(str(database))
            numbers = {"read": [], "written": []}
            for size in range(0, 13 * MEBIBYTE, MEBIBYTE // 2):
                writer.SetFileName(str(database))
                self.assertEqual(writer.Write(), 1)
                old = {path.name for path in database.iterdir()}
                reader.GetOutput().Initialize()  # releases its memory
                reader.Modified()
                writer.Modified()
                errors.clear()
                of_writer.clear()
                with little_memory(size):
                    reader.Update()
                    written = writer.Write()
                blocks = reader.GetOutput().GetNumberOfBlocks()
                self.assertEqual(len(errors), 0 if blocks and reader.GetOutput().GetBlock(0) else 1)
                self.assertEqual(len(of_writer), 1 - written, of_writer)
                for message in errors + of_writer:
                    self.assertRegex(message.lower(), "not enough memory|cannot allocate memory")
                self.assertEqual({path.name for path in database.iterdir()}, old)
                numbers["read"].append(not errors)
                numbers["written"].append(written == 1)
            for name, successes in numbers.items():
                self.assertEqual(set(successes), {False, True}, name)


if __name__ == "__main__":
    unittest.main(argv=["TestMemory"])
