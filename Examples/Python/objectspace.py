# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compute streaks on a torus that is refined where its vectors turn: objectspace.py PICTURE.png

The script needs no display.
"""

from __future__ import annotations

import math
import sys

import relevo
from arguments import read_arguments
from figure import Figure, draw_recipe, get_mapper, make_actor
from meshes import make_grid, set_normals, set_point_array
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper, vtkTexture

AROUND, ACROSS, LEVEL = 48, 28, 3
PANEL = (360, 300)


def make_torus() -> vtkPolyData:
    """Return a torus of radii 1 and 0.5, with texture coordinates that have two seams."""

    def angles(x: float, y: float) -> tuple[float, float]:
        return 2 * math.pi * (x % 1), 2 * math.pi * (y % 1)

    def place(x: float, y: float) -> tuple[float, float, float]:
        u, v = angles(x, y)
        radius = 1 + 0.5 * math.cos(v)
        return radius * math.cos(u), radius * math.sin(u), 0.5 * math.sin(v)

    def normal(x: float, y: float) -> tuple[float, float, float]:
        u, v = angles(x, y)
        return math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v)

    torus = make_grid(AROUND, ACROSS, place)
    coordinates = torus.GetPointData().GetTCoords()
    set_normals(
        torus, [normal(*coordinates.GetTuple2(i)) for i in range(torus.GetNumberOfPoints())]
    )
    return torus


def swirl(x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return a vector along the torus, which turns through all directions in one region."""
    u, v = math.atan2(y, x), math.atan2(z, math.hypot(x, y) - 1)
    angle = 0.3 + 3 * math.exp(-(u * u + v * v) / 0.4) * math.sin(6 * v) * math.cos(6 * u)
    c, s = math.cos(angle), math.sin(angle)
    return (
        -c * math.sin(u) - s * math.sin(v) * math.cos(u),
        c * math.cos(u) - s * math.sin(v) * math.sin(u),
        s * math.cos(v),
    )


def add_vectors(mesh: vtkPolyData) -> vtkPolyData:
    set_point_array(
        mesh, "Velocity", [swirl(*mesh.GetPoint(i)) for i in range(mesh.GetNumberOfPoints())]
    )
    return mesh


def make_recipe(
    metric: relevo.vtkDepthTagMetric | None, level: int = LEVEL
) -> relevo.vtkAdaptiveRefinement:
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetSurface(relevo.vtkPNTriangleSurface())
    recipe.SetMaximumLevel(level)
    recipe.SetMetric(metric)
    recipe.GeomorphingOff()
    return recipe


def refine(
    mesh: vtkPolyData, recipe: relevo.vtkAdaptiveRefinement, camera: vtkCamera | None = None
) -> vtkPolyData:
    """Return the refined mesh, with the vectors evaluated at its new points."""
    refinement = relevo.vtkAdaptiveRefinementFilter()
    refinement.SetInputData(mesh)
    refinement.SetRefinement(recipe)
    refinement.SetCamera(camera)
    refinement.SetViewportSize(*PANEL)
    refinement.Update()
    return add_vectors(refinement.GetOutput())


def make_lic(
    mesh: vtkPolyData, texture_size: tuple[int, int] = (0, 0)
) -> relevo.vtkSurfaceLineIntegralConvolution:
    lic = relevo.vtkSurfaceLineIntegralConvolution()
    lic.SetInputData(mesh)
    lic.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Velocity")
    lic.SetGrainSize(0.05)
    lic.SetStepSize(0.02)
    lic.SetEnhanceContrastToLIC()
    lic.SetLowLICContrastEnhancementFactor(0.15)
    lic.SetHighLICContrastEnhancementFactor(0.15)
    lic.SetTextureSize(*texture_size)
    lic.Update()
    return lic


def make_grey_actor(mesh: vtkPolyData) -> vtkActor:
    """Return a white actor with its scalars in grey."""
    greys = vtkLookupTable()
    greys.SetSaturationRange(0, 0)
    greys.SetValueRange(0, 1)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetLookupTable(greys)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = make_actor(mapper)
    look = actor.GetProperty()
    look.SetColor(1, 1, 1)
    look.SetAmbient(0.35)
    look.SetDiffuse(0.65)
    look.SetSpecular(0)
    return actor


def draw(mesh: vtkPolyData) -> vtkActor:
    return make_grey_actor(make_lic(mesh).GetOutput())


def draw_texture(mesh: vtkPolyData) -> vtkActor:
    lic = make_lic(mesh, (768, 384))
    actor = make_grey_actor(lic.GetOutput())
    actor.GetMapper().ScalarVisibilityOff()
    texture = vtkTexture()
    texture.SetInputData(lic.GetOutputDataObject(1))
    texture.InterpolateOn()
    actor.SetTexture(texture)
    return actor


def draw_levels(mesh: vtkPolyData, recipe: relevo.vtkAdaptiveRefinement) -> vtkActor:
    actor = draw_recipe(mesh, recipe)
    get_mapper(actor).SetColorModeToLevel()
    return actor


def main(picture: str) -> None:
    torus = add_vectors(make_torus())
    variation = relevo.vtkFieldVariationDepthTagMetric()
    variation.SetArrayName("Velocity")
    variation.SetMaximumVariation(0.15)
    by_field = make_recipe(variation)
    adaptive, uniform = refine(torus, by_field), refine(torus, make_recipe(None, LEVEL - 1))

    figure = Figure(3, 2, PANEL, (1, -0.2, 0.3), (0, 0, 1), 1.75)
    near = 2.8
    figure.add(f"{torus.GetNumberOfCells()} triangles", draw(torus))
    figure.add("levels by the vectors' angles", draw_levels(torus, by_field))
    figure.add(f"{adaptive.GetNumberOfCells()} by the vectors' angles", draw(adaptive))
    figure.add(f"{uniform.GetNumberOfCells()} of one level", draw(uniform), zoom=near)
    camera = figure.add(
        f"{adaptive.GetNumberOfCells()} by the vectors' angles", draw(adaptive), zoom=near
    ).GetActiveCamera()
    figure.add(f"{torus.GetNumberOfCells()} with a texture", draw_texture(torus), zoom=near)
    figure.write(picture)

    # Refine what a close camera sees.
    region = relevo.vtkRegionDepthTagMetric()
    region.SetCenter(1.5, 0, 0)
    region.SetRadius(0.4)
    sides = relevo.vtkScreenEdgeDepthTagMetric()
    sides.SetReferenceLength(10)
    zoomed = relevo.vtkCompositeDepthTagMetric()
    for metric in (variation, region, sides):
        zoomed.AddMetric(metric)
    in_region = make_lic(refine(torus, make_recipe(zoomed), camera)).GetOutput()
    print(
        f"{torus.GetNumberOfCells()} triangles, {adaptive.GetNumberOfCells()} by the vectors, "
        f"{in_region.GetNumberOfCells()} with a region of interest and sides of 10 pixels"
    )


arguments = read_arguments()
if len(arguments) != 1:
    sys.exit("usage: objectspace.py PICTURE.png")
main(*arguments)
