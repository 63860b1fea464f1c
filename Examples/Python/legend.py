# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a terrain and the legend of its colours: legend.py HEIGHTMAP PICTURE.png [COLOURS]

COLOURS is height (the default), slope, aspect, hillshade, or the name of another raster, whose values
are shown. Heights up to 0 are water if the height map has some. No display is needed.
"""

import os

import relevo
import vtkmodules.vtkRenderingFreeType  # draws text
from arguments import check_file, read_arguments
from relevo.files import write_picture
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

height_map, picture, *rest = read_arguments()
colours = rest[0] if rest else "height"
pyramid = relevo.vtkTerrainPyramid()
pyramid.SetFileName(check_file(height_map))
pyramid.Update()
pyramid.WaitForIndex()  # the range of the colours is not an estimate
terrain = relevo.vtkTerrainMapper()
terrain.SetPyramid(pyramid)
terrain.SetLoadingModeToComplete()  # the picture is drawn once
modes = {
    "height": terrain.SetColorModeToElevation,
    "slope": terrain.SetColorModeToSlope,
    "aspect": terrain.SetColorModeToAspect,
    "hillshade": terrain.SetColorModeToHillshade,
}
if colours in modes:
    modes[colours]()
else:
    terrain.SetColorRasterFileName(check_file(colours))
terrain.SetUseSeaLevel(pyramid.GetRange()[0] <= 0)

actor = vtkActor()
actor.SetMapper(terrain)
renderer = vtkRenderer()
renderer.SetBackground(0.92, 0.94, 0.96)
renderer.AddActor(actor)

bar = vtkScalarBarActor()
bar.SetLookupTable(terrain.GetLegendLookupTable())
bar.SetTitle(terrain.GetLegendTitle())  # with the unit
bar.SetMaximumNumberOfColors(512)  # a sharp border of water and land
bar.SetNumberOfLabels(5)
bar.SetLabelFormat("%.3g")
bar.SetVerticalTitleSeparation(8)
bar.SetPosition(0.04, 0.32)
bar.SetWidth(0.1)
bar.SetHeight(0.62)
for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(15)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()
bar.SetUnconstrainedFontSize(True)
renderer.AddViewProp(bar)

left, right, bottom, top, lowest, highest = terrain.GetBounds()
size = max(right - left, top - bottom)
terrain.SetExaggeration(max(1, 0.04 * size / max(highest - lowest, 1e-6 * size)))
camera = renderer.GetActiveCamera()
camera.SetPosition(-1, -0.4, 1.2)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.4)
window = relevo.vtkEGLOffscreenRenderWindow()
window.SetSize(800, 500)
window.AddRenderer(renderer)
window.Render()
print(os.path.basename(height_map) + ":", terrain.GetLegendTitle())
write_picture(picture, window)
