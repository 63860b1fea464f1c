# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Small data for tests of the functions that draw, which need numpy, EGL and GDAL."""

import sys

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

import relevo
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON
from vtkmodules.vtkFiltersSources import vtkCellTypeSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGReader

if not hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
    print("skipped: built without rendering, or without EGL")
    sys.exit(125)

BOUNDS = (86.8, 87.0, 27.9, 28.1)


def make_heights(rows=64, columns=96):
    y, x = numpy.mgrid[-2 : 2 : rows * 1j, -2 : 2 : columns * 1j]
    return (3000 * numpy.exp(-x * x - y * y) + 300 * numpy.sin(5 * x)).astype(numpy.float32)


def make_sphere(resolution=12):
    """Return a sphere with the vectors "V" around the z axis."""
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    mesh = source.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    around = numpy.stack([-points[:, 1], points[:, 0], 0 * points[:, 0]], axis=1)
    vectors = numpy_to_vtk(around, deep=True)
    vectors.SetName("V")
    mesh.GetPointData().AddArray(vectors)
    return mesh


def make_block(kind=VTK_HEXAHEDRON, size=(4, 4, 4)):
    """Return hexahedra with scalars "DistanceToCenter" and vectors "Shift" of points."""
    source = vtkCellTypeSource()
    source.SetCellType(kind)
    source.SetBlocksDimensions(*size)
    source.Update()
    grid = source.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    shift = numpy.zeros_like(points)
    shift[:, 1] = 0.1 * points[:, 0] ** 2
    array = numpy_to_vtk(shift, deep=True)
    array.SetName("Shift")
    grid.GetPointData().AddArray(array)
    return grid


def make_curved_block():
    return make_block(VTK_QUADRATIC_HEXAHEDRON, (4, 1, 1))


def read_picture(path):
    """Return the pixels of a PNG file, of shape (rows, columns, 3), top row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1, :, :3]


def count_colours(picture):
    return len(numpy.unique(picture.reshape(-1, 3), axis=0))


try:
    relevo.terrain(make_heights())
except relevo.Error as error:
    if "does not have GDAL" not in str(error):
        raise
    print("skipped: a build without GDAL")
    sys.exit(125)
