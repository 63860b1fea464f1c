# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkEGLOffscreenRenderWindow promises the same pictures as VTK's window."""

import os
import sys
import unittest

import relevo
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkHardwareSelector,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

if not hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
    print("skipped: built without rendering, or without EGL")
    sys.exit(125)


def make_renderer(opacity=1.0):
    renderer = vtkRenderer()
    renderer.SetBackground(0.1, 0.2, 0.4)
    for source, x in ((vtkConeSource(), -0.5), (vtkSphereSource(), 0.3)):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(x, 0, 0)
        actor.GetProperty().SetOpacity(opacity)
        renderer.AddActor(actor)
    return renderer


def show(window, renderer, size=(160, 120)):
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    return picture(window)


def picture(window):
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    width, height, _ = image.GetOutput().GetDimensions()
    values = image.GetOutput().GetPointData().GetScalars()
    return (width, height), [values.GetTuple3(i) for i in range(width * height)]


class TestEGLOffscreenRenderWindow(unittest.TestCase):
    def assert_same(self, first, second):
        self.assertEqual(first[0], second[0])
        self.assertGreater(len(set(first[1])), 20)
        different = sum(
            max(abs(a - b) for a, b in zip(p, q)) > 2 for p, q in zip(first[1], second[1])
        )
        self.assertLess(different, 0.002 * len(first[1]))

    @unittest.skipUnless(os.environ.get("DISPLAY"), "no display")
    def test_as_vtk_window(self):
        for opacity in (1.0, 0.5):
            own = show(relevo.vtkEGLOffscreenRenderWindow(), make_renderer(opacity))
            window = vtkRenderWindow()
            window.SetOffScreenRendering(1)
            theirs = show(window, make_renderer(opacity))
            del window  # both kinds of windows cannot be used at the same time
            self.assert_same(own, theirs)

    @unittest.skipUnless(os.environ.get("DISPLAY"), "no display")
    def test_error_while_a_display_window_is_current(self):
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        before = show(window, make_renderer())
        own = relevo.vtkEGLOffscreenRenderWindow()
        errors = []
        own.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
        own.Render()
        self.assertEqual(errors, ["ErrorEvent"])
        self.assert_same(picture(window), before)
        del window
        self.assert_same(show(own, make_renderer()), before)

    def test_size_changes(self):
        window = relevo.vtkEGLOffscreenRenderWindow()
        small = show(window, make_renderer(), (80, 60))
        self.assertEqual(small[0], (80, 60))
        window.SetSize(200, 150)
        large = picture(window)
        self.assertEqual(large[0], (200, 150))
        window.SetSize(80, 60)
        self.assert_same(picture(window), small)

    def test_windows_take_turns(self):
        first = relevo.vtkEGLOffscreenRenderWindow()
        before = show(first, make_renderer())
        second = relevo.vtkEGLOffscreenRenderWindow()
        self.assert_same(show(second, make_renderer()), before)
        self.assertNotEqual(first.GetGenericContext(), second.GetGenericContext())
        self.assert_same(picture(first), before)
        del second
        self.assert_same(picture(first), before)

    def test_mapper_in_two_windows(self):
        sphere = vtkSphereSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        windows = []
        for _ in range(2):
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer = vtkRenderer()
            renderer.AddActor(actor)
            windows.append(relevo.vtkEGLOffscreenRenderWindow())
            pictures = [show(windows[-1], renderer)]
        for _ in range(2):
            pictures += [picture(window) for window in windows]
        for other in pictures[1:]:
            self.assert_same(other, pictures[0])

    def test_renderer_outlives_window(self):
        renderer = make_renderer()
        window = relevo.vtkEGLOffscreenRenderWindow()
        before = show(window, renderer)
        window.RemoveRenderer(renderer)
        del window
        self.assert_same(show(relevo.vtkEGLOffscreenRenderWindow(), renderer), before)

    def test_selection(self):
        window = relevo.vtkEGLOffscreenRenderWindow()
        renderer = make_renderer()
        show(window, renderer)
        selector = vtkHardwareSelector()
        selector.SetRenderer(renderer)
        selector.SetArea(0, 0, 159, 119)
        selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
        self.assertEqual(selector.Select().GetNumberOfNodes(), 2)

    def test_capabilities(self):
        window = relevo.vtkEGLOffscreenRenderWindow()
        self.assertEqual(window.SupportsOpenGL(), 1)
        self.assertEqual(window.IsDirect(), 1)
        self.assertIn("OpenGL renderer string", window.ReportCapabilities())


if __name__ == "__main__":
    unittest.main(argv=["TestEGLOffscreenRenderWindow"])
