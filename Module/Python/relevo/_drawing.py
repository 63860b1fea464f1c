# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The base class of drawings: terrains, surfaces, volumes and others."""

from __future__ import annotations

import os
import weakref
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkCamera,
    vtkInteractorStyle,
    vtkProp,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkWindowToImageFilter,
)

import relevo

from . import _camera, _inputs, _legend, _outputs, _quantities, _time_label, _work, files
from ._colours import Colours
from ._error import Error
from ._messages import Messages
from ._options import MeshOptions
from ._typing import Array, Camera, Path

if TYPE_CHECKING:
    from numpy.typing import NDArray

SIZE = (1280, 800)
_DRAWING: dict[str, int] = {}  # the process that has drawn
_SAMPLES = 4  # per pixel of a picture, as in relevo-view


def _check_size(size: Any) -> tuple[int, int]:
    try:
        columns, rows = (int(number) for number in size)
    except (TypeError, ValueError):
        raise TypeError(f"size must be (columns, rows), not {size!r}") from None
    if not (0 < columns <= 16384 and 0 < rows <= 16384):
        raise ValueError(f"size must be from 1 x 1 to 16384 x 16384 pixels, not {columns} x {rows}")
    return columns, rows


def _check_process() -> None:
    """Raise Error in a process that was forked from one that has drawn."""
    if _DRAWING.setdefault("process", os.getpid()) != os.getpid():
        raise Error(
            "OpenGL cannot be used in a process that was forked after a picture was drawn; start"
            " processes with multiprocessing.get_context('spawn')"
        )


def _has_display() -> bool:
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _find_window(plotter: Any) -> Any:
    """Return the window of a renderer or a plotter, or None."""
    if isinstance(plotter, vtkRenderWindow):
        return plotter
    if hasattr(plotter, "GetRenderWindow"):
        return plotter.GetRenderWindow()
    # Attributes of PyVista and vedo.
    return getattr(plotter, "render_window", None) or getattr(plotter, "window", None)


def _make_offscreen_window(is_on_display: bool) -> vtkRenderWindow:
    """Return a window that needs no display, where EGL is built.

    is_on_display: whether a window on a display draws the same actor. Its OpenGL excludes EGL, so
        the result is a hidden window on the display, as if such a window is current.
    """
    if hasattr(relevo, "vtkEGLOffscreenRenderWindow") and not is_on_display:
        own = relevo.vtkEGLOffscreenRenderWindow()
        own.SetMultiSamples(_SAMPLES)
        try:
            with Messages():
                own.Initialize()
            return own
        except Error:
            if not _has_display():
                raise
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(_SAMPLES)
    return window


def set_exact_colours(actor: Any) -> None:
    """Draw the colours of an actor without lighting."""
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetAmbient(0)
    actor.GetProperty().SetDiffuse(1)


class Drawing:
    """Data that can be drawn, with a camera, lights and colours that suit it.

    actor: the vtkProp3D. mapper: its mapper. Change their settings as in VTK; later pictures show
    the changes.
    """

    _background = ((0.86, 0.90, 0.94), (0.42, 0.58, 0.78))
    _lights: tuple[tuple[float, float, float], ...] = ((250, 45, 0.95), (150, 15, 0.45))  # azimuth, elevation, intensity
    _direction: tuple[float, float] = (205, 20)  # azimuth and elevation of the viewer
    _up = 1  # the vertical axis: 0, 1 or 2
    _scale = Colours()
    _table: vtkScalarsToColors | None = None  # of the colour bar
    _title = ""
    _source: Any = None  # what the caller has given
    _kind = ""  # package of the caller's mesh
    _time: float | None = None  # of the drawn step, if there are several
    _others: Sequence[vtkProp] = ()  # further props, such as the section of a cut
    _plotters: Sequence[weakref.ref[Any]] = ()  # that have the actor
    _names: Mapping[str, str] = {}  # of things in messages, see Messages

    # Subclasses have precise types.
    mapper: Any
    actor: Any

    def __init__(self, mapper: Any, actor: Any) -> None:
        self.mapper = mapper
        self.actor = actor

    def _take(self, mesh: Any, options: MeshOptions) -> tuple[vtkDataObject, str | None]:
        """Return the data of a mesh, see take_data(), and the name of the array for colours."""
        self._up = options.axis
        self._scale = options.colours
        self._source, data, self._kind, self._time = _inputs.take_data(mesh, time=options.time)
        return _quantities.add_quantity(data, options.scalars)

    def _set_lighting(self, lighting: bool | None) -> None:
        if not lighting:
            set_exact_colours(self.actor)

    def __repr__(self) -> str:
        return f"<relevo.{type(self).__name__.lower()}: {self._describe()}>"

    def _describe(self) -> str:
        """Return the data of the drawing in a few words."""
        raise NotImplementedError

    def show(self, size: tuple[int, int] = SIZE) -> None:
        """Draw in a window, and return when it is closed.

        size: columns and rows in pixels.

        Raises relevo.Error if there is no display; use screenshot() then.
        """
        interactor = self._open(size)
        _work.start(interactor)
        interactor.GetRenderWindow().Finalize()

    def screenshot(
        self,
        path: Path | None = None,
        size: tuple[int, int] = SIZE,
        camera: Camera = None,
    ) -> NDArray[numpy.uint8]:
        """Draw without a display.

        path: a PNG or JPEG file to write; none by default.
        size: columns and rows in pixels.
        camera: a vtkCamera, or azimuth and elevation (-90 to 90) of the viewer in degrees. By
            default, all of the data are in the picture.

        Returns the picture as uint8 of shape (rows, columns, 3), top row first. Raises relevo.Error
        if it cannot be drawn.
        """
        image = self._draw(size, camera)
        if path is not None:
            with Messages():
                files.write_picture(path, image)
        columns, rows, _ = image.GetDimensions()
        pixels: NDArray[numpy.uint8] = vtk_to_numpy(image.GetPointData().GetScalars())
        return pixels.reshape(rows, columns, -1)[::-1].copy()

    def mesh(self, camera: Camera = None) -> Any:
        """Return the triangles that are drawn, as a mesh of the same package as the input.

        camera: as for screenshot(), for a picture of the default size. Other levels follow from it
            if they depend on the view.

        Raises relevo.Error if the drawing has cells and the mesh has none.
        """
        with Messages(names=self._names):
            mesh = self._make_mesh(camera)
        return _outputs.to_kind(mesh, self._kind)

    def save(self, path: Path) -> None:
        """Write a picture (.png, .jpg) or mesh() (.vtp, .vtu, .vti, .ply, .stl).

        Raises ValueError for another extension, and OSError if the file cannot be written.
        """
        if files.is_picture(path):
            self.screenshot(path)
            return
        _outputs.check_extension(path)
        with Messages(names=self._names):
            _outputs.write_mesh(path, self._make_mesh(None))

    def _is_on_display(self) -> bool:
        windows = [_find_window(plotter()) for plotter in self._plotters]
        own = getattr(relevo, "vtkEGLOffscreenRenderWindow", ())
        return _has_display() and any(
            isinstance(window, vtkRenderWindow) and not isinstance(window, own)
            for window in windows
        )

    def add_to(self, plotter: Any) -> None:
        """Add the actors to a vtkRenderer, a vtkRenderWindow, or a plotter of PyVista or vedo.

        plotter.remove_actor(drawing.actors) of PyVista removes them.
        """
        for actor in self.actors:
            self._add_prop(plotter, actor)
        self._plotters = [*self._plotters, weakref.ref(plotter)]

    @property
    def actors(self) -> list[Any]:
        """The actor, and further ones of a cut or of streamlines."""
        return [self.actor, *self._others]

    @staticmethod
    def _add_prop(plotter: Any, prop: Any) -> None:
        if _inputs.find_package(plotter) == "pyvista":
            # As for meshes of PyVista, the camera shows all actors unless the caller has set it.
            plotter.add_actor(prop, reset_camera=None)
        elif hasattr(plotter, "add_actor"):
            plotter.add_actor(prop)
        elif hasattr(plotter, "AddViewProp"):
            plotter.AddViewProp(prop)
        elif isinstance(plotter, vtkRenderWindow) and plotter.GetRenderers().GetFirstRenderer():
            plotter.GetRenderers().GetFirstRenderer().AddViewProp(prop)
        elif hasattr(plotter, "add") and _inputs.get_package(plotter) == "vedo":
            # vedo converts volumes of VTK to its own, which are not of meshes.
            if prop.IsA("vtkVolume"):
                plotter.renderer.AddViewProp(prop)
            else:
                plotter.add(prop)
        else:
            raise TypeError(
                "plotter must be a vtkRenderer, a vtkRenderWindow with a renderer, or a plotter of"
                f" PyVista or vedo, not {type(plotter).__name__}"
            )

    def _repr_png_(self) -> bytes:
        writer = vtkPNGWriter()
        writer.SetInputData(self._draw((800, 500), None))
        writer.WriteToMemoryOn()
        writer.Write()
        result: Any = writer.GetResult()
        return bytes(memoryview(result))

    def _get_points(self) -> Array:
        """Return points, of shape (n, 3), that a default picture shows."""
        bounds = numpy.array(self.actor.GetBounds()).reshape(3, 2)
        return numpy.array(numpy.meshgrid(*bounds)).reshape(3, -1).T

    def _get_axes(self) -> Array:
        """Return the unit vectors to the east, to the north and upwards."""
        return _camera.AXES[self._up]

    def _get_legend(self) -> tuple[vtkScalarsToColors | None, str]:
        """Return the table and the title of the colour bar, or None and a text."""
        return self._table, self._title

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        raise NotImplementedError

    def _make_renderer(self, size: tuple[int, int], camera: Camera) -> vtkRenderer:
        renderer = vtkRenderer()
        renderer.AutomaticLightCreationOff()
        renderer.GradientBackgroundOn()
        renderer.SetBackground(self._background[0])
        renderer.SetBackground2(self._background[1])
        axes = self._get_axes()
        for azimuth, elevation, intensity in self._lights:
            _camera.add_light(renderer, azimuth, elevation, intensity, axes)
        for actor in self.actors:
            renderer.AddViewProp(actor)
        corner = (0, 0)
        table, title = self._get_legend()
        if table is not None:
            actors, corner = _legend.make_legend(table, title, size)
            for actor in actors:
                renderer.AddViewProp(actor)
        if self._time is not None:
            renderer.AddViewProp(_time_label.make_time_label(self._time))
        if isinstance(camera, vtkCamera):
            renderer.GetActiveCamera().DeepCopy(camera)
            renderer.ResetCameraClippingRange()
        else:
            direction = self._check_direction(camera)
            _camera.fit_camera(renderer, self._get_points(), direction, axes, size, corner)
        return renderer

    def _make_camera(self, camera: Camera, size: tuple[int, int] = SIZE) -> vtkCamera:
        """Return the vtkCamera of a picture."""
        return self._make_renderer(size, camera).GetActiveCamera()

    def _check_direction(self, camera: Any) -> tuple[float, float]:
        if camera is None:
            return self._direction
        try:
            azimuth, elevation = (float(number) for number in camera)
        except (TypeError, ValueError):
            raise TypeError(
                "camera must be a vtkCamera, or azimuth and elevation of the viewer in degrees,"
                f" not {camera!r}"
            ) from None
        if not (abs(azimuth) < numpy.inf and abs(elevation) <= 90):
            raise ValueError(
                "camera must have an elevation from -90 to 90 degrees and a finite azimuth, not"
                f" {(azimuth, elevation)}"
            )
        return azimuth, elevation

    def _draw(self, size: tuple[int, int], camera: Camera) -> vtkImageData:
        """Return a picture as vtkImageData."""
        size = _check_size(size)
        _check_process()
        window = _make_offscreen_window(self._is_on_display())
        with Messages(names=self._names):
            window.SetSize(size)
            window.AddRenderer(self._make_renderer(size, camera))
            try:
                _work.render(window)
                grab = vtkWindowToImageFilter()
                grab.SetInput(window)
                grab.ReadFrontBufferOff()
                grab.ShouldRerenderOff()
                grab.Update()
                image = grab.GetOutput()
            finally:
                window.Finalize()
        return image

    def _make_style(self) -> vtkInteractorStyle:
        from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera

        return vtkInteractorStyleTrackballCamera()

    def _open(self, size: tuple[int, int]) -> vtkRenderWindowInteractor:
        """Return the interactor of a window on the display, which shows the first frame."""
        import vtkmodules.vtkRenderingUI  # noqa: F401, windows that have an interactor

        style = self._make_style()
        size = _check_size(size)
        if not _has_display():
            raise Error("show() needs a display, and DISPLAY is not set; use screenshot() instead")
        _check_process()
        with Messages():
            window = vtkRenderWindow()
            window.SetSize(size)
            window.SetWindowName("relevo")
            window.AddRenderer(self._make_renderer(size, None))
            interactor = vtkRenderWindowInteractor()
            interactor.SetRenderWindow(window)
            interactor.SetInteractorStyle(style)
            interactor.Initialize()
            window.Render()
        return interactor
