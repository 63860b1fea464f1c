# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Show curves and hair, without a display: curves.py NAME PICTURE.png [FILE]

NAME is one of
  hair   hair on a mesh; FILE is for example bunny.ply
  knot   a cubic B-spline around a torus as line, ribbon and tube
Without FILE the script generates a mesh.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable

import relevo
from arguments import read_arguments
from figure import Figure, draw_mesh, get_mapper, make_actor
from meshes import make_ring, read
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPointSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import vtkActor


def make_recipe(pixels: float = 0.5) -> relevo.vtkAdaptiveRefinement:
    """Return a recipe that limits the error in pixels."""
    metric = relevo.vtkPatchErrorDepthTagMetric()
    metric.SetScreenSpaceError(pixels)
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMetric(metric)
    recipe.SetSegmentPolicyToWholeNumbers()
    recipe.SetMaximumLevel(7)
    return recipe


def draw_curves(
    curves: vtkPointSet,
    representation: str = "Lines",
    radius: float | None = None,
    recipe: relevo.vtkAdaptiveRefinement | None = None,
) -> vtkActor:
    mapper = relevo.vtkAdaptiveCurveMapper()
    mapper.SetInputData(curves)
    mapper.SetRefinement(recipe or make_recipe())
    getattr(mapper, "SetRepresentationTo" + representation)()
    if radius:
        mapper.SetRadius(radius)
    mapper.ScalarVisibilityOff()
    return make_actor(mapper)


def orient(mesh: vtkPolyData) -> vtkPolyData:
    """Make normals point outwards, because scans may be inside out and hair follows normals."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    normals.AutoOrientNormalsOn()
    normals.Update()
    return normals.GetOutput()


def grow(mesh: vtkPolyData, hairs: int, length: float, curl: float) -> vtkUnstructuredGrid:
    """Return this many hairs; their length is a fraction of the diagonal of the mesh."""
    area = vtkMassProperties()
    area.SetInputData(mesh)
    area.Update()
    source = relevo.vtkHairSource()
    source.SetInputData(mesh)
    source.SetDensity(hairs / area.GetSurfaceArea())
    source.SetLength(length * mesh.GetLength())
    source.SetCurl(curl)
    source.SetGravity(0, -0.4, 0)
    source.Update()
    return source.GetOutput()


def hair(filename: str | None = None) -> Figure:
    """Draw straight hair and curls as ribbons that face the camera."""
    mesh = orient(read(filename) if filename else make_ring(120, 48))
    figure = Figure(2, 1, (480, 440), (0.35, 0.45, 1), (0, 1, 0), 1.2)
    for label, count, length, curl in (
        ("60,000 hairs", 60000, 0.04, 0),
        ("12,000 curls", 12000, 0.06, 2.5),
    ):
        curves = grow(mesh, count, length, curl)
        actor = draw_curves(curves, "Ribbons")
        get_mapper(actor).SetRadiusArrayName("HairRadius")
        actor.GetProperty().SetColor(0.72, 0.52, 0.30)
        skin = draw_mesh(mesh)
        skin.GetProperty().SetColor(0.45, 0.33, 0.22)
        figure.add(label, actor, bounds=mesh.GetBounds()).AddActor(skin)
    return figure


def make_knot(turns: int = 3, windings: int = 7, spans: int = 42) -> vtkUnstructuredGrid:
    """Return a closed cubic B-spline around a torus."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(spans + 3):
        angle = 2 * math.pi * i / spans
        across = 1 + 0.4 * math.cos(windings * angle)
        turn = turns * angle
        points.InsertNextPoint(
            across * math.cos(turn), across * math.sin(turn), 0.4 * math.sin(windings * angle)
        )
    knots = vtkDoubleArray()
    for i in range(spans + 7):
        knots.InsertNextValue(i)
    source = relevo.vtkNURBSSource()
    source.SetDegree(0, 3)
    source.SetKnots(0, knots)
    source.SetDimensions(spans + 3, 1)
    source.SetControlPoints(points)
    source.Update()
    return source.GetOutput()


def knot() -> Figure:
    """Draw the same cells as lines, ribbons and tubes."""
    curves = make_knot()
    figure = Figure(3, 1, (360, 330), (0.2, -0.35, 1.4), (0, 1, 0), 1.2)
    for representation, radius in (("Lines", None), ("Ribbons", 0.06), ("Tubes", 0.06)):
        actor = draw_curves(curves, representation, radius)
        actor.GetProperty().SetLineWidth(2)
        figure.add(representation.lower(), actor, bounds=curves.GetBounds())
    return figure


FIGURES: tuple[Callable[..., Figure], ...] = (hair, knot)


def main(name: str, picture: str, *files: str) -> None:
    for figure in FIGURES:
        if figure.__name__ == name and len(files) <= (figure is hair):
            figure(*files).write(picture)
            return
    names = ", ".join(figure.__name__ for figure in FIGURES)
    sys.exit(f"usage: curves.py NAME PICTURE.png [FILE]; NAME is one of {names}")


arguments = read_arguments()
if len(arguments) < 2:
    main("", "")
main(*arguments)
