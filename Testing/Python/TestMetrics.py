# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves guide.md from Python: settings of the depth-tag metrics, levels through the filters,
errors, and docstrings."""

import math
import sys
import unittest

import relevo
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera

NAMES = (
    "vtkCompositeDepthTagMetric", "vtkFieldVariationDepthTagMetric", "vtkRegionDepthTagMetric",
    "vtkScreenEdgeDepthTagMetric", "vtkSilhouetteDepthTagMetric", "vtkViewDependentDepthTagMetric")


def make_triangle():
    """A triangle with edges of 0.8, 0.6 and 1 in the plane z = 0."""
    mesh = vtkPolyData()
    points = vtkPoints()
    for point in ((0, 0, 0), (0.8, 0, 0), (0, 0.6, 0)):
        points.InsertNextPoint(point)
    mesh.SetPoints(points)
    cells = vtkCellArray()
    cells.InsertNextCell(3, (0, 1, 2))
    mesh.SetPolys(cells)
    return mesh


def make_camera():
    """A camera that shows a length of 1 in the plane z = 0 as a quarter of the picture's height."""
    camera = vtkCamera()
    camera.SetPosition(0, 0, 2)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewAngle(90)
    return camera


def levels(metric, mesh, maximum_level=5):
    """The tags of vtkDepthTagFilter for a view of 640 x 400 pixels."""
    tags = relevo.vtkDepthTagFilter()
    tags.SetInputData(mesh)
    tags.SetMetric(metric)
    tags.SetCamera(make_camera())
    tags.SetViewportSize(640, 400)
    tags.SetMaximumLevel(maximum_level)
    tags.Update()
    array = tags.GetOutput().GetPointData().GetArray("DepthTag")
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())]


def sphere(resolution=16):
    """A sphere of radius 1/2."""
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source.GetOutput()


class Errors:
    """Collects the ErrorEvents of an object."""

    def __init__(self, item):
        self.messages = []

        def catch(caller, event, message):
            self.messages.append(message)

        catch.CallDataType = "string0"
        item.AddObserver("ErrorEvent", catch)

    def take(self):
        """Returns the text of the errors so far and clears it."""
        text = "".join(self.messages)
        self.messages.clear()
        return text


class TestMetrics(unittest.TestCase):

    def assertLevels(self, found, expected, places=4):
        self.assertEqual(len(found), len(expected))
        for one, other in zip(found, expected):
            self.assertAlmostEqual(one, other, places=places)

    def test_screen_edge(self):
        metric = relevo.vtkScreenEdgeDepthTagMetric()
        self.assertEqual(metric.GetReferenceLength(), 10)
        self.assertTrue(metric.IsViewDependent())
        self.assertLevels(levels(metric, make_triangle()), (3, math.log2(10), math.log2(10)))
        metric.SetReferenceLength(20)
        self.assertLevels(levels(metric, make_triangle()), (2, math.log2(5), math.log2(5)))
        errors = Errors(metric)
        metric.SetReferenceLength(-1)
        self.assertIn("ReferenceLength", errors.take())
        self.assertEqual(metric.GetReferenceLength(), 20)

    def test_silhouette(self):
        metric = relevo.vtkSilhouetteDepthTagMetric()
        self.assertEqual(metric.GetCriterion(), metric.NORMAL_ANGLE)
        self.assertLevels(
            levels(metric, make_triangle())[:2], (0, 5 * (1 - 2 / math.hypot(2, 0.8))))
        metric.SetCriterionToContour()
        self.assertEqual(metric.GetCriterionAsString(), "Contour")
        self.assertEqual(levels(metric, make_triangle()), [5, 5, 5])
        found = levels(metric, sphere(40))
        self.assertEqual((min(found), max(found)), (0, 5))
        errors = Errors(metric)
        metric.SetContourWidth(2)
        self.assertIn("ContourWidth", errors.take())
        metric.SetCriterion(7)
        self.assertIn("Criterion", errors.take())

    def test_view_dependent(self):
        metric = relevo.vtkViewDependentDepthTagMetric()
        self.assertEqual((metric.GetMaximumSpread(), metric.GetEdgeOnWeight()), (30, 0.5))
        self.assertLevels(levels(metric, make_triangle()), (0, 0, 0))
        mesh = sphere()
        found = levels(metric, mesh)
        heights = [abs(mesh.GetPoint(i)[2]) for i in range(mesh.GetNumberOfPoints())]
        edge = [level for level, height in zip(found, heights) if height < 0.2]
        front = [level for level, height in zip(found, heights) if height > 0.48]
        self.assertGreater(min(edge), max(front))
        errors = Errors(metric)
        metric.SetMaximumSpread(0)
        self.assertIn("MaximumSpread", errors.take())
        metric.SetEdgeOnWeight(-1)
        self.assertIn("EdgeOnWeight", errors.take())

    def test_field_variation(self):
        metric = relevo.vtkFieldVariationDepthTagMetric()
        self.assertFalse(metric.IsViewDependent())
        self.assertEqual(metric.GetArrayName(), "")
        mesh = make_triangle()
        array = vtkDoubleArray()
        array.SetName("height")
        for value in (0, 1, 4):
            array.InsertNextValue(value)
        mesh.GetPointData().AddArray(array)
        metric.SetArrayName("height")
        metric.SetMaximumVariation(1)
        self.assertLevels(levels(metric, mesh, 4), (4, 3, 4))
        array.SetValue(2, math.nan)
        array.Modified()
        self.assertLevels(levels(metric, mesh, 4), (4, 4, 0))
        errors = Errors(metric)
        metric.SetMinimumVariation(2)
        self.assertIn("MinimumVariation", errors.take())

    def test_region(self):
        metric = relevo.vtkRegionDepthTagMetric()
        metric.SetCenter(0.8, 0, 0)
        metric.SetRadius(0.3)
        metric.SetFallOff(1)
        self.assertLevels(levels(metric, make_triangle(), 4), (2, 4, 4 * (0.09 * 3 - 0.027 * 2)))
        plane = vtkPlane()
        plane.SetOrigin(0.2, 0, 0)
        plane.SetNormal(1, 0, 0)
        metric.SetImplicitFunction(plane)
        self.assertIs(metric.GetImplicitFunction(), plane)
        self.assertLevels(levels(metric, make_triangle(), 4), (4, 4 * (0.16 * 3 - 0.064 * 2), 4))
        errors = Errors(metric)
        metric.SetFallOff(-1)
        self.assertIn("FallOff", errors.take())

    def test_composite(self):
        region = relevo.vtkRegionDepthTagMetric()
        region.SetRadius(0.7)
        region.SetFallOff(0.05)
        edges = relevo.vtkScreenEdgeDepthTagMetric()
        metric = relevo.vtkCompositeDepthTagMetric()
        errors = Errors(metric)
        metric.AddMetric(metric)
        self.assertIn("contain itself", errors.take())
        metric.AddMetric(region)
        self.assertFalse(metric.IsViewDependent())
        metric.AddMetric(edges, 1)
        self.assertTrue(metric.IsViewDependent())
        self.assertEqual(metric.GetNumberOfMetrics(), 2)
        self.assertIs(metric.GetMetric(1), edges)
        ten = math.log2(10)
        self.assertLevels(levels(metric, make_triangle()), (5, ten, 5))
        metric.SetModeToProduct()
        self.assertLevels(levels(metric, make_triangle()), (3, 0, ten))
        metric.SetModeToSum()
        self.assertLevels(levels(metric, make_triangle()), (5, ten, 5))
        self.assertEqual(metric.GetModeAsString(), "Sum")

    def test_height_error(self):
        image = vtkImageData()
        image.SetDimensions(33, 33, 1)
        image.AllocateScalars(VTK_FLOAT, 1)
        for j in range(33):
            for i in range(33):
                image.SetScalarComponentFromDouble(i, j, 0, 0, 10 * math.sin(0.3 * i) * j / 32)
        terrain = relevo.vtkTerrainSource()
        terrain.GetHeightMap().SetImageData(image)
        terrain.SetResolution(4)
        terrain.Update()
        faces = terrain.GetOutput().GetNumberOfCells()
        terrain.AlignToSamplesOn()
        terrain.Update()
        # Four squares of 8 texels, and a border of half a texel.
        self.assertEqual((faces, terrain.GetOutput().GetNumberOfCells()), (32, 72))
        metric = relevo.vtkHeightErrorDepthTagMetric()
        self.assertEqual((metric.GetScreenSpaceError(), metric.GetMaximumError()), (1, 0))
        self.assertTrue(metric.IsViewDependent())
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMetric(metric)
        recipe.SetMaximumLevel(6)
        recipe.SetLevelRuleToPerEdge()
        recipe.SetDisplacement(terrain.GetDisplacement())
        refined = relevo.vtkAdaptiveRefinementFilter()
        refined.SetInputConnection(terrain.GetOutputPort())
        refined.SetRefinement(recipe)
        counts = []
        for length in (0.5, 0.05):
            metric.SetMaximumError(length)
            self.assertFalse(metric.IsViewDependent())
            refined.Update()
            mesh = refined.GetOutput()
            counts.append(mesh.GetNumberOfCells())
            uv = mesh.GetPointData().GetTCoords()
            heights = terrain.GetHeightMap()
            for cell in range(mesh.GetNumberOfCells()):
                ids = [mesh.GetCell(cell).GetPointId(k) for k in range(3)]
                u, v = (sum(uv.GetComponent(i, axis) for i in ids) / 3 for axis in range(2))
                z = sum(mesh.GetPoint(i)[2] for i in ids) / 3
                self.assertLess(abs(z - heights.GetHeight(u, v)), 1.001 * length)
        self.assertGreater(counts[1], 2 * counts[0])
        errors = Errors(metric)
        metric.SetMaximumError(-1)
        self.assertIn("MaximumError", errors.take())
        self.assertIn("height map", relevo.vtkHeightErrorDepthTagMetric.__doc__)

    def test_recipe(self):
        for name in NAMES[2:]:
            metric = getattr(relevo, name)()
            if name == "vtkRegionDepthTagMetric":
                metric.SetRadius(0.2)
                metric.SetCenter(0, 0, 0.5)
            recipe = relevo.vtkAdaptiveRefinement()
            recipe.SetMaximumLevel(3)
            recipe.SetMetric(metric)
            refined = relevo.vtkAdaptiveRefinementFilter()
            refined.SetInputData(sphere())
            refined.SetRefinement(recipe)
            refined.SetCamera(make_camera())
            refined.Update()
            coarse = sphere().GetNumberOfCells()
            self.assertGreater(refined.GetOutput().GetNumberOfCells(), coarse, name)
            self.assertLess(refined.GetOutput().GetNumberOfCells(), coarse * 4 ** 3, name)

    def test_documentation(self):
        for name in NAMES:
            documentation = getattr(relevo, name).__doc__
            self.assertIn("MaximumLevel", documentation, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
