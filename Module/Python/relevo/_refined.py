# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A refined surface."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkDataArray, vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkImageData, vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _colours, _inputs, _quantities, _results, _section, _work, arrays
from ._drawing import SIZE, Drawing
from ._error import Error
from ._messages import Messages, warn
from ._options import MeshOptions
from ._raster import RasterFile, is_raster
from ._typing import Array, Camera

if TYPE_CHECKING:
    from . import _vtk

_PIXELS = 4.0  # per segment of an edge
_LEVEL = 4  # where the metric does not limit lengths on the screen
_HIGHEST_LEVEL = 7
_VIEWED_TRIANGLES = 100000  # for the view

_SURFACES = {
    "linear": "vtkLinearSurface",
    "pn": "vtkPNTriangleSurface",
    "phong": "vtkPhongSurface",
    "g1": "vtkG1Surface",
    "st": "vtkScalarTaggedSurface",
    "procedural": "vtkProceduralSurface",
}


def _make_screen_edge(array: str | None) -> relevo.vtkDepthTagMetric:
    metric = relevo.vtkScreenEdgeDepthTagMetric()
    metric.SetReferenceLength(_PIXELS)
    # A bulge above an edge that is seen end-on is fully visible.
    metric.SetMeasureToSphereDiameter()
    return metric


def _make_curvature(array: str | None) -> relevo.vtkDepthTagMetric:
    metric = relevo.vtkCurvatureDepthTagMetric()
    metric.SetCurvatureTypeToMean()
    return metric


def _make_silhouette(array: str | None) -> relevo.vtkDepthTagMetric:
    metric = relevo.vtkSilhouetteDepthTagMetric()
    metric.SetCriterion(relevo.vtkSilhouetteDepthTagMetric.NORMAL_ANGLE)
    return metric


def _make_contour(array: str | None) -> relevo.vtkDepthTagMetric:
    metric = relevo.vtkSilhouetteDepthTagMetric()
    metric.SetCriterion(relevo.vtkSilhouetteDepthTagMetric.CONTOUR)
    return metric


def _make_field(array: str | None) -> relevo.vtkDepthTagMetric:
    if not array:
        raise ValueError("metric='field' needs a mesh with active point scalars")
    metric = relevo.vtkFieldVariationDepthTagMetric()
    metric.SetArrayName(array)
    return metric


_METRICS = {
    "screen-edge": _make_screen_edge,
    "curvature": _make_curvature,
    "distance": lambda array: relevo.vtkDistanceDepthTagMetric(),
    "silhouette": _make_silhouette,
    "contour": _make_contour,
    "view-dependent": lambda array: relevo.vtkViewDependentDepthTagMetric(),
    "field": _make_field,
    "height": lambda array: relevo.vtkHeightErrorDepthTagMetric(),
}


def _choose(value: Any, names: dict[str, Any], kind: type, option: str) -> Any:
    """Return an object of VTK, or what a name stands for."""
    if isinstance(value, kind):
        return value
    if not isinstance(value, str):
        raise TypeError(
            f"{option} must be a str or a {kind.__name__}, not {type(value).__name__}"
        )
    name = value.lower()
    if name not in names:
        raise ValueError(f"{option} must be one of {', '.join(names)}, not {value!r}")
    return names[name]


def _extend(one: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    return min(one[0], other[0]), max(one[1], other[1])


def _get_range_of(blocks: Sequence[vtkDataSet], name: str) -> tuple[float, float]:
    """Return the range of the finite values, or the lengths of vectors, of an array."""
    _, of_points = _inputs.find_array(blocks, name)
    low, high = math.inf, -math.inf
    for block in blocks:
        array = (block.GetPointData() if of_points else block.GetCellData()).GetArray(name)
        if array is not None and array.GetNumberOfTuples():
            own = array.GetFiniteRange(-1 if array.GetNumberOfComponents() > 1 else 0)
            low, high = _extend((low, high), own)
    return low, high


def set_material(actor: vtkActor) -> None:
    """Set the material of surfaces in relevo-view."""
    material = actor.GetProperty()
    material.SetColor(0.80, 0.78, 0.74)
    material.SetAmbient(0.12)
    material.SetDiffuse(0.80)
    material.SetSpecular(0.18)
    material.SetSpecularPower(30.0)
    material.SetInterpolationToPhong()


class Refined(Drawing):
    """A surface that is refined where the viewer needs detail, see relevo.refined()."""

    # The main light is above the viewer's left shoulder. Weaker lights are on the right and behind.
    _lights = ((250, 45, 0.95), (150, 15, 0.45), (10, 40, 0.30))

    mapper: relevo.vtkAdaptiveRefinementMapper
    actor: _vtk.vtkActor
    recipe: relevo.vtkAdaptiveRefinement
    _plane: vtkPlane | None = None  # of a cut
    _shows_cells = False  # whether colours are also those of values inside of the mesh

    def __init__(
        self,
        mesh: Any,
        options: MeshOptions,
        surface: Any = None,
        metric: Any = None,
        max_level: int | None = None,
        height: Any = None,
        scale: float | None = None,
    ) -> None:
        if max_level is not None:
            _inputs.check_number(max_level, "max_level", integer=True)
        if scale is not None:
            _inputs.check_number(scale, "scale")
        scalars = self._take_surface(mesh, options, surface)
        super().__init__(relevo.vtkAdaptiveRefinementMapper(), vtkActor())
        self._set_up(self._find_scalars(scalars))
        if height is not None and self._plane is not None:
            raise ValueError("clip cannot be combined with height")
        if height is not None:
            self._displace(height, scale)
        elif scale is not None:
            raise ValueError("scale needs height")
        name = self._scalars.GetName() if self._scalars and self._of_points else None
        # More triangles in the same plane do not change the picture.
        is_flat = isinstance(self._surface, relevo.vtkLinearSurface) and height is None
        if max_level is None and metric is None and is_flat:
            max_level = 0
        if metric is None:
            metric = "screen-edge" if height is None else "height"
        chosen = _choose(metric, _METRICS, relevo.vtkDepthTagMetric, "metric")
        self.recipe.SetMetric(chosen(name) if callable(chosen) else chosen)
        if max_level is None:
            limited = isinstance(metric, str) and metric.lower() in ("screen-edge", "height")
            max_level = _HIGHEST_LEVEL if limited else _LEVEL
        with Messages(ValueError, {"MaximumLevel": "max_level"}):
            self.recipe.SetMaximumLevel(max_level)
        self._set_lighting(options.lighting)
        self._cut()

    def _take(self, mesh: Any, options: MeshOptions) -> tuple[vtkDataObject, str | None]:
        self._plane = options.plane
        self._shows_cells = self._shows_cells or options.plane is not None
        return super()._take(mesh, options)

    def _take_surface(
        self, mesh: Any, options: MeshOptions, surface: Any = None
    ) -> str | None:
        """Set the coarse mesh and the surface of the recipe. Return the name of the scalars."""
        data, scalars = self._take(mesh, options)
        self._data = data
        self._coarse = vtkPolyData()
        self._coarse.ShallowCopy(_inputs.extract_surface(data))
        self.recipe = relevo.vtkAdaptiveRefinement()
        if surface is not None:
            chosen = _choose(surface, _SURFACES, relevo.vtkRefinementSurface, "surface")
            self._surface = getattr(relevo, chosen)() if isinstance(chosen, str) else chosen
        elif not isinstance(data, vtkPolyData):
            # Linear cells are flat, and nothing indicates that they should be curved.
            self._surface = relevo.vtkLinearSurface()
        else:
            normals = relevo.vtkCreaseNormals()
            normals.SetInputData(self._coarse)
            _work.update(normals)
            self._coarse.ShallowCopy(normals.GetOutput())
            self._surface = normals.GetFittingSurface()
        self.recipe.SetSurface(self._surface)
        return scalars

    def _find_scalars(self, name: str | None = None) -> tuple[vtkDataArray | None, bool]:
        """Return an array, by default the active scalars, and whether it is of points."""
        if name is not None:
            return _inputs.find_array([self._coarse], name)
        for data, of_points in (
            (self._coarse.GetPointData(), True),
            (self._coarse.GetCellData(), False),
        ):
            scalars = data.GetScalars()
            if scalars is not None and scalars.GetNumberOfTuples():
                if not scalars.GetName():
                    scalars.SetName("Scalars")
                return scalars, of_points
        return None, True

    def _set_up(self, found: tuple[vtkDataArray | None, bool]) -> None:
        """Set input, recipe and colours of the mapper."""
        self._scalars, self._of_points = found
        self.mapper.SetInputData(self._coarse)
        self.mapper.SetRefinement(self.recipe)
        self.mapper.ScalarVisibilityOff()
        self.actor.SetMapper(self.mapper)
        set_material(self.actor)
        given = self._scale.find_given()
        if self._scalars is not None:
            self._colour(self._scalars)
        elif given:
            raise ValueError(f"{given} needs colours by an array, and the mesh has no active scalars")

    def _colour(self, array: vtkDataArray) -> None:
        _colours.choose_array(self.mapper, array.GetName(), self._of_points)
        components = array.GetNumberOfComponents()
        # Bytes with three or more components are colours.
        if array.GetDataType() == VTK_UNSIGNED_CHAR and components >= 3:
            return
        name = array.GetName()
        low, high = array.GetFiniteRange(-1 if components > 1 else 0)
        if self._shows_cells:
            low, high = _extend((low, high), self._get_range_of_cells(self._data, name))
        if self._scale.of_all_steps:
            low, high = _quantities.find_range_of_steps(
                self._source, name, self._get_range, (low, high)
            )
        self._table = self._scale.make_table(*self._scale.choose_range(low, high, name))
        self._title = _colours.make_title(array.GetName(), array)
        _colours.set_table(self.mapper, self._table)

    def _extract(self, data: vtkDataObject) -> vtkPolyData:
        """Return the surface of a time step."""
        return _inputs.extract_surface(data)

    def _get_range(self, data: vtkDataObject, name: str) -> tuple[float, float]:
        """Return the range of an array in a time step: on the surface, and inside if that is shown."""
        found = _get_range_of([self._extract(data)], name)
        if self._shows_cells:
            found = _extend(found, self._get_range_of_cells(data, name))
        return found

    @staticmethod
    def _get_range_of_cells(data: vtkDataObject, name: str) -> tuple[float, float]:
        return _get_range_of(_inputs.get_blocks(data), name)

    def _cut(self) -> None:
        """Clip the surface, and fill the section of 3D cells."""
        if self._plane is None:
            return
        self.mapper.AddClippingPlane(self._plane)
        if not any(_section.is_solid(block) for block in _inputs.get_blocks(self._data)):
            warn("the mesh has no 3D cells, so the cut is hollow")
            return
        section = _section.Section(_inputs.merge_blocks(self._data), self._plane)
        section.set_colours(self.mapper, self.actor)
        self._section = section
        self._others = section.actors

    def _get_legend(self) -> tuple[vtkScalarsToColors | None, str]:
        """Return the table of the mapper, which the caller may have replaced, and the title."""
        is_coloured = self._table is not None and self.mapper.GetScalarVisibility()
        return self.mapper.GetLookupTable() if is_coloured else None, self._title

    def _describe(self) -> str:
        text = f"{self._coarse.GetNumberOfCells()} faces, up to level {self.recipe.GetMaximumLevel()}"
        return text + self._describe_colours()

    def _describe_colours(self) -> str:
        if self._table is None:
            return ""
        low, high = self._table.GetRange()
        return f", {self._title} from {low:g} to {high:g}"

    def _displace(self, height: Any, scale: float | None) -> None:
        displacement = height
        if not isinstance(height, relevo.vtkDisplacement):
            displacement = relevo.vtkDisplacement()
            heights = self._read_heights(height)
            displacement.SetHeightMap(heights)
            if scale is None:
                # Makes heights visible, and puts the lowest point on the surface.
                span = [0.0, 0.0]
                heights.GetRange(span)
                low, high = span
                factor = 0.05 * self._coarse.GetLength() / (high - low) if high > low else 0.0
                displacement.SetScale(factor)
                displacement.SetOffset(-factor * low)
        if scale is not None:
            with Messages(ValueError, {"Scale": "scale"}):
                displacement.SetScale(scale)
        if self._coarse.GetPointData().GetTCoords() is None:
            self._add_texture_coordinates()
        self.recipe.SetDisplacement(displacement)

    @staticmethod
    def _read_heights(height: Any) -> relevo.vtkHeightField:
        if isinstance(height, relevo.vtkHeightField):
            heights = height
        elif _inputs.is_path(height):
            heights = relevo.vtkHeightMap()
            heights.SetFileName(_results.check_file(height))
        elif is_raster(height):
            if isinstance(height, numpy.ndarray):
                heights = arrays.height_map(height)
            else:
                raster = RasterFile(height)
                heights = relevo.vtkHeightMap()
                raster.keep_for(heights)
                heights.SetFileName(raster.name)
        else:
            raise TypeError(
                "height must be a path, a 2-D array, a vtkHeightField or a vtkDisplacement, not"
                f" {type(height).__name__}"
            )
        _work.update_heights(heights)
        return heights

    def _add_texture_coordinates(self) -> None:
        """Map a flat mesh by a plane and other meshes by a sphere, as relevo-view does."""
        points = vtk_to_numpy(self._coarse.GetPoints().GetData()).astype(float)
        low, high = points.min(axis=0), points.max(axis=0)
        size = high - low
        thinnest = int(size.argmin())
        if size[thinnest] < 0.1 * size.max():
            axes = [axis for axis in range(3) if axis != thinnest]
            share = (points - low) / numpy.where(size > 0, size, 1.0)
            uv = numpy.where(size > 0, share, 0.5)[:, axes]
        else:
            order = [(self._up + axis) % 3 for axis in range(3)]
            z, x, y = ((points - 0.5 * (low + high))[:, order]).T
            radius = numpy.sqrt(x * x + y * y + z * z)
            cosine = numpy.divide(z, radius, out=numpy.zeros_like(z), where=radius > 0)
            u = numpy.abs(numpy.arctan2(y, x)) / numpy.pi
            uv = numpy.stack([u, 1.0 - numpy.arccos(cosine) / numpy.pi], axis=1)
        coordinates = numpy_to_vtk(uv.astype(numpy.float32), deep=True)
        coordinates.SetName("TextureCoordinates")
        self._coarse.GetPointData().SetTCoords(coordinates)

    def _get_points(self) -> Array:
        """Return points of the surface, refined to about 100 000 triangles."""
        level = 3
        while level > 0 and self._coarse.GetNumberOfCells() << (2 * level) > _VIEWED_TRIANGLES:
            level -= 1
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(level)
        recipe.SetSurface(self.recipe.GetSurface())
        recipe.SetDisplacement(self.recipe.GetDisplacement())
        refine = relevo.vtkAdaptiveRefinementFilter()
        refine.SetInputData(self._coarse)
        refine.SetRefinement(recipe)
        _work.update(refine)
        points = refine.GetOutput().GetPoints()
        if points is None or points.GetNumberOfPoints() == 0:
            return super()._get_points()
        result: Array = vtk_to_numpy(points.GetData())
        return result

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        refine = relevo.vtkAdaptiveRefinementFilter()
        refine.SetInputData(self._coarse)
        refine.SetRefinement(self.recipe)
        refine.SetCamera(self._make_camera(camera))
        refine.SetViewportSize(*SIZE)
        # Vertices of a mesh have their final positions.
        geomorphing = self.recipe.GetGeomorphing()
        self.recipe.GeomorphingOff()
        try:
            _work.update(refine)
        finally:
            self.recipe.SetGeomorphing(geomorphing)
        if refine.GetOutput().GetNumberOfCells() == 0:
            raise Error("the mesh has no cells to draw")
        return refine.GetOutput()

    def _draw(self, size: tuple[int, int], camera: Camera) -> vtkImageData:
        image = super()._draw(size, camera)
        if self.mapper.GetNumberOfCoarseFaces() == 0:
            raise Error("the mesh has no cells to draw")
        return image
