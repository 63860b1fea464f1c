# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw curved cells with their exact shape, without a display: patches.py NAME PICTURE.png [FILE]

NAME is one of
  teapot   Bézier patches, their levels, and about as many triangles by VTK; FILE is teapot.bpt
  torus    a torus of rational cells
  field    a field of degree 4 with isolines, beside VTK's linear colours
  can      hexahedra made quadratic and bent; FILE is can.vtu
Without FILE the script generates cells.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable
from typing import Any

import relevo
from arguments import check_file, read_arguments
from figure import Figure, get_mapper, make_actor, show_edges
from vtkmodules.vtkCommonCore import (
    vtkDataArray,
    vtkDoubleArray,
    vtkIdList,
    vtkLookupTable,
    vtkPoints,
)
from vtkmodules.vtkCommonDataModel import (
    VTK_LAGRANGE_QUADRILATERAL,
    VTK_QUADRATIC_HEXAHEDRON,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter, vtkLinearToQuadraticCellsFilter
from vtkmodules.vtkFiltersSources import vtkCellTypeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

HALF = math.sqrt(0.5)
# A circle of radius 1 as a rational curve of degree 2: x, y and weight of each control point.
CIRCLE = [
    (1, 0, 1),
    (1, 1, HALF),
    (0, 1, 1),
    (-1, 1, HALF),
    (-1, 0, 1),
    (-1, -1, HALF),
    (0, -1, 1),
    (1, -1, HALF),
    (1, 0, 1),
]
CIRCLE_KNOTS = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]


def make_array(values: Iterable[float], name: str | None = None) -> vtkDoubleArray:
    array = vtkDoubleArray()
    for value in values:
        array.InsertNextValue(value)
    if name:
        array.SetName(name)
    return array


def make_torus(radius: float = 1.0, tube: float = 0.4) -> vtkUnstructuredGrid:
    """Return a torus of 16 rational cells of degree 2 x 2."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    weights = []
    for x, z, w in CIRCLE:
        for c, s, v in CIRCLE:
            across = radius + tube * x
            points.InsertNextPoint(across * c, across * s, tube * z)
            weights.append(w * v)
    source = relevo.vtkNURBSSource()
    for direction in (0, 1):
        source.SetDegree(direction, 2)
        source.SetKnots(direction, make_array(CIRCLE_KNOTS))
    source.SetDimensions(len(CIRCLE), len(CIRCLE))
    source.SetControlPoints(points)
    source.SetWeights(make_array(weights))
    source.Update()
    return source.GetOutput()


def read_grid(filename: str) -> vtkUnstructuredGrid:
    if filename.endswith(".bpt"):
        reader: Any = relevo.vtkBezierPatchReader()
    else:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

        reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(check_file(filename))
    reader.Update()
    grid: vtkUnstructuredGrid = reader.GetOutput()
    return grid


def make_recipe(pixels: float = 0.5) -> relevo.vtkAdaptiveRefinement:
    """Return a recipe that limits the error in pixels."""
    metric = relevo.vtkPatchErrorDepthTagMetric()
    metric.SetScreenSpaceError(pixels)
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetSurface(relevo.vtkPatchSurface())
    recipe.SetMetric(metric)
    recipe.SetLevelRuleToPerEdge()
    recipe.SetSegmentPolicyToWholeNumbers()
    recipe.SetMaximumLevel(7)
    return recipe


def draw_patches(
    grid: vtkUnstructuredGrid, recipe: relevo.vtkAdaptiveRefinement | None = None
) -> vtkActor:
    patches = relevo.vtkPatchSurfaceFilter()
    patches.SetInputData(grid)
    mapper = relevo.vtkAdaptivePatchMapper()
    mapper.SetInputConnection(patches.GetOutputPort())
    mapper.SetRefinement(recipe or make_recipe())
    mapper.ScalarVisibilityOff()
    mapper.Update()
    return make_actor(mapper)


def draw_flat(grid: vtkUnstructuredGrid, level: int) -> vtkActor:
    """Draw VTK's uniform subdivision of the cells, with the normals of VTK's filter."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.SetNonlinearSubdivisionLevel(level)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.Update()
    return make_actor(mapper)


def count_flat(actor: vtkActor) -> int:
    return int(get_mapper(actor).GetInput().GetNumberOfCells())


def teapot(filename: str | None = None) -> Figure:
    """Draw the patches, their levels, and VTK's subdivision with about as many triangles."""
    grid = read_grid(filename) if filename else make_torus()
    figure = Figure(3, 1, (420, 330), (0.4, -1, 0.5), (0, 0, 1), 1.5)
    smooth = draw_patches(grid, make_recipe(2))
    levels = draw_patches(grid, make_recipe(2))
    get_mapper(levels).SetColorModeToLevel()
    get_mapper(levels).ScalarVisibilityOn()
    show_edges(levels)
    bounds = smooth.GetBounds()
    figure.add("2 pixels", smooth, bounds=bounds)
    figure.add("their levels", levels, bounds=bounds)
    figure.window.Render()
    triangles: int = get_mapper(smooth).GetNumberOfDrawnTriangles()
    rivals = [draw_flat(grid, level) for level in range(1, 5)]
    rival = min(rivals, key=lambda actor: abs(count_flat(actor) - triangles))
    show_edges(rival)
    figure.add(f"VTK: {count_flat(rival):,} triangles", rival, bounds=bounds)
    figure.labels[0].SetInput(f"{triangles:,} triangles: 2 pixels")
    return figure


def torus() -> Figure:
    """Draw VTK's coarsest triangles beside the exact cells."""
    grid = make_torus()
    figure = Figure(2, 1, (420, 320), (0.2, -1, 1.1), (0, 1, 0), 1.3)
    flat = draw_flat(grid, 1)
    round_one = draw_patches(grid)
    get_mapper(round_one).PatchEdgesOn()
    figure.add(f"VTK: {count_flat(flat):,} triangles", flat, bounds=flat.GetBounds())
    figure.add("rational cells and their edges", round_one, bounds=flat.GetBounds())
    return figure


def make_field(cells: int = 2, degree: int = 4) -> vtkUnstructuredGrid:
    """Return Lagrange cells on a wavy sheet, with a field that oscillates within them."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    side = cells * degree + 1
    field = []
    for j in range(side):
        for i in range(side):
            x, y = i / (side - 1), j / (side - 1)
            points.InsertNextPoint(x, y, 0.12 * math.sin(math.pi * x) * math.cos(math.pi * y))
            field.append(math.sin(5 * x + 1) * math.cos(6 * y) + 0.5 * x)
    grid.SetPoints(points)

    def at(i: int, j: int) -> int:
        return j * side + i

    for cj in range(cells):
        for ci in range(cells):
            i0, j0, d = ci * degree, cj * degree, degree
            inner = range(1, d)
            ids = [at(i0, j0), at(i0 + d, j0), at(i0 + d, j0 + d), at(i0, j0 + d)]
            ids += [at(i0 + k, j0) for k in inner] + [at(i0 + d, j0 + k) for k in inner]
            ids += [at(i0 + k, j0 + d) for k in inner] + [at(i0, j0 + k) for k in inner]
            ids += [at(i0 + k, j0 + m) for m in inner for k in inner]
            cell = vtkIdList()
            for point in ids:
                cell.InsertNextId(point)
            grid.InsertNextCell(VTK_LAGRANGE_QUADRILATERAL, cell)
    grid.GetPointData().SetScalars(make_array(field, "Field"))
    return grid


def colour(actor: vtkActor, array: vtkDataArray, component: int = 0) -> None:
    """Colour an actor by a component, or with -1 by the length of the vectors."""
    table = vtkLookupTable()
    table.SetHueRange(0.66, 0.0)
    table.SetTableRange(array.GetRange(component))
    if component < 0:
        table.SetVectorModeToMagnitude()
    mapper = actor.GetMapper()
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    mapper.ScalarVisibilityOn()
    actor.GetProperty().SetSpecular(0)


def field() -> Figure:
    """Draw cells subdivided once by VTK, and the same cells evaluated at every pixel."""
    grid = make_field()
    array = grid.GetPointData().GetScalars()
    figure = Figure(2, 1, (420, 360), (0.1, -0.8, 1), (0, 1, 0), 1.25)
    flat = draw_flat(grid, 1)
    exact = draw_patches(grid)
    get_mapper(exact).SetIsolineSpacing(0.2)
    get_mapper(exact).PatchEdgesOn()
    for label, actor in (
        (f"VTK: {count_flat(flat):,} triangles, linear colours", flat),
        ("the cells' own basis, with isolines", exact),
    ):
        colour(actor, array)
        figure.add(label, actor, bounds=exact.GetBounds())
    return figure


def bend(grid: vtkUnstructuredGrid, angle: float = 1.2) -> vtkUnstructuredGrid:
    """Bend the grid along its longest side. Nodes within edges move too, so cells become curved."""
    bounds = grid.GetBounds()
    axis = max(range(3), key=lambda c: bounds[2 * c + 1] - bounds[2 * c])
    across = (axis + 1) % 3
    low, high = bounds[2 * axis : 2 * axis + 2]
    radius = (high - low) / angle
    points = grid.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        x = list(points.GetPoint(i))
        turn = angle * ((x[axis] - low) / (high - low) - 0.5)
        away = radius + x[across]
        x[axis], x[across] = away * math.sin(turn), away * math.cos(turn) - radius
        points.SetPoint(i, x)
    return grid


def make_block() -> vtkUnstructuredGrid:
    """Return a bar of 32 quadratic hexahedra."""
    source = vtkCellTypeSource()
    source.SetCellType(VTK_QUADRATIC_HEXAHEDRON)
    source.SetBlocksDimensions(8, 2, 2)
    source.Update()
    return source.GetOutput()


def can(filename: str | None = None) -> Figure:
    """Colour cells by a point array, evaluated with their quadratic basis."""
    if filename:
        quadratic = vtkLinearToQuadraticCellsFilter()
        quadratic.SetInputData(read_grid(filename))
        quadratic.Update()
        grid, name = quadratic.GetOutput(), "VEL"
    else:
        grid, name = make_block(), "DistanceToCenter"
    grid = bend(grid)
    figure = Figure(2, 1, (420, 330), (0.2, 1, 0.5), (0, 0, 1), 1.15)
    for label, edges in (("quadratic cells, bent", False), ("their edges", True)):
        actor = draw_patches(grid)
        array = grid.GetPointData().GetArray(name)
        actor.GetMapper().SetScalarModeToUsePointFieldData()
        actor.GetMapper().SelectColorArray(name)
        colour(actor, array, -1 if array.GetNumberOfComponents() > 1 else 0)
        get_mapper(actor).SetPatchEdges(edges)
        figure.add(label, actor, bounds=actor.GetBounds())
    return figure


FIGURES: tuple[Callable[..., Figure], ...] = (teapot, torus, field, can)


def main(name: str, picture: str, *files: str) -> None:
    for figure in FIGURES:
        takes_file = figure in (teapot, can)
        if figure.__name__ == name and len(files) <= takes_file:
            figure(*files).write(picture)
            return
    names = ", ".join(figure.__name__ for figure in FIGURES)
    sys.exit(f"usage: patches.py NAME PICTURE.png [FILE]; NAME is one of {names}")


arguments = read_arguments()
if len(arguments) < 2:
    main("", "")
main(*arguments)
