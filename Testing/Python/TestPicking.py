# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves guide.md from Python: VTK's pickers work on refined and displaced surfaces."""

# Imported before relevo: pickers do not depend on it.
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCellPicker, vtkPointPicker, vtkPropPicker, vtkRenderer, vtkRenderWindow)

import math
import unittest

import numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: the implementation of windows

import relevo


def show(mesh, recipe):
    """The renderer of a window that shows a refined mesh from above."""
    mapper = relevo.vtkAdaptiveRefinementMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(200, 200)
    window.AddRenderer(renderer)
    window.Render()
    return renderer, window, mapper


class TestPicking(unittest.TestCase):
    def test_sphere(self):
        source = vtkSphereSource()
        source.Update()
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(5)
        recipe.SetSurface(relevo.vtkPNTriangleSurface())
        mesh = source.GetOutput()
        renderer, _window, mapper = show(mesh, recipe)
        picker = vtkCellPicker()
        flattest = 1.0
        for x in range(70, 131, 7):
            for y in range(70, 131, 7):
                self.assertTrue(picker.Pick(x, y, 0, renderer))
                p = numpy.array(picker.GetPickPosition())
                radius = math.sqrt(p @ p)
                self.assertLess(abs(radius - 0.5), 0.004)
                self.assertGreater(numpy.array(picker.GetPickNormal()) @ p / radius, 0.995)
                self.assertLess(picker.GetCellId(), mesh.GetNumberOfCells())
                flattest = min(flattest, radius)
        self.assertGreater(flattest, 0.496)
        self.assertIs(picker.GetMapper(), mapper)
        self.assertTrue(picker.GetDataSet().IsA("vtkPolyData"))
        self.assertEqual(picker.GetDataSet().GetNumberOfCells(), mesh.GetNumberOfCells())
        self.assertIs(mapper.GetInput(), mesh)

    def test_displaced(self):
        source = vtkPlaneSource()
        source.SetResolution(4, 4)
        source.Update()
        displacement = relevo.vtkDisplacement()
        displacement.SetOffset(2.0)
        displacement.SetDirection(0, 0, 1)
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetDisplacement(displacement)
        renderer, window, _mapper = show(source.GetOutput(), recipe)
        for picker in (vtkCellPicker(), vtkPointPicker(), vtkPropPicker()):
            if isinstance(picker, vtkPointPicker):
                picker.SetTolerance(0.1)
            self.assertTrue(picker.Pick(100, 100, 0, renderer))
            self.assertAlmostEqual(picker.GetPickPosition()[2], 2.0, 2)
        displacement.SetOffset(-1.0)
        renderer.ResetCameraClippingRange()
        window.Render()
        picker = vtkCellPicker()
        self.assertTrue(picker.Pick(100, 100, 0, renderer))
        self.assertAlmostEqual(picker.GetPickPosition()[2], -1.0, 5)

    def test_locator(self):
        source = vtkSphereSource()
        source.Update()
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(5)
        recipe.SetSurface(relevo.vtkPNTriangleSurface())
        locator = relevo.vtkRefinedCellLocator()
        locator.SetDataSet(source.GetOutput())
        locator.SetRefinement(recipe)
        t = reference(0.0)
        x = [0.0, 0.0, 0.0]
        sub_id = reference(0)
        cell_id = reference(0)
        self.assertEqual(locator.IntersectWithLine(
            (0.1, 0.2, 5), (0.1, 0.2, 0), 0.0, t, x, [0.0] * 3, sub_id, cell_id,
            vtkGenericCell()), 1)
        self.assertLess(abs(math.dist(x, (0, 0, 0)) - 0.5), 0.004)
        nearest = [0.0, 0.0, 0.0]
        distance2 = reference(0.0)
        locator.FindClosestPoint((0.0, 3.0, 0.0), nearest, cell_id, sub_id, distance2)
        self.assertLess(abs(math.sqrt(distance2) - 2.5), 0.004)


if __name__ == "__main__":
    unittest.main(argv=["TestPicking"])
