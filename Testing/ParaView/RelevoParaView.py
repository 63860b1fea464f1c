# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Views, pictures and comparisons for tests that pvbatch runs."""

import unittest

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def view(size=(300, 200)):
    """A new view that draws on all ranks, however small the data are."""
    result = simple.CreateView("RenderView")
    result.ViewSize = size
    result.RemoteRenderThreshold = 0
    result.OrientationAxesVisibility = 0
    simple.SetActiveView(result)
    return result


def show(source, in_view, representation="Adaptive Refinement", **properties):
    """Shows a source in one grey, as `representation` with these properties."""
    result = simple.Show(source, in_view)
    result.Representation = representation
    result.ColorArrayName = ["POINTS", ""]
    for name, value in properties.items():
        setattr(result, name, value)
    return result


def picture(of_view):
    """What a view shows: rows x columns x 3 unsigned bytes, the lowest row first."""
    simple.Render(of_view)
    image = of_view.CaptureWindow(1)
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[..., :3].copy()


def differing(one, other, tolerance=2):
    """How many pixels differ by more than `tolerance` of 255 in some component."""
    return int((numpy.abs(one.astype(int) - other).max(axis=2) > tolerance).sum())


def foreground(of_picture):
    """How many pixels do not have the colour of the lower left corner."""
    return differing(of_picture, numpy.broadcast_to(of_picture[0, 0], of_picture.shape), 0)


def copy_camera(source, target):
    for name in ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraParallelScale"):
        setattr(target, name, getattr(source, name))


def clear():
    """Deletes views first: ParaView 5.11 does not end well after ResetSession() with two windows."""
    for each in simple.GetViews():
        simple.Delete(each)
    for each in list(simple.GetSources().values()):
        simple.Delete(each)


class TestCase(unittest.TestCase):
    def tearDown(self):
        clear()

    def assert_same_picture(self, one, other, pixels=0):
        """Two views show the same, but for some pixels, and not nothing."""
        expected = picture(other)
        self.assertGreater(foreground(expected), 1000)
        self.assertLessEqual(differing(picture(one), expected), pixels)


def main():
    """Runs the tests of the calling script; the exit status tells whether they passed."""
    result = unittest.main(argv=["test"], exit=False, verbosity=2).result
    raise SystemExit(0 if result.wasSuccessful() else 1)
