# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The interior of a mesh of 3D cells."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty

import relevo

from . import _colours, _inputs, _quantities, _results, _section, _work
from ._drawing import SIZE, Drawing, _check_size, _make_offscreen_window
from ._error import Error
from ._messages import Messages
from ._options import MeshOptions
from ._typing import Array, Camera

if TYPE_CHECKING:
    from . import _vtk

_BLENDS = ("composite", "maximum", "minimum", "average", "additive", "isosurface")
_BY_LENGTH = ("composite", "additive")
_PARTS = 10  # between quantiles
_NODES = 9
_SAMPLE = 20000  # values
_LOWEST_SHARE = 0.03  # opacity at the lowest value, relative to the highest
_DEPTH = 20.0  # optical depth of a diagonal at the highest value
_OPACITY_OF_ONE_VALUE = 0.8
_MINIMUM_THICKNESS = 1e-3  # relative to the diagonal
_CUBE = 2 / 3 / math.sqrt(3)  # mean chord of a cube, relative to its diagonal
_PEAK_WIDTH = 2e-4  # relative to the range
_PEAK_OPACITY = 0.6

_TOLERANCES = {"ShapeTolerance": "shape_tolerance", "FieldTolerance": "field_tolerance"}


def _find_array(
    blocks: Sequence[vtkDataSet], name: str | None
) -> tuple[list[vtkDataArray], str, bool]:
    """Return the arrays of the blocks that have it, their name, and whether they are of points."""
    if name is not None:
        _, of_points = _inputs.find_array(blocks, name)
    else:
        names = _inputs.list_arrays(blocks)
        for of_points in (True, False):
            for block in blocks:
                data = block.GetPointData() if of_points else block.GetCellData()
                if data.GetScalars() is not None:
                    if not data.GetScalars().GetName():
                        data.GetScalars().SetName("Scalars")
                    name = data.GetScalars().GetName()
                    break
            if name is not None:
                break
        else:
            if not any(names):
                raise ValueError("the mesh has no arrays to show")
            of_points = bool(names[0])
            name = names[0 if of_points else 1][0]
    arrays = [
        (block.GetPointData() if of_points else block.GetCellData()).GetArray(name)
        for block in blocks
    ]
    return [array for array in arrays if array is not None], name, of_points


def _get_quantiles(arrays: Iterable[vtkDataArray]) -> tuple[float, float, Array]:
    """Return the range and the deciles of the values, or the lengths of vectors."""
    samples = []
    low, high = math.inf, -math.inf
    for array in arrays:
        values = vtk_to_numpy(array)
        own = array.GetFiniteRange(-1 if values.ndim > 1 else 0)
        low, high = min(low, own[0]), max(high, own[1])
        values = values[:: len(values) // _SAMPLE + 1].astype(float)
        samples.append(numpy.linalg.norm(values, axis=1) if values.ndim > 1 else values)
    sample = numpy.concatenate(samples)
    sample = numpy.sort(sample[numpy.isfinite(sample)])
    indices = numpy.arange(_PARTS + 1) * (len(sample) - 1) // _PARTS
    quantiles = sample[indices] if len(sample) else sample
    if not low < high:
        # A range of representable numbers around a constant.
        middle = low if low == high else 0.0
        reach = max(1e-3 * abs(middle), 1e-6)
        low, high = middle - reach, middle + reach
    return low, high, quantiles


def _get_mean_chord(data: vtkDataObject) -> float:
    """Return four times the volume divided by the area of the surface (Cauchy); 0 if unknown."""
    from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(_inputs.extract_surface(data))
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    measure = vtkMassProperties()
    measure.SetInputConnection(triangulate.GetOutputPort())
    _work.update(measure)
    area, volume = measure.GetSurfaceArea(), abs(measure.GetVolume())
    chord = 4 * volume / area if area > 0 else 0.0
    return chord if math.isfinite(chord) else 0.0


def _make_nodes(
    low: float,
    high: float,
    quantiles: Array,
    blend: str,
    cells_of_side: float,
    thickness: float,
    colours: _colours.Colours,
) -> Array:
    """Return nodes of a transfer function, (n, 5): value, red, green, blue, opacity.

    They follow the distribution of the values, as in relevo-view.
    """
    ranks = {low: 0.0, high: 1.0}
    for i, value in enumerate(quantiles):
        if low <= value <= high:
            ranks[float(value)] = i / (len(quantiles) - 1)
    known = sorted(ranks)
    spaced = numpy.linspace(low, high, _NODES)
    if colours.log:
        spaced = numpy.geomspace(low, high, _NODES)
    values = numpy.array(sorted({*known, *spaced.clip(low, high).tolist()}))
    rank = numpy.interp(values, known, [ranks[value] for value in known])
    # Opacities follow the scale of the colours.
    share = (values - low) / (high - low)
    if colours.log:
        share = numpy.log(values / low) / math.log(high / low)
    # Values show the distribution; ranks show every part despite outliers.
    height = 0.7 * share**2 + 0.3 * rank**2
    if blend in _BY_LENGTH:
        # Additive blending saturates early.
        depth = 0.2 * _DEPTH if blend == "additive" else _DEPTH
        thinness = max(_CUBE / max(thickness, _MINIMUM_THICKNESS), 1.0) if thickness > 0 else 1.0
        # Coarse blocks have at most opacity 1. Thin parts have few cells, however fine these are.
        highest = min(depth * thinness / cells_of_side, thinness**2)
        opacities = highest * (_LOWEST_SHARE + (1 - _LOWEST_SHARE) * height)
    else:
        opacities = numpy.full(len(values), _OPACITY_OF_ONE_VALUE)
    table = colours.make_function(low, high)
    return numpy.column_stack([values, [table.GetColor(value) for value in values], opacities])


def _add_peaks(nodes: Array, values: Iterable[float]) -> Array:
    """Return nodes that are more opaque at isosurfaces."""
    reach = 0.5 * _PEAK_WIDTH * (nodes[-1, 0] - nodes[0, 0])
    plain = nodes
    for value in values:
        nodes = nodes[abs(nodes[:, 0] - value) > reach]
        places = value + reach * numpy.array([-1, 0, 1])
        peak = numpy.column_stack(
            [places, *(numpy.interp(places, plain[:, 0], plain[:, c]) for c in range(1, 5))]
        )
        peak[1, 4] = max(min(peak[1, 4], 1.0), _PEAK_OPACITY)
        nodes = numpy.concatenate([nodes, peak])
        nodes = nodes[nodes[:, 0].argsort()]
    return nodes


def _check_nodes(transfer: Any) -> Array:
    """Return the nodes of an array, or of a file with one node in each line."""
    if _inputs.is_path(transfer):
        path = _results.check_file(transfer)
        try:
            transfer = numpy.loadtxt(path, ndmin=2)
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from None
    nodes = _inputs.check_array(transfer, "transfer", (5,)).astype(float)
    if not len(nodes) or not numpy.isfinite(nodes).all() or (numpy.diff(nodes[:, 0]) <= 0).any():
        raise ValueError("transfer: values must be finite and increase")
    if nodes[:, 1:].min() < 0 or nodes[:, 1:].max() > 1:
        raise ValueError("transfer: colours and opacities must be from 0 to 1")
    return nodes


class VolumePoint(NamedTuple):
    """A position in a volume, with its cell (of its block), parametric coordinates and value."""

    position: tuple[float, float, float]
    cell: int
    parameters: tuple[float, float, float]
    value: float


class Volume(Drawing):
    """The interior of a mesh, see relevo.volume()."""

    # A light background suits translucent volumes.
    _background = ((0.98, 0.98, 0.98), (0.84, 0.87, 0.91))
    _probe: Any = None
    _names = _TOLERANCES

    mapper: relevo.vtkGPUUnstructuredGridVolumeMapper
    actor: _vtk.vtkVolume

    def __init__(
        self,
        mesh: Any,
        options: MeshOptions,
        transfer: Any,
        unit_distance: float | None,
        isosurfaces: Any,
        blend: str,
        shape_tolerance: float | None,
        field_tolerance: float | None,
    ) -> None:
        given = options.colours.find_given()
        if transfer is not None and given:
            raise ValueError(f"{given} cannot be combined with transfer, which has colours")
        if unit_distance is not None:
            _inputs.check_number(unit_distance, "unit_distance")
        self._data, array = self._take(mesh, options)
        blocks = [block for block in _inputs.get_blocks(self._data) if _section.is_solid(block)]
        if not blocks:
            raise ValueError("the mesh has no 3D cells; relevo.refined() draws surfaces")
        if str(blend).lower() not in _BLENDS:
            raise ValueError(f"blend must be one of {', '.join(_BLENDS)}, not {blend!r}")
        blend = blend.lower()
        super().__init__(relevo.vtkGPUUnstructuredGridVolumeMapper(), vtkVolume())
        values, name, of_points = _find_array(blocks, array)
        self._array = name
        self.mapper.SetInputDataObject(self._data)
        self._set_tolerances(shape_tolerance, field_tolerance)
        if of_points:
            self.mapper.SetScalarModeToUsePointFieldData()
        else:
            self.mapper.SetScalarModeToUseCellFieldData()
        self.mapper.SelectScalarArray(name)
        if values[0].GetNumberOfComponents() > 1:
            self.mapper.SetVectorMode(self.mapper.MAGNITUDE)
        self.mapper.SetBlendMode(_BLENDS.index(blend))
        if options.plane is not None:
            self.mapper.AddClippingPlane(options.plane)
        self.actor.SetMapper(self.mapper)
        self._set_look(values, transfer, unit_distance, isosurfaces, blend)
        self._table = self.actor.GetProperty().GetRGBTransferFunction()
        self._title = _colours.make_title(name, values[0])
        if options.lighting is not None:
            self.actor.GetProperty().SetShade(bool(options.lighting))

    def _set_tolerances(self, shape: float | None, field: float | None) -> None:
        for value, name, setter in (
            (shape, "shape_tolerance", self.mapper.SetShapeTolerance),
            (field, "field_tolerance", self.mapper.SetFieldTolerance),
        ):
            if value is not None:
                _inputs.check_number(value, name)
                with Messages(ValueError, _TOLERANCES):
                    setter(value)

    def _set_look(
        self,
        values: Sequence[vtkDataArray],
        transfer: Any,
        unit_distance: float | None,
        isosurfaces: Any,
        blend: str,
    ) -> None:
        bounds = numpy.array(self.mapper.GetBounds()).reshape(3, 2)
        diagonal = float(numpy.linalg.norm(bounds[:, 1] - bounds[:, 0]))
        if not 0 < diagonal < math.inf:
            raise Error("the mesh has no extent: its points are not finite, or coincide")
        if isinstance(transfer, vtkVolumeProperty):
            self.actor.SetProperty(transfer)
            if unit_distance is not None:
                transfer.SetScalarOpacityUnitDistance(unit_distance)
            return
        low, high, quantiles = _get_quantiles(values)
        if transfer is None:
            if self._scale.of_all_steps:
                low, high = _quantities.find_range_of_steps(
                    self._source, self._array, self._get_range, (low, high)
                )
            low, high = self._scale.choose_range(low, high, self._array)
        cells_of_side = self._data.GetNumberOfElements(self._data.CELL) ** (1 / 3)
        surfaces = _inputs.check_numbers(isosurfaces, "isosurfaces")
        if blend == "isosurface" and not surfaces:
            surfaces = [0.5 * (low + high)]
        if transfer is not None:
            nodes = _check_nodes(transfer)
        else:
            thickness = _get_mean_chord(self._data) / diagonal
            nodes = _make_nodes(
                low, high, quantiles, blend, cells_of_side, thickness, self._scale
            )
            if blend in _BY_LENGTH:
                nodes = _add_peaks(nodes, surfaces)
        colours, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
        for value, red, green, blue, opacity in nodes.tolist():
            colours.AddRGBPoint(value, red, green, blue)
            opacities.AddPoint(value, opacity)
        look = self.actor.GetProperty()
        if transfer is None:
            colours = self._scale.make_function(low, high)
        look.SetColor(colours)
        look.SetScalarOpacity(opacities)
        look.SetAmbient(0.3)
        if unit_distance is None:
            unit_distance = diagonal / cells_of_side
        elif not 0 < unit_distance < math.inf:
            raise ValueError(f"unit_distance must be a length greater than 0, not {unit_distance}")
        look.SetScalarOpacityUnitDistance(unit_distance)
        look.GetIsoSurfaceValues().SetNumberOfContours(0)
        for i, value in enumerate(surfaces):
            look.GetIsoSurfaceValues().SetValue(i, value)
        self.mapper.SetIsoSurfaces(bool(surfaces))
        look.SetShade(bool(surfaces))

    def _describe(self) -> str:
        cells = self._data.GetNumberOfElements(self._data.CELL)
        low, high = self.actor.GetProperty().GetRGBTransferFunction().GetRange()
        return f"{cells} cells, {self._title} from {low:g} to {high:g}"

    @staticmethod
    def _get_range(data: vtkDataObject, name: str) -> tuple[float, float]:
        """Return the range of an array in a time step."""
        blocks = [block for block in _inputs.get_blocks(data) if _section.is_solid(block)]
        return _get_quantiles(_find_array(blocks, name)[0])[:2]

    def probe(
        self, x: float, y: float, size: tuple[int, int] = SIZE, camera: Camera = None
    ) -> VolumePoint | None:
        """Return where the ray through a pixel of screenshot(size=, camera=) becomes opaque.

        x, y: column and row of the pixel, counted from the top left.
        size, camera: as for screenshot().

        Returns the position at which half of the light is absorbed, its cell and its value, or None
        if more light passes. See vtkVolumeProbe. Raises relevo.Error with average blending.
        """
        size = _check_size(size)
        window = _make_offscreen_window(self._is_on_display())
        with Messages():
            window.SetSize(size)
            renderer = self._make_renderer(size, camera)
            window.AddRenderer(renderer)
            try:
                if self._probe is None:
                    self._probe = relevo.vtkVolumeProbe()
                self._probe.SetRenderer(renderer)
                is_hit = self._probe.Probe(x, size[1] - 1 - y)
            finally:
                self._probe.SetRenderer(None)
                window.Finalize()
        if not is_hit:
            return None
        return VolumePoint(
            self._probe.GetPosition(),
            self._probe.GetCellId(),
            self._probe.GetParametricCoordinates(),
            self._probe.GetValue(),
        )

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        result = self._data.NewInstance()
        result.ShallowCopy(self._data)
        return result
