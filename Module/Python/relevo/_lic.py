# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Streaks along a vector field on a refined surface."""

from __future__ import annotations

import math
from typing import Any

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _inputs
from ._drawing import SIZE, Drawing
from ._options import MeshOptions
from ._refined import Refined

_HIGHEST_LEVEL = 7
_PIXELS = 10.0  # length of the longest segment of an edge
_MEAN_PIXELS = 4.0  # length of the segments of a mean edge at the highest level


def _choose_level(mesh: vtkPolyData) -> int:
    """Return the level at which a mean edge has short segments if the mesh fills the picture."""
    polygons = mesh.GetPolys()
    corners = vtk_to_numpy(polygons.GetConnectivityArray())
    if not len(corners):
        return 0
    points = vtk_to_numpy(mesh.GetPoints().GetData())[corners].astype(float)
    offsets = vtk_to_numpy(polygons.GetOffsetsArray())
    following = numpy.arange(1, len(corners) + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    length = numpy.linalg.norm(points[following] - points, axis=1).mean()
    pixels = max(SIZE) * length / mesh.GetLength() if mesh.GetLength() > 0 else 0.0
    if not 0 < pixels < math.inf:
        return 0
    return min(max(math.ceil(math.log2(pixels / _MEAN_PIXELS)), 0), _HIGHEST_LEVEL)


def _is_flow(array: vtkDataArray | None) -> bool:
    return array is not None and array.GetNumberOfComponents() in (2, 3)


class LIC(Refined):
    """Streaks along a vector field on a refined surface, see relevo.lic()."""

    mapper: relevo.vtkAdaptiveLICMapper

    def __init__(
        self,
        mesh: Any,
        options: MeshOptions,
        vectors: str | None,
    ) -> None:
        self._take_surface(mesh, options)
        array, of_points = self._find_vectors(vectors)
        Drawing.__init__(self, relevo.vtkAdaptiveLICMapper(), vtkActor())
        self._set_up((array, of_points))
        self.mapper.SetInputArrayToProcess(
            0,
            0,
            0,
            vtkDataObject.FIELD_ASSOCIATION_POINTS
            if of_points
            else vtkDataObject.FIELD_ASSOCIATION_CELLS,
            array.GetName(),
        )
        length = relevo.vtkScreenEdgeDepthTagMetric()
        length.SetReferenceLength(_PIXELS)
        length.SetMeasureToSphereDiameter()
        variation = relevo.vtkFieldVariationDepthTagMetric()
        variation.SetArrayName(array.GetName())
        metric = relevo.vtkCompositeDepthTagMetric()
        metric.SetModeToMaximum()
        metric.AddMetric(variation)
        metric.AddMetric(length)
        self.recipe.SetMetric(metric)
        self.recipe.SetMaximumLevel(_choose_level(self._coarse))
        self._set_lighting(options.lighting)

    def _find_vectors(self, vectors: str | None) -> tuple[vtkDataArray, bool]:
        if vectors is not None:
            array, of_points = _inputs.find_array([self._coarse], vectors)
            if not _is_flow(array):
                raise ValueError(
                    f"the array {vectors!r} has {array.GetNumberOfComponents()} components, not 2"
                    " or 3"
                )
            return array, of_points
        points, cells = self._coarse.GetPointData(), self._coarse.GetCellData()
        for data in (points, cells):
            if data.GetVectors() is not None and data.GetVectors().GetName():
                return data.GetVectors(), data is points
        for names, data in zip(_inputs.list_arrays([self._coarse]), (points, cells)):
            for name in names:
                if _is_flow(data.GetArray(name)):
                    return data.GetArray(name), data is points
        raise ValueError("the mesh has no array of 2 or 3 components")
