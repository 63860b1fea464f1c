# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a height map without a display: terrain.py HEIGHTMAP PICTURE.png"""

import relevo
from arguments import check_file, read_arguments
from relevo.files import write_picture
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

heightmap, picture = read_arguments()
check_file(heightmap)

pyramid = relevo.vtkTerrainPyramid()
pyramid.SetFileName(heightmap)  # of any size
mapper = relevo.vtkTerrainMapper()
mapper.SetPyramid(pyramid)
mapper.SetScreenSpaceError(1)  # pixels that the picture may differ from all samples
mapper.SetExaggeration(5)
mapper.SetLoadingModeToComplete()

# The rest is ordinary VTK.
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.9, 0.8, 0.65)
renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(0.65, 0.75, 0.88)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -1, 0.7)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Dolly(1.4)
renderer.ResetCameraClippingRange()
window = relevo.vtkEGLOffscreenRenderWindow()
window.SetSize(800, 500)
window.AddRenderer(renderer)
window.Render()
print(mapper.GetNumberOfDrawnTriangles(), "triangles, exact to 1 pixel")

write_picture(picture, window)
