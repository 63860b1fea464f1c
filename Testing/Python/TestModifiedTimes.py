# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that setters raise the modification time exactly when they change something."""

import unittest

import relevo
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCompositeDataDisplayAttributes
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLPolyDataMapper

# For each setter two different values that also differ from the default.
VALUES = {
    "SetRefinement": [(relevo.vtkAdaptiveRefinement(),) for _ in range(2)],
    "SetLevelLookupTable": [(vtkLookupTable(),) for _ in range(2)],
    "SetCompositeDataDisplayAttributes": [
        (vtkCompositeDataDisplayAttributes(),) for _ in range(2)
    ],
    "SetBlockVisibility": [(0, False), (0, True)],
    "SetBlockColor": [(0, 1.0, 0.5, 0.25), (0, 0.25, 0.5, 1.0)],
    "SetBlockOpacity": [(0, 0.5), (0, 0.25)],
    "SetTargetNumberOfTriangles": [(1000,), (2000,)],
    "SetMethod": [(1,), (2,)],
    "SetSelectionDevice": [(1,), (0,)],
    "SetFrustumCulling": [(False,), (True,)],
    "SetBackFaceCulling": [(False,), (True,)],
    "SetUseAllocatedRenderTime": [(False,), (True,)],
}

# Setters without arguments, in an order in which each changes the value.
CHOICES = [
    "SetColorModeToLevel",
    "SetColorModeToPattern",
    "SetColorModeToMetric",
    "SetColorModeToScalars",
    "SetMethodToARK",
    "SetMethodToDMR",
    "SetMethodToSUAPT",
    "SetMethodToHardwareTessellation",
    "SetMethodToUniform",
    "SetMethodToARKFPI",
    "SetSelectionDeviceToCPU",
    "SetSelectionDeviceToGPU",
    "SetSelectionDeviceToAutomatic",
]


def make_mapper():
    source = vtkSphereSource()
    source.Update()
    mapper = relevo.vtkAdaptiveRefinementMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.Update()
    mapper.SetRefinement(relevo.vtkAdaptiveRefinement())
    return mapper


class TestModifiedTimes(unittest.TestCase):
    def test_every_setter_is_here(self):
        setters = {name for name in dir(relevo.vtkAdaptiveRefinementMapper) if name[:3] == "Set"}
        self.assertEqual(
            setters - set(dir(vtkOpenGLPolyDataMapper)), set(VALUES) | set(CHOICES)
        )

    def check(self, mapper, name, arguments):
        before = mapper.GetMTime()
        getattr(mapper, name)(*arguments)
        changed = mapper.GetMTime()
        self.assertGreater(changed, before, name)
        getattr(mapper, name)(*arguments)
        self.assertEqual(mapper.GetMTime(), changed, name)

    def test_values(self):
        mapper = make_mapper()
        for name, values in VALUES.items():
            for arguments in values:
                self.check(mapper, name, arguments)

    def test_choices(self):
        mapper = make_mapper()
        for name in CHOICES:
            self.check(mapper, name, ())

    def test_observers_are_told(self):
        mapper = make_mapper()
        calls = []
        mapper.AddObserver("ModifiedEvent", lambda *_: calls.append(1))
        mapper.SetFrustumCulling(False)
        self.assertEqual(len(calls), 1)

    def test_parts_of_the_recipe(self):
        mapper = make_mapper()
        recipe = mapper.GetRefinement()
        metric = relevo.vtkDistanceDepthTagMetric()
        several = relevo.vtkCompositeDepthTagMetric()
        several.AddMetric(metric)
        surface = relevo.vtkPhongSurface()
        displacement = relevo.vtkDisplacement()
        heights = relevo.vtkHeightMap()
        displacement.SetHeightMap(heights)
        table = vtkLookupTable()
        self.check(mapper, "SetLevelLookupTable", (table,))
        for call, argument in (
            (recipe.SetMetric, several),
            (recipe.SetSurface, surface),
            (recipe.SetDisplacement, displacement),
            (metric.SetMaximumDistance, 3.0),
            (surface.SetAlpha, 0.3),
            (displacement.SetScale, 2.0),
            (heights.SetFileName, "another.tif"),
            (recipe.GetPatternTable().SetMaximumLevel, 5),
            (recipe.SetLevelOffset, 1.0),
            (table.SetNumberOfTableValues, 7),
        ):
            before = mapper.GetMTime()
            call(argument)
            changed = mapper.GetMTime()
            self.assertGreater(changed, before, call.__name__)
            call(argument)
            self.assertEqual(mapper.GetMTime(), changed, call.__name__)


if __name__ == "__main__":
    unittest.main(argv=["TestModifiedTimes"])
