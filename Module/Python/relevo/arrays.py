# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Heights from numpy arrays, and refined meshes as numpy arrays."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import relevo


def height_map(heights, no_data=float("nan")):
    """A vtkHeightMap of a two-dimensional array.

    heights: any real numbers, shape (rows, columns), row 0 the northern one, as rasters come from
        files; at least 2 x 2. The array is copied.
    no_data: the value that stands for "no data" (default: NaN).

    Raises ValueError for another shape, and when no sample has data.
    """
    heights = numpy.asarray(heights)
    if heights.ndim != 2 or not numpy.issubdtype(heights.dtype, numpy.number):
        raise ValueError(f"heights must be a 2-D array of numbers, not {heights.dtype} {heights.shape}")
    rows, columns = heights.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    # VTK's row 0 is the southern one.
    image.GetPointData().SetScalars(numpy_to_vtk(heights[::-1].ravel(), deep=True))
    result = relevo.vtkHeightMap()
    result.SetImageData(image)
    result.SetNoDataValue(no_data)
    errors = []
    observer = result.AddObserver("ErrorEvent", _Collector(errors))
    updated = result.Update()
    result.RemoveObserver(observer)
    if not updated:
        raise ValueError(errors[0] if errors else "no height map can be made of this array")
    return result


def triangles(mesh):
    """Points, float (n, 3), and triangles, integer (m, 3), of a refined mesh (vtkPolyData).

    The arrays share the mesh's memory where VTK's own layout allows.

    Raises ValueError when the mesh has other polygons than triangles.
    """
    polygons = mesh.GetPolys()
    connectivity = vtk_to_numpy(polygons.GetConnectivityArray())
    if polygons.IsHomogeneous() not in (3, 0) or len(connectivity) % 3:
        raise ValueError("the mesh has other polygons than triangles")
    if mesh.GetNumberOfPoints() == 0:
        return numpy.empty((0, 3), numpy.float32), connectivity.reshape(-1, 3)
    return vtk_to_numpy(mesh.GetPoints().GetData()), connectivity.reshape(-1, 3)


class _Collector:
    """An observer that keeps the texts of errors."""

    CallDataType = "string0"

    def __init__(self, texts):
        self.texts = texts

    def __call__(self, caller, event, text):
        self.texts.append(text.partition("): ")[2].strip() or text.strip())
