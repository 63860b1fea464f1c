# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells with their exact shape and fields."""

from __future__ import annotations

import math
from typing import Any

from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataSet,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _inputs, _work
from ._drawing import Drawing
from ._messages import Messages, warn
from ._options import MeshOptions
from ._refined import Refined

_LEVEL = 7


def _warp_block(block: vtkDataSet, name: str, factor: float) -> vtkDataSet:
    from vtkmodules.vtkFiltersGeneral import vtkWarpVector

    if block.GetPointData().GetArray(name).GetNumberOfComponents() != 3:
        raise ValueError(f"warp: {name!r} must be an array of points with 3 components")
    warp = vtkWarpVector()
    warp.SetInputData(block)
    warp.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    warp.SetScaleFactor(factor)
    _work.update(warp)
    warped: Any = warp.GetOutputDataObject(0)
    moved: vtkDataSet = warped
    return moved


def _warp(data: vtkDataObject, name: str, factor: float) -> vtkDataObject:
    """Return a mesh whose nodes are displaced by an array of points.

    Blocks without the array stay where they are, with a warning.
    """
    blocks = _inputs.get_blocks(data)
    if not _inputs.find_array(blocks, name)[1]:
        raise ValueError(f"warp: {name!r} must be an array of points with 3 components")
    moved = vtkMultiBlockDataSet()
    missing = 0
    for i, block in enumerate(blocks):
        has_array = block.GetPointData().GetArray(name) is not None
        missing += not has_array and block.GetNumberOfPoints() > 0
        moved.SetBlock(i, _warp_block(block, name, factor) if has_array else block)
    if missing:
        warn(
            f"{missing} of {len(blocks)} blocks have no array of points {name!r}, so they are not"
            " moved"
        )
    return moved


class Patches(Refined):
    """The outer faces of curved cells, see relevo.patches()."""

    mapper: relevo.vtkAdaptivePatchMapper

    def __init__(
        self,
        mesh: Any,
        options: MeshOptions,
        warp: str | None,
        factor: float,
        edges: bool,
        isolines: int,
        error: float | None,
    ) -> None:
        _inputs.check_number(factor, "factor")
        if not math.isfinite(factor):
            raise ValueError(f"factor must be finite, not {factor}")
        if error is not None:
            _inputs.check_number(error, "error")
        data, scalars = self._take(mesh, options)
        if warp is not None:
            data = _warp(data, warp, factor)
        elif factor != 1.0:
            raise ValueError("factor needs warp, the name of an array")
        self._data = data
        self._coarse = self._extract(data)
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
        self._set_up(self._find_scalars(scalars))
        with Messages(ValueError, {"ScreenSpaceError": "error", "IsolineSpacing": "isolines"}):
            if error is not None:
                metric.SetScreenSpaceError(error)
            self.mapper.SetPatchEdges(bool(edges))
            self._draw_isolines(isolines)
        if isolines and self._scale.log:
            raise ValueError("isolines cannot be combined with log")
        self._set_lighting(options.lighting)
        self._cut()

    def _extract(self, data: vtkDataObject) -> vtkPolyData:
        patches = relevo.vtkPatchSurfaceFilter()
        patches.SetInputData(_inputs.make_grid(data))
        _work.update(patches)
        return patches.GetOutput()

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
