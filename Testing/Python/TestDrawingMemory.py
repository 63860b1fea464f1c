# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that drawings leave neither objects of VTK nor memory nor files behind."""

import gc
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

from DrawingData import make_curved_block, make_heights, make_sphere, numpy, relevo

STATUS = pathlib.Path("/proc/self/statm")
if not STATUS.exists():
    print("skipped: how much memory is in use is not known")
    sys.exit(125)
PAGE = 4096
MEBIBYTE = 1 << 20


def get_memory():
    return int(STATUS.read_text().split()[1]) * PAGE


class TestDrawingMemory(unittest.TestCase):
    def check(self, make, number, warming=20):
        """Create drawings, and check that their objects are deleted and memory does not grow."""
        living = set()

        def create():
            drawing = make()
            for name in ("mapper", "actor"):
                living.add(name)
                getattr(drawing, name).AddObserver(
                    "DeleteEvent", lambda caller, event, name=name: living.remove(name)
                )

        for repetition in range(warming + number):
            if repetition == warming:
                before = get_memory()
            create()
            self.assertEqual(living, set())
        # Small pieces between others remain, but not one mesh or raster of each drawing.
        self.assertLess(get_memory() - before, 4 * MEBIBYTE)

    def setUp(self):
        gc.disable()  # cycles of Python would keep the data for long
        self.addCleanup(gc.enable)

    def test_meshes(self):
        """2800 drawings."""
        sphere, block = make_sphere(8), make_curved_block()
        micro = relevo.micromesh(sphere).micro
        for make in (
            lambda: relevo.refined(sphere),
            lambda: relevo.lic(sphere, "V"),
            lambda: relevo.volume(block),
            lambda: relevo.patches(block),
            lambda: relevo.streamlines(sphere, "V", seeds=2),
            lambda: relevo.micromesh(micro),
            lambda: relevo.intersection(sphere, block),
        ):
            self.check(make, 400)

    def test_arrays(self):
        points = numpy.random.default_rng(1).random((20000, 3))
        faces = numpy.arange(18000).reshape(-1, 3)
        self.check(lambda: relevo.refined((points.copy(), faces), surface="linear"), 40)

    def test_rasters(self):
        heights = make_heights()
        # Other programs write to the usual folder at the same time.
        with tempfile.TemporaryDirectory() as folder:
            with unittest.mock.patch("tempfile.tempdir", folder):
                terrain = relevo.terrain(heights)
                self.assertEqual(len(list(pathlib.Path(folder).iterdir())), 1)
                del terrain
                self.check(lambda: relevo.terrain(heights), 100)
                self.check(lambda: relevo.relief(heights), 100)
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])

    def test_copies_of_heights(self):
        """Heights need at most the memory of one more array, and less afterwards."""
        program = """
import numpy, relevo
from relevo import arrays

def read(name):
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith(name))

small = relevo.terrain(numpy.eye(8)), arrays.height_map(numpy.eye(8))
heights = numpy.random.default_rng(1).random((4096, 3000), numpy.float32)
with open("/proc/self/clear_refs", "w") as file:
    file.write("5")  # forget the peak
before = read("VmRSS")
result = {call}
print((read("VmHWM") - before) / heights.nbytes, (read("VmRSS") - before) / heights.nbytes)
"""
        for call, limits in (
            ("relevo.terrain(heights)", (1.0, 0.4)),
            ("arrays.height_map(heights)", (1.05, 1.05)),
        ):
            code = program.format(call=call)
            done = subprocess.run(
                [sys.executable, "-c", code], capture_output=True, text=True, check=True
            )
            for size, limit in zip(map(float, done.stdout.split()), limits):
                self.assertLess(size, limit, call)

    def test_pictures(self):
        drawing = relevo.refined(make_sphere())
        for _ in range(5):
            drawing.screenshot(size=(200, 100))
        before = get_memory()
        for _ in range(40):
            drawing.screenshot(size=(200, 100))
        self.assertLess(get_memory() - before, 20 * MEBIBYTE)

    def test_actors_outlive_drawings(self):
        """A renderer keeps what it draws, with the file of an array."""
        actor = relevo.terrain(make_heights()).actor
        pyramid = actor.GetMapper().GetPyramid()
        self.assertEqual(pyramid.GetNumberOfLevels(), 1)
        self.assertTrue(pathlib.Path(pyramid.GetFileName()).exists())
        self.assertTrue(numpy.isfinite(pyramid.GetElevation(40, 30)))


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingMemory"])
