# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Show vectors on surfaces as streaks, without a display: flow.py NAME PICTURE.png [FILE]

NAME is one of
  fields    a sphere and a torus with vectors from formulae
  levels    a coarse torus, refined where the vectors turn, with the levels beside it
  looks     ways to combine streaks with colours, and contrasts
  oriented  streaks with heads, from sparse noise
or, with a FILE of VTK's data,
  plane     a section through a reactor: SurfaceVectors.vtk
  disk      the rotating disk of a reactor, whose walls have no flow: disk_out_ref_surface.vtp
  office    the air of a room, on slices: office.binary.vtk
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from typing import Any

import relevo
from arguments import check_file, read_arguments
from figure import Figure, draw_recipe, get_mapper, show_edges
from meshes import make_mesh, set_normals, set_point_array
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter, vtkPolyDataNormals, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOLegacy import vtkDataSetReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkRenderer

# From slow to fast. Colours are light, so that streaks are visible.
SPEEDS = (
    (0.29, 0.27, 0.62),
    (0.20, 0.55, 0.72),
    (0.36, 0.78, 0.58),
    (0.93, 0.86, 0.42),
    (0.95, 0.52, 0.25),
)

Vector = tuple[float, ...]
Field = Callable[[Vector], Vector]
TorusField = Callable[[float, float], tuple[float, float]]


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def make_sphere(field: Field, around: int = 48, across: int = 24) -> vtkPolyData:
    """Return a unit sphere with the vectors field(p) at its points p."""
    points = [(0.0, 0.0, -1.0)]
    for j in range(1, across):
        b = math.pi * (j / across - 0.5)
        for i in range(around):
            a = 2 * math.pi * i / around
            points.append((math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)))
    points.append((0.0, 0.0, 1.0))
    triangles, last = [], len(points) - 1
    for i in range(around):
        k = (i + 1) % around
        triangles.append((0, 1 + k, 1 + i))
        triangles.append((last, last - around + i, last - around + k))
        for j in range(across - 2):
            a, b = 1 + j * around, 1 + (j + 1) * around
            triangles += [(a + i, a + k, b + k), (a + i, b + k, b + i)]
    mesh = make_mesh(points, triangles)
    set_normals(mesh, points)
    set_point_array(mesh, "Flow", [field(p) for p in points])
    return mesh


def make_torus(
    field: TorusField, around: int = 60, across: int = 30, thickness: float = 0.42
) -> vtkPolyData:
    """Return a torus around z with vectors a * e_u + b * e_v, where (a, b) = field(u, v).

    u runs around the torus and v around its tube; e_u and e_v are the unit vectors along them.
    """
    points, normals, vectors, triangles = [], [], [], []
    for i in range(around):
        u = 2 * math.pi * i / around
        e_u = (-math.sin(u), math.cos(u), 0.0)
        for j in range(across):
            v = 2 * math.pi * j / across
            normal = (math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
            radius = 1 + thickness * math.cos(v)
            points.append((radius * math.cos(u), radius * math.sin(u), thickness * math.sin(v)))
            normals.append(normal)
            a, b = field(u, v)
            vectors.append(tuple(a * s + b * t for s, t in zip(e_u, cross(normal, e_u))))
            c, d = i * across, (i + 1) % around * across
            k = (j + 1) % across
            triangles += [(c + j, d + j, d + k), (c + j, d + k, c + k)]
    mesh = make_mesh(points, triangles)
    set_normals(mesh, normals)
    set_point_array(mesh, "Flow", vectors)
    return mesh


def swirls(p: Vector) -> Vector:
    """Return the sum of s * exp(4 (a.p - 1)) * a x p over several axes a.

    These are rotations that are fastest near their axes. Those with negative s turn backwards.
    """
    v: Vector = (0.0, 0.0, 0.0)
    for s, a in (
        (1.0, (0.36, -0.8, 0.48)),
        (-1.0, (-0.48, -0.6, 0.64)),
        (0.8, (-0.6, -0.8, 0.0)),
        (-0.9, (0.6, -0.64, -0.48)),
        (0.6, (-0.28, -0.96, -0.4)),
        (0.8, (0.8, 0.36, 0.48)),
        (-0.7, (0.0, 0.6, 0.8)),
    ):
        share = s * math.exp(4 * (sum(x * y for x, y in zip(a, p)) - 1))
        v = tuple(x + share * y for x, y in zip(v, cross(a, p)))
    return v


def waves(u: float, v: float) -> tuple[float, float]:
    """Return components along the torus and, alternating, across it."""
    return 0.6 + 0.5 * math.cos(v), math.sin(3 * u) + 0.4 * math.cos(2 * v)


def make_colours(highest: float) -> vtkColorTransferFunction:
    colours = vtkColorTransferFunction()
    for i, colour in enumerate(SPEEDS):
        colours.AddRGBPoint(highest * i / (len(SPEEDS) - 1), *colour)
    colours.SetVectorModeToMagnitude()
    return colours


def make_recipe(
    level: int = 0,
    metric: relevo.vtkDepthTagMetric | None = None,
    surface: relevo.vtkRefinementSurface | None = None,
) -> relevo.vtkAdaptiveRefinement:
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(level)
    recipe.SetMetric(metric)
    recipe.SetSurface(surface)
    return recipe


def draw_flow(
    mesh: vtkPolyData, name: str, highest: float, recipe: relevo.vtkAdaptiveRefinement
) -> vtkActor:
    """Draw streaks along the vectors, coloured by their length from 0 to `highest`."""
    mapper = relevo.vtkAdaptiveLICMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    mapper.SetInputArrayToProcess(0, 0, 0, 0, name)  # the last 0: point data
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(make_colours(highest))
    mapper.InterpolateScalarsBeforeMappingOn()
    # Streaks change the lightness of the colours. The bias avoids the darkest part of the range.
    mapper.SetColorModeToMultiply()
    mapper.SetEnhanceContrastToLIC()
    mapper.SetMapModeBias(0.3)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.75)
    return actor


def add_legend(
    renderer: vtkRenderer, table: vtkScalarsToColors, title: str, left: float = 0.87
) -> None:
    legend = vtkScalarBarActor()
    legend.SetLookupTable(table)
    legend.SetTitle(title)
    legend.SetNumberOfLabels(3)
    legend.SetLabelFormat("%.3g")
    legend.SetTextPositionToPrecedeScalarBar()
    legend.SetPosition(left, 0.03)
    legend.SetWidth(0.11)
    legend.SetHeight(0.36)
    legend.SetBarRatio(0.25)
    legend.UnconstrainedFontSizeOn()
    legend.SetVerticalTitleSeparation(6)
    for text in (legend.GetTitleTextProperty(), legend.GetLabelTextProperty()):
        text.SetFontSize(12)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    renderer.AddViewProp(legend)


def fields() -> Figure:
    """Draw vectors on a sphere and a torus, refined so that both look round."""
    figure = Figure(2, 1, (480, 420), (0, -1, 0.35), (0, 0, 1), 1.35)
    recipe = make_recipe(2, surface=relevo.vtkPNTriangleSurface())
    for label, mesh, highest, view in (
        ("swirls on a sphere", make_sphere(swirls), 0.6, (0, -1, 0.35)),
        ("waves along a torus", make_torus(waves), 1.6, (0, -1, 0.9)),
    ):
        actor = draw_flow(mesh, "Flow", highest, recipe)
        add_legend(figure.add(label, actor, view), actor.GetMapper().GetLookupTable(), "|v|")
    return figure


def levels() -> Figure:
    """Draw a coarse mesh, its curved surface refined where the vectors turn, and the levels."""
    coarse = make_torus(waves, 20, 9)
    metric = relevo.vtkFieldVariationDepthTagMetric()
    metric.SetArrayName("Flow")
    curved = make_recipe(3, metric, relevo.vtkPNTriangleSurface())
    curved.SetLevelRuleToPerEdge()
    figure = Figure(3, 1, (400, 300), (0, -1, 0.9), (0, 0, 1), 1.45)
    actor = draw_flow(coarse, "Flow", 1.6, make_recipe())
    figure.add(f"{coarse.GetNumberOfCells()} triangles", actor)
    figure.add("refined where the vectors turn", draw_flow(coarse, "Flow", 1.6, curved))
    coloured = draw_recipe(coarse, curved)
    get_mapper(coloured).SetColorModeToLevel()
    get_mapper(coloured).ScalarVisibilityOn()
    coloured.GetProperty().SetAmbient(0.3)
    coloured.GetProperty().SetSpecular(0)
    show_edges(coloured)
    table = get_mapper(coloured).GetLevelLookupTable()
    add_legend(figure.add("its levels", coloured), table, "", 0.82)
    return figure


def looks() -> Figure:
    """Draw each colour mode with each contrast and default settings otherwise."""
    mesh = make_sphere(swirls)
    recipe = make_recipe(2, surface=relevo.vtkPNTriangleSurface())
    figure = Figure(4, 2, (270, 270), (0, -1, 0.35), (0, 0, 1), 1.35)
    for mode in ("Blend", "Multiply"):
        for contrast in ("Off", "LIC", "Color", "Both"):
            actor = draw_flow(mesh, "Flow", 0.6, recipe)
            mapper = get_mapper(actor)
            getattr(mapper, f"SetColorModeTo{mode}")()
            getattr(mapper, f"SetEnhanceContrastTo{contrast}")()
            mapper.SetMapModeBias(0)
            figure.add(f"{mode}, contrast {contrast}", actor)
    return figure


def oriented() -> Figure:
    """Draw streaks without and with heads. Dark spots on a light ground give dark heads."""
    mesh = make_sphere(swirls)
    recipe = make_recipe(2, surface=relevo.vtkPNTriangleSurface())
    figure = Figure(2, 1, (480, 420), (0, -1, 0.35), (0, 0, 1), 1.35)
    actor = draw_flow(mesh, "Flow", 0.6, recipe)
    figure.add("streaks", actor)
    actor = draw_flow(mesh, "Flow", 0.6, recipe)
    mapper = get_mapper(actor)
    mapper.OrientedLICOn()
    mapper.EnhancedLICOff()
    mapper.SetNumberOfSteps(30)
    mapper.SetNoiseType(mapper.NOISE_TYPE_UNIFORM)
    mapper.SetMaxNoiseValue(0.02)
    mapper.SetImpulseNoiseBackgroundValue(1)
    mapper.SetImpulseNoiseProbability(0.02)
    mapper.SetNoiseGrainSize(3)
    mapper.SetLowLICContrastEnhancementFactor(0.5)
    mapper.SetMapModeBias(0)
    figure.add("streaks with heads", actor)
    return figure


def read(filename: str) -> vtkDataSet:
    reader: Any = vtkXMLPolyDataReader() if filename.endswith(".vtp") else vtkDataSetReader()
    reader.SetFileName(check_file(filename))
    reader.Update()
    data: vtkDataSet = reader.GetOutput()
    if data.GetNumberOfPoints() == 0:
        sys.exit(f"flow.py: {filename!r} has no points")
    return data


def get_surface(data: vtkDataSet) -> vtkPolyData:
    surface = vtkGeometryFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()


def make_plane(origin: Sequence[float], normal: Sequence[float]) -> vtkPlane:
    result = vtkPlane()
    result.SetOrigin(origin)
    result.SetNormal(normal)
    return result


def cut(data: vtkDataSet, origin: Sequence[float], normal: Sequence[float]) -> vtkPolyData:
    cutter = vtkCutter()
    cutter.SetInputData(data)
    cutter.SetCutFunction(make_plane(origin, normal))
    cutter.Update()
    return cutter.GetOutput()


def draw_still(data: vtkDataSet, name: str) -> vtkActor:
    """Draw the cells without flow, which are the furniture of the room."""
    still = vtkThreshold()
    still.SetInputData(data)
    still.SetInputArrayToProcess(0, 0, 0, 0, name)
    still.SetComponentModeToUseAll()
    still.AllScalarsOn()
    still.SetLowerThreshold(-1e-12)
    still.SetUpperThreshold(1e-12)
    still.Update()
    return draw_recipe(get_surface(still.GetOutput()), make_recipe())


def show_no_flow(mapper: relevo.vtkAdaptiveLICMapper) -> None:
    """Show zero vectors in grey instead of the colour of slow ones."""
    mapper.SetMaskColor(0.62, 0.62, 0.66)
    mapper.SetMaskIntensity(1)


def plane(filename: str) -> Figure:
    """Draw a section of a reactor. The gas enters from above and rises again over the disk."""
    figure = Figure(1, 1, (720, 480), (1, 0, 0), (0, 0, 1), 1.35)
    actor = draw_flow(get_surface(read(filename)), "V", 15, make_recipe())
    actor.GetProperty().LightingOff()
    renderer = figure.add("a section through a reactor", actor)
    renderer.GetActiveCamera().SetWindowCenter(0.08, -0.06)
    add_legend(renderer, actor.GetMapper().GetLookupTable(), "|V|")
    return figure


def disk(filename: str) -> Figure:
    """Draw a rotating disk in a wall that is cut open. Regions without flow are grey.

    The gas leaves through the gap below the disk.
    """
    normals = vtkPolyDataNormals()
    normals.SetInputData(read(filename))
    normals.SetFeatureAngle(30)
    normals.Update()
    recipe = make_recipe(3, surface=relevo.vtkPNTriangleSurface())
    actor = draw_flow(normals.GetOutput(), "V", 20, recipe)
    actor.GetProperty().SetAmbient(0.5)
    mapper = get_mapper(actor)
    show_no_flow(mapper)
    mapper.AddClippingPlane(make_plane((0, -3.95, 0), (0, 1, 0)))
    mapper.AddClippingPlane(make_plane((0, 0, 4), (0, 0, -1)))
    figure = Figure(1, 1, (720, 480), (0.2, -1, 0.55), (0, 0, 1), 1.35)
    renderer = figure.add("a disk that turns, in a wall that is cut open", actor)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, -2.6)
    add_legend(renderer, mapper.GetLookupTable(), "|V|")
    return figure


def office(filename: str) -> Figure:
    """Draw slices of a room. Air enters at the foot of the left wall and leaves at the ceiling."""
    room = read(filename)
    figure = Figure(1, 1, (720, 480), (0.45, -1, 0.95), (0, 0, 1))
    renderer = figure.add("the air of a room", draw_still(room, "vectors"))
    for origin, normal in (
        ((0, 0, 0.3), (0, 0, 1)),
        ((0, 4.2, 0), (0, 1, 0)),
        ((0.3, 0, 0), (1, 0, 0)),
    ):
        actor = draw_flow(cut(room, origin, normal), "vectors", 0.25, make_recipe())
        actor.GetProperty().LightingOff()
        renderer.AddActor(actor)
    renderer.ResetCamera()
    camera = renderer.GetActiveCamera()
    camera.Dolly(1.15)
    camera.SetWindowCenter(0.02, -0.1)
    renderer.ResetCameraClippingRange()
    add_legend(renderer, actor.GetMapper().GetLookupTable(), "|v|")
    return figure


FORMULAE = {figure.__name__: figure for figure in (fields, levels, looks, oriented)}
FILES = {figure.__name__: figure for figure in (plane, disk, office)}


def main(name: str, picture: str, *filename: str) -> None:
    print((FORMULAE | FILES)[name](*filename).write(picture), "triangles")


arguments = read_arguments()
if not (
    (len(arguments) == 2 and arguments[0] in FORMULAE)
    or (len(arguments) == 3 and arguments[0] in FILES)
):
    sys.exit(
        f"usage: flow.py NAME PICTURE.png; NAME is one of {', '.join(FORMULAE)}; "
        f"or: flow.py NAME PICTURE.png FILE; NAME is one of {', '.join(FILES)}"
    )
main(*arguments)
