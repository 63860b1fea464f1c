# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make and read coarse meshes for the scripts in this folder."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from arguments import check_file
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkQuadricDecimation, vtkTriangleFilter
from vtkmodules.vtkIOPLY import vtkPLYReader


def make_mesh(points: Iterable[Sequence[float]], triangles: Iterable[Sequence[int]]) -> vtkPolyData:
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.SetPolys(vtkCellArray())
    for point in points:
        mesh.GetPoints().InsertNextPoint(point)
    for triangle in triangles:
        mesh.GetPolys().InsertNextCell(3, triangle)
    return mesh


def set_point_array(
    mesh: vtkDataSet, name: str, values: Sequence[float] | Sequence[Sequence[float]]
) -> vtkFloatArray:
    """Add an array with one number or one tuple of numbers per point."""
    array = vtkFloatArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(values[0]) if isinstance(values[0], tuple) else 1)
    for value in values:
        array.InsertNextTuple(value if isinstance(value, tuple) else (value,))
    mesh.GetPointData().AddArray(array)
    return array


def set_normals(mesh: vtkDataSet, values: Sequence[Sequence[float]]) -> None:
    mesh.GetPointData().SetNormals(set_point_array(mesh, "Normals", values))


def set_texture_coordinates(mesh: vtkDataSet, values: Sequence[Sequence[float]]) -> None:
    mesh.GetPointData().SetTCoords(set_point_array(mesh, "TextureCoordinates", values))


def add_normals(mesh: vtkPolyData) -> vtkPolyData:
    """Return the mesh with smooth point normals."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def make_ring(around: int = 30, across: int = 12) -> vtkPolyData:
    """Return a bent ring of varying thickness, with 2 * around * across triangles."""
    points = []
    triangles = []
    for i in range(around):
        u = 2 * math.pi * i / around
        thickness = 0.32 + 0.12 * math.cos(3 * u)
        for j in range(across):
            v = 2 * math.pi * j / across
            radius = 1 + thickness * math.cos(v)
            height = thickness * math.sin(v) + 0.2 * math.sin(2 * u)
            points.append((radius * math.cos(u), radius * math.sin(u), height))
            a, b = i * across, (i + 1) % around * across
            k = (j + 1) % across
            triangles += [(a + j, b + j, b + k), (a + j, b + k, a + k)]
    return make_mesh(points, triangles)


def make_grid(
    columns: int, rows: int, place: Callable[[float, float], Sequence[float]]
) -> vtkPolyData:
    """Return a grid of triangles with points place(x, y) and texture coordinates x, y in [0, 1]."""
    grid = [(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
    triangles = []
    for j in range(rows):
        for i in range(columns):
            a, b = j * (columns + 1) + i, (j + 1) * (columns + 1) + i
            triangles += [(a, a + 1, b + 1), (a, b + 1, b)]
    mesh = make_mesh([place(x, y) for x, y in grid], triangles)
    set_texture_coordinates(mesh, grid)
    return mesh


def make_wave(extremes: int = 6) -> vtkPolyData:
    """Return a strip with points at the crests and troughs of a wave, where its slope is 0."""
    mesh = make_grid(
        extremes, 1, lambda x, y: (extremes * x, 2.5 * y, 0.5 * math.cos(extremes * math.pi * x))
    )
    set_normals(mesh, [(0.0, 0.0, 1.0)] * mesh.GetNumberOfPoints())
    return mesh


def make_dome() -> vtkPolyData:
    """Return an arch of eight triangles with texture coordinates."""
    mesh = make_grid(
        2, 2, lambda x, y: (2 * x - 1, 2 * y - 1, 0.8 * (1 - (2 * x - 1) ** 2) * (1 - (2 * y - 1) ** 2))
    )
    return add_normals(mesh)


def make_mapped_ring(around: int = 14, across: int = 6) -> vtkPolyData:
    """Return the ring with texture coordinates that run around and back, to avoid a seam."""
    ring = make_ring(around, across)
    set_texture_coordinates(
        ring,
        [
            (abs(1 - 2 * (i // across) / around), abs(1 - 2 * (i % across) / across))
            for i in range(ring.GetNumberOfPoints())
        ],
    )
    return add_normals(ring)


def read(filename: str) -> vtkPolyData:
    """Return the triangles of a .ply or .g file."""
    if filename.endswith(".g"):
        from vtkmodules.vtkIOGeometry import vtkBYUReader

        reader: Any = vtkBYUReader()
        reader.SetGeometryFileName(check_file(filename))
    else:
        reader = vtkPLYReader()
        reader.SetFileName(check_file(filename))
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(reader.GetOutputPort())
    triangulate.Update()
    return triangulate.GetOutput()


def read_decimated(filename: str, triangles: int) -> vtkPolyData:
    """Return a .ply or .g file with about this many triangles and a longest side of length 2."""
    mesh = read(filename)
    if mesh.GetNumberOfCells() > triangles:
        decimation = vtkQuadricDecimation()
        decimation.SetInputData(mesh)
        decimation.SetTargetReduction(1 - triangles / mesh.GetNumberOfCells())
        decimation.Update()
        mesh = decimation.GetOutput()
    bounds = mesh.GetBounds()
    scale = 2 / max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
    points = vtkPoints()
    for i in range(mesh.GetNumberOfPoints()):
        points.InsertNextPoint([scale * c for c in mesh.GetPoint(i)])
    mesh.SetPoints(points)
    return add_normals(mesh)
