# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkDepthTagFilter promises, from Python: every setting, the arrays, errors by observer, and
docstrings."""

import math
import sys
import unittest

import relevo
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera


def make_square(points=((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0))):
    """Two triangles with four points."""
    mesh = vtkPolyData()
    coordinates = vtkPoints()
    for point in points:
        coordinates.InsertNextPoint(point)
    mesh.SetPoints(coordinates)
    cells = vtkCellArray()
    for triangle in ((0, 1, 2), (2, 1, 3)):
        cells.InsertNextCell(3, triangle)
    mesh.SetPolys(cells)
    return mesh


def values(array):
    """The tuples of a data array as a list."""
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


class Errors:
    """Collects the ErrorEvents of objects."""

    def __init__(self, *objects):
        self.messages = []

        def catch(caller, event, message):
            self.messages.append(message)

        catch.CallDataType = "string0"
        for item in objects:
            item.AddObserver("ErrorEvent", catch)

    def take(self):
        """Returns the text of the errors so far and clears it."""
        text = "".join(self.messages)
        self.messages.clear()
        return text


class TestDepthTags(unittest.TestCase):

    def test_distance(self):
        metric = relevo.vtkDistanceDepthTagMetric()
        self.assertTrue(metric.IsViewDependent())
        self.assertEqual(metric.GetMaximumDistance(), 0.0)
        metric.SetMaximumDistance(4)
        camera = vtkCamera()
        camera.SetPosition(0, 0, 0)
        tags = relevo.vtkDepthTagFilter()
        tags.SetInputData(make_square())
        tags.SetMetric(metric)
        tags.SetCamera(camera)
        tags.SetViewportSize(640, 480)
        tags.SetMaximumLevel(4)
        self.assertIs(tags.GetMetric(), metric)
        self.assertIs(tags.GetCamera(), camera)
        self.assertEqual(tags.GetViewportSize(), (640, 480))
        tags.Update()
        output = tags.GetOutput()
        levels = values(output.GetPointData().GetArray("DepthTag"))
        for (level,), expected in zip(levels, (4, 3, 3, 4 - math.sqrt(2))):
            self.assertAlmostEqual(level, expected, places=6)
        # The means are 3.5, 3, 3.5 and 3, 2.79, 2.79.
        self.assertEqual(
            values(output.GetCellData().GetArray("EdgeLevels")), [(4, 3, 4), (3, 3, 3)])

        # Per edge, the tag of the nearer end.
        self.assertEqual(tags.GetLevelRule(), relevo.vtkDepthTagMetric.PER_VERTEX)
        tags.SetLevelRuleToPerEdge()
        self.assertEqual(tags.GetLevelRule(), relevo.vtkDepthTagMetric.PER_EDGE)
        tags.Update()
        self.assertEqual(
            values(tags.GetOutput().GetCellData().GetArray("EdgeLevels")),
            [(4, 3, 4), (3, 3, 3)])

    def test_distance_options(self):
        metric = relevo.vtkDistanceDepthTagMetric()
        metric.SetMaximumDistance(4)
        metric.SetFallOffToProjectedSize()
        self.assertEqual(metric.GetFallOff(), metric.PROJECTED_SIZE)
        self.assertEqual(metric.GetFallOffAsString(), "ProjectedSize")
        camera = vtkCamera()
        camera.SetPosition(0, 0, 2)
        tags = relevo.vtkDepthTagFilter()
        tags.SetMaximumLevel(5)
        tags.SetInputData(make_square())
        tags.SetMetric(metric)
        tags.SetCamera(camera)
        tags.Update()
        levels = values(tags.GetOutput().GetPointData().GetArray("DepthTag"))
        self.assertAlmostEqual(levels[0][0], 1, places=6)
        self.assertAlmostEqual(levels[1][0], math.log2(4 / math.sqrt(5)), places=6)
        metric.SetMeasureToCentroids()
        self.assertEqual(metric.GetMeasureAsString(), "Centroids")
        tags.Update()
        levels = values(tags.GetOutput().GetPointData().GetArray("DepthTag"))
        self.assertAlmostEqual(levels[0][0], levels[1][0], places=6)
        metric.SetMaximumDistance(0)
        metric.SetReferenceLength(8)
        self.assertEqual(metric.GetReferenceLength(), 8)
        tags.SetViewportSize(600, 400)
        tags.Update()
        self.assertGreater(
            tags.GetOutput().GetPointData().GetArray("DepthTag").GetRange()[0], 3)

    def test_curvature(self):
        sphere = vtkSphereSource()
        sphere.SetRadius(2)
        sphere.SetThetaResolution(60)
        sphere.SetPhiResolution(60)
        metric = relevo.vtkCurvatureDepthTagMetric()
        self.assertFalse(metric.IsViewDependent())
        metric.SetCurvatureTypeToMean()
        self.assertEqual(metric.GetCurvatureType(), metric.MEAN)
        self.assertEqual(metric.GetCurvatureTypeAsString(), "Mean")
        metric.SetMinimumCurvature(0.25)
        metric.SetMaximumCurvature(0.75)
        tags = relevo.vtkDepthTagFilter()
        tags.SetInputConnection(sphere.GetOutputPort())
        tags.SetMetric(metric)
        tags.SetMaximumLevel(6)
        tags.Update()
        low, high = tags.GetOutput().GetPointData().GetArray("DepthTag").GetRange()
        self.assertGreater(low, 2.95)
        self.assertLess(high, 3.05)

        metric.SetQuantiles(0.25, 0.75)
        self.assertEqual(metric.GetQuantiles(), (0.25, 0.75))
        curvatures = vtkDoubleArray()
        metric.ComputeCurvatures(sphere.GetOutput(), curvatures)
        self.assertEqual(curvatures.GetName(), "Mean_Curvature")
        self.assertEqual(
            curvatures.GetNumberOfTuples(), sphere.GetOutput().GetNumberOfPoints())
        self.assertAlmostEqual(curvatures.GetValue(100), 0.5, places=2)
        metric.SetCurvatureTypeToGaussian()
        metric.ComputeCurvatures(sphere.GetOutput(), curvatures)
        self.assertEqual(curvatures.GetName(), "Gauss_Curvature")
        self.assertAlmostEqual(curvatures.GetValue(1000), 0.25, places=2)

    def test_own_array(self):
        mesh = make_square()
        own = vtkFloatArray()
        own.SetName("DepthTag")
        for tag in (0, 1, 2, 9):
            own.InsertNextValue(tag)
        mesh.GetPointData().AddArray(own)
        tags = relevo.vtkDepthTagFilter()
        tags.SetMaximumLevel(5)
        tags.SetInputData(mesh)
        tags.Update()
        output = tags.GetOutput()
        self.assertEqual(
            values(output.GetPointData().GetArray("DepthTag")), [(0,), (1,), (2,), (9,)])
        self.assertEqual(
            values(output.GetCellData().GetArray("EdgeLevels")), [(1, 2, 1), (2, 5, 5)])

    def test_errors(self):
        tags = relevo.vtkDepthTagFilter()
        tags.SetInputData(make_square())
        distance = relevo.vtkDistanceDepthTagMetric()
        curvature = relevo.vtkCurvatureDepthTagMetric()
        errors = Errors(tags, distance, curvature)
        Errors(tags.GetExecutive())

        tags.Update()
        self.assertIn("no metric", errors.take())
        self.assertEqual(tags.GetOutput().GetNumberOfPoints(), 0)
        tags.SetMetric(distance)
        tags.Update()
        self.assertIn("SetCamera", errors.take())
        self.assertEqual(tags.GetOutput().GetNumberOfPoints(), 0)
        for level in (-1, 8):
            tags.SetMaximumLevel(level)
            self.assertIn("MaximumLevel must be in [0, 7], got %d" % level, errors.take())
        self.assertEqual(tags.GetMaximumLevel(), 3)
        tags.SetViewportSize(0, 0)
        self.assertIn("ViewportSize", errors.take())
        for value in (-1.0, math.nan, math.inf):
            distance.SetMaximumDistance(value)
            self.assertIn("MaximumDistance", errors.take())
            curvature.SetMaximumCurvature(value)
            self.assertIn("MaximumCurvature", errors.take())
        distance.SetReferenceLength(-1)
        self.assertIn("ReferenceLength", errors.take())
        curvature.SetQuantiles(0.5, 0.5)
        self.assertIn("Quantiles", errors.take())
        curvature.SetCurvatureType(5)
        self.assertIn("CurvatureType", errors.take())

        tags.SetMetric(curvature)
        tags.Update()
        self.assertEqual(errors.take(), "")
        self.assertEqual(tags.GetOutput().GetNumberOfPoints(), 4)

    def test_documentation(self):
        for name in (
                "vtkDepthTagFilter", "vtkDistanceDepthTagMetric", "vtkCurvatureDepthTagMetric"):
            documentation = getattr(relevo, name).__doc__
            self.assertIn("MaximumLevel", documentation)
        self.assertIn("MaximumLevel * (1 - x / d)", relevo.vtkDistanceDepthTagMetric.__doc__)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
