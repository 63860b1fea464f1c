# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a track and an area on a terrain: track.py HEIGHTMAP PICTURE.png [TRACK.csv]

Each line of TRACK.csv has a longitude and a latitude in degrees. Without it, the track is a loop
around the middle of the height map. The area is a disk. No display is needed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import relevo
from arguments import check_file, read_arguments
from relevo.files import write_picture
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer


def read_track(name: str) -> list[tuple[float, ...]]:
    """Return the pairs of numbers in the lines of a file."""
    with open(check_file(name), encoding="utf-8") as lines:
        return [tuple(map(float, line.split(",")[:2])) for line in lines if line.strip()]


def make_circle(
    center: tuple[float, float], radius: float, waves: float, points: int = 360
) -> list[tuple[float, ...]]:
    """Return the points of a circle, whose radius can have waves."""
    angles = [2 * math.pi * i / points for i in range(points + 1)]
    radii = [radius * (1 + waves * math.sin(7 * angle)) for angle in angles]
    return [
        (center[0] + r * math.cos(angle), center[1] + r * math.sin(angle))
        for r, angle in zip(radii, angles)
    ]


def make_cell(places: Sequence[tuple[float, ...]], is_polygon: bool) -> vtkPolyData:
    """Return polydata of one line or polygon."""
    points, cell = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    cell.InsertNextCell(len(places))
    for x, y in places:
        cell.InsertCellPoint(points.InsertNextPoint(x, y, 0))  # z is ignored
    data = vtkPolyData()
    data.SetPoints(points)
    if is_polygon:
        data.SetPolys(cell)
    else:
        data.SetLines(cell)
    return data


height_map, picture, *track = read_arguments()
check_file(height_map)
pyramid = relevo.vtkTerrainPyramid()
pyramid.SetFileName(height_map)
terrain = relevo.vtkTerrainMapper()
terrain.SetPyramid(pyramid)
terrain.SetColorModeToHillshade()
terrain.SetLoadingModeToComplete()  # the picture is drawn once
terrain.SetContourColor(0.45, 0.3, 0.15)
left, right, bottom, top, lowest, highest = terrain.GetBounds()
terrain.SetContourInterval((highest - lowest) / 15)
size = min(right - left, top - bottom)

renderer = vtkRenderer()
renderer.SetBackground(0.75, 0.84, 0.95)
actor = vtkActor()
actor.SetMapper(terrain)
renderer.AddActor(actor)  # before the lines that lie on it


def add(
    data: vtkPolyData,
    color: tuple[float, float, float],
    coordinates: int = relevo.vtkTerrainClamp.WORLD,
) -> tuple[vtkActor, relevo.vtkTerrainClamp]:
    """Draw polydata on the terrain."""
    clamp = relevo.vtkTerrainClamp()
    clamp.SetInputData(data)
    clamp.SetCoordinateType(coordinates)
    clamp.SetMapper(terrain)
    clamp.SetOffset(size / 1000)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(clamp.GetOutputPort())
    cells = vtkActor()
    cells.SetMapper(mapper)
    cells.GetProperty().SetColor(*color)
    cells.GetProperty().SetLineWidth(4)
    cells.GetProperty().SetRenderLinesAsTubes(True)
    cells.GetProperty().LightingOff()
    renderer.AddActor(cells)
    return cells, clamp


disk = make_cell(make_circle((0.26 * size, -0.27 * size), 0.07 * size, 0)[:-1], True)
area, clamp = add(disk, (0.1, 0.3, 0.9))
area.GetProperty().SetOpacity(0.45)
if track:
    route = make_cell(read_track(track[0]), False)
    line, draped = add(route, (0.85, 0.05, 0.1), relevo.vtkTerrainClamp.GEOGRAPHIC)
else:
    route = make_cell(make_circle((0, 0), 0.25 * size, 0.12), False)
    line, draped = add(route, (0.85, 0.05, 0.1))

camera = renderer.GetActiveCamera()
camera.SetPosition(0, -0.9 * size, 0.55 * size + highest)
camera.SetFocalPoint(0, -0.05 * size, (lowest + highest) / 2)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window = relevo.vtkEGLOffscreenRenderWindow()
window.SetSize(800, 500)
window.AddRenderer(renderer)
window.Render()
print(
    route.GetNumberOfPoints(), "points,", draped.GetOutput().GetNumberOfPoints(), "on the terrain"
)
write_picture(picture, window)
