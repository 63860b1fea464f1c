# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of heights, refined meshes and images from and to numpy arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.util.numpy_support import create_vtk_array, get_vtk_array_type, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import relevo

from . import _work
from ._error import Error

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_masked: Any = numpy.ma  # without annotations up to numpy 2.2


def _real_numbers(values: ArrayLike | None, name: str) -> NDArray[Any]:
    """Return an array of a type that VTK supports, in the machine's byte order.

    Numbers that are not integers become float or double. Masked values become NaN.
    """
    if values is None:
        raise TypeError(f"{name} must be an array of real numbers, not None")
    given: Any = numpy.asanyarray(values)
    if given.dtype.kind not in "iuf":
        raise ValueError(f"{name} must be real numbers, not {given.dtype}")
    if _masked.is_masked(given):
        given = given.astype(numpy.result_type(given.dtype, numpy.float32)).filled(numpy.nan)
    array: NDArray[Any] = numpy.asarray(given)
    if array.dtype.kind == "f" and array.dtype.itemsize not in (4, 8):
        return array.astype(numpy.float32 if array.dtype.itemsize < 4 else numpy.float64)
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def _check_type(value: object, kind: type, name: str) -> None:
    if not isinstance(value, kind):
        given = "None" if value is None else type(value).__name__
        raise TypeError(f"{name} must be a {kind.__name__}, not {given}")


def _copy(values: NDArray[Any]) -> vtkDataArray:
    """Return a VTK array with a copy of an array of 1 or 2 dimensions.

    numpy allocates the copy, so that insufficient memory raises a MemoryError. VTK would abort.
    """
    copy = numpy.array(values, order="C")
    result: Any = create_vtk_array(get_vtk_array_type(copy.dtype))
    result.SetNumberOfComponents(copy.shape[1] if copy.ndim == 2 else 1)
    result.SetVoidArray(copy.reshape(-1), copy.size, 1)
    result._numpy_reference = copy  # must live as long as the VTK array
    array: vtkDataArray = result
    return array


def _share(values: NDArray[Any]) -> vtkDataArray:
    """Return a VTK array with the memory of a contiguous array of real numbers."""
    flat = values.reshape(-1)
    result: Any = create_vtk_array(get_vtk_array_type(flat.dtype))
    result.SetVoidArray(flat, flat.size, 1)
    result._numpy_reference = flat  # must live as long as the VTK array
    array: vtkDataArray = result
    return array


def height_map(heights: ArrayLike, no_data: float = float("nan")) -> relevo.vtkHeightMap:
    """Create a vtkHeightMap from a two-dimensional array.

    heights: real numbers of any type and byte order, of shape (rows, columns), at least 2 x 2.
        Row 0 is the northernmost, as in raster files. Masked values (numpy.ma) are no data. An
        array in C order is shared with the image of the result, whose heights are a copy. After
        changes of the array, call Modified() of GetImageData() to copy them again.
    no_data: the value of samples without data (default: NaN).

    Raises ValueError for other shapes or values and if no sample has data, and TypeError for None.
    """
    if heights is not None and _masked.is_masked(heights):
        # NaN replaces no_data, because not every type can represent no_data.
        heights = _masked.masked_where(heights == no_data, heights)
        no_data = float("nan")
    heights = _real_numbers(heights, "heights")
    if heights.ndim != 2:
        raise ValueError(f"heights must be a 2-D array, not of shape {heights.shape}")
    rows, columns = heights.shape
    if rows < 2 or columns < 2:
        raise ValueError(f"heights must be at least 2 x 2, not {rows} x {columns}")
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    result = relevo.vtkHeightMap()
    # Row 0 is the southernmost in VTK.
    southwards = not heights[::-1].flags.c_contiguous
    image.GetPointData().SetScalars(
        _share(numpy.ascontiguousarray(heights if southwards else heights[::-1]))
    )
    result.SetFlipRows(southwards)
    result.SetImageData(image)
    result.SetNoDataValue(no_data)
    try:
        _work.update_heights(result)
    except Error as error:
        raise ValueError(str(error)) from None
    return result


def heights(height_map: relevo.vtkHeightMap) -> NDArray[Any]:
    """Return the heights of a vtkHeightMap, float of shape (rows, columns), row 0 in the north.

    Missing heights are NaN. The map is updated, so that a file is read. While the heights are copied,
    eight times the memory of the result is needed.

    Raises relevo.Error if the file cannot be read, and TypeError if it is not a vtkHeightMap.
    """
    _check_type(height_map, relevo.vtkHeightMap, "height_map")
    _work.update_heights(height_map)
    columns, rows = height_map.GetDimensions()
    result = numpy.array(height_map.GetSamples(), numpy.float32)
    validity = height_map.GetValidity()
    if validity is not None:
        result[numpy.array(validity, numpy.uint8) == 0] = numpy.nan
    return result.reshape(rows, columns)[::-1].copy()


def triangles(mesh: vtkPolyData) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the points, float (n, 3), and triangles, integer (m, 3), of a refined vtkPolyData.

    The arrays share the mesh's memory if VTK's memory layout allows it.

    Raises ValueError if the mesh has polygons that are not triangles, and TypeError if it is not a
    vtkPolyData.
    """
    _check_type(mesh, vtkPolyData, "mesh")
    polygons = mesh.GetPolys()
    connectivity = vtk_to_numpy(polygons.GetConnectivityArray())
    if polygons.IsHomogeneous() not in (3, 0) or len(connectivity) % 3:
        raise ValueError("the mesh has polygons that are not triangles")
    if mesh.GetNumberOfPoints() == 0:
        return numpy.empty((0, 3), numpy.float32), connectivity.reshape(-1, 3)
    return vtk_to_numpy(mesh.GetPoints().GetData()), connectivity.reshape(-1, 3)


def image(
    values: ArrayLike, name: str = "Values", spacing: tuple[float, float] = (1.0, 1.0)
) -> vtkImageData:
    """Create a flat vtkImageData with a point array, for vtkLineIntegralConvolution and its noise.

    values: real numbers of any type and byte order, of shape (rows, columns), which become the
        active scalars, or (rows, columns, components). Row 0 has the smallest y, as in VTK. The
        array is copied. Masked values (numpy.ma) become NaN.
    name: the name of the array.
    spacing: the distances between columns and between rows.

    Raises ValueError for other shapes or values or an empty array, and TypeError for None.
    """
    values = _real_numbers(values, "values")
    if values.ndim not in (2, 3) or not values.size:
        raise ValueError(f"values must be a 2-D or 3-D array, not of shape {values.shape}")
    rows, columns = values.shape[:2]
    result = vtkImageData()
    result.SetDimensions(columns, rows, 1)
    result.SetSpacing(spacing[0], spacing[1], 1.0)
    flat = values.reshape((rows * columns,) + values.shape[2:])
    array = _copy(flat)
    array.SetName(name)
    if values.ndim == 2:
        result.GetPointData().SetScalars(array)
    else:
        result.GetPointData().AddArray(array)
    return result


def samples(image: vtkImageData, name: str | None = None) -> NDArray[Any]:
    """Return a point array of a flat vtkImageData.

    The result has the shape (rows, columns) or (rows, columns, components). Row 0 has the smallest
    coordinate. The result shares the image's memory if VTK's memory layout allows it.

    name: the name of the array (default: the active scalars).

    Raises ValueError if the image has no such array or is not flat, and TypeError if it is not a
    vtkImageData.
    """
    _check_type(image, vtkImageData, "image")
    data = image.GetPointData()
    array = data.GetArray(name) if name else data.GetScalars()
    if array is None:
        raise ValueError(f"the image has no point array {name!r}" if name else "the image has no point scalars")
    sizes = image.GetDimensions()
    if 1 not in sizes:
        raise ValueError(f"the image is not flat: {sizes}")
    flat = max(axis for axis in range(3) if sizes[axis] == 1)
    columns, rows = (sizes[axis] for axis in range(3) if axis != flat)
    values: NDArray[Any] = vtk_to_numpy(array)
    return values.reshape((rows, columns) + values.shape[1:])
