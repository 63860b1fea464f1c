# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkLICSettings promises, from Python: the complete interface of VTK's vtkSurfaceLICInterface,
ranges, sharing, and scripts for vtkSurfaceLICMapper."""

import math
import sys
import unittest

import relevo
from ErrorMessages import catch_errors
from vtkmodules.vtkCommonCore import VTK_COLOR_MODE_DEFAULT, vtkObject
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkArrayCalculator
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

if not hasattr(relevo, "vtkAdaptiveLICMapper"):
    print("skipped: built without rendering")
    sys.exit(125)

import vtkmodules.vtkRenderingOpenGL2  # noqa: E402,F401  makes render windows

# From vtkSurfaceLICInterface in VTK 9.1: defaults, switches with ...On() and ...Off(), and
# constants.
DEFAULTS = {
    "Enable": 1,
    "NumberOfSteps": 20,
    "StepSize": 1.0,
    "NormalizeVectors": 1,
    "MaskOnSurface": 0,
    "MaskThreshold": 0.0,
    "MaskColor": (0.5, 0.5, 0.5),
    "MaskIntensity": 0.0,
    "EnhancedLIC": 1,
    "EnhanceContrast": 0,
    "LowLICContrastEnhancementFactor": 0.0,
    "HighLICContrastEnhancementFactor": 0.0,
    "LowColorContrastEnhancementFactor": 0.0,
    "HighColorContrastEnhancementFactor": 0.0,
    "AntiAlias": 0,
    "ColorMode": 0,
    "LICIntensity": 0.8,
    "MapModeBias": 0.0,
    "NoiseDataSet": None,
    "NoiseType": 1,
    "NoiseTextureSize": 200,
    "NoiseGrainSize": 1,
    "MinNoiseValue": 0.0,
    "MaxNoiseValue": 0.8,
    "NumberOfNoiseLevels": 256,
    "ImpulseNoiseProbability": 1.0,
    "ImpulseNoiseBackgroundValue": 0.0,
    "NoiseGeneratorSeed": 1,
    "CompositeStrategy": 3,
}
OTHER_DEFAULTS = {"GenerateNoiseTexture": 1}  # 0 in VTK
ADDED = {"OrientedLIC": 0, "Phase": 0.0, "NoDataMagnitude": 1e8, "NoiseFileName": None}
SWITCHES = ("Enable", "NormalizeVectors", "MaskOnSurface", "EnhancedLIC", "AntiAlias")
CONSTANTS = {
    "ENHANCE_CONTRAST_OFF": 0,
    "ENHANCE_CONTRAST_LIC": 1,
    "ENHANCE_CONTRAST_COLOR": 3,
    "ENHANCE_CONTRAST_BOTH": 4,
    "COLOR_MODE_BLEND": 0,
    "COLOR_MODE_MAP": 1,
    "NOISE_TYPE_UNIFORM": 0,
    "NOISE_TYPE_GAUSSIAN": 1,
    "NOISE_TYPE_PERLIN": 2,
    "COMPOSITE_INPLACE": 0,
    "COMPOSITE_INPLACE_DISJOINT": 1,
    "COMPOSITE_BALANCED": 2,
    "COMPOSITE_AUTO": 3,
}
# Not settings: VTK's mapper and its stages call these.
STAGES = ("SetHasVectors", "GetHasVectors", "GetCommunicator", "GetGlobalMinMax")

BAD = {
    "NumberOfSteps": (0, -1, 100001),
    "StepSize": (0, -1, math.nan, math.inf),
    "MaskThreshold": (math.nan,),
    "MaskColor": ((0, 0, 1.5), (-0.1, 0, 0), (math.nan, 0, 0)),
    "MaskIntensity": (-0.1, 1.1),
    "EnhanceContrast": (-1, 2, 5),
    "LowLICContrastEnhancementFactor": (-1.1, 1.1),
    "HighLICContrastEnhancementFactor": (-1.1, 1.1),
    "LowColorContrastEnhancementFactor": (-1.1, 1.1),
    "HighColorContrastEnhancementFactor": (-1.1, 1.1),
    "AntiAlias": (-1, 1001),
    "LICIntensity": (-0.1, 1.1, math.nan),
    "MapModeBias": (-1.1, 1.1),
    "NoiseType": (-1, 3),
    "NoiseTextureSize": (1, 16385),
    "NoiseGrainSize": (0, 16384),
    "MinNoiseValue": (-0.1, 1.1),
    "MaxNoiseValue": (-0.1, 1.1),
    "NumberOfNoiseLevels": (1,),
    "ImpulseNoiseProbability": (-0.1, 1.1),
    "ImpulseNoiseBackgroundValue": (-0.1, 1.1),
    "Phase": (math.nan, math.inf),
    "NoDataMagnitude": (0, -1, math.nan),
}
ONLY_OF_SETTINGS = {"ColorMode": (-1, 2), "CompositeStrategy": (-1, 4)}

# A script for VTK.
SCRIPT = """
mapper = vtkSurfaceLICMapper()
mapper.SetInputData(mesh)
mapper.SetInputArrayToProcess(0, 0, 0, 0, "Flow")
mapper.ScalarVisibilityOff()
mapper.SetColorModeToDefault()
lic = mapper.GetLICInterface()
lic.EnableOn()
lic.SetNumberOfSteps(40)
lic.SetStepSize(0.5)
lic.NormalizeVectorsOn()
lic.EnhancedLICOn()
lic.SetEnhanceContrast(lic.ENHANCE_CONTRAST_BOTH)
lic.SetLowLICContrastEnhancementFactor(0.05)
lic.SetHighLICContrastEnhancementFactor(0.05)
lic.SetLowColorContrastEnhancementFactor(0.02)
lic.SetHighColorContrastEnhancementFactor(0.02)
lic.AntiAliasOn()
lic.SetColorMode(lic.COLOR_MODE_MAP)
lic.SetLICIntensity(0.8)
lic.SetMapModeBias(0.1)
lic.MaskOnSurfaceOff()
lic.SetMaskThreshold(0.1)
lic.SetMaskColor(1, 0, 0)
lic.SetMaskIntensity(0.5)
lic.SetGenerateNoiseTexture(1)
lic.SetNoiseType(lic.NOISE_TYPE_PERLIN)
lic.SetNoiseTextureSize(128)
lic.SetNoiseGrainSize(4)
lic.SetMinNoiseValue(0.1)
lic.SetMaxNoiseValue(0.9)
lic.SetNumberOfNoiseLevels(1024)
lic.SetImpulseNoiseProbability(1)
lic.SetImpulseNoiseBackgroundValue(0)
lic.SetNoiseGeneratorSeed(3)
lic.SetNoiseDataSet(None)
lic.SetCompositeStrategy(lic.COMPOSITE_BALANCED)
"""


def make_mesh():
    """A sphere with the vectors "Flow" around the z axis."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(12)
    flow = vtkArrayCalculator()
    flow.SetInputConnection(sphere.GetOutputPort())
    flow.AddCoordinateVectorVariable("p")
    flow.SetFunction("cross(kHat, p) + 0.2*iHat")
    flow.SetResultArrayName("Flow")
    flow.Update()
    return flow.GetOutput()


def draw(mapper):
    """The picture as bytes."""
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(150, 150)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    scalars = grab.GetOutput().GetPointData().GetScalars()
    return bytes(memoryview(scalars))


class TestLICSettings(unittest.TestCase):
    def test_all_of_vtk(self):
        """Everything that a script can set and get in VTK."""
        settings = relevo.vtkLICSettings()
        for name, value in {**DEFAULTS, **OTHER_DEFAULTS, **ADDED}.items():
            self.assertEqual(getattr(settings, "Get" + name)(), value, name)
            self.assertTrue(callable(getattr(settings, "Set" + name)), name)
            self.assertGreater(len(getattr(settings, "Set" + name).__doc__), 80, name)
        for name in SWITCHES:
            for switch, value in (("Off", 0), ("On", 1)):
                getattr(settings, name + switch)()
                self.assertEqual(getattr(settings, "Get" + name)(), value, name)
        for name, value in CONSTANTS.items():
            self.assertEqual(getattr(settings, name), value, name)

    def test_against_vtk(self):
        """The same by introspection, if VTK has the class."""
        try:
            from vtkmodules.vtkRenderingLICOpenGL2 import vtkSurfaceLICInterface
        except ImportError:
            self.skipTest("VTK without RenderingLICOpenGL2")
        theirs = vtkSurfaceLICInterface()
        ours = relevo.vtkLICSettings()
        for name in set(dir(theirs)) - set(dir(vtkObject())) - set(STAGES):
            if name.isupper():
                self.assertEqual(getattr(ours, name, None), getattr(theirs, name), name)
            elif name.startswith(("Set", "Get")) or name.endswith(("On", "Off")):
                self.assertTrue(hasattr(ours, name), name)
            # Without NoiseDataSet, VTK returns its default image.
            if name.startswith("Get") and name[3:] not in (*OTHER_DEFAULTS, "NoiseDataSet"):
                self.assertEqual(getattr(ours, name)(), getattr(theirs, name)(), name)

    def test_ranges(self):
        """A value out of range gives one error of the object called, and the old value stays."""
        mapper = relevo.vtkAdaptiveLICMapper()
        for holder, bad in (
            (relevo.vtkLICSettings(), {**BAD, **ONLY_OF_SETTINGS}),
            (mapper, BAD),
            (relevo.vtkLineIntegralConvolution(), BAD),
            (relevo.vtkSurfaceLineIntegralConvolution(), BAD),
        ):
            messages = catch_errors(holder)
            others = catch_errors(mapper.GetLICInterface())
            count = 0
            for name, values in bad.items():
                if not hasattr(holder, "Set" + name):
                    continue
                before = getattr(holder, "Get" + name)()
                for value in values:
                    if name == "StepSize" and value == 0 and before == 0:
                        continue  # automatic
                    getattr(holder, "Set" + name)(value)
                    self.assertEqual(len(messages), 1, (name, value))
                    self.assertIn(name + " must be ", messages.pop())
                    self.assertEqual(getattr(holder, "Get" + name)(), before, name)
                    count += 1
            self.assertEqual(others, [])
            self.assertGreater(count, 15)

    def test_script(self):
        """A script for vtkSurfaceLICMapper with only the class name changed gives the same picture
        as the mapper's setters."""
        mesh = make_mesh()
        names = {"mesh": mesh, "vtkSurfaceLICMapper": relevo.vtkAdaptiveLICMapper}
        exec(SCRIPT, names)
        mapper = names["mapper"]
        errors = catch_errors(mapper)
        picture = draw(mapper)
        self.assertEqual(errors, [])
        self.assertEqual(mapper.GetNumberOfConvolutions(), 1)
        self.assertEqual(mapper.GetColorMode(), VTK_COLOR_MODE_DEFAULT)

        own = relevo.vtkAdaptiveLICMapper()
        own.SetInputData(mesh)
        own.SetInputArrayToProcess(0, 0, 0, 0, "Flow")
        own.ScalarVisibilityOff()
        plain = draw(own)
        own.SetColorModeToMap()
        lic = mapper.GetLICInterface()
        for name in (*DEFAULTS, *OTHER_DEFAULTS):
            if name not in ONLY_OF_SETTINGS:
                getattr(own, "Set" + name)(getattr(lic, "Get" + name)())
        self.assertEqual(draw(own), picture)
        self.assertNotEqual(plain, picture)

    def test_sharing(self):
        settings = relevo.vtkLICSettings()
        image = relevo.vtkLineIntegralConvolution()
        surface = relevo.vtkSurfaceLineIntegralConvolution()
        mapper = relevo.vtkAdaptiveLICMapper()
        holders = (image, surface, mapper)
        for holder in holders:
            self.assertIsNot(holder.GetLICSettings(), settings)
            holder.SetLICSettings(settings)
            self.assertIs(holder.GetLICSettings(), settings)
        self.assertIs(mapper.GetLICInterface(), settings)
        for changed in (settings, *holders):
            times = [holder.GetMTime() for holder in holders]
            steps = settings.GetNumberOfSteps() + 1
            changed.SetNumberOfSteps(steps)
            for holder, time in zip(holders, times):
                self.assertGreater(holder.GetMTime(), time)
                self.assertEqual(holder.GetNumberOfSteps(), steps)
        noise = vtkImageData()
        settings.SetNoiseDataSet(noise)
        times = [holder.GetMTime() for holder in holders]
        noise.Modified()
        for holder, time in zip(holders, times):
            self.assertGreater(holder.GetMTime(), time)
            holder.SetLICSettings(None)  # new settings
            self.assertIsNot(holder.GetLICSettings(), settings)
            self.assertEqual(holder.GetNumberOfSteps(), 20)
        copy = relevo.vtkLICSettings()
        copy.ShallowCopy(settings)
        self.assertEqual(copy.GetNumberOfSteps(), settings.GetNumberOfSteps())
        self.assertIs(copy.GetNoiseDataSet(), noise)


if __name__ == "__main__":
    unittest.main(argv=["TestLICSettings"])
