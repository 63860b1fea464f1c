# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves terrain.md from Python: vtkHeightMap with files, images and missing data, errors by
observer, and docstrings."""

import math
import os
import pathlib
import struct
import sys
import tempfile
import unittest

import relevo
from ErrorMessages import catch_errors
from vtkmodules.util.vtkConstants import VTK_FLOAT, VTK_UNSIGNED_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

RELIEF = pathlib.Path(os.environ.get("RELEVO_TEST_DATA", ""), "relief")


def make_image(width, height, value, scalar_type=VTK_FLOAT):
    """An image whose scalar at column i and row j is value(i, j)."""
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.AllocateScalars(scalar_type, 1)
    for j in range(height):
        for i in range(width):
            image.SetScalarComponentFromDouble(i, j, 0, 0, value(i, j))
    return image


class TestHeightMap(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return pathlib.Path(self.folder.name, name)

    def write_png(self, name="heights.png"):
        """Writes 16 bits. VTK writes the image's first row last, at the bottom of the picture."""
        writer = vtkPNGWriter()
        writer.SetInputData(make_image(7, 5, lambda i, j: 1000 * j + i, VTK_UNSIGNED_SHORT))
        writer.SetFileName(str(self.path(name)))
        writer.Write()
        return self.path(name)

    def test_is_a_height_field(self):
        heights = relevo.vtkHeightMap()
        self.assertIsInstance(heights, relevo.vtkHeightField)
        self.assertEqual(heights.GetDimensions(), (0, 0))
        self.assertIsNone(heights.GetFileName())
        for words in ("GeoTIFF", "SetImageData", "no data", "error"):
            self.assertIn(words, relevo.vtkHeightMap.__doc__)

    def test_png(self):
        heights = relevo.vtkHeightMap()
        heights.SetFileName(self.write_png())
        self.assertIs(heights.Update(), True)
        self.assertEqual(heights.GetDimensions(), (7, 5))
        self.assertEqual(heights.GetRange(), (0.0, 4006.0))
        self.assertFalse(heights.HasNoData())
        self.assertTrue(math.isnan(heights.GetNoDataValue()))
        for j in range(5):
            for i in range(7):
                self.assertEqual(heights.GetSample(i, j), 1000 * j + i)
                self.assertAlmostEqual(
                    heights.GetHeight((i + 0.5) / 7, (j + 0.5) / 5), 1000 * j + i, delta=0.01)
        # Bilinear between texel centres, and constant outside the outermost ones.
        self.assertAlmostEqual(heights.GetHeight(1.0 / 7, 1.0 / 5), 500.5, delta=0.01)
        self.assertEqual(heights.GetHeight(0.0, 0.0), 0.0)
        self.assertEqual(heights.GetHeight(-3.0, 0.0), 0.0)
        self.assertEqual(heights.GetSample(7, 0), 0.0)
        filled = [0, 0]
        heights.GetDimensions(filled)
        self.assertEqual(filled, [7, 5])

    def test_hgt(self):
        name = self.path("S02W003.hgt")
        size = 1201
        samples = [(7 * i) % 500 - 20 for i in range(size * size)]
        samples[0] = -32768  # the north-western corner
        name.write_bytes(struct.pack(">%dh" % len(samples), *samples))
        heights = relevo.vtkHeightMap()
        errors = catch_errors(heights)
        heights.SetFileName(name)
        if not heights.Update() and "without GDAL" in errors[0]:
            self.skipTest("a build without GDAL")
        self.assertEqual(heights.GetDimensions(), (size, size))
        self.assertTrue(heights.HasNoData())
        self.assertEqual(heights.GetNoDataValue(), -32768)
        self.assertFalse(heights.IsValid(0.0, 1.0))
        self.assertTrue(heights.IsValid(1.0, 0.0))
        self.assertEqual(heights.GetSample(3, 0), samples[(size - 1) * size + 3])
        self.assertGreater(heights.GetSample(0, size - 1), -21)

    def test_image(self):
        image = make_image(4, 3, lambda i, j: i * j)
        heights = relevo.vtkHeightMap()
        heights.SetImageData(image)
        self.assertTrue(heights.Update())
        self.assertIs(heights.GetImageData(), image)
        self.assertEqual(heights.GetRange(), (0.0, 6.0))
        image.SetScalarComponentFromDouble(3, 2, 0, 0, 60.0)
        image.Modified()
        self.assertTrue(heights.Update())
        self.assertEqual(heights.GetRange(), (0.0, 60.0))

    def test_no_data(self):
        heights = relevo.vtkHeightMap()
        heights.SetImageData(make_image(9, 9, lambda i, j: -1.0 if i == j == 4 else 10.0 + i))
        self.assertTrue(heights.Update())
        self.assertEqual(heights.GetRange(), (-1.0, 18.0))
        heights.SetNoDataValue(-1)
        self.assertTrue(heights.Update())
        self.assertTrue(heights.HasNoData())
        self.assertEqual(heights.GetRange(), (10.0, 18.0))
        self.assertAlmostEqual(heights.GetSample(4, 4), 14.0, delta=0.01)
        heights.SetNoDataValue(-2)
        self.assertTrue(heights.Update())
        self.assertFalse(heights.HasNoData())

    def test_reduced(self):
        heights = relevo.vtkHeightMap()
        warnings = []
        heights.AddObserver("WarningEvent", lambda *_: warnings.append(1))
        self.assertEqual(heights.GetMaximumDimension(), 16384)
        heights.SetImageData(make_image(40, 20, lambda i, j: 2.0 * i))
        heights.SetMaximumDimension(20)
        self.assertTrue(heights.Update())
        self.assertEqual(heights.GetDimensions(), (20, 10))
        self.assertEqual(heights.GetFullDimensions(), (40, 20))
        self.assertEqual(heights.GetSample(3, 3), 13.0)
        self.assertEqual(len(warnings), 1)
        heights.SetImageData(None)
        heights.SetFileName(self.write_png())
        self.assertTrue(heights.UpdateInformation())
        self.assertEqual(heights.GetFullDimensions(), (7, 5))

    def test_errors(self):
        heights = relevo.vtkHeightMap()
        errors = catch_errors(heights)
        self.assertIs(heights.Update(), False)
        heights.SetFileName(self.path("nowhere.tif"))
        self.assertIs(heights.Update(), False)
        self.assertIn("nowhere.tif: the file does not exist", errors[-1])
        self.path("text.tif").write_text("no image")
        heights.SetFileName(self.path("text.tif"))
        self.assertIs(heights.Update(), False)
        self.assertIn("text.tif", errors[-1])
        png = self.write_png()
        half = self.path("half.png")
        half.write_bytes(png.read_bytes()[:-60])
        heights.SetFileName(half)
        self.assertIs(heights.Update(), False)
        self.assertIn("half.png", errors[-1])
        nan = make_image(3, 3, lambda i, j: math.nan if (i, j) == (2, 1) else 1.0)
        heights.SetImageData(nan)
        self.assertIs(heights.Update(), False)
        self.assertIn("1 of 9 heights are NaN or infinite, the first in column 2, row 1", errors[-1])
        self.assertIn("SetNoDataValue", errors[-1])
        heights.SetNoDataValue(math.nan)
        count = len(errors)
        self.assertTrue(heights.Update())
        heights.SetImageData(make_image(3, 3, lambda i, j: math.nan))
        self.assertIs(heights.Update(), False)
        self.assertIn("all 9 heights are missing values", errors[-1])
        self.assertEqual(len(errors), count + 1)
        heights.SetImageData(None)
        heights.SetFileName(png)
        self.assertTrue(heights.Update())

    def test_real_relief(self):
        if not (RELIEF / "mt_rainier_90m.tif").exists():
            self.skipTest("no relief in RELEVO_TEST_DATA")
        heights = relevo.vtkHeightMap()
        heights.SetFileName(RELIEF / "mt_rainier_90m.tif")
        self.assertTrue(heights.Update())
        self.assertEqual(heights.GetDimensions(), (1201, 1201))
        self.assertEqual(heights.GetRange(), (263.0, 4371.0))
        self.assertTrue(heights.HasNoData())
        # Mount Adams, 46.2024 N 121.4909 W, 3743 m, and the Yakima plain to its east.
        summit = max(
            heights.GetHeight(0.5091 + du / 1201, 0.2024 + dv / 1201)
            for du in range(-5, 6) for dv in range(-5, 6))
        self.assertAlmostEqual(summit, 3743, delta=60)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
