# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves flow.md from Python: vtkAdaptiveLICMapper has the names and defaults of VTK's surface LIC.
Arrays, errors and windows without a display are tested too."""

import sys
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

import relevo
from relevo import arrays
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  makes render windows

# The defaults of vtkSurfaceLICInterface; those of the noise are from vtkLICNoiseSource.
DEFAULTS = {
    "Enable": 1,
    "NumberOfSteps": 20,
    "StepSize": 1.0,
    "NormalizeVectors": 1,
    "EnhancedLIC": 1,
    "EnhanceContrast": 0,
    "LowLICContrastEnhancementFactor": 0.0,
    "HighLICContrastEnhancementFactor": 0.0,
    "LowColorContrastEnhancementFactor": 0.0,
    "HighColorContrastEnhancementFactor": 0.0,
    "AntiAlias": 0,
    "MaskThreshold": 0.0,
    "MaskOnSurface": 0,
    "MaskColor": (0.5, 0.5, 0.5),
    "MaskIntensity": 0.0,
    "LICIntensity": 0.8,
    "MapModeBias": 0.0,
    "NoiseDataSet": None,
    "GenerateNoiseTexture": 1,
    "OrientedLIC": 0,
    "Phase": 0.0,
    "NoDataMagnitude": 1e8,
}
NOISE = (
    "NoiseType",
    "NoiseTextureSize",
    "NoiseGrainSize",
    "MinNoiseValue",
    "MaxNoiseValue",
    "NumberOfNoiseLevels",
    "ImpulseNoiseProbability",
    "ImpulseNoiseBackgroundValue",
    "NoiseGeneratorSeed",
)
CHANGED = {
    "Enable": 0,
    "NumberOfSteps": 7,
    "StepSize": 0.5,
    "NormalizeVectors": 0,
    "EnhancedLIC": 0,
    "EnhanceContrast": 4,
    "LowLICContrastEnhancementFactor": 0.1,
    "HighLICContrastEnhancementFactor": 0.2,
    "LowColorContrastEnhancementFactor": 0.3,
    "HighColorContrastEnhancementFactor": 0.4,
    "AntiAlias": 2,
    "MaskThreshold": 0.25,
    "MaskOnSurface": 1,
    "MaskColor": (0.25, 0.5, 1.0),
    "MaskIntensity": 0.5,
    "LICIntensity": 0.5,
    "MapModeBias": -0.5,
    "GenerateNoiseTexture": 0,
    "OrientedLIC": 1,
    "Phase": 1.75,
    "NoDataMagnitude": 1e6,
    "NoiseType": 2,
    "NoiseTextureSize": 64,
    "NoiseGrainSize": 4,
    "MinNoiseValue": 0.1,
    "MaxNoiseValue": 0.9,
    "NumberOfNoiseLevels": 16,
    "ImpulseNoiseProbability": 0.5,
    "ImpulseNoiseBackgroundValue": 0.25,
    "NoiseGeneratorSeed": 3,
}


def sphere():
    """A sphere with the vectors "Flow" around the z axis."""
    source = vtkSphereSource()
    source.SetThetaResolution(16)
    source.SetPhiResolution(12)
    source.Update()
    mesh = source.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    add_vectors(mesh, numpy.column_stack((-points[:, 1], points[:, 0], 0.5 + 0 * points[:, 0])))
    return mesh


def add_vectors(mesh, values):
    array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=True)
    array.SetName("Flow")
    mesh.GetPointData().SetVectors(array)


class View:
    """A window with one white, unlit actor, which shows only the LIC."""

    def __init__(self, mesh, window=None):
        self.mapper = relevo.vtkAdaptiveLICMapper()
        self.mapper.SetInputData(mesh)
        self.recipe = relevo.vtkAdaptiveRefinement()
        self.recipe.SetMaximumLevel(2)
        self.mapper.SetRefinement(self.recipe)
        self.mapper.SetLICIntensity(1.0)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.actor.GetProperty().LightingOff()
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.window = window or vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(200, 200)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()

    def draw(self):
        """The middle of the picture as grey values in [0, 255], which must be grey."""
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        pixels = arrays.samples(grab.GetOutput()).astype(int)[75:125, 75:125]
        assert (pixels[..., 0] == pixels[..., 2]).all()
        return pixels[..., 0]


class TestAdaptiveLICMapper(unittest.TestCase):
    def test_defaults(self):
        mapper = relevo.vtkAdaptiveLICMapper()
        noise = relevo.vtkLICNoiseSource()
        for name, value in DEFAULTS.items():
            self.assertEqual(getattr(mapper, "Get" + name)(), value, name)
        for name in NOISE:
            self.assertEqual(getattr(mapper, "Get" + name)(), getattr(noise, "Get" + name)(), name)
        self.assertIsNone(mapper.GetNoiseFileName())

    def test_settings(self):
        mapper = relevo.vtkAdaptiveLICMapper()
        for name, value in CHANGED.items():
            getattr(mapper, "Set" + name)(value)
        copy = relevo.vtkAdaptiveLICMapper()
        copy.ShallowCopy(mapper)
        for name, value in CHANGED.items():
            self.assertEqual(getattr(mapper, "Get" + name)(), value, name)
            self.assertEqual(getattr(copy, "Get" + name)(), value, name)
        for mode, number in (("Blend", 0), ("Multiply", 1), ("Map", 1)):
            getattr(mapper, "SetColorModeTo" + mode)()
            self.assertEqual(mapper.GetLICInterface().GetColorMode(), number)
        for mode, number in (("Off", 0), ("LIC", 1), ("Color", 3), ("Both", 4)):
            getattr(mapper, "SetEnhanceContrastTo" + mode)()
            self.assertEqual(mapper.GetEnhanceContrast(), number)
        for name in CHANGED:
            self.assertGreater(len(getattr(mapper, "Set" + name).__doc__), 60, name)

    def test_picture(self):
        view = View(sphere())
        greys = view.draw()
        self.assertGreater(greys.std(), 10)
        self.assertLess(abs(greys.mean() / 255 - 0.33), 0.05)
        self.assertEqual(view.mapper.GetNumberOfConvolutions(), 1)
        self.assertGreater(view.mapper.GetGraphicsMemorySize(), 200 * 200 * 20)

    def test_direction(self):
        mesh = sphere()
        view = View(mesh)
        for axis in (0, 1):  # on the screen x points to the right and y upwards
            values = numpy.zeros((mesh.GetNumberOfPoints(), 3))
            values[:, axis] = 1.0
            add_vectors(mesh, values)
            change = [abs(part).mean() for part in numpy.gradient(view.draw().astype(float))]
            self.assertGreater(change[axis], 1.5 * change[1 - axis])

    def test_noise_of_numpy(self):
        view = View(sphere())
        first = view.draw()
        random = numpy.random.default_rng(1).random((64, 48)).astype(numpy.float32)
        view.mapper.SetNoiseDataSet(arrays.image(random))
        second = view.draw()
        self.assertGreater((first != second).mean(), 0.8)
        self.assertLess(abs(second.mean() / 255 - 0.5), 0.05)
        view.mapper.SetNoiseDataSet(arrays.image(numpy.full((3, 5), 0.25, numpy.float32)))
        self.assertLess(abs(view.draw() - 64).max(), 2)

    def test_no_data(self):
        """All markers of missing data give the same picture, and their values are not used."""
        mesh = sphere()
        good = vtk_to_numpy(mesh.GetPointData().GetVectors()).copy()
        view = View(mesh)
        pictures = []
        for mark in (numpy.nan, -1e9, 1e20, numpy.inf):
            values = good.copy()
            values[::5] = mark
            add_vectors(mesh, values)
            pictures.append(view.draw())
        for picture in pictures[1:]:
            self.assertTrue((picture == pictures[0]).all())
        self.assertGreater((pictures[0] == 255).mean(), 0.1)  # the actor is white

    def test_errors(self):
        mesh = sphere()
        view = View(mesh)
        messages = []

        def keep(_, __, text):
            messages.append(text)

        keep.CallDataType = "string0"
        view.mapper.AddObserver(vtkCommand.ErrorEvent, keep)
        mesh.GetPointData().RemoveArray("Flow")
        self.assertTrue((view.draw() == 255).all())
        view.draw()
        self.assertEqual(len(messages), 1)
        self.assertIn("does not have the array of vectors", messages[0])
        view.mapper.SetStepSize(0)
        self.assertIn("StepSize", messages[1])
        self.assertEqual(view.mapper.GetStepSize(), 1.0)
        with self.assertRaises(TypeError):
            view.mapper.SetStepSize("long")

    def test_without_display(self):
        if not hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
            self.skipTest("built without EGL")
        mesh = sphere()
        expected = View(mesh).draw()
        actual = View(mesh, relevo.vtkEGLOffscreenRenderWindow()).draw()
        self.assertLess((abs(actual - expected) > 2).mean(), 0.01)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
