# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves patches.md from Python: Bézier cells of files and of NURBS have the shape that VTK's
filters give them."""

import math
import pathlib
import sys
import tempfile
import unittest

import numpy

import relevo
from ErrorMessages import catch_errors
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_BEZIER_CURVE, VTK_BEZIER_QUADRILATERAL
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter


def doubles(values):
    array = vtkDoubleArray()
    for value in values:
        array.InsertNextValue(value)
    return array


def points_of(places):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for place in places:
        points.InsertNextPoint(*place)
    return points


def evaluate(grid, cell, u, v):
    curved = grid.GetCell(cell)
    place, weights = [0.0] * 3, [0.0] * curved.GetNumberOfPoints()
    curved.EvaluateLocation(reference(0), (u, v, 0.0), place, weights)
    return numpy.array(place)


def make_circle():
    """A circle of two cubic halves with the weights 1, 1/3, 1/3, 1."""
    source = relevo.vtkNURBSSource()
    source.SetKnots(0, doubles([0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2]))
    source.SetDimensions(7, 1)
    source.SetControlPoints(points_of(
        [(1, 0, 0), (1, 2, 0), (-1, 2, 0), (-1, 0, 0), (-1, -2, 0), (1, -2, 0), (1, 0, 0)]))
    source.SetWeights(doubles([1, 1 / 3, 1 / 3, 1, 1 / 3, 1 / 3, 1]))
    return source


class TestNURBS(unittest.TestCase):
    def test_circle(self):
        source = make_circle()
        source.Update()
        grid = source.GetOutput()
        self.assertEqual([grid.GetCellType(i) for i in range(grid.GetNumberOfCells())], [VTK_BEZIER_CURVE] * 2)
        self.assertEqual(grid.GetNumberOfPoints(), 6)
        for cell in range(2):
            for u in numpy.linspace(0.0, 1.0, 101):
                self.assertAlmostEqual(math.hypot(*evaluate(grid, cell, u, 0.0)), 1.0, delta=1e-14)

    def test_kept_in_a_file(self):
        """VTK's file format stores everything that the cells need."""
        source = make_circle()
        with tempfile.TemporaryDirectory() as folder:
            name = str(pathlib.Path(folder, "circle.vtu"))
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(name)
            writer.Write()
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(name)
            reader.Update()
        place = evaluate(reader.GetOutput(), 1, 0.3, 0.0)
        self.assertTrue(numpy.array_equal(place, evaluate(source.GetOutput(), 1, 0.3, 0.0)))

    def test_errors(self):
        source = make_circle()
        errors = catch_errors(source)
        catch_errors(source.GetExecutive())
        source.GetWeights().SetValue(2, 0.0)
        source.Update()
        self.assertIn("Weight 2 is 0; weights must be positive and finite.", errors[0])
        self.assertEqual((source.GetOutput().GetNumberOfCells(), len(errors)), (0, 1))
        source.SetWeights(None)
        source.Update()
        self.assertEqual((source.GetOutput().GetNumberOfCells(), len(errors)), (2, 1))
        self.assertIsNone(source.GetOutput().GetPointData().GetArray("RationalWeights"))


class TestPatchFiles(unittest.TestCase):
    TEXT = "1\n1 2\n0 0 0\n1 0 1\n2 0 0\n0 2 1\n1 2 -1\n2 2 1\n"

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = pathlib.Path(self.folder.name, "saddle.bpt")
        self.file.write_text(self.TEXT)
        self.reader = relevo.vtkBezierPatchReader()
        self.reader.SetFileName(str(self.file))

    def test_surface(self):
        self.reader.Update()
        grid = self.reader.GetOutput()
        self.assertEqual(grid.GetCellType(0), VTK_BEZIER_QUADRILATERAL)
        self.assertEqual(vtk_to_numpy(grid.GetCellData().GetHigherOrderDegrees()).tolist(), [[2, 1, 0]])
        # The height is linear in y and quadratic in x.
        self.assertTrue(numpy.allclose(evaluate(grid, 0, 0.5, 0.25), (1.0, 0.5, 0.75 * 0.5), atol=1e-15))
        surface = vtkDataSetSurfaceFilter()
        surface.SetInputConnection(self.reader.GetOutputPort())
        surface.SetNonlinearSubdivisionLevel(3)
        surface.Update()
        bounds = surface.GetOutput().GetBounds()
        self.assertEqual(bounds[:4], (0.0, 2.0, 0.0, 2.0))
        self.assertGreater(surface.GetOutput().GetNumberOfCells(), 32)

    def test_errors(self):
        errors = catch_errors(self.reader)
        catch_errors(self.reader.GetExecutive())
        self.assertEqual(self.reader.CanReadFile(str(self.file)), 1)
        self.file.write_text(self.TEXT.replace("-1", "nan"))
        self.reader.Update()
        self.assertIn(f"{self.file}, line 7: 'nan' is not a finite number.", errors[0])
        self.assertEqual((self.reader.GetOutput().GetNumberOfCells(), len(errors)), (0, 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
