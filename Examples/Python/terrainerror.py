# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Show how far a terrain that is drawn is from its data: terrainerror.py HEIGHTMAP PICTURE.png

The left half is the terrain within one pixel. The right half shows, for each pixel, the vertical
distance of the drawn point from the height map, in pixels: blue below, white equal, red above. No
display is needed.
"""

import math
import sys

import numpy
import relevo
from arguments import check_file, read_arguments
from relevo.files import write_picture
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

COLUMNS, ROWS = 500, 440

height_map, picture = read_arguments()
pyramid = relevo.vtkTerrainPyramid()
pyramid.SetFileName(check_file(height_map))
mapper = relevo.vtkTerrainMapper()
mapper.SetPyramid(pyramid)
mapper.SetScreenSpaceError(1)
mapper.SetLoadingModeToComplete()
left, right, bottom, top, lowest, highest = mapper.GetBounds()
if left > right:
    sys.exit(1)  # the mapper has said why
size = min(right - left, top - bottom)

actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.SetBackground(0.75, 0.84, 0.95)
renderer.AddActor(actor)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -0.7 * size, highest + 0.3 * size)
camera.SetFocalPoint(0, 0, (lowest + highest) / 2)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window = relevo.vtkEGLOffscreenRenderWindow()
window.SetMultiSamples(0)  # depths at the centres of pixels
window.SetSize(COLUMNS, ROWS)
window.AddRenderer(renderer)
window.Render()

colors = vtkUnsignedCharArray()
window.GetPixelData(0, 0, COLUMNS - 1, ROWS - 1, 0, colors, 0)
drawn = vtk_to_numpy(colors).reshape(ROWS, COLUMNS, 3)
depths = vtkFloatArray()
window.GetZbufferData(0, 0, COLUMNS - 1, ROWS - 1, depths)
depth = vtk_to_numpy(depths).reshape(ROWS, COLUMNS).astype(float)

# The points that are drawn, in world coordinates.
matrix = camera.GetCompositeProjectionTransformMatrix(COLUMNS / ROWS, -1, 1)
inverse = numpy.linalg.inv([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
pixels = numpy.flatnonzero(depth < 1)
x = (pixels % COLUMNS + 0.5) / COLUMNS
y = (pixels // COLUMNS + 0.5) / ROWS
view = 2 * numpy.stack([x, y, depth.ravel()[pixels], numpy.ones_like(x)], axis=1) - 1
points = view @ inverse.T
points = points[:, :3] / points[:, 3:]

# The points of the height map above or below them, at full resolution.
cloud = vtkPolyData()
cloud.SetPoints(vtkPoints())
cloud.GetPoints().SetData(numpy_to_vtk(points, deep=True))
cells = vtkCellArray()
cells.SetData(1, numpy_to_vtkIdTypeArray(numpy.arange(len(points)), deep=True))
cloud.SetVerts(cells)
numbers = numpy_to_vtk(numpy.arange(len(points), dtype=float), deep=True)
numbers.SetName("Number")
cloud.GetPointData().AddArray(numbers)
clamp = relevo.vtkTerrainClamp()
clamp.SetInputData(cloud)
clamp.SetPyramid(pyramid)
clamp.Update()
arrays = clamp.GetOutput().GetPointData()
found = vtk_to_numpy(arrays.GetArray("Number")).astype(int)
height = vtk_to_numpy(arrays.GetArray("Height"))

# The error on the screen, as vtkTerrainMapper::SetScreenSpaceError() defines it.
distance = numpy.linalg.norm(points[found] - camera.GetPosition(), axis=1)
per_unit = ROWS / (2 * math.tan(math.radians(camera.GetViewAngle() / 2)))
error = (points[found, 2] - height) * per_unit / distance

shown = numpy.full((ROWS * COLUMNS, 3), 190, dtype=numpy.uint8)
strength = numpy.clip(numpy.abs(error), 0, 1)[:, None]
full = numpy.where(error[:, None] > 0, (200, 20, 20), (20, 60, 200))
shown[pixels[found]] = 255 + strength * (full - 255)
both = numpy.concatenate([drawn, shown.reshape(ROWS, COLUMNS, 3)], axis=1)
image = vtkImageData()
image.SetDimensions(2 * COLUMNS, ROWS, 1)
image.GetPointData().SetScalars(numpy_to_vtk(both.reshape(-1, 3), deep=True))
write_picture(picture, image)
print(f"{mapper.GetNumberOfDrawnTriangles()} triangles; largest error {abs(error).max():.2f} pixels")
