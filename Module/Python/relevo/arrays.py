# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Heights and images from numpy arrays; refined meshes and images as numpy arrays."""

import numpy
from vtkmodules.util.numpy_support import create_vtk_array, get_vtk_array_type, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import relevo


def _real_numbers(values, name):
    """An array as VTK takes it: in the machine's byte order, of float or double if not whole.

    Masked values become NaN.
    """
    if values is None:
        raise TypeError(f"{name} must be an array of real numbers, not None")
    values = numpy.asanyarray(values)
    if values.dtype.kind not in "iuf":
        raise ValueError(f"{name} must be real numbers, not {values.dtype}")
    if numpy.ma.is_masked(values):
        values = values.astype(numpy.result_type(values.dtype, numpy.float32)).filled(numpy.nan)
    values = numpy.asarray(values)
    if values.dtype.kind == "f" and values.dtype.itemsize not in (4, 8):
        return values.astype(numpy.float32 if values.dtype.itemsize < 4 else numpy.float64)
    return values.astype(values.dtype.newbyteorder("="), copy=False)


def _check_type(value, kind, name):
    if not isinstance(value, kind):
        given = "None" if value is None else type(value).__name__
        raise TypeError(f"{name} must be a {kind.__name__}, not {given}")


def _copy(values):
    """A VTK array with a copy, of 1 or 2 dimensions.

    numpy allocates it: without enough memory that is a MemoryError, and VTK would end the program.
    """
    copy = numpy.array(values, order="C")
    result = create_vtk_array(get_vtk_array_type(copy.dtype))
    result.SetNumberOfComponents(copy.shape[1] if copy.ndim == 2 else 1)
    result.SetVoidArray(copy.reshape(-1), copy.size, 1)
    result._numpy_reference = copy  # lives as long as the VTK array
    return result


def height_map(heights, no_data=float("nan")):
    """A vtkHeightMap of a two-dimensional array.

    heights: any real numbers in any byte order, shape (rows, columns), row 0 the northern one, as
        rasters come from files; at least 2 x 2. The array is copied. Masked values (numpy.ma) have
        no data.
    no_data: the value that stands for "no data" (default: NaN).

    Raises ValueError for another shape, other values, and when no sample has data; TypeError for
    None.
    """
    if heights is not None and numpy.ma.is_masked(heights):
        # NaN then stands for all: not every type of numbers can hold no_data.
        heights = numpy.ma.masked_where(heights == no_data, heights)
        no_data = float("nan")
    heights = _real_numbers(heights, "heights")
    if heights.ndim != 2:
        raise ValueError(f"heights must be a 2-D array, not of shape {heights.shape}")
    rows, columns = heights.shape
    if rows < 2 or columns < 2:
        raise ValueError(f"heights must be at least 2 x 2, not {rows} x {columns}")
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    # VTK's row 0 is the southern one.
    image.GetPointData().SetScalars(_copy(heights[::-1].ravel()))
    result = relevo.vtkHeightMap()
    result.SetImageData(image)
    result.SetNoDataValue(no_data)
    observer = result.AddObserver("ErrorEvent", lambda caller, event: None)  # raised, not printed
    updated = result.Update()
    result.RemoveObserver(observer)
    if not updated:
        raise ValueError(result.GetErrorMessage())
    return result


def triangles(mesh):
    """Points, float (n, 3), and triangles, integer (m, 3), of a refined mesh (vtkPolyData).

    The arrays share the mesh's memory where VTK's own layout allows.

    Raises ValueError when the mesh has other polygons than triangles, TypeError when it is no
    vtkPolyData.
    """
    _check_type(mesh, vtkPolyData, "mesh")
    polygons = mesh.GetPolys()
    connectivity = vtk_to_numpy(polygons.GetConnectivityArray())
    if polygons.IsHomogeneous() not in (3, 0) or len(connectivity) % 3:
        raise ValueError("the mesh has other polygons than triangles")
    if mesh.GetNumberOfPoints() == 0:
        return numpy.empty((0, 3), numpy.float32), connectivity.reshape(-1, 3)
    return vtk_to_numpy(mesh.GetPoints().GetData()), connectivity.reshape(-1, 3)


def image(values, name="Values", spacing=(1.0, 1.0)):
    """A flat vtkImageData with a point array, for vtkLineIntegralConvolution and its noise.

    values: any real numbers in any byte order, shape (rows, columns), which become the active
        scalars, or (rows, columns, components); row 0 is the lowest in y, as VTK has it. The array
        is copied. Masked values (numpy.ma) become NaN.
    name: the array's name.
    spacing: distances of columns and of rows.

    Raises ValueError for another shape, other values or an empty array, TypeError for None.
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


def samples(image, name=None):
    """A point array of a flat vtkImageData, shape (rows, columns) or (rows, columns, components).

    name: the array's name (default: the active scalars). Row 0 is the lowest. The result shares the
    image's memory where VTK's own layout allows.

    Raises ValueError when the image has no such array or is not flat, TypeError when it is no
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
    values = vtk_to_numpy(array)
    return values.reshape((rows, columns) + values.shape[1:])
