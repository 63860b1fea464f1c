# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts of a plane through meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor, vtkMapper, vtkPolyDataMapper

import relevo

from . import _inputs

if TYPE_CHECKING:
    from . import _vtk

_LINE_OFFSET = 5e-4  # towards the viewer, as a share of the diagonal
_AMBIENT = 0.7  # so that values can be read whichever way the cut faces
_LINE_OPACITY = 0.35


def make_plane(clip: Any) -> vtkPlane:
    """Return the plane of the option clip: a vtkPlane, or (point, normal)."""
    if isinstance(clip, vtkPlane):
        return clip
    try:
        origin, normal = (tuple(float(number) for number in vector) for vector in clip)
    except (TypeError, ValueError):
        origin = normal = ()
    if len(origin) != 3 or len(normal) != 3:
        raise TypeError(f"clip must be a vtkPlane, or (point, normal), not {clip!r}")
    if not any(normal) or not numpy.isfinite([*origin, *normal]).all():
        raise ValueError("clip: the normal must have a length, and all numbers must be finite")
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane


def is_solid(block: vtkDataSet) -> bool:
    """Return whether a data set has 3D cells."""
    return any(cell.GetCellDimension() == 3 for cell in _inputs.get_kinds_of_cells(block))


class Section:
    """The filled cut of a plane through 3D cells, and the edges of the cells there."""

    actors: tuple[_vtk.vtkActor, _vtk.vtkActor]

    def __init__(self, data: vtkDataSet, plane: vtkPlane) -> None:
        self._cutter = relevo.vtkCurvedCellCutter()
        self._cutter.SetInputData(data)
        self._cutter.SetCutFunction(plane)
        self._faces, lines = vtkPolyDataMapper(), vtkPolyDataMapper()
        self._faces.SetInputConnection(self._cutter.GetOutputPort(0))
        lines.SetInputConnection(self._cutter.GetOutputPort(1))
        lines.ScalarVisibilityOff()
        self.actors = vtkActor(), vtkActor()
        self.actors[0].SetMapper(self._faces)
        self.actors[1].SetMapper(lines)
        look = self.actors[1].GetProperty()
        look.SetColor(0, 0, 0)
        look.SetOpacity(_LINE_OPACITY)
        look.LightingOff()
        normal = numpy.array(plane.GetNormal())
        length = _LINE_OFFSET * data.GetLength() / numpy.linalg.norm(normal)
        self.actors[1].SetPosition(-length * normal)

    def set_colours(self, mapper: vtkMapper, actor: vtkActor) -> None:
        """Use the colours of the surface, nearly without shading."""
        faces = self._faces
        faces.SetScalarMode(mapper.GetScalarMode())
        faces.SetScalarVisibility(mapper.GetScalarVisibility())
        faces.SetInterpolateScalarsBeforeMapping(mapper.GetInterpolateScalarsBeforeMapping())
        faces.SetLookupTable(mapper.GetLookupTable())
        faces.SetUseLookupTableScalarRange(mapper.GetUseLookupTableScalarRange())
        if mapper.GetArrayName():
            faces.SelectColorArray(mapper.GetArrayName())
        look = self.actors[0].GetProperty()
        look.DeepCopy(actor.GetProperty())
        look.SetInterpolationToFlat()
        if look.GetLighting():
            look.SetAmbient(_AMBIENT)
            look.SetDiffuse(1 - _AMBIENT)
        look.SetSpecular(0)
