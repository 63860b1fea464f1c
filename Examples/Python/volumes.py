# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Render volumes of unstructured meshes, without a display: volumes.py NAME PICTURE.png [FILE ...]

NAME is one of
  fin      air in front of a blunt fin, beside VTK's mappers: bluntfinxyz.bin bluntfinq.bin
  post     liquid oxygen around a post, with an isosurface and a cut: postxyz.bin postq.bin
  reactor  the gas of a reactor inside its opaque wall: disk_out_ref.ex2
  can      a crushed can, coloured by cell values: can.vtu
  probe    where rays through some pixels end, with the values there: postxyz.bin postq.bin
  curved   cells of degree 4, beside an even subdivision to linear cells (no files)
  stress   stresses of each cell, beside averages at points (no files)
The files are VTK's data. Without them the script generates a mesh, the flow past a cylinder.
"""

from __future__ import annotations

import itertools
import math
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import relevo
from arguments import check_file, read_arguments
from figure import Figure, make_actor
from meshes import set_point_array
from vtkmodules.vtkCommonCore import vtkDataArray, vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_LAGRANGE_HEXAHEDRON,
    vtkDataSet,
    vtkHexahedron,
    vtkLagrangeHexahedron,
    vtkPiecewiseFunction,
    vtkPlane,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkTextActor,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingVolume import (
    vtkProjectedTetrahedraMapper,
    vtkUnstructuredGridVolumeMapper,
    vtkUnstructuredGridVolumeRayCastMapper,
)
import vtkmodules.vtkRenderingVolumeOpenGL2  # vtkProjectedTetrahedraMapper's drawing

# From low to high: fraction of the range, red, green, blue.
COLOURS = (
    (0.0, 0.16, 0.22, 0.66),
    (0.25, 0.20, 0.62, 0.82),
    (0.5, 0.62, 0.86, 0.62),
    (0.75, 0.98, 0.82, 0.32),
    (1.0, 0.86, 0.22, 0.16),
)


def make_flow(cells: tuple[int, int, int] = (14, 40, 12)) -> vtkStructuredGrid:
    """Return hexahedra around a cylinder of radius 1.

    The point array Speed is the velocity along x of a potential flow that is 0 at the ground. The
    cell array Strain is the range of Speed within a cell.
    """
    radii, angles, heights = cells
    grid = vtkStructuredGrid()
    grid.SetDimensions(radii + 1, angles + 1, heights + 1)
    grid.SetPoints(vtkPoints())
    speeds = []
    for k in range(heights + 1):
        for j in range(angles + 1):
            a = 2 * math.pi * (j % angles) / angles
            for i in range(radii + 1):
                r, z = 4 ** (i / radii), 3 * k / heights
                grid.GetPoints().InsertNextPoint(r * math.cos(a), r * math.sin(a), z)
                speeds.append((1 - math.cos(2 * a) / r**2) * (1 - math.exp(-2 * z)))
    set_point_array(grid, "Speed", speeds)
    strain = vtkFloatArray()
    strain.SetName("Strain")
    for cell in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(cell).GetPointIds()
        corners = [speeds[ids.GetId(i)] for i in range(8)]
        strain.InsertNextValue(max(corners) - min(corners))
    grid.GetCellData().AddArray(strain)
    return grid


def read_plot3d(points: str, flow: str) -> vtkStructuredGrid:
    """Return the grid of a PLOT3D file, with the arrays Density and Momentum."""
    from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader

    reader = vtkMultiBlockPLOT3DReader()
    reader.SetXYZFileName(check_file(points))
    reader.SetQFileName(check_file(flow))
    reader.AutoDetectFormatOn()
    reader.Update()
    blocks: Any = reader.GetOutput()
    grid: vtkStructuredGrid = blocks.GetBlock(0)
    return grid


def read_exodus(filename: str) -> vtkUnstructuredGrid:
    """Return the first block of an Exodus II file, with its point arrays."""
    from vtkmodules.vtkIOExodus import vtkExodusIIReader

    reader = vtkExodusIIReader()
    reader.SetFileName(check_file(filename))
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.Update()
    blocks: Any = reader.GetOutput()
    grid: vtkUnstructuredGrid = blocks.GetBlock(0).GetBlock(0)
    return grid


def read_cells(filename: str) -> vtkUnstructuredGrid:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(check_file(filename))
    reader.Update()
    return reader.GetOutput()


def make_property(
    array: vtkDataArray,
    component: int,
    opacities: Iterable[tuple[float, float]],
    unit_distance: float,
) -> vtkVolumeProperty:
    """Return colours over a component's range (-1: length) and opacities at fractions of it."""
    low, high = array.GetRange(component)
    colour, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for share, *rgb in COLOURS:
        colour.AddRGBPoint(low + share * (high - low), *rgb)
    for share, value in opacities:
        opacity.AddPoint(low + share * (high - low), value)
        # VTK's ray caster integrates exactly between nodes of the colours only.
        colour.AddRGBPoint(low + share * (high - low), *colour.GetColor(low + share * (high - low)))
    look = vtkVolumeProperty()
    look.SetColor(colour)
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(unit_distance)
    return look


def make_volume(
    mapper: vtkUnstructuredGridVolumeMapper, mesh: vtkDataSet, name: str, look: vtkVolumeProperty
) -> vtkVolume:
    """Return a volume of a mesh with a point or cell array."""
    mapper.SetInputData(mesh)
    if mesh.GetPointData().HasArray(name):
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectScalarArray(name)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(look)
    return volume


def make_plane(origin: Sequence[float], normal: Sequence[float]) -> vtkPlane:
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane


def fin(points: str = "", flow: str = "") -> Figure:
    """Tetrahedra, which is all that VTK's mappers take."""
    grid, name = (read_plot3d(points, flow), "Density") if points else (make_flow(), "Speed")
    split = vtkDataSetTriangleFilter()
    split.SetInputData(grid)
    split.Update()
    mesh = split.GetOutput()
    array = mesh.GetPointData().GetArray(name)
    mesh.GetPointData().SetActiveScalars(name)  # which vtkProjectedTetrahedraMapper takes
    opacities = (
        (0, 0.6), (0.1, 0.2), (0.16, 0), (0.18, 0), (0.24, 0.4), (0.28, 0.1), (0.5, 0.7), (1, 1)
    )
    look = make_property(array, 0, opacities, 0.03 * mesh.GetLength())
    figure = Figure(3, 1, (360, 300), (-0.75, -1, 0.6), (0, 0, 1), 1.35)
    for mapper, label in (
        # This mapper draws at the lower left of the window in every viewport, so it comes first.
        (vtkProjectedTetrahedraMapper(), "vtkProjectedTetrahedraMapper"),
        (relevo.vtkGPUUnstructuredGridVolumeMapper(), "exact, on the GPU"),
        (vtkUnstructuredGridVolumeRayCastMapper(), "vtkUnstructuredGridVolumeRayCastMapper"),
    ):
        figure.add(label, make_volume(mapper, mesh, name, look))
    return figure


def post(points: str = "", flow: str = "") -> Figure:
    """Draw the oxygen behind the post. Inside the isosurface it flows backwards.

    Fast streams are opaque. A clipping plane removes the half in front of the plane of symmetry.
    """
    mesh, name = (read_plot3d(points, flow), "Momentum") if points else (make_flow(), "Speed")
    array = mesh.GetPointData().GetArray(name)
    low, high = array.GetRange(0)
    value = 0.0 if low < 0 else low + 0.35 * (high - low)
    zero = (value - low) / (high - low)
    opacities = (
        (0, 0.6), (zero - 1e-4, 0.2), (zero, 0.6), (zero + 1e-4, 0.1), (0.5, 0.02), (0.83, 0), (1, 0.9)
    )
    look = make_property(array, 0, opacities, 0.03 * mesh.GetLength())
    look.GetIsoSurfaceValues().SetValue(0, value)
    look.ShadeOn()
    look.SetAmbient(0.4)
    mapper = relevo.vtkGPUUnstructuredGridVolumeMapper()
    mapper.SetVectorMode(mapper.COMPONENT)  # by default the first
    mapper.IsoSurfacesOn()
    mapper.AddClippingPlane(make_plane((0, 0, 0), (0, 1, 0)))
    figure = Figure(1, 1, (720, 480), (0.5, -1, 0.6), (0, 0, 1))
    volume = make_volume(mapper, mesh, name, look)
    renderer = figure.add("momentum along x, and where it is zero", volume)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(1.2, 0, 0.45 * mesh.GetBounds()[5])
    camera.Dolly(0.1 * mesh.GetLength())
    renderer.ResetCameraClippingRange()
    return figure


def reactor(filename: str | None = None) -> Figure:
    """Draw the gas in a wall that is cut open. The opaque wall hides what is behind it."""
    mesh, name = (read_exodus(filename), "Temp") if filename else (make_flow(), "Speed")
    array = mesh.GetPointData().GetArray(name)
    opacities = ((0, 0), (0.2, 0.03), (0.5, 0.1), (0.9, 0.5), (1, 1))
    look = make_property(array, 0, opacities, 0.04 * mesh.GetLength())
    figure = Figure(1, 1, (720, 480), (0.3, -1, 0.5), (0, 0, 1), 1.05)
    mapper = relevo.vtkGPUUnstructuredGridVolumeMapper()
    volume = make_volume(mapper, mesh, name, look)
    renderer = figure.add("the gas of a reactor in its wall", volume)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    clip = vtkClipPolyData()
    clip.SetInputConnection(surface.GetOutputPort())
    clip.SetClipFunction(make_plane((0, 0, 0), (0.2, 1, 0)))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(clip.GetOutputPort())
    normals.SetFeatureAngle(30)
    wall = vtkPolyDataMapper()
    wall.SetInputConnection(normals.GetOutputPort())
    wall.ScalarVisibilityOff()
    renderer.AddActor(make_actor(wall))
    return figure


def can(filename: str | None = None) -> Figure:
    """Draw a can by cell values. The most strained cells are red."""
    mesh, name = (read_cells(filename), "EQPS") if filename else (make_flow(), "Strain")
    array = mesh.GetCellData().GetArray(name)
    opacities = ((0, 0.05), (0.1, 0.2), (0.4, 0.8), (1, 1))
    look = make_property(array, 0, opacities, 0.008 * mesh.GetLength())
    figure = Figure(1, 1, (720, 480), (-0.2, -0.9, 1), (0, 0, 1), 1.45)
    mapper = relevo.vtkGPUUnstructuredGridVolumeMapper()
    figure.add("strain of a can's cells", make_volume(mapper, mesh, name, look))
    return figure


def probe(points: str = "", flow: str = "") -> Figure:
    """Mark the positions that rays through some pixels reach, with the values there."""
    figure = post(points, flow)
    renderer = figure.window.GetRenderers().GetFirstRenderer()
    columns, rows = figure.window.GetSize()
    volume_probe = relevo.vtkVolumeProbe()
    volume_probe.SetRenderer(renderer)
    marks = []
    for share_x, share_y in ((0.5, 0.62), (0.56, 0.4), (0.72, 0.55), (0.85, 0.7), (0.9, 0.5)):
        x, y = round(share_x * columns), round(share_y * rows)
        if volume_probe.Probe(x, y):
            marks.append((x, y, volume_probe.GetPosition(), volume_probe.GetValue()))
    for x, y, position, value in marks:
        ball = vtkSphereSource()
        ball.SetCenter(position)
        ball.SetRadius(0.008 * renderer.ComputeVisiblePropBounds()[1])
        ball_mapper = vtkPolyDataMapper()
        ball_mapper.SetInputConnection(ball.GetOutputPort())
        actor = make_actor(ball_mapper)
        actor.GetProperty().SetColor(0.1, 0.1, 0.1)
        renderer.AddActor(actor)
        label = vtkTextActor()
        label.SetInput(f"{value:.3f}")
        label.SetPosition(x + 8, y + 6)
        label.GetTextProperty().SetFontSize(18)
        label.GetTextProperty().SetColor(0, 0, 0)
        label.GetTextProperty().SetBackgroundColor(1, 1, 1)
        label.GetTextProperty().SetBackgroundOpacity(0.8)
        renderer.AddViewProp(label)
    return figure


def make_coil(cells: int = 4, degree: int = 4) -> vtkUnstructuredGrid:
    """Return curved hexahedra around an axis. The array Wave has their degree along each."""
    mesh, waves = vtkUnstructuredGrid(), []
    mesh.SetPoints(vtkPoints())
    cell = vtkLagrangeHexahedron()
    side = degree + 1
    cell.GetPointIds().SetNumberOfIds(side**3)
    cell.GetPoints().SetNumberOfPoints(side**3)
    cell.SetUniformOrderFromNumPoints(side**3)
    for number in range(cells):
        ids = [0] * side**3
        for at in itertools.product(range(side), repeat=3):
            u, v, w = (step / degree for step in at)
            angle = 1.75 * math.pi * (number + u) / cells
            radius, height = 1 + v, w + 0.6 * angle / math.pi
            point = (radius * math.cos(angle), radius * math.sin(angle), height)
            ids[cell.PointIndexFromIJK(*at)] = mesh.GetPoints().InsertNextPoint(point)
            waves.append(math.cos(2.5 * angle) * math.cos(math.pi * v) * math.cos(math.pi * w))
        mesh.InsertNextCell(VTK_LAGRANGE_HEXAHEDRON, len(ids), ids)
    set_point_array(mesh, "Wave", waves)
    return mesh


def curved() -> Figure:
    """Draw curved cells, and the linear cells between their nodes."""
    mesh = make_coil()
    opacities = (
        (0, 1), (0.1, 0.6), (0.2, 0), (0.32, 0), (0.38, 0.5), (0.44, 0), (0.56, 0), (0.62, 0.5),
        (0.68, 0), (0.8, 0), (0.9, 0.6), (1, 1)
    )
    look = make_property(mesh.GetPointData().GetArray("Wave"), 0, opacities, 0.12)
    split = vtkDataSetTriangleFilter()
    split.SetInputData(mesh)
    split.Update()
    figure = Figure(2, 1, (430, 360), (0.4, -1, 1), (0, 0, 1), 1.5)
    for drawn, label in (
        (mesh, f"{mesh.GetNumberOfCells()} cells of degree 4"),
        (split.GetOutput(), f"even subdivision: {split.GetOutput().GetNumberOfCells()} tetrahedra"),
    ):
        mapper = relevo.vtkGPUUnstructuredGridVolumeMapper()
        figure.add(label, make_volume(mapper, drawn, "Wave", look))
    return figure


def make_beam(cells: tuple[int, int, int] = (14, 4, 4)) -> vtkUnstructuredGrid:
    """Return a bent and twisted beam, in which each hexahedron has points of its own.

    The array Stress is the von Mises stress of a cell at its corners, for a modulus of 1.
    """
    beam, stresses = vtkUnstructuredGrid(), []
    beam.SetPoints(vtkPoints())

    def bend(x: float, y: float, z: float) -> tuple[float, float, float]:
        sag = 0.05 * x * x * (10 - x)
        return (-0.1 * x * y * (7 - x), sag + 0.04 * x * x * z, 0.1 * z * y - 0.04 * x * x * y)

    hexahedron = vtkHexahedron()
    for first in itertools.product(*(range(count) for count in cells)):
        points, moves = [], []
        for corner in range(8):
            step = hexahedron.GetParametricCoords()[3 * corner : 3 * corner + 3]
            at = [(a + b) / count for a, b, count in zip(first, step, cells)]
            x, y, z = 4 * at[0], at[1] - 0.5, at[2] - 0.5
            points.append((x, y, z))
            moves.append(bend(x, y, z))
            hexahedron.GetPoints().SetPoint(corner, (x, y, z))
        ids = []
        for corner in range(8):
            step = hexahedron.GetParametricCoords()[3 * corner : 3 * corner + 3]
            slopes = [0.0] * 9  # x, y and z derivatives of each component
            values = [value for move in moves for value in move]
            hexahedron.Derivatives(0, step, values, 3, slopes)
            normal = [slopes[4 * c] for c in range(3)]
            shear = [slopes[3 * a + b] + slopes[3 * b + a] for a, b in ((0, 1), (1, 2), (2, 0))]
            pairs = sum((normal[c] - normal[c - 1]) ** 2 for c in range(3))
            stresses.append(math.sqrt(0.5 * pairs + 0.75 * sum(value**2 for value in shear)))
            place = [a + 0.3 * b for a, b in zip(points[corner], moves[corner])]
            ids.append(beam.GetPoints().InsertNextPoint(place))
        beam.InsertNextCell(VTK_HEXAHEDRON, 8, ids)
    set_point_array(beam, "Stress", stresses)
    return beam


def stress() -> Figure:
    """Draw stresses that jump between cells, and their averages at coincident points."""
    beam = make_beam()
    values = beam.GetPointData().GetArray("Stress")
    at_points: dict[tuple[float, ...], list[float]] = {}
    places = [tuple(beam.GetPoint(i)) for i in range(beam.GetNumberOfPoints())]
    for i, place in enumerate(places):
        at_points.setdefault(place, []).append(values.GetComponent(i, 0))
    averaged = vtkUnstructuredGrid()
    averaged.DeepCopy(beam)
    means = [sum(at_points[place]) / len(at_points[place]) for place in places]
    set_point_array(averaged, "Stress", means)
    opacities = ((0, 0.02), (0.25, 0.1), (0.5, 0.5), (1, 1))
    look = make_property(values, 0, opacities, 0.15)
    figure = Figure(1, 2, (720, 260), (-0.25, -1, 0.5), (0, 0, 1), 1.5)
    for mesh, label in ((beam, "stresses of each cell"), (averaged, "averages at points")):
        mapper = relevo.vtkGPUUnstructuredGridVolumeMapper()
        figure.add(label, make_volume(mapper, mesh, "Stress", look))
    return figure


FIGURES: dict[Callable[..., Figure], int] = {  # numbers of files
    fin: 2, post: 2, reactor: 1, can: 1, probe: 2, curved: 0, stress: 0
}


def main(name: str, picture: str, *files: str) -> None:
    for figure, number in FIGURES.items():
        if figure.__name__ == name and len(files) in (0, number):
            drawn = figure(*files)
            drawn.write(picture)
            for renderer in drawn.window.GetRenderers():
                for volume in renderer.GetVolumes():
                    if volume.GetMapper().IsA("vtkGPUUnstructuredGridVolumeMapper"):
                        print(volume.GetMapper().GetNumberOfDrawnCells(), "cells")
            return
    names = ", ".join(figure.__name__ for figure in FIGURES)
    sys.exit(f"usage: volumes.py NAME PICTURE.png [FILE ...]; NAME is one of {names}")


arguments = read_arguments()
if len(arguments) < 2:
    main("", "")
main(*arguments)
