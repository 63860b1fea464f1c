# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Equivalent stress of tensor arrays."""

from __future__ import annotations

import re

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkFieldData

from . import _inputs
from ._typing import Array

_NAME = re.compile(r"von[ -]mises( of (?P<tensor>.+))?", re.IGNORECASE)
_TENSORS = (6, 9)  # components


def _get_components(array: vtkDataArray) -> Array:
    """Return tensors as (n, 6): xx, yy, zz, xy, yz, xz, which is VTK's order."""
    values: Array = vtk_to_numpy(array).astype(float)
    if values.shape[1] == 6:
        return values
    full = values.reshape(-1, 3, 3)
    half = 0.5 * (full + full.transpose(0, 2, 1))
    upper: Array = half[:, [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]
    return upper


def _compute(array: vtkDataArray, name: str) -> vtkDataArray:
    xx, yy, zz, xy, yz, xz = _get_components(array).T
    normal = 0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
    result: vtkDataArray = numpy_to_vtk(numpy.sqrt(normal + 3 * (xy**2 + yz**2 + xz**2)), deep=True)
    result.SetName(name)
    if array.HasInformation():
        result.CopyInformation(array.GetInformation())  # the unit
    return result


def _get_attributes(block: vtkDataSet) -> tuple[vtkFieldData, vtkFieldData]:
    return block.GetPointData(), block.GetCellData()


def _list_tensors(data: vtkDataObject) -> list[str]:
    tensors: dict[str, None] = {}
    for block in _inputs.get_blocks(data):
        for own in _get_attributes(block):
            for i in range(own.GetNumberOfArrays()):
                array = own.GetArray(i)
                if array is not None and array.GetNumberOfComponents() in _TENSORS:
                    tensors[array.GetName()] = None
    return list(tensors)


def _choose_tensor(data: vtkDataObject, name: str, wanted: str | None) -> str:
    tensors = _list_tensors(data)
    if wanted in tensors:
        return wanted
    listed = ", ".join(map(repr, tensors)) or "none"
    if wanted is not None or not tensors:
        raise ValueError(
            f"{name!r} needs an array of 6 or 9 components, the stress tensor; the mesh has {listed}"
        )
    if len(tensors) > 1:
        raise ValueError(
            f"{name!r}: the mesh has the tensors {listed}; choose one, such as"
            f" 'von Mises of {tensors[0]}'"
        )
    return tensors[0]


def add_stress(data: vtkDataObject, name: str | None) -> tuple[vtkDataObject, str | None]:
    """Return a copy of a mesh with the von Mises stress that a name asks for, and its array's name.

    name: "von Mises", or "von Mises of S" for the tensors S. The mesh and the name are unchanged for
        others, and if the mesh has an array of that name.
    """
    match = _NAME.fullmatch(name) if isinstance(name, str) else None
    if match is None:
        return data, name
    blocks = _inputs.get_blocks(data)
    if any(own.HasArray(match[0]) for block in blocks for own in _get_attributes(block)):
        return data, name
    tensor = _choose_tensor(data, match[0], match["tensor"])
    result = data.NewInstance()
    # A copy of a composite data set shares its blocks in VTK 9.1 and 9.2.
    copy = getattr(result, "RecursiveShallowCopy", result.ShallowCopy)
    copy(data)
    title = f"von Mises of {tensor}"
    for block in _inputs.get_blocks(result):
        for own in _get_attributes(block):
            array = own.GetArray(tensor)
            if array is not None and array.GetNumberOfComponents() in _TENSORS:
                own.AddArray(_compute(array, title))
    return result, title
