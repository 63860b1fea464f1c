# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Images with depth."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _inputs, _results, _work
from ._drawing import Drawing
from ._messages import Messages
from ._raster import is_raster
from ._refined import Refined
from ._typing import Camera

if TYPE_CHECKING:
    from . import _vtk


def _convert(heights: relevo.vtkHeightField) -> vtkDataObject:
    """Return the relief of a vtkHeightField. It is flattened if it would be higher than wide."""
    convert = relevo.vtkHeightMapToRelief()
    convert.SetHeightMap(heights)
    mapper = relevo.vtkReliefMapper()
    mapper.SetInputConnection(convert.GetOutputPort())
    with Messages():
        _work.update(convert)
        bounds = mapper.GetBounds()
        width = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
        if bounds[5] - bounds[4] > width:
            convert.SetExaggeration(float(f"{0.2 * width / (bounds[5] - bounds[4]):.2g}"))
            _work.update(convert)
    return convert.GetOutput()


def _is_heights(source: object) -> bool:
    if _inputs.is_path(source):
        return not os.path.isdir(source) and not _results.is_mesh_file(source)
    return isinstance(source, relevo.vtkHeightField) or is_raster(source)


def _read(source: Any) -> tuple[vtkDataObject, str]:
    """Return the reliefs of a source, and its package."""
    if _inputs.is_path(source) and os.path.isdir(source):
        reader = relevo.vtkReliefDatabaseReader()
        reader.SetFileName(os.fspath(source))
        _work.update(reader)
        return reader.GetOutput(), ""
    if _is_heights(source):
        return _convert(Refined._read_heights(source)), ""
    taken = _inputs.take_data(source, "source")
    return taken.data, taken.package


class Relief(Drawing):
    """Reliefs, which are images with depth, see relevo.relief()."""

    mapper: relevo.vtkReliefMapper
    actor: _vtk.vtkActor

    def __init__(self, source: Any, lighting: bool | None) -> None:
        self._data, self._kind = _read(source)
        super().__init__(relevo.vtkReliefMapper(), vtkActor())
        self.mapper.SetInputDataObject(self._data)
        self.actor.SetMapper(self.mapper)
        if _is_heights(source):
            self.mapper.SetShadingToLit()
            self._up = 2
            self._direction = (192, 38)
            self._lights = ((315, 40, 1.0), (160, 50, 0.35))
        if lighting is not None:
            shading = self.mapper.LIT if lighting else self.mapper.CAPTURED
            self.mapper.SetShading(shading)
        with Messages():
            self.mapper.GetBounds()

    def _describe(self) -> str:
        blocks = _inputs.get_blocks(self._data)
        images = [own.GetDimensions()[:2] for own in blocks if isinstance(own, vtkImageData)]
        sizes = dict.fromkeys(f"{columns} x {rows}" for columns, rows in images)
        return f"{len(images)} of {', '.join(sizes)} texels"

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        result = self._data.NewInstance()
        result.ShallowCopy(self._data)
        return result
