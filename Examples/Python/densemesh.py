# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a dense mesh, its micro-mesh and the error: densemesh.py PICTURE.png [MESH.ply]

The micro-mesh is within 0.1 % of the diagonal of the mesh. Without a mesh, the script makes a
rough torus. No display is needed.
"""

from __future__ import annotations

import math

import numpy
import relevo
from arguments import check_file, read_arguments
from figure import Figure, draw_coarse, draw_mesh, draw_recipe, make_actor
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkDistancePolyDataFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper


def make_mesh() -> vtkPolyData:
    """Return a torus with waves."""
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(vtkParametricTorus())
    source.SetUResolution(160)
    source.SetVResolution(80)
    source.GenerateTextureCoordinatesOff()
    source.GenerateNormalsOff()
    joined = vtkCleanPolyData()
    joined.SetInputConnection(source.GetOutputPort())
    joined.SetTolerance(1e-6)
    joined.Update()
    mesh = joined.GetOutput()
    points = mesh.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        x, y, z = points.GetPoint(i)
        height = 0.03 * math.sin(12 * x) * math.sin(12 * y)
        points.SetPoint(i, x, y, z + height)
    return mesh


def read_mesh(name: str) -> vtkPolyData:
    reader = vtkPLYReader()
    reader.SetFileName(check_file(name))
    reader.Update()
    return reader.GetOutput()


def draw_distance(mesh: vtkPolyData, red: float) -> vtkActor:
    """Draw points near the mesh white, and those at a distance red."""
    table = vtkLookupTable()
    table.SetHueRange(0, 0)
    table.SetSaturationRange(0, 1)
    table.SetValueRange(1, 0.9)
    table.Build()
    mesh.GetPointData().SetActiveScalars("Distance")
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarModeToUsePointData()
    mapper.SetScalarRange(0, red)
    mapper.SetLookupTable(table)
    return make_actor(mapper)


picture, *names = read_arguments()
dense = read_mesh(names[0]) if names else make_mesh()
normals = vtkPolyDataNormals()
normals.SetInputData(dense)
normals.SplittingOff()
normals.Update()

encode = relevo.vtkMicroMeshFilter()
encode.SetInputData(dense)
encode.SetTolerance(0.001 * dense.GetLength())
encode.Update()
micro = encode.GetOutput()
recipe = relevo.vtkAdaptiveRefinement()
recipe.SetSurface(relevo.vtkMicroMeshSurface())
recipe.SetMaximumLevel(encode.GetMaximumLevel())

refine = relevo.vtkAdaptiveRefinementFilter()
refine.SetInputData(micro)
refine.SetRefinement(recipe)
distance = vtkDistancePolyDataFilter()
distance.SetInputConnection(0, refine.GetOutputPort())
distance.SetInputData(1, dense)
distance.SignedDistanceOff()
distance.ComputeSecondDistanceOff()
distance.Update()
points = vtk_to_numpy(distance.GetOutput().GetPointData().GetArray("Distance"))
most = float(numpy.quantile(points, 0.98))  # single points are farther away

figure = Figure(4, 1, (320, 320), (0.3, 0.4, 1), (0, 1, 0), 1.15)
figure.add(f"the mesh, {dense.GetNumberOfCells()} triangles", draw_mesh(normals.GetOutput()))
coarse = vtkPolyData()
coarse.SetPoints(micro.GetPoints())
coarse.SetPolys(micro.GetPolys())
figure.add(f"{micro.GetNumberOfCells()} coarse faces", draw_coarse(coarse))
figure.add("with their displacements", draw_recipe(micro, recipe))
text = f"distance, red at {100 * most / dense.GetLength():.3f} % of the diagonal"
figure.add(text, draw_distance(distance.GetOutput(), most))
figure.write(picture)
share = 100 * encode.GetError() / dense.GetLength()
print(f"{micro.GetNumberOfCells()} faces, at most {share:.2f} % of the diagonal from the mesh")
