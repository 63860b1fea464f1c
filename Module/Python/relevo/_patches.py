# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells with their exact shape and fields."""

from __future__ import annotations

import math
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _camera, _inputs, _stress, _work
from ._drawing import Drawing
from ._messages import Messages
from ._refined import Refined

_LEVEL = 7


def _warp(grid: vtkUnstructuredGrid, name: str, factor: float) -> vtkUnstructuredGrid:
    """Return a grid whose nodes are displaced by an array of points."""
    from vtkmodules.vtkFiltersGeneral import vtkWarpVector

    array, of_points = _inputs.find_array([grid], name)
    if not of_points or array.GetNumberOfComponents() != 3:
        raise ValueError(f"warp: {name!r} must be an array of points with 3 components")
    warp = vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    warp.SetScaleFactor(factor)
    _work.update(warp)
    warped: vtkUnstructuredGrid = warp.GetUnstructuredGridOutput()
    return warped


def _take_grid(data: vtkDataObject) -> vtkUnstructuredGrid:
    """Return a mesh as one vtkUnstructuredGrid."""
    from vtkmodules.vtkFiltersCore import vtkAppendFilter

    append = vtkAppendFilter()
    blocks = _inputs.get_blocks(data)
    if not blocks:
        raise ValueError("the mesh is empty")
    for block in blocks:
        append.AddInputData(block)
    _work.update(append)
    return append.GetOutput()


class Patches(Refined):
    """The outer faces of curved cells, see relevo.patches()."""

    mapper: relevo.vtkAdaptivePatchMapper

    def __init__(
        self,
        mesh: Any,
        scalars: str | None,
        warp: str | None,
        factor: float,
        edges: bool,
        isolines: int,
        error: float | None,
        up: str,
        lighting: bool,
    ) -> None:
        self._up = _camera.find_axis(up)
        _inputs.check_number(factor, "factor")
        if not math.isfinite(factor):
            raise ValueError(f"factor must be finite, not {factor}")
        if error is not None:
            _inputs.check_number(error, "error")
        data, self._kind = _inputs.take_data(mesh)
        data, scalars = _stress.add_stress(data, scalars)
        grid = data if isinstance(data, vtkUnstructuredGrid) else _take_grid(data)
        if warp is not None:
            grid = _warp(grid, warp, factor)
        elif factor != 1.0:
            raise ValueError("factor needs warp, the name of an array")
        patches = relevo.vtkPatchSurfaceFilter()
        patches.SetInputData(grid)
        _work.update(patches)
        self._coarse = patches.GetOutput()
        if self._coarse.GetNumberOfCells() == 0:
            raise ValueError("the mesh has no 2D or 3D cells")
        Drawing.__init__(self, relevo.vtkAdaptivePatchMapper(), vtkActor())
        metric = relevo.vtkPatchErrorDepthTagMetric()
        self.recipe = relevo.vtkAdaptiveRefinement()
        self.recipe.SetSurface(relevo.vtkPatchSurface())
        self.recipe.SetMetric(metric)
        self.recipe.SetLevelRuleToPerEdge()
        self.recipe.SetSegmentPolicyToWholeNumbers()
        self.recipe.SetMaximumLevel(_LEVEL)
        if scalars is None:
            found = self._find_scalars()
        else:
            found = _inputs.find_array([self._coarse], scalars)
        self._set_up(found)
        with Messages(ValueError, {"ScreenSpaceError": "error", "IsolineSpacing": "isolines"}):
            if error is not None:
                metric.SetScreenSpaceError(error)
            self.mapper.SetPatchEdges(bool(edges))
            self._draw_isolines(isolines)
        self._set_lighting(lighting)

    def _describe(self) -> str:
        return f"{self._coarse.GetNumberOfCells()} patches{self._describe_colours()}"

    def _draw_isolines(self, number: int) -> None:
        if isinstance(number, bool) or not isinstance(number, int) or number < 0:
            raise ValueError(f"isolines must be a number of lines, at least 0, not {number!r}")
        if number == 0:
            return
        if self._table is None:
            raise ValueError("isolines need scalars")
        low, high = self._table.GetRange()
        if high > low:
            self.mapper.SetIsolineSpacing((high - low) / number)
