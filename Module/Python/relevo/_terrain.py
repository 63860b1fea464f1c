# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A height raster as a terrain."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkInteractorStyle,
    vtkRenderer,
    vtkRenderWindowInteractor,
)

import relevo

from . import _colours, _inputs, _results, _work
from ._drawing import SIZE, Drawing
from ._error import Error
from ._messages import Messages, rename, warn
from ._raster import RasterFile
from ._typing import Array, Bounds, Camera, Path

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from . import _vtk

_masked: Any = numpy.ma  # without annotations up to numpy 2.2

_SMALL = 1 << 24  # samples whose index is built in a moment
_LARGEST_OUTLINE = 2048  # columns or rows that are read for the first view
_DIRECTION_OF_GLOBES = (180, 60)  # azimuth and elevation of the viewer
_SMALLEST_MEMORY = 1 << 22  # bytes of cached tiles
_FRAME_DELAY = 50  # milliseconds, while tiles are loaded


def _check_file(name: str) -> None:
    """Raise FileNotFoundError for a missing file. Other names, such as /vsizip/, are GDAL's."""
    if ":" not in name and not name.startswith("/vsi"):
        _results.check_file(name)


class _Colours:
    """Keeps the lookup table of a mapper that of its colour mode, whoever draws the mapper.

    It does not hold the mapper, which holds it by an observer.
    """

    def __init__(self, mapper: relevo.vtkTerrainMapper, pyramid: relevo.vtkTerrainPyramid) -> None:
        self._pyramid = pyramid
        self._by_height: vtkColorTransferFunction | None = None
        self._range = (0.0, 0.0)  # in that table; an estimate before the index is complete
        self._others = mapper.GetLookupTable()  # the mapper's default, for other modes
        mapper.AddObserver("ModifiedEvent", self._update_caller)

    def _update_caller(self, caller: relevo.vtkTerrainMapper, event: str) -> None:
        self.update(caller)

    def update(self, mapper: relevo.vtkTerrainMapper) -> None:
        """Set the table of the colour mode, unless the caller has set another one."""
        if mapper.GetLookupTable() not in (self._by_height, self._others):
            return
        table = self._others
        if mapper.GetTerrainColorMode() == mapper.COLOR_BY_ELEVATION:
            heights = self._pyramid.GetRange()
            if self._by_height is None or heights != self._range:
                self._range = heights
                self._by_height = _colours.make_table(*heights, _colours.RELIEF)
            table = self._by_height
        mapper.SetLookupTable(table)


class Terrain(Drawing):
    """A terrain that is drawn from a height raster, see relevo.terrain()."""

    _lights = ((315, 40, 1.0), (160, 50, 0.35))
    _direction = (192, 38)
    _up = 2

    mapper: relevo.vtkTerrainMapper
    actor: _vtk.vtkActor

    def __init__(
        self,
        source: Any,
        imagery: Path | None,
        exaggeration: float | None,
        bounds: Bounds | None,
        crs: Any,
        no_data: float | None,
        lighting: bool,
    ) -> None:
        if imagery is not None and not _inputs.is_path(imagery):
            raise TypeError(f"imagery must be the path of an image, not {type(imagery).__name__}")
        if exaggeration is not None:
            _inputs.check_number(exaggeration, "exaggeration")
        raster = RasterFile(source, bounds, crs, no_data)
        self._raster_title, self._names = raster.title, raster.names
        _check_file(raster.name)
        mapper = relevo.vtkTerrainMapper()
        self._pyramid = relevo.vtkTerrainPyramid()
        raster.keep_for(self._pyramid)
        self._pyramid.SetFileName(raster.name)
        if raster.is_array:
            # Less than another copy of the array.
            self._pyramid.SetIndexMemoryLimit(max(_SMALLEST_MEMORY, 3 * raster.size // 4))
            self._pyramid.SetMemoryLimit(max(_SMALLEST_MEMORY, raster.size // 4))
        with Messages(ValueError if raster.is_array else Error, self._names):
            self._pyramid.Update()
        if crs is not None and not self._pyramid.GetCoordinateSystem():
            raise ValueError(f"crs: {crs!r} is not a coordinate system that GDAL knows")
        mapper.SetPyramid(self._pyramid)
        columns, rows = self._pyramid.GetDimensions()
        if columns * rows <= _SMALL:
            self._wait()
        self._check_data(raster.name)
        with Messages(ValueError, {"Exaggeration": "exaggeration"}):
            mapper.SetExaggeration(
                self._choose_exaggeration() if exaggeration is None else exaggeration
            )
        super().__init__(mapper, vtkActor())
        self.actor.SetMapper(mapper)
        self._colours = _Colours(mapper, self._pyramid)
        if imagery is None:
            mapper.SetColorModeToElevation()
            self.actor.GetProperty().SetAmbient(0.15)
            self.actor.GetProperty().SetDiffuse(0.85)
        else:
            imagery = str(imagery)
            _check_file(imagery)
            mapper.SetImageryFileName(imagery)
            # Photographs contain shadows.
            self.actor.GetProperty().SetAmbient(0.30)
            self.actor.GetProperty().SetDiffuse(0.80)
        self._set_lighting(lighting)
        self._colours.update(self.mapper)
        with Messages(names=self._names):
            box = mapper.GetBounds()
        if box[0] > box[1]:
            raise Error(f"{raster.title} has no terrain to draw: all heights are missing values")

    def elevation(self, lon: ArrayLike, lat: ArrayLike) -> Any:
        """Return heights in the unit of the raster.

        lon, lat: longitude and latitude in degrees, on the ellipsoid of the raster's coordinate
            system; without a coordinate system, x and y of the raster. Numbers, or arrays of any
            shapes that numpy broadcasts.

        Returns a float, or an array of floats of the broadcast shape. It is NaN outside of the
        raster, at masked coordinates and where there are no data. Raises relevo.Error if samples
        cannot be read, TypeError, and ValueError for shapes that do not fit.
        """
        given = []
        for values, name in ((lon, "lon"), (lat, "lat")):
            array: Any = numpy.asanyarray(values)
            if array.dtype.kind not in "iuf":
                raise TypeError(f"{name} must be real numbers, not {array.dtype}")
            if isinstance(array, _masked.MaskedArray):
                array = array.astype(float).filled(numpy.nan)
            given.append(array)
        try:
            x, y = numpy.broadcast_arrays(*given)
        except ValueError:
            raise ValueError(
                f"lon and lat must have shapes that fit, not {given[0].shape} and {given[1].shape}"
            ) from None
        points = numpy.stack([x, y], axis=-1).astype(float).reshape(-1, 2)
        if self._pyramid.GetCoordinateSystem() and not self._pyramid.IsGeographic():
            points = self._from_degrees(points)
        if not len(points):
            return numpy.empty(x.shape)
        with Messages(names=self._names):
            found = self._pyramid.GetElevations(numpy_to_vtk(points))
        heights: Array = vtk_to_numpy(found).astype(float).reshape(x.shape)
        return heights if x.ndim else float(heights)

    def _from_degrees(self, points: Array) -> Array:
        result = numpy.full(points.shape, numpy.nan)
        place = [0.0, 0.0]
        for i, point in enumerate(points.tolist()):
            if self._pyramid.GeographicToRaster(point, place):
                result[i] = place
        return result

    def _wait(self) -> None:
        _work.wait_for_index(self._pyramid)

    def _check_data(self, name: str) -> None:
        """Warn if coordinates or samples are probably not what they are taken for."""
        for doubt in (self._pyramid.GetLocationWarning(), self._pyramid.GetSampleWarning()):
            if doubt:
                warn(rename(name + doubt, self._names))

    def _describe(self) -> str:
        columns, rows = self._pyramid.GetDimensions()
        low, high = self._pyramid.GetRange()
        return f"{self._raster_title}, {columns} x {rows} heights from {low:g} to {high:g}"

    def _choose_exaggeration(self) -> float:
        """Return 1, or less for heights of an unknown unit that would be more than the width."""
        if self._pyramid.GetCoordinateSystem():
            return 1.0
        west, east, south, north = self._pyramid.GetBounds()
        low, high = self._pyramid.GetRange()
        width = max(east - west, north - south)
        relief = self._pyramid.GetVerticalUnit() * (high - low)
        return 1.0 if relief <= width else max(0.001, float(f"{0.2 * width / relief:.2g}"))

    def _get_legend(self) -> tuple[vtkScalarsToColors | None, str]:
        return self.mapper.GetLegendLookupTable(), self.mapper.GetLegendTitle()

    def _get_axes(self) -> Array:
        if self.mapper.GetFrame() != self.mapper.GEOCENTRIC:
            return super()._get_axes()
        return self._find_axes_of_globe()

    def _find_axes_of_globe(self) -> Array:
        """Return the directions of the ellipsoid at the centre of the raster."""
        west, east, south, north = self._pyramid.GetBounds()
        centre = numpy.array((0.5 * (west + east), 0.5 * (south + north), 0.0))
        height = 0.01 * max(self._pyramid.GetRange()[1] - self._pyramid.GetRange()[0], 100.0)
        step = 1e-3 * (north - south)
        places = [centre + offset for offset in ((0, 0, 0), (0, step, 0), (0, 0, height))]
        worlds = numpy.zeros((3, 3))
        for place, world in zip(places, worlds):
            found = [0.0, 0.0, 0.0]
            self.mapper.RasterToWorld(place, found)
            world[:] = found
        up = worlds[2] - worlds[0]
        up /= numpy.linalg.norm(up)
        right = numpy.cross(worlds[1] - worlds[0], up)
        right /= numpy.linalg.norm(right)
        return numpy.array([right, numpy.cross(up, right), up])

    def _check_direction(self, camera: Any) -> tuple[float, float]:
        if camera is None and self.mapper.GetFrame() == self.mapper.GEOCENTRIC:
            return _DIRECTION_OF_GLOBES
        return super()._check_direction(camera)

    def _get_points(self) -> Array:
        coarsest = [0, 0]
        self._pyramid.GetLevelDimensions(self._pyramid.GetNumberOfLevels() - 1, coarsest)
        if max(coarsest) > _LARGEST_OUTLINE:
            return super()._get_points()
        image = self._pyramid.GetReducedElevations(65)
        heights = vtk_to_numpy(image.GetPointData().GetScalars()).tolist()
        across, down, _ = image.GetDimensions()
        step = image.GetSpacing()
        samples = [(i * step[0], j * step[1]) for j in range(down) for i in range(across)]
        points = [self._find_point(sample, own) for sample, own in zip(samples, heights)]
        # The last points of the image may be before the borders.
        columns, rows = self._pyramid.GetDimensions()
        points += [
            self._find_point((column, row)) for column in (0, columns - 1) for row in (0, rows - 1)
        ]
        if self.mapper.GetUseBase():
            base = self.mapper.GetBaseHeight()
            points += [
                self._find_point(sample, base)
                for sample, own in zip(samples, heights)
                if math.isfinite(own)
            ]
        known = [point for point in points if point is not None]
        return numpy.array(known) if known else super()._get_points()

    def _find_point(self, sample: Sequence[float], height: float | None = None) -> list[float] | None:
        """Return the position of a sample, or None without data."""
        coordinates, world = [0.0, 0.0], [0.0, 0.0, 0.0]
        self._pyramid.SampleToRaster(sample, coordinates)
        if height is None:
            height = self._pyramid.GetElevation(*coordinates)
        found = self.mapper.RasterToWorld((*coordinates, height), world)
        return world if found and math.isfinite(height) else None

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        source = relevo.vtkTerrainMeshSource()
        source.SetPyramid(self._pyramid)
        source.SetCamera(self._make_camera(camera))
        source.SetViewportSize(SIZE)
        source.SetScreenSpaceError(self.mapper.GetScreenSpaceError())
        source.SetExaggeration(self.mapper.GetExaggeration())
        source.SetMemoryLimit(self.mapper.GetMemoryLimit())
        source.SetFrame(self.mapper.GetFrame())
        source.SetUseBase(self.mapper.GetUseBase())
        source.SetBaseHeight(self.mapper.GetBaseHeight())
        _work.update(source)
        if source.GetOutput().GetNumberOfCells() == 0:
            raise Error("the mesh has no cells: the camera sees no part of the terrain")
        return source.GetOutput()

    def _make_renderer(self, size: tuple[int, int], camera: Camera) -> vtkRenderer:
        self._colours.update(self.mapper)
        return super()._make_renderer(size, camera)

    def add_to(self, plotter: Any) -> None:
        """Add the actor to a vtkRenderer, a vtkRenderWindow, or a plotter of PyVista or vedo.

        Plotters without a window draw the terrain when its tiles are loaded. In other windows, each
        frame shows the tiles that are loaded, see vtkTerrainMapper.SetLoadingMode().
        """
        self._colours.update(self.mapper)
        # Attributes of PyVista and vedo.
        if getattr(plotter, "off_screen", False) or getattr(plotter, "offscreen", False):
            self.mapper.SetLoadingModeToComplete()
        super().add_to(plotter)

    def _draw(self, size: tuple[int, int], camera: Camera) -> vtkImageData:
        self._wait()
        mode = self.mapper.GetLoadingMode()
        self.mapper.SetLoadingModeToComplete()
        try:
            return super()._draw(size, camera)
        finally:
            self.mapper.SetLoadingMode(mode)

    def _make_style(self) -> vtkInteractorStyle:
        from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTerrain

        return vtkInteractorStyleTerrain()

    def _open(self, size: tuple[int, int]) -> vtkRenderWindowInteractor:
        interactor = super()._open(size)
        mapper = self.mapper

        def draw_more(caller: vtkRenderWindowInteractor, event: str) -> None:
            if not mapper.IsComplete():
                caller.GetRenderWindow().Render()

        interactor.AddObserver("TimerEvent", draw_more)
        interactor.CreateRepeatingTimer(_FRAME_DELAY)
        return interactor
