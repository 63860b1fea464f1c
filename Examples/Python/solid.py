# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write a terrain as a solid for a 3D print, and draw it: solid.py HEIGHTMAP PICTURE.png [MODEL.stl]

The surface is within a thousandth of the width of the data. The base is below it by a tenth of the
width. No display is needed.
"""

import relevo
from arguments import check_file, read_arguments
from relevo.files import write_picture
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

height_map, picture, *model = read_arguments()
pyramid = relevo.vtkTerrainPyramid()
pyramid.SetFileName(check_file(height_map))
surface = relevo.vtkTerrainMapper()
surface.SetPyramid(pyramid)
left, right, bottom, top, lowest, highest = surface.GetBounds()
width = max(right - left, top - bottom)
pyramid.WaitForIndex()
low, high = pyramid.GetRange()
unit = (highest - lowest) / (high - low) if high > low else 1  # metres per unit of the heights

mesh = relevo.vtkTerrainMeshSource()
mesh.SetPyramid(pyramid)
mesh.SetMaximumError(width / 1000)  # metres
mesh.UseBaseOn()
mesh.SetBaseHeight(low - 0.1 * width / unit)  # in the unit of the heights
mesh.Update()
solid = mesh.GetOutput()

edges = vtkFeatureEdges()
edges.SetInputData(solid)
edges.BoundaryEdgesOn()
edges.NonManifoldEdgesOn()
edges.FeatureEdgesOff()
edges.ManifoldEdgesOff()
edges.Update()
print(solid.GetNumberOfCells(), "triangles,", edges.GetOutput().GetNumberOfCells(), "open edges")
if model:
    writer = vtkSTLWriter()
    writer.SetFileName(model[0])
    writer.SetFileTypeToBinary()
    writer.SetInputData(solid)
    writer.Write()

normals = vtkPolyDataNormals()
normals.SetInputData(solid)
normals.SetFeatureAngle(60)  # sharp edges between the surface and the walls
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(normals.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.85, 0.74, 0.58)
renderer = vtkRenderer()
renderer.SetBackground(0.92, 0.94, 0.96)
renderer.AddActor(actor)
camera = renderer.GetActiveCamera()
camera.SetPosition(-0.5, -1, 0.6)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.25)
window = relevo.vtkEGLOffscreenRenderWindow()
window.SetSize(800, 500)
window.AddRenderer(renderer)
window.Render()
write_picture(picture, window)
