# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Small files for the tests of relevo-view: a hill as a height map, a sphere as a mesh."""

import math

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_SHORT, vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter


def hill(x, y):
    """Height in the unit square: one hill, its top in the north-east."""
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
    """
    Radius 0.5, with the arrays of points Latitude (z) and Around, vectors about the z axis.
    """
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
