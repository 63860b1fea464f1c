# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw wind over relief, without a display: wind.py HEIGHTMAP PICTURE.png [LID]

The wind is computed, not measured. A layer of ideal air comes from the west-south-west at 10 m/s
and flows between the ground and a lid, without vorticity: div(D grad(phi)) = 0, where D is the
depth of the layer. It flows around mountains that reach the lid, and faster through gaps. LID is a
height; the default is the lowest height plus three fifths of the range. The ground above the lid
has no data. Rows of the height map must run to the east and columns to the north, as in longitude
and latitude.
The script needs numpy.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable

import numpy
import relevo
import vtkmodules.vtkRenderingFreeType  # draws the legend
from arguments import check_file, read_arguments
from numpy.typing import NDArray
from relevo.files import write_picture
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkRenderer,
)

SAMPLES = 300  # samples of the wind along the longer side
SPEED, FROM = 10.0, 250.0  # m/s; degrees, clockwise from north
TOLERANCE = 1e-5

Array = NDArray[numpy.float64]


def sample_heights(height_map: relevo.vtkHeightMap) -> Array:
    """Return heights in rows from south to north, at most SAMPLES in each direction."""
    columns, rows = height_map.GetDimensions()
    share = min(1.0, SAMPLES / max(columns, rows))
    columns, rows = max(3, round(share * columns)), max(3, round(share * rows))
    return numpy.array(
        [
            [height_map.GetHeight((i + 0.5) / columns, (j + 0.5) / rows) for i in range(columns)]
            for j in range(rows)
        ]
    )


def solve(apply: Callable[[Array], Array], right: Array, start: Array) -> Array:
    """Solve apply(x) = right by conjugate gradients; apply is linear and positive semi-definite."""
    x, residual = start, right - apply(start)
    direction, square = residual.copy(), (residual**2).sum()
    goal = TOLERANCE**2 * square
    for _ in range(10 * right.size):
        if square <= goal:
            break
        image = apply(direction)
        step = square / (direction * image).sum()
        x = x + step * direction
        residual = residual - step * image
        previous, square = square, (residual**2).sum()
        direction = residual + square / previous * direction
    return x


def flow(depth: Array, dx: float, dy: float) -> tuple[Array, Array]:
    """Return the velocity to the east and to the north in a layer, 0 where its depth is 0."""
    angle = math.radians(FROM + 180)
    east, north = SPEED * math.sin(angle), SPEED * math.cos(angle)
    rows, columns = depth.shape
    far = east * dx * numpy.arange(columns) + north * dy * numpy.arange(rows)[:, None]
    air = depth > 0
    inner = numpy.zeros_like(air)
    inner[1:-1, 1:-1] = air[1:-1, 1:-1]

    def between(a: Array, b: Array) -> Array:
        """Return the depth between two samples: their harmonic mean, or 0, a wall, if one is 0."""
        return numpy.where((a > 0) & (b > 0), 2 * a * b / numpy.maximum(a + b, 1e-30), 0.0)

    east_faces = between(depth[:, 1:], depth[:, :-1])
    north_faces = between(depth[1:], depth[:-1])

    def outflow(potential: Array) -> Array:
        result = numpy.zeros_like(potential)
        flux = east_faces * numpy.diff(potential, axis=1) / dx**2
        result[:, :-1] -= flux
        result[:, 1:] += flux
        flux = north_faces * numpy.diff(potential, axis=0) / dy**2
        result[:-1] -= flux
        result[1:] += flux
        return result

    # At the border the wind is undisturbed.
    border = numpy.where(inner, 0.0, far)
    change = solve(
        lambda x: numpy.where(inner, outflow(numpy.where(inner, x, 0.0)), 0.0),
        numpy.where(inner, -outflow(border), 0.0),
        numpy.where(inner, far, 0.0),
    )
    potential = border + change
    u, v = numpy.zeros_like(far), numpy.zeros_like(far)
    across = numpy.where(east_faces > 0, numpy.diff(potential, axis=1) / dx, 0.0)
    u[:, 1:-1] = 0.5 * (across[:, 1:] + across[:, :-1])
    u[:, 0], u[:, -1] = across[:, 0], across[:, -1]
    across = numpy.where(north_faces > 0, numpy.diff(potential, axis=0) / dy, 0.0)
    v[1:-1] = 0.5 * (across[1:] + across[:-1])
    v[0], v[-1] = across[0], across[-1]
    return numpy.where(air, u, 0.0), numpy.where(air, v, 0.0)


def make_wind(terrain: relevo.vtkTerrainSource, lid: float) -> vtkImageData:
    """Return an image of vectors to the east, to the north, and up along the slope."""
    heights = sample_heights(terrain.GetHeightMap())
    rows, columns = heights.shape
    bounds = terrain.GetOutput().GetBounds()
    dx, dy = (bounds[1] - bounds[0]) / columns, (bounds[3] - bounds[2]) / rows
    depth = numpy.maximum(lid - heights, 0.0)
    u, v = flow(depth, dx, dy)
    slopes = numpy.gradient(heights, dy, dx)
    wind = numpy.stack([u, v, u * slopes[1] + v * slopes[0]], axis=-1)
    wind[depth == 0] = numpy.nan
    array = numpy_to_vtk(wind.reshape(-1, 3), deep=True)
    array.SetName("Wind")
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.GetPointData().AddArray(array)
    return image


def add_speeds(mesh: vtkPolyData) -> Array:
    """Add and return horizontal speeds, because exaggeration scales the vertical components."""
    wind = vtk_to_numpy(mesh.GetPointData().GetVectors())
    speeds: Array = numpy.hypot(wind[:, 0], wind[:, 1])
    array = numpy_to_vtk(speeds, deep=True)
    array.SetName("Speed")
    mesh.GetPointData().AddArray(array)
    return speeds


def make_colours(highest: float) -> vtkColorTransferFunction:
    colours = vtkColorTransferFunction()
    for share, colour in (
        (0.0, (0.13, 0.19, 0.42)),
        (0.3, (0.16, 0.48, 0.60)),
        (0.5, (0.40, 0.70, 0.50)),
        (0.75, (0.93, 0.82, 0.45)),
        (1.0, (0.80, 0.25, 0.16)),
    ):
        colours.AddRGBPoint(share * highest, *colour)
    colours.SetNanColor(0.95, 0.95, 0.97)
    return colours


def make_legend(colours: vtkScalarsToColors) -> vtkScalarBarActor:
    legend = vtkScalarBarActor()
    legend.SetLookupTable(colours)
    legend.SetTitle("Wind, m/s")
    legend.SetNumberOfLabels(5)
    legend.SetLabelFormat("%.0f")
    legend.SetPosition(0.92, 0.25)
    legend.SetWidth(0.07)
    legend.SetHeight(0.5)
    legend.SetVerticalTitleSeparation(8)
    legend.UnconstrainedFontSizeOn()
    legend.GetTitleTextProperty().SetFontSize(13)
    legend.GetLabelTextProperty().SetFontSize(13)
    return legend


def main(heightmap: str, picture: str, lid: str | None = None) -> None:
    terrain = relevo.vtkTerrainSource()
    terrain.SetFileName(check_file(heightmap))
    terrain.SetResolution(SAMPLES)
    terrain.SetNoDataPolicyToFill()
    terrain.SetExaggeration(2.5)
    terrain.Update()
    lowest, highest = terrain.GetHeightMap().GetRange()
    top = lowest + 0.6 * (highest - lowest) if lid is None else float(lid)
    vectors = relevo.vtkGeographicVectors()
    vectors.SetInputConnection(terrain.GetOutputPort())
    vectors.SetTerrain(terrain)
    vectors.SetRasterData(make_wind(terrain, top))
    vectors.Update()
    mesh = vectors.GetOutput()
    speeds = add_speeds(mesh)
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMetric(relevo.vtkDistanceDepthTagMetric())
    recipe.SetMaximumLevel(3)
    recipe.SetDisplacement(terrain.GetDisplacement())
    mapper = relevo.vtkAdaptiveLICMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    mapper.SetNumberOfSteps(30)
    mapper.SetColorModeToMultiply()
    mapper.SetEnhanceContrastToLIC()
    mapper.SetMapModeBias(0.35)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Speed")
    fastest = float(numpy.nanpercentile(speeds, 99))  # ignores jets through gaps of one sample
    mapper.SetLookupTable(make_colours(fastest))
    mapper.InterpolateScalarsBeforeMappingOn()

    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.85)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.AddViewProp(make_legend(mapper.GetLookupTable()))
    renderer.SetBackground(0.65, 0.75, 0.88)
    for x, y, z, intensity in ((-1, 1, 0.8, 0.95), (1, -0.6, 0.9, 0.35)):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(x, y, z)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-0.35, -1, 0.75)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Dolly(1.9)
    camera.SetWindowCenter(-0.06, -0.12)
    renderer.ResetCameraClippingRange()
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.SetSize(800, 500)
    window.SetMultiSamples(4)
    window.AddRenderer(renderer)
    window.Render()
    print(f"{mapper.GetNumberOfDrawnTriangles()} triangles, wind up to {fastest:.1f} m/s")

    write_picture(picture, window)


if __name__ == "__main__":
    arguments = read_arguments()
    if len(arguments) not in (2, 3):
        sys.exit("usage: wind.py HEIGHTMAP PICTURE.png [LID]")
    main(*arguments)
