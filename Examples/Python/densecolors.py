# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a scan with colours and an isosurface as micro-meshes: densecolors.py PICTURE.png

The isosurface of a volume like that of a CT is encoded block by block. Both micro-meshes keep their
colours at every pixel. No display is needed.
"""

from __future__ import annotations

import numpy
import relevo
from arguments import read_arguments
from figure import Figure, draw_coarse, draw_recipe, get_mapper, make_actor
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SIZE = 112  # points of the volume per side


def make_volume() -> vtkImageData:
    """Return a volume like that of a CT: bone with pores, around a hollow."""
    axis = numpy.linspace(-1, 1, SIZE, dtype=numpy.float32)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij", sparse=True)
    radius = numpy.sqrt(x * x + 1.3 * y * y + 1.1 * z * z)
    relief = 0.05 * numpy.sin(9 * x + 2) * numpy.sin(8 * y) * numpy.sin(10 * z)
    relief = relief + 0.006 * numpy.sin(45 * x) * numpy.sin(50 * y + 9 * z)
    image = vtkImageData()
    image.SetDimensions(SIZE, SIZE, SIZE)
    image.SetOrigin(-1, -1, -1)
    image.SetSpacing(*3 * (2 / (SIZE - 1),))
    heights = numpy.cos(14 * x) * numpy.cos(12 * z) * numpy.cos(13 * y)
    for name, values in (("Density", 1 - radius - relief), ("Mineral", heights)):
        array = numpy_to_vtk(values.astype(numpy.float32).ravel(), deep=1)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    image.GetPointData().SetActiveScalars("Density")
    return image


def make_scan(volume: vtkImageData) -> vtkPolyData:
    """Return a dense mesh with a colour at each point, which stands for a scan."""
    contour = vtkFlyingEdges3D()
    contour.SetInputData(volume)
    contour.SetValue(0, 0.35)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    contour.InterpolateAttributesOff()
    contour.Update()
    scan = contour.GetOutput()
    x, y, z = vtk_to_numpy(scan.GetPoints().GetData()).astype(float).T
    stripes = 0.5 + 0.5 * numpy.tanh(4 * numpy.sin(18 * y + 3 * numpy.sin(6 * x)))
    colors = numpy.outer(stripes, (215, 180, 120)) + numpy.outer(1 - stripes, (60, 95, 150))
    array = numpy_to_vtk(numpy.clip(colors, 0, 255).astype(numpy.uint8), deep=1)
    array.SetName("Color")
    scan.GetPointData().SetScalars(array)
    return scan


def use_colors(actor: vtkActor, name: str) -> vtkActor:
    """Colour by a point array: by a table, or by the colours themselves."""
    table = vtkLookupTable()
    table.SetHueRange(0.62, 0.05)
    table.SetSaturationRange(0.6, 0.6)
    table.SetValueRange(0.85, 0.95)
    table.Build()
    mapper = get_mapper(actor)
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(-0.8, 0.8)
    mapper.SetInterpolateScalarsBeforeMapping(True)
    return actor


def draw_colors(mesh: vtkPolyData, name: str) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    return use_colors(make_actor(mapper), name)


def draw_micro_mesh(micro: vtkPolyData, name: str) -> vtkActor:
    """Draw with all displacements."""
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetSurface(relevo.vtkMicroMeshSurface())
    recipe.SetMaximumLevel(5)
    return use_colors(draw_recipe(micro, recipe), name)


(picture,) = read_arguments()
volume = make_volume()
scan = make_scan(volume)
encode = relevo.vtkMicroMeshFilter()
encode.SetInputData(scan)
encode.SetTolerance(0.0015)
encode.Update()
contour = relevo.vtkMicroMeshContourFilter()
contour.SetInputData(volume)
contour.SetValue(0, 0.2)
contour.SetTolerance(0.0015)
contour.SetBlockSize(SIZE // 2)
contour.Update()

figure = Figure(4, 1, (320, 320), (0.5, 0.35, 1), (0, 1, 0), 1.25)
figure.add(f"a scan, {scan.GetNumberOfPolys()} triangles", draw_colors(scan, "Color"))
faces = encode.GetOutput().GetNumberOfPolys()
figure.add(f"{faces} faces with displacements", draw_micro_mesh(encode.GetOutput(), "Color"))
faces = contour.GetOutput().GetNumberOfPolys()
text = f"an isosurface in {contour.GetNumberOfBlocks()} blocks, {faces} faces"
figure.add(text, draw_coarse(contour.GetOutput()))
figure.add("with displacements", draw_micro_mesh(contour.GetOutput(), "Mineral"))
figure.write(picture)
print(f"{contour.GetNumberOfTriangles()} triangles, error {contour.GetError():.4f}")
