# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for PyVista 0.48 with the parts that the package uses.

Accessors and components are registered by decorators. The first use of an unknown attribute imports
the module that an entry point names.
"""

import importlib
import importlib.metadata

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter

__version__ = "0.48.0"


class _Cached:
    def __init__(self, name, kind):
        self._name, self._kind = name, kind

    def __get__(self, owner, kind=None):
        if owner is None:
            return self._kind
        return owner.__dict__.setdefault(self._name, self._kind(owner))


def _find_extension(group, owner, name):
    """Import the module of an entry point, and return the attribute that it has registered."""
    for point in importlib.metadata.entry_points(group=group, name=name):
        importlib.import_module(point.value)
        return getattr(owner, name)
    raise AttributeError(name)


class DataObject:
    def __getattr__(self, name):
        return _find_extension("pyvista.accessors", self, name)


class PolyData(DataObject, vtkPolyData):
    pass


class UnstructuredGrid(DataObject, vtkUnstructuredGrid):
    pass


class MultiBlock(DataObject, vtkMultiBlockDataSet):
    pass


class BasePlotter:
    def __getattr__(self, name):
        return _find_extension("pyvista.plotter_components", self, name)


class Plotter(BasePlotter):
    """It draws without a display.

    As in PyVista, the first picture shows all actors, nothing is drawn before it, and later pictures
    show the last frame, which add_actor(), remove_actor() and render() draw.
    """

    def __init__(self, off_screen=None, *, window_size=(300, 200)):
        import relevo

        self.off_screen = off_screen
        self.render_window = relevo.vtkEGLOffscreenRenderWindow()
        self.render_window.SetSize(window_size)
        self.renderer = vtkRenderer()
        self.render_window.AddRenderer(self.renderer)
        self._is_camera_set = False
        self._is_drawn = False

    def render(self):
        if self._is_drawn:
            self.render_window.Render()

    def reset_camera(self, render=True):
        self.renderer.ResetCamera()
        if render:
            self.render()

    def add_actor(
        self,
        actor,
        reset_camera=False,
        name=None,
        culling=False,
        pickable=True,
        render=True,
        remove_existing_actor=True,
    ):
        actor.name = name or f"{type(actor).__name__}({actor.GetAddressAsString('')})"
        actor.SetPickable(pickable)
        self.renderer.AddActor(actor)
        if reset_camera or (reset_camera is None and not self._is_camera_set):
            self.reset_camera(render)
        elif render:
            self.render()
        return actor, actor.GetProperty() if hasattr(actor, "GetProperty") else None

    def remove_actor(self, actor, reset_camera=False, render=True):
        if isinstance(actor, (list, tuple)):
            return any([self.remove_actor(own, reset_camera, render) for own in actor])
        if not self.renderer.HasViewProp(actor):
            return False
        self.renderer.RemoveActor(actor)
        if render:
            self.render()
        return True

    @property
    def camera(self):
        return self.renderer.GetActiveCamera()

    def set_background(self, color, top=None, right=None, side=None, corner=None):
        self.renderer.SetBackground(vtkNamedColors().GetColor3d(color))

    def view_vector(self, vector, viewup=None, render=True, bounds=None):
        """Look at the actors from the direction of a vector."""
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetPosition(vector)
        self.camera.SetViewUp(viewup or (0, 0, 1))
        self._is_camera_set = True
        self.reset_camera(render)

    def screenshot(
        self,
        filename=None,
        transparent_background=None,
        return_img=True,
        window_size=None,
        scale=None,
    ):
        """Return the picture as an array of shape (rows, columns, 3), and write a PNG file."""
        if not self._is_drawn:
            self._is_drawn = True
            if not self._is_camera_set:
                self.renderer.ResetCamera()
                self._is_camera_set = True
            self.render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.render_window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        if filename:
            writer = vtkPNGWriter()
            writer.SetFileName(str(filename))
            writer.SetInputData(grab.GetOutput())
            writer.Write()
        columns, rows, _ = grab.GetOutput().GetDimensions()
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
        return pixels.reshape(rows, columns, -1)[::-1].copy()


def register_dataset_accessor(name, target_cls, *, override=False):
    def register(kind):
        setattr(target_cls, name, _Cached(name, kind))
        return kind

    return register


def register_plotter_component(name, target_cls=None, *, override=False):
    def register(kind):
        setattr(target_cls or BasePlotter, name, _Cached(name, kind))
        return kind

    return register


def wrap(data):
    kinds = {kind.__bases__[1]: kind for kind in (PolyData, UnstructuredGrid, MultiBlock)}
    for base, kind in kinds.items():
        if isinstance(data, base):
            result = kind()
            result.ShallowCopy(data)
            return result
    raise NotImplementedError(type(data).__name__)


def read(filename):
    reader = vtkPLYReader()
    reader.SetFileName(str(filename))
    reader.Update()
    return wrap(reader.GetOutput())
