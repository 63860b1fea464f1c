# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves flow.md from Python: vtkGeographicVectors for a terrain with wind and for rasters, errors,
and docstrings."""

import math
import os
import pathlib
import sys
import unittest

import relevo
from ErrorMessages import catch_errors
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData

RELIEF = pathlib.Path(os.environ.get("RELEVO_TEST_DATA", ""), "relief")


def make_array(name, tuples):
    array = vtkFloatArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(tuples[0]))
    for values in tuples:
        array.InsertNextTuple(values)
    return array


class TestGeographicVectors(unittest.TestCase):
    def test_defaults(self):
        vectors = relevo.vtkGeographicVectors()
        self.assertEqual(vectors.GetNumberOfInputPorts(), 2)
        self.assertEqual(vectors.GetExaggeration(), 1.0)
        self.assertEqual(vectors.GetOrigin(), (0.0, 0.0, 0.0))
        self.assertEqual(vectors.GetCoordinateSystem(), "")
        self.assertEqual(vectors.GetOutputArrayName(), "")
        self.assertIsNone(vectors.GetTerrain())
        for words in ("convergence", "LocalCartesian", "missing", "error", "1e8"):
            self.assertIn(words, relevo.vtkGeographicVectors.__doc__)

    def test_raster(self):
        """An image of west wind over a terrain without georeference."""
        heights = vtkImageData()
        heights.SetDimensions(8, 6, 1)
        heights.GetPointData().SetScalars(make_array("Heights", [(0.0,)] * 48))
        terrain = relevo.vtkTerrainSource()
        terrain.GetHeightMap().SetImageData(heights)
        wind = vtkImageData()
        wind.SetDimensions(2, 2, 1)
        wind.GetPointData().AddArray(
            make_array("Wind", [(2.0, 0.0), (2.0, 0.0), (2.0, 0.0), (math.nan, 0.0)]))
        vectors = relevo.vtkGeographicVectors()
        vectors.SetTerrain(terrain)
        vectors.SetInputConnection(terrain.GetOutputPort())
        vectors.SetRasterData(wind)
        vectors.Update()
        mesh = vectors.GetOutput()
        result = mesh.GetPointData().GetVectors()
        self.assertEqual(result.GetName(), "Wind")
        self.assertEqual(result.GetNumberOfComponents(), 3)
        for i in range(mesh.GetNumberOfPoints()):
            u, v = mesh.GetPointData().GetTCoords().GetTuple2(i)
            if u > 0.25 and v > 0.25:  # the north-eastern sample contributes
                self.assertTrue(all(map(math.isnan, result.GetTuple3(i))))
            else:
                self.assertEqual(result.GetTuple3(i), (2.0, 0.0, 0.0))

    def test_errors(self):
        terrain = relevo.vtkTerrainSource()
        heights = vtkImageData()
        heights.SetDimensions(2, 2, 1)
        heights.GetPointData().SetScalars(make_array("Heights", [(0.0,)] * 4))
        terrain.GetHeightMap().SetImageData(heights)
        vectors = relevo.vtkGeographicVectors()
        errors = catch_errors(vectors)
        executive = catch_errors(vectors.GetExecutive())
        vectors.SetInputConnection(terrain.GetOutputPort())
        vectors.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Wind")
        vectors.Update()
        self.assertIn('named "Wind"', errors[-1])
        self.assertEqual(len(errors), 1)
        self.assertEqual(len(executive), 1)
        self.assertEqual(vectors.GetOutput().GetNumberOfPoints(), 0)

    def test_real_relief(self):
        """South wind on UTM follows the meridians."""
        if not (RELIEF / "SainteHelens.dem").exists():
            self.skipTest("no relief in RELEVO_TEST_DATA")
        terrain = relevo.vtkTerrainSource()
        terrain.SetFileName(RELIEF / "SainteHelens.dem")
        terrain.SetResolution(8)
        terrain.Update()
        if not terrain.GetCoordinateSystem():
            self.skipTest("a build without GDAL")
        wind = vtkImageData()
        wind.SetDimensions(2, 2, 1)
        wind.GetPointData().AddArray(make_array("Wind", [(0.0, 10.0, 0.5)] * 4))
        terrain.SetExaggeration(2.0)
        vectors = relevo.vtkGeographicVectors()
        vectors.SetTerrain(terrain)
        vectors.SetInputConnection(terrain.GetOutputPort())
        vectors.SetRasterData(wind)
        vectors.Update()
        mesh = vectors.GetOutput()
        for i in range(mesh.GetNumberOfPoints()):
            x, y, z = mesh.GetPointData().GetVectors().GetTuple3(i)
            self.assertAlmostEqual(math.hypot(x, y), 10.0, places=5)
            self.assertEqual(z, 1.0)
            # UTM zone 10, about 123 W: the crater is at 122.188 W, 46.2 N, and a degree has 77 km.
            east = 562710.0 + mesh.GetPoint(i)[0] - 500000.0
            longitude = math.radians(east / 0.9996 / 111320.0 / math.cos(math.radians(46.19)))
            convergence = math.atan(math.tan(longitude) * math.sin(math.radians(46.19)))
            self.assertAlmostEqual(math.atan2(x, y), -convergence, delta=1e-4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
