# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Small files for the tests of relevo-view: a height map of a hill, a sphere, and a cube of
tetrahedra."""

import math

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_SHORT, vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

CUBES = 4  # along a side of the cube


def hill(x, y):
    """Height in the unit square: one hill with its top in the north-east."""
    return 30.0 * math.exp(-12.0 * ((x - 0.65) ** 2 + (y - 0.65) ** 2))


def write_hill(folder):
    """48 x 32 texels of the hill, without georeference."""
    image = vtkImageData()
    image.SetDimensions(48, 32, 1)
    image.AllocateScalars(VTK_UNSIGNED_SHORT, 1)
    for j in range(32):
        for i in range(48):
            height = hill((i + 0.5) / 48, (j + 0.5) / 32)
            image.SetScalarComponentFromDouble(i, j, 0, 0, round(height))
    name = folder / "hill.png"
    writer = vtkPNGWriter()
    writer.SetFileName(str(name))
    writer.SetInputData(image)
    writer.Write()
    return name


def write_mesh(folder, name, mesh):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(folder / name))
    writer.SetInputData(mesh)
    writer.Write()
    return folder / name


def make_sphere():
    """Radius 0.5, with the point arrays Latitude (z) and Around, vectors about the z axis."""
    source = vtkSphereSource()
    source.SetThetaResolution(10)
    source.SetPhiResolution(8)
    source.Update()
    sphere = vtkPolyData()
    sphere.SetPoints(source.GetOutput().GetPoints())
    sphere.SetPolys(source.GetOutput().GetPolys())
    latitude = vtkDoubleArray()
    latitude.SetName("Latitude")
    around = vtkDoubleArray()
    around.SetName("Around")
    around.SetNumberOfComponents(3)
    for i in range(sphere.GetNumberOfPoints()):
        x, y, z = sphere.GetPoint(i)
        latitude.InsertNextValue(z)
        around.InsertNextTuple((-y, x, 0.0))
    sphere.GetPointData().AddArray(latitude)
    sphere.GetPointData().AddArray(around)
    return sphere


def write_sphere(folder):
    return write_mesh(folder, "sphere.vtp", make_sphere())


def make_array(name, values):
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(values[0]))
    for value in values:
        array.InsertNextTuple(value)
    return array


def make_cube():
    """The unit cube in tetrahedra with the point arrays Left (x), Around (vectors), Flat (constant)
    and Spike (x, except for one much higher value), and the cell array Low (1 in the lower half,
    otherwise 0)."""
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    size = CUBES + 1
    for k in range(size):
        for j in range(size):
            for i in range(size):
                grid.GetPoints().InsertNextPoint(i / CUBES, j / CUBES, k / CUBES)
    low = []
    for k in range(CUBES):
        for j in range(CUBES):
            for i in range(CUBES):
                a = (k * size + j) * size + i
                # Around the diagonal, with steps along the axes in each order.
                for first, second in ((0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)):
                    steps = (1, size, size * size)
                    b = a + steps[first]
                    corners = (a, b, b + steps[second], a + sum(steps))
                    grid.InsertNextCell(VTK_TETRA, 4, corners)
                    low.append((1.0 if j < CUBES // 2 else 0.0,))
    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    of_points = grid.GetPointData()
    of_points.AddArray(make_array("Flat", [(7.0,)] * len(points)))
    of_points.AddArray(make_array("Left", [(x,) for x, _, _ in points]))
    of_points.AddArray(make_array("Around", [(y - 0.5, 0.5 - x, 0) for x, y, _ in points]))
    spike = [(1e6 if i == 60 else x,) for i, (x, _, _) in enumerate(points)]
    of_points.AddArray(make_array("Spike", spike))
    of_points.SetActiveScalars("Left")
    grid.GetCellData().AddArray(make_array("Low", low))
    return grid


def write_cube(folder):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(folder / "cube.vtu"))
    writer.SetInputData(make_cube())
    writer.Write()
    return folder / "cube.vtu"
