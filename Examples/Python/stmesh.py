# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Shape a head with tags at four vertices, without a display: stmesh.py PICTURE.png

From left to right: a head of 376 triangles, its PN triangles, and the same with scalar tags at the
marked vertices. They give a pointed nose (sharpness), creased brows (sharpness with a direction)
and a fuller chin (tension). The surface is refined where it curves.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from typing import Any

import relevo
from arguments import read_arguments
from figure import Figure, draw_coarse, draw_recipe, get_mapper, make_actor
from meshes import make_mesh
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

AROUND, RINGS = 16, 11  # vertices per ring, and rings between the two poles


def bump(x: float, center: float, width: float) -> float:
    return math.exp(-(((x - center) / width) ** 2))


def place(azimuth: float, latitude: float) -> list[float]:
    """Return a point of the head. The face looks along -y, with its middle at azimuth 0."""
    side, front = math.sin(azimuth), math.cos(azimuth)
    across, up = math.cos(latitude), math.sin(latitude)
    x, y, z = 0.74 * side * across, -0.92 * front * across, 1.05 * up
    if front > 0:
        middle, eyes = bump(azimuth, 0, 0.12), bump(abs(azimuth), 0.39, 0.25)
        y -= 0.34 * bump(latitude, -0.26, 0.16) * middle  # nose
        y -= 0.1 * bump(latitude, 0, 0.16) * middle  # its bridge
        y -= 0.16 * bump(latitude, 0.26, 0.12) * bump(abs(azimuth), 0.39, 0.4)  # brows
        y += 0.12 * bump(latitude, 0, 0.12) * eyes  # sockets
        y += 0.08 * bump(latitude, -0.52, 0.1) * bump(azimuth, 0, 0.5)  # mouth
        y -= 0.3 * bump(latitude, -0.79, 0.2) * bump(azimuth, 0, 0.4)  # chin
    # The head narrows towards the chin and the neck.
    narrow = 1 - 0.25 * bump(latitude, -0.95, 0.5)
    return [narrow * x, y, z]


def make_head() -> tuple[list[list[float]], list[tuple[int, int, int]], list[int]]:
    """Return points, triangles, and the four vertices to tag: nose, two brows, chin."""
    points = [[0.0, 0.1, -1.15], [0.0, 0.05, 1.05]]
    for ring in range(RINGS):
        latitude = math.pi * ((ring + 1) / (RINGS + 1) - 0.5)
        for i in range(AROUND):
            azimuth = 2 * math.pi * i / AROUND
            points.append(place(azimuth if i <= AROUND // 2 else azimuth - 2 * math.pi, latitude))

    def vertex(ring: int, i: int) -> int:
        return 2 + ring * AROUND + i % AROUND

    triangles = []
    for i in range(AROUND):
        triangles.append((0, vertex(0, i + 1), vertex(0, i)))
        triangles.append((1, vertex(RINGS - 1, i), vertex(RINGS - 1, i + 1)))

    def add_quad(a: int, b: int, c: int, d: int) -> None:
        triangles.extend([(a, b, c), (a, c, d)])

    eared = set()  # quads that ears replace
    for side, column in ((1, AROUND // 4), (-1, AROUND - AROUND // 4 - 1)):
        # Move two quads of the side outwards, and add six quads as walls.
        rim = [vertex(r, column + c) for r, c in ((4, 0), (4, 1), (5, 1), (6, 1), (6, 0), (5, 0))]
        moved = []
        for k, corner in enumerate(rim):
            x, y, z = points[corner]
            back = (k in (1, 2, 3)) == (side > 0)
            moved.append(len(points))
            points.append(
                [x + side * (0.2 if back else 0.1), y + 0.08, z + (0.08 if k in (3, 4) else 0)]
            )
        for k in range(6):
            add_quad(rim[k], rim[(k + 1) % 6], moved[(k + 1) % 6], moved[k])
        add_quad(moved[0], moved[1], moved[2], moved[5])
        add_quad(moved[5], moved[2], moved[3], moved[4])
        eared |= {(4, column), (5, column)}
    for ring in range(RINGS - 1):
        for i in range(AROUND):
            if (ring, i) not in eared:
                corners = ((ring, i), (ring, i + 1), (ring + 1, i + 1), (ring + 1, i))
                add_quad(*(vertex(*corner) for corner in corners))
    return points, triangles, [vertex(4, 0), vertex(6, 1), vertex(6, -1), vertex(2, 0)]


def add_tags(mesh: vtkPolyData, tags: dict[int, dict[str, Any]]) -> None:
    """Add point arrays with the tags of a few points and 0 at the others."""
    for name, components in (("Sharpness", 1), ("Tension", 1), ("Bias", 1), ("Direction", 3)):
        array = vtkFloatArray()
        array.SetName(name)
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(mesh.GetNumberOfPoints())
        array.Fill(0)
        for point, values in tags.items():
            if name in values:
                array.SetTuple(point, values[name] if components > 1 else [values[name]])
        mesh.GetPointData().AddArray(array)


def draw_bent(mesh: vtkPolyData, surface: relevo.vtkRefinementSurface) -> vtkActor:
    """Draw the surface, refined where the mesh curves."""
    metric = relevo.vtkCurvatureDepthTagMetric()
    metric.SetQuantiles(0, 0.86)
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(4)
    recipe.SetMetric(metric)
    recipe.GeomorphingOff()  # a still picture needs no morphing
    recipe.SetSurface(surface)
    return draw_recipe(mesh, recipe)


def draw_mark(position: Sequence[float]) -> vtkActor:
    sphere = vtkSphereSource()
    sphere.SetCenter(position)
    sphere.SetRadius(0.03)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = make_actor(mapper)
    actor.GetProperty().SetColor(0.85, 0.1, 0.1)
    return actor


def main(picture: str) -> None:
    points, triangles, tagged = make_head()
    nose, left, right, chin = tagged
    mesh = make_mesh(points, triangles)
    add_tags(
        mesh,
        {
            nose: {"Sharpness": 1},
            left: {"Sharpness": 1, "Direction": (1, 0, 0)},
            right: {"Sharpness": 1, "Direction": (1, 0, 0)},
            chin: {"Tension": -1},
        },
    )
    figure = Figure(3, 1, (400, 420), position=(0.62, -1, 0.12), up=(0, 0, 1), zoom=1.5)
    curved = draw_bent(mesh, relevo.vtkPNTriangleSurface())
    shaped = draw_bent(mesh, relevo.vtkScalarTaggedSurface())
    coarse_panel = figure.add(f"{mesh.GetNumberOfCells()} triangles", draw_coarse(mesh))
    figure.add("PN triangles", curved)
    tagged_panel = figure.add("scalar tags at four vertices", shaped)
    for renderer in (coarse_panel, tagged_panel):
        for vertex in tagged:
            renderer.AddActor(draw_mark(points[vertex]))
    figure.write(picture)
    count = get_mapper(shaped).GetNumberOfDrawnTriangles()
    print(mesh.GetNumberOfCells(), "faces,", count, "triangles")


arguments = read_arguments()
if len(arguments) != 1:
    sys.exit("usage: stmesh.py PICTURE.png")
main(*arguments)
