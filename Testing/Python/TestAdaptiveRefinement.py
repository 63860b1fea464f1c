# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves guide.md from Python: settings and output of recipe and filter, errors by observer, and
docstrings."""

import math
import unittest

import relevo
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_ID_TYPE, vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera


def make(source):
    source.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(source.GetOutput())
    return mesh


def add_tags(mesh, tags):
    array = vtkFloatArray()
    array.SetName("DepthTag")
    for tag in tags:
        array.InsertNextValue(tag)
    mesh.GetPointData().AddArray(array)


class TestAdaptiveRefinement(unittest.TestCase):

    def setUp(self):
        self.recipe = relevo.vtkAdaptiveRefinement()
        self.filter = relevo.vtkAdaptiveRefinementFilter()
        self.filter.SetRefinement(self.recipe)
        self.messages = []

        def catch(caller, event, message):
            self.messages.append(message)

        catch.CallDataType = "string0"
        self.catch = catch
        self.filter.AddObserver("ErrorEvent", catch)
        self.filter.AddObserver("WarningEvent", catch)

    def refine(self, mesh):
        self.filter.SetInputData(mesh)
        self.filter.Update()
        return self.filter.GetOutput()

    def test_uniform(self):
        mesh = make(vtkSphereSource())
        for level in range(5):
            self.recipe.SetMaximumLevel(level)
            output = self.refine(mesh)
            self.assertEqual(output.GetNumberOfPolys(), mesh.GetNumberOfPolys() * 4**level)
        ids = output.GetCellData().GetArray("vtkOriginalCellIds")
        self.assertEqual(ids.GetDataType(), VTK_ID_TYPE)
        self.assertEqual(ids.GetRange(), (0.0, mesh.GetNumberOfPolys() - 1.0))
        self.assertEqual(output.GetPointData().GetNormals().GetName(), "Normals")
        self.assertEqual(self.messages, [])

    def test_tags(self):
        mesh = make(vtkPlaneSource())
        add_tags(mesh, [0, 1, 2, 3])
        output = self.refine(mesh)
        # Edges on the border: the means 0.5, 1, 2 and 2.5 are the levels 1, 1, 2 and 3.
        bottom = [i for i in range(output.GetNumberOfPoints())
                  if output.GetPoint(i)[1] == -0.5]
        top = [i for i in range(output.GetNumberOfPoints()) if output.GetPoint(i)[1] == 0.5]
        self.assertEqual((len(bottom), len(top)), (3, 9))
        self.recipe.SetDepthTagArrayName("")
        self.recipe.SetMaximumLevel(1)
        self.assertEqual(self.refine(mesh).GetNumberOfPolys(), 8)

    def test_surface_and_displacement(self):
        surface = relevo.vtkPNTriangleSurface()
        self.recipe.SetSurface(surface)
        self.recipe.SetMaximumLevel(3)
        source = vtkSphereSource()
        source.SetThetaResolution(12)
        source.SetPhiResolution(10)
        output = self.refine(make(source))
        for i in range(output.GetNumberOfPoints()):
            self.assertAlmostEqual(math.hypot(*output.GetPoint(i)), 0.5, delta=2e-3)

        image = vtkImageData()
        image.SetDimensions(2, 2, 1)
        image.AllocateScalars(VTK_FLOAT, 1)
        for y in range(2):
            for x in range(2):
                image.SetScalarComponentFromDouble(x, y, 0, 0, 1.0 + x)
        if not hasattr(relevo, "vtkHeightMap"):
            self.skipTest("built without Relevo::FiltersTerrain")
        heights = relevo.vtkHeightMap()
        heights.SetImageData(image)
        displacement = relevo.vtkDisplacement()
        displacement.SetHeightMap(heights)
        displacement.SetScale(2.0)
        displacement.SetOffset(0.5)
        displacement.SetDirection(0.0, 0.0, 3.0)
        self.assertEqual(displacement.GetDirection(), (0.0, 0.0, 1.0))
        self.recipe.SetDisplacement(displacement)
        output = self.refine(make(vtkPlaneSource()))
        self.assertEqual(self.messages, [])
        bounds = output.GetBounds()
        self.assertAlmostEqual(bounds[4], 2.5, places=5)
        self.assertAlmostEqual(bounds[5], 4.5, places=5)
        self.assertEqual(self.recipe.GetSurface(), surface)
        self.assertEqual(self.recipe.GetDisplacement(), displacement)

    def test_camera(self):
        metric = relevo.vtkDistanceDepthTagMetric()
        metric.SetMaximumDistance(3.0)
        self.recipe.SetMetric(metric)
        camera = vtkCamera()
        self.filter.SetCamera(camera)
        self.filter.SetViewportSize(640, 480)
        self.assertEqual(self.filter.GetViewportSize(), (640, 480))
        mesh = make(vtkSphereSource())
        counts = []
        for distance in (1.0, 2.0, 10.0):
            camera.SetPosition(0.0, 0.0, distance)
            counts.append(self.refine(mesh).GetNumberOfPolys())
        self.assertGreater(counts[0], counts[1])
        self.assertEqual(counts[2], mesh.GetNumberOfPolys())

    def test_errors(self):
        mesh = make(vtkSphereSource())
        add_tags(mesh, [1.0, 2.0])
        self.assertEqual(self.refine(mesh).GetNumberOfPoints(), 0)
        self.assertIn("DepthTag", "".join(self.messages))
        self.messages.clear()
        self.filter.SetRefinement(None)
        self.filter.Update()
        self.assertIn("SetRefinement", "".join(self.messages))
        self.messages.clear()
        self.recipe.AddObserver("ErrorEvent", self.catch)
        self.recipe.SetMaximumLevel(8)
        self.assertIn("MaximumLevel", "".join(self.messages))
        self.assertEqual(self.recipe.GetMaximumLevel(), 3)

    def test_documentation(self):
        for name in ("vtkAdaptiveRefinement", "vtkAdaptiveRefinementFilter", "vtkDisplacement",
                     "vtkLinearSurface", "vtkPNTriangleSurface"):
            self.assertGreater(len(getattr(relevo, name).__doc__), 100, name)
            self.assertIn(name, repr(getattr(relevo, name)()))
        self.assertIn("0 to 7", relevo.vtkAdaptiveRefinement.SetMaximumLevel.__doc__)
        self.assertIn("Vlachos", relevo.vtkPNTriangleSurface.__doc__)


if __name__ == "__main__":
    unittest.main(argv=["TestAdaptiveRefinement"])
