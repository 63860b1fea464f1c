# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Show where two objects intersect, without a display: contact.py NAME PICTURE [FILES]

NAME is one of
  candidates  levels, red where the bounding boxes meet, and the curve of intersection: a .png
  distance    the distance of each face from the other object: a .png
  displaced   a ball with waves in a curved ring, refined where the two can meet: a .png
  motion      the candidates while one object moves through the other: a .gif
FILES are two meshes, for example bunny.ply and teapot.g. displaced needs none. Without FILES the
script generates the meshes.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import relevo
from arguments import read_arguments
from figure import Figure, draw_coarse, draw_recipe, get_mapper, make_actor
from gif import photograph, write_gif
from heights import displace, make_image
from meshes import add_normals, make_ring, read_decimated, set_texture_coordinates
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkStripper, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

FRAMES, SECONDS, COLOURS = 20, 0.1, 48
VIEW = (0.25, 0.3, 1)
PLACE = (0.75, -0.3, 0.15)  # centre of the second mesh


def make_ball(columns: int = 40, rows: int = 30) -> vtkPolyData:
    source = vtkSphereSource()
    source.SetRadius(0.8)
    source.SetThetaResolution(columns)
    source.SetPhiResolution(rows)
    source.Update()
    return add_normals(source.GetOutput())


def read_meshes(files: Sequence[str], triangles: int) -> list[vtkPolyData]:
    """Return two meshes of about this many triangles, with longest sides of length 2."""
    if files:
        return [read_decimated(name, triangles) for name in files]
    return [add_normals(make_ring(60, 24)), make_ball()]


def put(actor: vtkActor, place: Sequence[float]) -> None:
    """Move the centre of the actor's mesh to a place."""
    actor.SetPosition(0, 0, 0)
    actor.SetPosition([x - c for x, c in zip(place, actor.GetCenter())])


def get_bounds(actors: Iterable[vtkActor]) -> list[float]:
    box = vtkBoundingBox()
    for actor in actors:
        box.AddBounds(actor.GetBounds())
    bounds = [0.0] * 6
    box.GetBounds(bounds)
    return bounds


def draw_curves(polydata: vtkPolyData, radius: float = 0.012) -> vtkActor:
    join = vtkStripper()
    join.SetInputData(polydata)
    tubes = vtkTubeFilter()
    tubes.SetInputConnection(join.GetOutputPort())
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(8)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = make_actor(mapper)
    actor.GetProperty().SetColor(0.05, 0.05, 0.05)
    return actor


class Meeting:
    """Two meshes that are refined where they may meet, in a panel of a figure."""

    def __init__(self, files: Sequence[str], triangles: int = 3000) -> None:
        self.scene = relevo.vtkContactScene()
        self.scene.SetDistance(0.6)
        self.actors = [self.add(mesh) for mesh in read_meshes(files, triangles)]
        put(self.actors[0], (0, 0, 0))
        self.renderer = vtkRenderer()
        self.curves: list[vtkActor] = []

    def add(self, mesh: vtkPolyData) -> vtkActor:
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(5)
        actor = draw_recipe(mesh, recipe)
        self.scene.AddActor(actor)
        return actor

    def move(self, place: Sequence[float]) -> None:
        put(self.actors[1], place)
        self.scene.Update()
        for actor in self.actors:
            mapper = get_mapper(actor)
            mapper.SetColorModeToMetric()
            mapper.SetLevelLookupTable(mapper.GetRefinement().GetMetric().GetLookupTable())

    def show(self, figure: Figure, label: str, bounds: Sequence[float]) -> None:
        self.renderer = figure.add(label, self.actors[0], bounds=bounds)
        self.renderer.AddActor(self.actors[1])
        self.show_curves()

    def show_curves(self) -> None:
        for actor in self.curves:
            self.renderer.RemoveActor(actor)
        contacts: Any = self.scene.GetContacts()
        self.curves = [draw_curves(contacts.GetBlock(i)) for i in range(contacts.GetNumberOfBlocks())]
        for actor in self.curves:
            self.renderer.AddActor(actor)


def candidates(picture: str, *files: str) -> None:
    meeting = Meeting(files)
    meeting.move(PLACE)
    figure = Figure(1, 1, (640, 460), VIEW, (0, 1, 0), 1.45)
    meeting.show(figure, "where the two may meet, and where they do", get_bounds(meeting.actors))
    figure.write(picture)


def make_distance_table(largest: float) -> vtkLookupTable:
    """Return colours from red at distance 0 to white and blue."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetTableRange(0, largest)
    for i in range(256):
        t = i / 255
        near, far = max(1 - 2 * t, 0), max(2 * t - 1, 0)
        table.SetTableValue(
            i, 0.95 - 0.1 * near - 0.75 * far, 0.95 - 0.85 * near - 0.6 * far, 0.95 - 0.85 * near - 0.15 * far
        )
    return table


def distance(picture: str, *files: str) -> None:
    meshes = read_meshes(files, 20000)
    meeting = relevo.vtkSurfaceIntersectionFilter()
    actors = []
    for i, mesh in enumerate(meshes):
        mapper = vtkPolyDataMapper()
        actors.append(make_actor(mapper))
        mapper.SetInputData(mesh)
        put(actors[i], PLACE if i == 1 else (0, 0, 0))
        actors[i].ComputeMatrix()
        meeting.SetInputData(i, mesh)
        meeting.SetMatrix(i, actors[i].GetMatrix())
    meeting.ClassifyOn()
    # The bunny has holes in its base, so the filter warns that it is not closed.
    meeting.AddObserver("WarningEvent", lambda *_: None)
    meeting.Update()
    for i, actor in enumerate(actors):
        mapper = get_mapper(actor)
        mapper.SetInputConnection(meeting.GetOutputPort(2 + i))
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray("Distance")
        mapper.SetLookupTable(make_distance_table(0.6))
        mapper.UseLookupTableScalarRangeOn()
    figure = Figure(1, 1, (640, 460), VIEW, (0, 1, 0), 1.45)
    renderer = figure.add("how far each is from the other", actors[0], bounds=get_bounds(actors))
    renderer.AddActor(actors[1])
    renderer.AddActor(draw_curves(meeting.GetOutput(0)))
    figure.write(picture)


def make_waves(u: float, v: float) -> Iterator[float]:
    """Yield heights that are 0 at the poles of a ball and equal on both sides of its seam."""
    yield math.cos(5 * math.pi * u) * math.cos(8 * math.pi * v) * math.sin(math.pi * v) ** 2


def make_mapped_ball() -> vtkPolyData:
    ball = make_ball(28, 18)
    normals = ball.GetPointData().GetNormals()
    places = []
    for i in range(ball.GetNumberOfPoints()):
        x, y, z = normals.GetTuple3(i)
        places.append((abs(math.atan2(y, x)) / math.pi, math.acos(max(-1, min(z, 1))) / math.pi))
    set_texture_coordinates(ball, places)
    return ball


def displaced(picture: str) -> None:
    meeting = relevo.vtkSurfaceIntersectionFilter()
    move = vtkTransform()
    move.Translate(0.95, 0.1, 0)
    move.RotateX(-70)
    for i, mesh in enumerate((add_normals(make_ring()), make_mapped_ball())):
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(5)
        recipe.SetSurface(relevo.vtkPNTriangleSurface())
        if i == 1:
            recipe.SetDisplacement(displace(make_image(64, 64, 1, VTK_FLOAT, make_waves), 0.1))
        meeting.SetInputData(i, mesh)
        meeting.SetRefinement(i, recipe)
    meeting.SetMatrix(1, move.GetMatrix())
    meeting.SetTolerance(0.002)
    meeting.Update()
    actors = [draw_coarse(meeting.GetRefinedSurface(i)) for i in (0, 1)]
    actors[0].GetProperty().SetColor(0.62, 0.72, 0.82)
    actors[1].SetUserTransform(move)
    figure = Figure(1, 1, (640, 460), VIEW, (0, 1, 0), 1.5)
    renderer = figure.add("refined where they can meet", actors[0], bounds=get_bounds(actors))
    renderer.AddActor(actors[1])
    curves = draw_curves(meeting.GetOutput(0), 0.016)
    curves.GetProperty().SetColor(0.85, 0.2, 0.1)
    renderer.AddActor(curves)
    figure.write(picture)


def motion(picture: str, *files: str) -> None:
    """Move there and back, so that the loop is seamless."""
    meeting = Meeting(files, 1500)
    figure = Figure(1, 1, (360, 220), VIEW, (0, 1, 0), 1.9)
    images: list[vtkImageData] = []
    for i in range(FRAMES):
        t = 1 - abs(1 - 2 * i / FRAMES)
        meeting.move((2.2 - 3.4 * t, PLACE[1], PLACE[2]))
        if not images:
            meeting.show(figure, "", (-1.9, 1.9, -1, 1, -0.8, 0.8))
        meeting.show_curves()
        images.append(photograph(figure.window))
    write_gif(picture, images, SECONDS, COLOURS)


FIGURES: tuple[Callable[..., None], ...] = (candidates, distance, displaced, motion)


def main(name: str, picture: str, *files: str) -> None:
    for figure in FIGURES:
        if figure.__name__ == name and len(files) in ((0,) if figure is displaced else (0, 2)):
            figure(picture, *files)
            return
    names = ", ".join(figure.__name__ for figure in FIGURES)
    sys.exit(f"usage: contact.py NAME PICTURE [FILES]; NAME is one of {names}, FILES two meshes")


arguments = read_arguments()
if len(arguments) < 2:
    main("", "")
main(*arguments)
