# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves terrain.md from Python: mesh, displacement and imagery of vtkTerrainSource, errors, and
docstrings."""

import math
import os
import pathlib
import sys
import tempfile
import unittest

import relevo
from ErrorMessages import catch_errors
from vtkmodules.util.vtkConstants import VTK_FLOAT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

RELIEF = pathlib.Path(os.environ.get("RELEVO_TEST_DATA", ""), "relief")


def make_image(width, height, components, scalar_type, value):
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.AllocateScalars(scalar_type, components)
    for j in range(height):
        for i in range(width):
            for c in range(components):
                image.SetScalarComponentFromDouble(i, j, 0, c, value(i, j, c))
    return image


def write_png(image, path):
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()


class TestTerrainSource(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.heights = pathlib.Path(self.folder.name, "heights.png")
        write_png(make_image(40, 20, 1, VTK_UNSIGNED_CHAR, lambda i, j, c: i + j), self.heights)

    def tearDown(self):
        self.folder.cleanup()

    def test_defaults(self):
        source = relevo.vtkTerrainSource()
        self.assertEqual(source.GetNumberOfInputPorts(), 0)
        self.assertEqual(source.GetResolution(), 128)
        self.assertEqual(source.GetExaggeration(), 1.0)
        self.assertEqual(source.GetImageryBands(), (0, 0, 0))
        self.assertIsNone(source.GetImagery())
        self.assertEqual(source.GetCoordinateSystem(), "")
        self.assertIs(source.GetDisplacement().GetHeightMap(), source.GetHeightMap())
        self.assertEqual(source.GetDisplacement().GetDirection(), (0.0, 0.0, 1.0))
        for words in ("metres", "imagery", "no data", "error"):
            self.assertIn(words.lower(), relevo.vtkTerrainSource.__doc__.lower())

    def test_mesh(self):
        source = relevo.vtkTerrainSource()
        source.SetFileName(self.heights)
        source.SetResolution(10)
        source.SetExaggeration(3.0)
        source.Update()
        mesh = source.GetOutput()
        self.assertEqual(mesh.GetNumberOfCells(), 2 * 10 * 5)
        self.assertEqual(mesh.GetNumberOfPoints(), 11 * 6)
        self.assertEqual(mesh.GetBounds(), (-20.0, 20.0, -10.0, 10.0, 0.0, 0.0))
        self.assertEqual(source.GetOrigin(), (20.0, 10.0, 0.0))
        self.assertEqual(source.GetDisplacement().GetScale(), 3.0)
        texture = mesh.GetPointData().GetTCoords()
        for i in range(mesh.GetNumberOfPoints()):
            x, y, _ = mesh.GetPoint(i)
            u, v = texture.GetTuple2(i)
            self.assertAlmostEqual(u, (x + 20) / 40, places=6)
            self.assertAlmostEqual(v, (y + 10) / 20, places=6)

    def test_coordinates(self):
        source = relevo.vtkTerrainSource()
        place = [0.0, 0.0, 0.0]
        self.assertFalse(source.TerrainToMap((1, 2, 3), place))
        source.SetFileName(self.heights)
        source.SetExaggeration(4.0)
        source.Update()
        self.assertFalse(source.IsGeographic())
        self.assertTrue(source.TerrainToMap((5, -3, 8), place))
        self.assertEqual(place, [25.0, 7.0, 2.0])
        self.assertTrue(source.MapToTerrain((25, 7, 2), place))
        self.assertEqual(place, [5.0, -3.0, 8.0])
        self.assertFalse(source.GeographicToTerrain((25, 7, 2), place))

    def test_no_file(self):
        """The error recommends a method that the source has."""
        source = relevo.vtkTerrainSource()
        errors = catch_errors(source)
        source.Update()
        self.assertEqual(len(errors), 1)
        self.assertIn("There is no file name: call SetFileName().", errors[0])
        self.assertNotIn("SetImageData", errors[0])

    def test_from_memory(self):
        source = relevo.vtkTerrainSource()
        source.GetHeightMap().SetImageData(
            make_image(12, 12, 1, VTK_FLOAT, lambda i, j, c: math.nan if i > 5 else 1.0))
        source.SetNoDataValue(math.nan)
        source.SetResolution(12)
        source.Update()
        holes = source.GetOutput().GetNumberOfCells()
        source.SetNoDataPolicyToFill()
        source.Update()
        self.assertEqual(source.GetOutput().GetNumberOfCells(), 2 * 12 * 12)
        self.assertEqual(holes, 2 * 12 * 7)

    def test_imagery(self):
        picture = make_image(24, 12, 3, VTK_UNSIGNED_CHAR, lambda i, j, c: 5 * i + 7 * j + c)
        path = pathlib.Path(self.folder.name, "picture.png")
        write_png(picture, path)
        source = relevo.vtkTerrainSource()
        source.SetFileName(self.heights)
        source.SetImageryFileName(path)
        source.Update()
        image = source.GetImagery()
        self.assertEqual(image.GetDimensions(), (24, 12, 1))
        self.assertEqual(image.GetScalarType(), VTK_UNSIGNED_CHAR)
        self.assertEqual(image.GetNumberOfScalarComponents(), 3)
        for j in range(12):
            for i in range(24):
                for c in range(3):
                    self.assertEqual(
                        image.GetScalarComponentAsDouble(i, j, 0, c), 5 * i + 7 * j + c)

    def test_errors(self):
        source = relevo.vtkTerrainSource()
        errors = catch_errors(source)
        executive = catch_errors(source.GetExecutive())
        source.SetFileName("nowhere.tif")
        source.Update()
        self.assertIn("nowhere.tif: the file does not exist", errors[-1])
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 0)
        source.SetFileName(self.heights)
        source.SetImageryFileName("no picture.jpg")
        source.Update()
        self.assertIn("no picture.jpg", errors[-1])
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(len(errors), 2)
        self.assertEqual(len(executive), 2)
        source.SetExaggeration(math.inf)
        self.assertIn("Exaggeration must be in [", errors[-1])
        self.assertEqual(source.GetExaggeration(), 1.0)
        source.SetImageryFileName(None)
        source.Update()
        self.assertGreater(source.GetOutput().GetNumberOfPoints(), 0)

    def test_real_relief(self):
        if not (RELIEF / "rmnp-dem.tif").exists():
            self.skipTest("no relief in RELEVO_TEST_DATA")
        source = relevo.vtkTerrainSource()
        source.SetFileName(RELIEF / "rmnp-dem.tif")
        source.SetImageryFileName(RELIEF / "rmnp-rgb.tif")
        source.Update()
        if not source.GetCoordinateSystem():
            self.skipTest("a build without GDAL")
        self.assertIn("WGS", source.GetCoordinateSystem())
        x, y, z = source.GetOrigin()
        self.assertAlmostEqual(x, -105.7035, places=9)
        self.assertAlmostEqual(y, 40.5536780696 - 93.5 * 0.00211, places=8)
        self.assertEqual(z, 0.0)
        bounds = source.GetOutput().GetBounds()
        # A degree of latitude is 111.2 km here, and one of longitude 85.1 km.
        self.assertAlmostEqual(bounds[3] - bounds[2], 187 * 0.00211 * 111.05e3, delta=100)
        self.assertAlmostEqual(bounds[1] - bounds[0], 152 * 0.00275 * 85.17e3, delta=150)
        width, height, _ = source.GetImagery().GetDimensions()
        self.assertAlmostEqual(width, 152 * 0.00275 / 0.0015, delta=1)
        self.assertAlmostEqual(height, 187 * 0.00211 / 0.0015, delta=1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
