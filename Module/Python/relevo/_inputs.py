# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads meshes from files, and takes those of VTK, PyVista, vedo and numpy."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeGuard

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkDoubleArray, vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkGenericCell,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import _results, _work
from ._typing import Path

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_masked: Any = numpy.ma  # without annotations up to numpy 2.2


def is_path(source: object) -> TypeGuard[Path]:
    return isinstance(source, (str, os.PathLike))


def check_number(value: Any, name: str, integer: bool = False) -> None:
    """Raise TypeError if the value of an option is not a number."""
    if numpy.ndim(value) or numpy.asarray(value).dtype.kind not in ("iu" if integer else "iuf"):
        wanted = "an integer" if integer else "a number"
        raise TypeError(f"{name} must be {wanted}, not {value!r}")


def check_numbers(values: Any, name: str) -> list[float]:
    """Return the numbers of an option, which is one number or several."""
    try:
        numbers = [float(value) for value in numpy.atleast_1d(values)]
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be numbers, not {values!r}") from None
    if not numpy.isfinite(numbers).all():
        raise ValueError(f"{name} must be finite")
    return numbers


def get_package(value: object) -> str:
    """Return the package of a value's class, such as "pyvista". It is not imported."""
    return type(value).__module__.partition(".")[0]


def find_package(value: object) -> str:
    """Return the package, "pyvista" or "vedo", of a mesh or of its base classes, or ""."""
    packages = {kind.__module__.partition(".")[0] for kind in type(value).__mro__}
    return next((name for name in ("pyvista", "vedo") if name in packages), "")


def check_array(
    values: ArrayLike, name: str, columns: tuple[int, ...], integers: bool = False
) -> NDArray[Any]:
    """Return an array of numbers, of shape (n, c), in the machine's byte order.

    columns: the allowed values of c.
    """
    try:
        array = numpy.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    if _masked.is_masked(values):
        raise ValueError(f"{name} must have no masked values")
    if array.dtype.kind not in ("iu" if integers else "iuf"):
        wanted = "integers" if integers else "real numbers"
        raise ValueError(f"{name} must be {wanted}, not {array.dtype}")
    if array.ndim != 2 or array.shape[1] not in columns:
        shapes = " or ".join(f"(n, {number})" for number in columns)
        raise ValueError(f"{name} must have the shape {shapes}, not {array.shape}")
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def make_mesh(points: ArrayLike, faces: ArrayLike) -> vtkPolyData:
    """Return a vtkPolyData of points, (n, 3), and triangles or quadrilaterals, (m, 3) or (m, 4).

    Float points in C order are shared. Faces are copied, because vtkCellArray outlives the array
    that would hold numpy's memory.
    """
    points = check_array(points, "points", (3,))
    if points.dtype not in (numpy.float32, numpy.float64):
        points = points.astype(numpy.float64)
    faces = check_array(faces, "faces", (3, 4), integers=True)
    if not len(points) or not len(faces):
        raise ValueError("the mesh is empty")
    if not numpy.isfinite(points).all():
        raise ValueError("points must be finite")
    if faces.min() < 0 or faces.max() >= len(points):
        raise ValueError(f"faces must be indices of points, from 0 to {len(points) - 1}")
    mesh = vtkPolyData()
    data = vtkPoints()
    data.SetData(numpy_to_vtk(numpy.ascontiguousarray(points)))
    mesh.SetPoints(data)
    ids = vtkIdTypeArray()
    ids.SetNumberOfValues(faces.size)
    vtk_to_numpy(ids)[:] = faces.reshape(-1)
    cells = vtkCellArray()
    cells.SetData(faces.shape[1], ids)
    mesh.SetPolys(cells)
    return mesh


def _get_vedo_data(mesh: Any) -> vtkDataObject | None:
    data = getattr(mesh, "dataset", None)  # since 2024
    if isinstance(data, vtkDataObject):
        return data
    data = getattr(mesh, "_data", None)
    if isinstance(data, vtkDataObject) and not isinstance(data, vtkPolyData):
        return data
    return mesh.polydata() if hasattr(mesh, "polydata") else None  # applies the transform


class Taken(NamedTuple):
    """The data of a source, its package as find_package(), and the time of the step that is drawn,
    or None if there are not several."""

    source: Any
    data: vtkDataObject
    package: str
    time: float | None


def take_data(source: Any, name: str = "mesh", time: float | None = None) -> Taken:
    """Return the vtkDataObject of a source.

    source: a path, a vtkDataObject, a vtkAlgorithm, a prop, a mesh of PyVista or vedo, points and
        faces as arrays, or a result of this function, which is returned.
    time: of a path or a vtkAlgorithm.
    """
    if isinstance(source, Taken):
        return source
    package = find_package(source)
    data = None
    step = None
    if time is not None:
        check_number(time, "time")
    if is_path(source):
        data, step = _results.read(source, time)
    elif time is not None and isinstance(source, vtkAlgorithm):
        data, step = _results.update(source, time)
    elif time is not None:
        raise ValueError(
            f"time is for files and algorithms of VTK; {name} is a {type(source).__name__}"
        )
    elif isinstance(source, vtkDataObject):
        data = source
    elif package == "vedo":
        data = _get_vedo_data(source)
    elif hasattr(source, "GetMapper") and source.GetMapper():
        data = source.GetMapper().GetInputDataObject(0, 0)
    elif isinstance(source, vtkAlgorithm) and source.GetNumberOfOutputPorts() > 0:
        _work.update(source)
        data = source.GetOutputDataObject(0)
        step = _results.find_current_time(source)
    elif isinstance(source, (tuple, list)) and len(source) == 2:
        data = make_mesh(*source)
    if data is None and numpy.ndim(source) == 3:
        raise TypeError(
            f"{name} cannot be an array of shape {numpy.shape(source)}; put samples on a"
            " grid into the point data of a vtkImageData, whose x varies fastest, as"
            " pyvista.wrap(array) does"
        )
    if data is None:
        raise TypeError(
            f"{name} must be a path, an object of VTK, PyVista or vedo, or (points, faces), not"
            f" {type(source).__name__}"
        )
    return Taken(source, data, package, step)


def get_blocks(data: vtkDataObject) -> list[vtkDataSet]:
    """Return the vtkDataSets of a data object."""
    if isinstance(data, vtkDataSet):
        return [data]
    if isinstance(data, vtkCompositeDataSet):
        blocks: list[vtkDataSet] = []
        iterator = data.NewIterator()
        while not iterator.IsDoneWithTraversal():
            block = iterator.GetCurrentDataObject()
            if isinstance(block, vtkDataSet):
                blocks.append(block)
            iterator.GoToNextItem()
        return blocks
    raise TypeError(f"{data.GetClassName()} is not a mesh")


def get_kinds_of_cells(block: vtkDataSet) -> list[vtkGenericCell]:
    """Return a cell of each type that a data set has."""
    types: set[int] = set()
    if block.GetNumberOfCells() == 0:
        pass
    elif not isinstance(block, vtkUnstructuredGrid):
        types = {block.GetCellType(0)}  # cells of other data sets have one type
    elif hasattr(block, "GetDistinctCellTypesArray"):
        types = set(vtk_to_numpy(block.GetDistinctCellTypesArray()).tolist())
    else:
        types = set(vtk_to_numpy(block.GetCellTypesArray()).tolist())
    cells = []
    for kind in types:
        cells.append(vtkGenericCell())
        cells[-1].SetCellType(kind)
    return cells


def _fill_arrays(blocks: Sequence[vtkDataSet], association: int) -> None:
    """Add arrays that some blocks lack, as NaN. Otherwise, vtkAppendFilter would drop them."""
    present: dict[str, list[vtkDataArray]] = {}
    for block in blocks:
        data = block.GetAttributes(association)
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            if array is not None and array.GetName() and array.GetName() != "vtkGhostType":
                present.setdefault(array.GetName(), []).append(array)
    for name, arrays in present.items():
        for block in blocks if len(arrays) < len(blocks) else ():
            filled = vtkDoubleArray()
            own = block.GetAttributes(association).GetArray(name)
            if own is not None:
                filled.DeepCopy(own)
            else:
                filled.SetNumberOfComponents(arrays[0].GetNumberOfComponents())
                filled.SetNumberOfTuples(block.GetNumberOfElements(association))
                filled.Fill(numpy.nan)
            filled.SetName(name)
            block.GetAttributes(association).AddArray(filled)


def merge_blocks(data: vtkDataObject) -> vtkDataSet:
    """Return the blocks of a mesh as one. An array that a block lacks is NaN there."""
    from vtkmodules.vtkFiltersCore import vtkAppendFilter

    blocks = []
    for block in get_blocks(data):
        if block.GetNumberOfPoints():
            blocks.append(block.NewInstance())
            blocks[-1].ShallowCopy(block)
    if not blocks:
        raise ValueError("the mesh is empty")
    if len(blocks) == 1:
        return blocks[0]
    append = vtkAppendFilter()
    for association in (vtkDataObject.POINT, vtkDataObject.CELL):
        _fill_arrays(blocks, association)
    for block in blocks:
        append.AddInputData(block)
    _work.update(append)
    merged: vtkDataSet = append.GetOutput()
    return merged


def make_grid(data: vtkDataObject) -> vtkUnstructuredGrid:
    """Return a mesh as one vtkUnstructuredGrid."""
    merged = data if isinstance(data, vtkUnstructuredGrid) else merge_blocks(data)
    if isinstance(merged, vtkUnstructuredGrid):
        return merged
    from vtkmodules.vtkFiltersCore import vtkAppendFilter

    append = vtkAppendFilter()
    append.AddInputData(merged)
    _work.update(append)
    return append.GetOutput()


def extract_surface(data: vtkDataObject) -> vtkPolyData:
    """Return the polygons of a mesh as a vtkPolyData."""
    if isinstance(data, vtkPolyData):
        surface = data
    else:
        from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

        extract = vtkGeometryFilter()
        extract.SetInputData(merge_blocks(data))
        _work.update(extract)
        surface = extract.GetOutput()
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise ValueError("the mesh has no polygons or 3D cells")
    return surface


def list_arrays(blocks: Iterable[vtkDataSet]) -> tuple[list[str], list[str]]:
    """Return the names of numeric arrays: those of points, those of cells."""
    names: tuple[list[str], list[str]] = [], []
    for block in blocks:
        for own, data in zip(names, (block.GetPointData(), block.GetCellData())):
            hidden = (data.GetNormals(), data.GetTCoords(), data.GetGlobalIds())
            for i in range(data.GetNumberOfArrays()):
                array = data.GetArray(i)
                if array is None or not array.GetName() or array in hidden:
                    continue
                if array.GetName() not in own and array.GetName() not in _OWN_ARRAYS:
                    own.append(array.GetName())
    return names


_OWN_ARRAYS = (
    "vtkGhostType",
    "vtkOriginalCellIds",
    "vtkOriginalPointIds",
    "PatchIds",
    "PatchCoordinates",
)


def find_array(blocks: Sequence[vtkDataSet], name: object) -> tuple[vtkDataArray, bool]:
    """Return an array of points or cells by its name, and whether it is of points.

    Raises ValueError with the names of all arrays if there is none.
    """
    if not isinstance(name, str):
        raise TypeError(f"an array is chosen by its name, a str, not {type(name).__name__}")
    for of_points in (True, False):
        for block in blocks:
            data = block.GetPointData() if of_points else block.GetCellData()
            if data.GetArray(name) is not None:
                return data.GetArray(name), of_points
    listed = ", ".join(repr(own) for names in list_arrays(blocks) for own in names)
    listed = f"its arrays are {listed}" if listed else "it has no arrays"
    raise ValueError(f"the mesh has no array {name!r}; {listed}")
