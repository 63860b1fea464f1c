# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines along a vector field."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkTubeFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from . import _colours, _inputs, _outputs, _section, _work
from ._drawing import set_exact_colours
from ._messages import Messages, warn
from ._options import MeshOptions
from ._refined import Refined
from ._typing import Array, Camera

if TYPE_CHECKING:
    from . import _vtk

# Shares of the diagonal.
_RADIUS = 0.002
_LONGEST_LINE = 3.0  # in each direction

_SIDES = 8
_MOST_STEPS = 5000
_MOST_SEEDS = 100000
_OPACITY_AROUND_LINES = 0.15  # of the surface and the section of 3D cells


def _check_line(seed_line: Any) -> Array:
    """Return two points, of shape (2, 3)."""
    ends = numpy.asarray(seed_line)
    if ends.shape != (2, 3) or ends.dtype.kind not in "iuf":
        raise TypeError(f"seed_line must be two points of three numbers, not {seed_line!r}")
    if not numpy.isfinite(ends).all():
        raise ValueError("seed_line: all numbers must be finite")
    return ends.astype(float)


def _list_seed_cells(mesh: vtkDataSet, number: int) -> list[int]:
    """Return cells that are evenly spaced in the order of the mesh: 3D cells if there are some."""
    cells: Any = range(mesh.GetNumberOfCells())
    kinds = {cell.GetCellType(): cell.GetCellDimension() for cell in _inputs.get_kinds_of_cells(mesh)}
    if len({dimension == 3 for dimension in kinds.values()}) > 1:
        cells = [cell for cell in cells if kinds[mesh.GetCellType(cell)] == 3]
    taken = min(number, len(cells))
    return [cells[(2 * i + 1) * len(cells) // (2 * taken)] for i in range(taken)]


def _make_seeds(mesh: vtkDataSet, number: int, seed_line: Array | None) -> vtkPolyData:
    """Return points on a line, or in the middles of cells."""
    if seed_line is not None:
        share = numpy.linspace(0, 1, number)[:, None] if number > 1 else numpy.array([[0.5]])
        places = seed_line[0] + share * (seed_line[1] - seed_line[0])
    else:
        corners = (mesh.GetCell(cell).GetPoints() for cell in _list_seed_cells(mesh, number))
        middles = [vtk_to_numpy(own.GetData()).mean(axis=0, dtype=float) for own in corners]
        places = numpy.array(middles).reshape(-1, 3)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    seeds = vtkPolyData()
    seeds.SetPoints(points)
    return seeds


class Streamlines(Refined):
    """Streamlines along a vector field, see relevo.streamlines()."""

    _shows_cells = True

    tracer: vtkStreamTracer
    tubes: vtkTubeFilter
    line_actor: _vtk.vtkActor

    def __init__(
        self,
        mesh: Any,
        options: MeshOptions,
        vectors: str | None,
        seeds: int,
        seed_line: Any,
    ) -> None:
        _inputs.check_number(seeds, "seeds", integer=True)
        if not 1 <= seeds <= _MOST_SEEDS:
            raise ValueError(f"seeds must be from 1 to {_MOST_SEEDS}, not {seeds}")
        line = None if seed_line is None else _check_line(seed_line)
        self._wanted = vectors
        super().__init__(mesh, options)
        self._trace(_inputs.merge_blocks(self._data), int(seeds), line)
        self._draw_lines(options.lighting)

    def _take_surface(
        self, mesh: Any, options: MeshOptions, surface: Any = None
    ) -> str | None:
        scalars = super()._take_surface(mesh, options, surface)
        self._vectors = self._find_vectors(self._wanted)
        return scalars or self._vectors

    def _find_vectors(self, name: str | None) -> str:
        blocks = _inputs.get_blocks(self._data)
        if name is not None:
            components = _inputs.find_array(blocks, name)[0].GetNumberOfComponents()
            if components != 3:
                raise ValueError(f"the array {name!r} has {components} components, not 3")
            return name
        attributes = [own for block in blocks for own in (block.GetPointData(), block.GetCellData())]
        for data in attributes:
            if data.GetVectors() is not None and data.GetVectors().GetName():
                found: str = data.GetVectors().GetName()
                return found
        for own in (name for names in _inputs.list_arrays(blocks) for name in names):
            if _inputs.find_array(blocks, own)[0].GetNumberOfComponents() == 3:
                return own
        raise ValueError("the mesh has no array of 3 components")

    def _trace(self, mesh: vtkDataSet, seeds: int, line: Array | None) -> None:
        """Trace the lines. Arrays of cells are averaged at points."""
        field: vtkDataObject = mesh
        names = [self._vectors, *([self._scalars.GetName()] if self._scalars else [])]
        if not all(mesh.GetPointData().HasArray(name) for name in names):
            average = vtkCellDataToPointData()
            average.SetInputData(mesh)
            _work.update(average)
            field = average.GetOutput()
        tracer = self.tracer = vtkStreamTracer()
        tracer.SetInputData(field)
        tracer.SetSourceData(_make_seeds(mesh, seeds, line))
        tracer.SetInputArrayToProcess(
            0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, self._vectors
        )
        tracer.SetIntegratorTypeToRungeKutta45()
        tracer.SetIntegrationDirectionToBoth()
        tracer.SetMaximumPropagation(_LONGEST_LINE * mesh.GetLength())
        tracer.SetMaximumNumberOfSteps(_MOST_STEPS)
        tracer.SetComputeVorticity(False)
        tracer.SetSurfaceStreamlines(isinstance(mesh, vtkPolyData))
        with Messages():
            _work.update(tracer)
        if tracer.GetOutput().GetNumberOfLines() == 0:
            warn(
                f"there are no streamlines: no seed is where {self._vectors!r} has a direction;"
                " seed_line and seeds set other seeds"
            )
        self.tubes = vtkTubeFilter()
        self.tubes.SetInputConnection(tracer.GetOutputPort())
        self.tubes.SetRadius(_RADIUS * mesh.GetLength())
        self.tubes.SetNumberOfSides(_SIDES)
        self.tubes.CappingOn()

    def _draw_lines(self, lighting: bool | None) -> None:
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self.tubes.GetOutputPort())
        if self._scalars is not None and self._table is not None:
            _colours.choose_array(mapper, self._scalars.GetName(), of_points=True)
            _colours.set_table(mapper, self._table)
        self.line_actor = vtkActor()
        self.line_actor.SetMapper(mapper)
        look = self.line_actor.GetProperty()
        look.SetInterpolationToPhong()
        look.SetAmbient(0.3)
        look.SetDiffuse(0.7)
        if not lighting:
            set_exact_colours(self.line_actor)
        self._others = [*self._others, self.line_actor]

    def _cut(self) -> None:
        # Before the section takes the material.
        if any(_section.is_solid(block) for block in _inputs.get_blocks(self._data)):
            self.actor.GetProperty().SetOpacity(_OPACITY_AROUND_LINES)
        super()._cut()

    @property
    def lines(self) -> Any:
        """The lines, as a mesh of poly-lines with the arrays of the points."""
        return _outputs.to_kind(self.tracer.GetOutput(), self._kind)

    def _describe(self) -> str:
        number = self.tracer.GetOutput().GetNumberOfLines()
        return f"{number} lines along {self._vectors!r}{self._describe_colours()}"

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        return self.tracer.GetOutput()
