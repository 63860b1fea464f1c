# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves for every class: a setting out of range gives one ErrorEvent and changes nothing.

Calls all setters of numbers in all public classes. After each call, either the getter returns the
new value, or there was one ErrorEvent and it returns the old one. NaN is never accepted unless the
documentation gives it a meaning."""

import itertools
import math
import re
import sys
import unittest

from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource

import relevo
from ErrorMessages import catch_errors

INTEGERS = {"int": 2**31, "vtkIdType": 2**63}
REALS = ("double", "float")

# Setters whose value is not simply stored.
OTHERS = {
    "vtkDisplacement.SetDirection": "the direction is made a unit vector",
    "vtkAdaptiveRefinementMapper.SetColorMode": "VTK's, which takes any number",
    "vtkMicroMeshContourFilter.SetValue": "a value of an index",
    "vtkNURBSSource.SetDegree": "one number of each direction: see test_degrees",
    "vtkReliefCapture.SetCamerasToSphere": "a choice: GetNumberOfCameras() says how many they are",
    "vtkReliefCapture.SetResolution": "one number stands for both",
}
# Integer switches of vtkSurfaceLICInterface: every value except 0 turns them on.
SWITCHES = ("Enable", "NormalizeVectors", "EnhancedLIC", "OrientedLIC", "MaskOnSurface", "GenerateNoiseTexture")


def make_objects():
    """One object of each class that has setters."""
    for name in sorted(dir(relevo)):
        kind = getattr(relevo, name)
        if name.startswith("vtk") and isinstance(kind, type):
            try:
                yield kind()
            except (TypeError, NotImplementedError):
                pass  # abstract


def get_signatures(setter):
    """Parameter types of each overload that takes only numbers."""
    for parameters in re.findall(r"C\+\+: .*?\bSet\w+\(([^)]*)\)", setter.__doc__):
        types = []
        for parameter in parameters.split(","):
            match = re.fullmatch(r"\s*(?:const )?(\w+)&? \w+(?:\[(\d)\])?\s*", parameter)
            if not match or match[1] not in (*INTEGERS, *REALS):
                break
            types.append((match[1], int(match[2] or 0)))
        else:
            yield types


def get_values(kind, documentation):
    """The extremes of a type, and values at and beside the numbers in the documentation."""
    named = {float(number) for number in re.findall(r"-?\b\d+(?:\.\d+)?(?:e\d+)?\b", documentation)}
    if kind in INTEGERS:
        limit = INTEGERS[kind]
        beside = {int(number) + step for number in named | {0.0} for step in (-1, 0, 1)}
        return [-limit, limit - 1, *sorted(value for value in beside if -limit <= value < limit)]
    beside = {number + step for number in named | {0.0} for step in (-1.0, -1e-6, 0.0, 1e-6, 1.0)}
    return [math.nan, math.inf, -math.inf, 1.7e308, -1.7e308, 1e39, -1e39, *sorted(beside)]


def get_arguments(types, documentation):
    """Tuples to call a setter with, and the same as the getter returns it."""
    if len(types) == 1 and not types[0][1]:
        for value in get_values(types[0][0], documentation):
            yield (value,), value
        return
    as_array = bool(types[0][1])
    length = types[0][1] if as_array else len(types)
    values = get_values(types[0][0], documentation)
    vectors = [(value,) * length for value in values]
    vectors += [tuple(1 if i != place else value for i in range(length)) for value in values for place in range(length)]
    for vector in vectors:
        yield ((vector,) if as_array else vector), vector


def is_same(one, other):
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(is_same, one, other))
    return one == other or (one != one and other != other)


def has_nan(value):
    return any(map(has_nan, value)) if isinstance(value, tuple) else value != value


class TestSettings(unittest.TestCase):
    def check(self, item, name, arguments, expected, errors):
        getter = getattr(item, name.replace("Set", "Get", 1))
        before = getter()
        errors.clear()
        getattr(item, name)(*arguments)
        after = getter()
        what = f"{item.GetClassName()}.{name}{arguments}: {before} before, {after} after, {errors}"
        if not errors:
            self.assertTrue(is_same(after, expected), what)
            self.assertTrue("NaN" in getattr(item, name).__doc__ or not has_nan(expected), what)
        else:
            self.assertEqual(len(errors), 1, what)
            self.assertTrue(is_same(after, before), what)
            self.assertIn(name[3:], errors[0], what)

    def test_setters(self):
        walked = set()
        for item in make_objects():
            errors = catch_errors(item)
            for base in type(item).__mro__:
                if not hasattr(relevo, base.__name__):
                    continue
                for name in sorted(vars(base)):
                    whole_name = f"{base.__name__}.{name}"
                    if not name.startswith("Set") or whole_name in OTHERS or name[3:] in SWITCHES:
                        continue
                    setter = getattr(item, name)
                    for types in get_signatures(setter):
                        with self.subTest(whole_name):
                            for arguments, expected in get_arguments(types, setter.__doc__):
                                self.check(item, name, arguments, expected, errors)
                            walked.add(whole_name)
        print(len(walked), "setters")
        self.assertGreater(len(walked), 60)
        self.assertTrue(all(hasattr(getattr(relevo, key.split(".")[0]), key.split(".")[1]) for key in OTHERS))

    def test_ranges(self):
        """Negative control: documented values are accepted, and others are errors."""
        surface = relevo.vtkPhongSurface()
        errors = catch_errors(surface)
        for value in (0.0, 0.25, 1.0):
            surface.SetAlpha(value)
            self.assertEqual(surface.GetAlpha(), value)
        self.assertEqual(errors, [])
        surface.SetAlpha(math.nan)
        surface.SetAlpha(1.0 + 1e-6)
        self.assertEqual(surface.GetAlpha(), 1.0)
        self.assertIn("Alpha must be in [0, 1], got nan.", errors[0])
        self.assertEqual(len(errors), 2)

    def test_switches(self):
        for item in make_objects():
            for name in SWITCHES:
                if hasattr(item, f"Set{name}"):
                    for value in (0, 1):
                        getattr(item, f"Set{name}")(value)
                        self.assertEqual(getattr(item, f"Get{name}")(), value)

    def test_blocks(self):
        sphere = vtkSphereSource()
        sphere.Update()
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, sphere.GetOutput())
        mapper = relevo.vtkAdaptiveRefinementMapper()
        mapper.SetInputDataObject(blocks)
        mapper.Update()
        errors = catch_errors(mapper)
        mapper.SetBlockOpacity(1, 0.5)
        mapper.SetBlockColor(1, 0.25, 0.5, 1.0)
        self.assertEqual(errors, [])
        for value in (math.nan, math.inf, -math.inf, -1e-6, 1.0 + 1e-6):
            errors.clear()
            mapper.SetBlockOpacity(1, value)
            self.assertEqual(mapper.GetBlockOpacity(1), 0.5)
            self.assertEqual(len(errors), 1)
            for place in range(3):
                color = [0.0, 0.0, 0.0]
                color[place] = value
                mapper.SetBlockColor(1, *color)
                mapper.SetBlockColor(1, color)
            self.assertEqual(tuple(mapper.GetBlockColor(1)), (0.25, 0.5, 1.0))
            self.assertEqual(len(errors), 7)

    def test_degrees(self):
        source = relevo.vtkNURBSSource()
        errors = catch_errors(source)
        for direction, degree in itertools.product((0, 1), (8, 1)):
            source.SetDegree(direction, degree)
            self.assertEqual(source.GetDegree(direction), degree)
        self.assertEqual(errors, [])
        time = source.GetMTime()
        for direction, degree in ((0, 0), (1, 9), (0, -(2**31)), (1, 2**31 - 1), (-1, 3), (2, 3)):
            source.SetDegree(direction, degree)
        self.assertEqual((source.GetDegree(0), source.GetDegree(1), source.GetMTime()), (1, 1, time))
        self.assertEqual(len(errors), 6)

    def test_weights(self):
        """Adding an item with a number out of range adds nothing."""
        composite = relevo.vtkCompositeDepthTagMetric()
        errors = catch_errors(composite)
        for weight in (math.nan, math.inf, -1e-6, 1.000001e6):
            composite.AddMetric(relevo.vtkDistanceDepthTagMetric(), weight)
        self.assertEqual(composite.GetNumberOfMetrics(), 0)
        self.assertEqual(len(errors), 4)
        procedural = relevo.vtkProceduralSurface()
        errors = catch_errors(procedural)
        time = procedural.GetMTime()
        for place, value in itertools.product(range(3), (math.nan, math.inf, -math.inf, 1e39)):
            procedural.SetUniform("number", *([1.0] * place), value, *([1.0] * (2 - place)))
            procedural.SetUniform("number", value)
        self.assertEqual(procedural.GetMTime(), time)
        self.assertEqual(len(errors), 24)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
