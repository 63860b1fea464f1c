# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves flow.md from Python: outputs and settings of vtkSurfaceLineIntegralConvolution,
refinement, errors, and the docstring."""

import math
import unittest

import relevo
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersSources import vtkPlaneSource


def make_plane(vector, resolution=30):
    """The square [-1/2, 1/2]^2 with the vectors "v". Its texture coordinates put the points at
    texel centres."""
    source = vtkPlaneSource()
    source.SetResolution(resolution, resolution)
    source.Update()
    plane = source.GetOutput()
    vectors, coordinates = vtkFloatArray(), vtkFloatArray()
    vectors.SetName("v")
    vectors.SetNumberOfComponents(3)
    coordinates.SetName("uv")
    coordinates.SetNumberOfComponents(2)
    for i in range(plane.GetNumberOfPoints()):
        x, y, _ = plane.GetPoint(i)
        vectors.InsertNextTuple(vector(x, y))
        coordinates.InsertNextTuple(
            [((c + 0.5) * resolution + 0.5) / (resolution + 1) for c in (x, y)]
        )
    plane.GetPointData().SetVectors(vectors)
    plane.GetPointData().SetTCoords(coordinates)
    return plane


def values(array):
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())]


def convolve(mesh, **settings):
    lic = relevo.vtkSurfaceLineIntegralConvolution()
    lic.SetInputData(mesh)
    for name, value in settings.items():
        getattr(lic, "Set" + name)(value)
    lic.Update()
    return lic


class TestSurfaceLineIntegralConvolution(unittest.TestCase):
    def test_streaks_run_along_the_vectors(self):
        n = 31
        lic = convolve(make_plane(lambda x, y: (1, 0, 0)))
        points = lic.GetOutput().GetPointData()
        self.assertEqual(points.GetScalars().GetName(), "LIC")
        self.assertEqual(set(values(points.GetArray("LICMask"))), {0})
        grey = values(points.GetArray("LIC"))
        self.assertTrue(all(0 <= value <= 1 for value in grey))
        along = sum(abs(grey[i] - grey[i + 1]) for i in range(n * n) if i % n < n - 1)
        across = sum(abs(grey[i] - grey[i + n]) for i in range(n * n - n))
        self.assertLess(3 * along, across)

    def test_texture_is_as_the_points(self):
        lic = convolve(make_plane(lambda x, y: (1, 0.3 + y, 0)), TextureSize=(31, 31))
        grey = values(lic.GetOutput().GetPointData().GetArray("LIC"))
        texture = lic.GetOutputDataObject(1)
        self.assertEqual(texture.GetDimensions(), (31, 31, 1))
        for point, texel in zip(grey, values(texture.GetPointData().GetScalars())):
            self.assertAlmostEqual(255 * point, texel, delta=0.6)

    def test_no_data(self):
        mesh = make_plane(lambda x, y: (1, 0, 0) if x < 0.01 else (math.nan, 0, 0))
        mask = values(convolve(mesh).GetOutput().GetPointData().GetArray("LICMask"))
        self.assertEqual(sum(mask), 15 * 31)

    def test_phase_comes_round(self):
        mesh = make_plane(lambda x, y: (-y, x, 0))

        def at(phase):
            return values(convolve(mesh, Phase=phase).GetOutput().GetPointData().GetScalars())

        self.assertEqual(at(0), at(1))
        self.assertNotEqual(at(0), at(0.5))

    def test_refined(self):
        """After the refinement filter, with an array selected by name."""
        metric = relevo.vtkFieldVariationDepthTagMetric()
        metric.SetArrayName("v")
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(2)
        recipe.SetMetric(metric)
        refine = relevo.vtkAdaptiveRefinementFilter()
        refine.SetInputData(make_plane(lambda x, y: (1, math.sin(9 * x * x), 0)))
        refine.SetRefinement(recipe)
        lic = relevo.vtkSurfaceLineIntegralConvolution()
        lic.SetInputConnection(refine.GetOutputPort())
        lic.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "v")
        lic.Update()
        self.assertGreater(lic.GetOutput().GetNumberOfCells(), 3000)
        grey = values(lic.GetOutput().GetPointData().GetScalars())
        self.assertGreater(max(grey) - min(grey), 0.2)

    def test_errors(self):
        plane = make_plane(lambda x, y: (1, 0, 0), 3)
        for setting in ({"NumberOfSteps": 0}, {"StepSize": math.nan}, {"TextureSize": (0, 1)}):
            lic = relevo.vtkSurfaceLineIntegralConvolution()
            errors = []
            lic.AddObserver("ErrorEvent", lambda *_: errors.append(1))
            lic.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
            lic.SetInputData(plane)
            for name, value in setting.items():
                before = getattr(lic, "Get" + name)()
                getattr(lic, "Set" + name)(value)
                self.assertEqual(errors, [1])  # reported at once; the old value stays
                self.assertEqual(getattr(lic, "Get" + name)(), before)
            lic.Update()
            self.assertEqual(errors, [1])
            self.assertEqual(lic.GetOutput().GetNumberOfPoints(), plane.GetNumberOfPoints())
        lic.SetLowLICContrastEnhancementFactor(0.5)
        lic.SetHighLICContrastEnhancementFactor(0.5)  # no range would remain
        lic.Update()
        self.assertEqual(errors, [1, 1])
        self.assertEqual(lic.GetOutput().GetNumberOfPoints(), 0)

    def test_documentation(self):
        text = relevo.vtkSurfaceLineIntegralConvolution.__doc__
        for word in ("Nellmeldin", "LICMask", "vtkScreenEdgeDepthTagMetric", "error"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main(argv=["TestSurfaceLineIntegralConvolution"])
