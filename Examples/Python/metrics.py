# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Show what a metric refines, without a display: metrics.py METRIC PICTURE.png [MESH.ply]

The colours are levels. An edge of level d has 2^d segments. Without MESH.ply the surface is a ring
of 720 triangles.
"""

from __future__ import annotations

import math
import sys

import relevo
from arguments import read_arguments
from meshes import add_normals, make_ring, read
from relevo.files import write_picture
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer


def distance(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine what is near."""
    metric = relevo.vtkDistanceDepthTagMetric()
    metric.SetMaximumDistance(2 * mesh.GetLength())
    return metric


def screen_edge(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine to segments of eight pixels."""
    metric = relevo.vtkScreenEdgeDepthTagMetric()
    metric.SetReferenceLength(8)
    return metric


def curvature(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine where the surface curves."""
    metric = relevo.vtkCurvatureDepthTagMetric()
    metric.SetCurvatureTypeToMean()
    return metric


def silhouette(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine near the silhouette, by point normals."""
    return relevo.vtkSilhouetteDepthTagMetric()


def contour(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine the contour, by the two faces of each edge."""
    metric = relevo.vtkSilhouetteDepthTagMetric()
    metric.SetCriterionToContour()
    return metric


def view_dependent(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine where the surface curves, more where it is seen edge-on."""
    metric = relevo.vtkViewDependentDepthTagMetric()
    metric.SetMaximumSpread(20)
    metric.SetEdgeOnWeight(0.8)
    return metric


def field_variation(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine where an array varies, here waves around a point."""
    waves = vtkFloatArray()
    waves.SetName("Waves")
    for i in range(mesh.GetNumberOfPoints()):
        x, y, _ = mesh.GetPoint(i)
        waves.InsertNextValue(math.sin(16 * math.hypot(x, y) / mesh.GetLength()))
    mesh.GetPointData().AddArray(waves)
    metric = relevo.vtkFieldVariationDepthTagMetric()
    metric.SetArrayName("Waves")
    return metric


def region(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine around a point."""
    metric = relevo.vtkRegionDepthTagMetric()
    metric.SetCenter(mesh.GetPoint(0))
    metric.SetRadius(0.1 * mesh.GetLength())
    metric.SetFallOff(0.2 * mesh.GetLength())
    return metric


def composite(mesh: vtkPolyData) -> relevo.vtkDepthTagMetric:
    """Refine to the highest level of two metrics."""
    metric = relevo.vtkCompositeDepthTagMetric()
    metric.AddMetric(contour(mesh))
    metric.AddMetric(region(mesh))
    return metric


METRICS = {
    metric.__name__.replace("_", "-"): metric
    for metric in (
        distance,
        screen_edge,
        curvature,
        silhouette,
        contour,
        view_dependent,
        field_variation,
        region,
        composite,
    )
}


def main(name: str, picture: str, filename: str | None = None) -> None:
    mesh = add_normals(read(filename) if filename else make_ring())

    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(3)
    recipe.SetMetric(METRICS[name](mesh))
    recipe.SetLevelRuleToPerEdge()
    recipe.GeomorphingOff()  # a still picture needs no morphing
    recipe.SetSurface(relevo.vtkPNTriangleSurface())
    mapper = relevo.vtkAdaptiveRefinementMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    mapper.SetColorModeToLevel()

    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.2)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.2, 0.2, 0.25)
    legend = vtkScalarBarActor()
    legend.SetLookupTable(mapper.GetLevelLookupTable())
    legend.SetTextPositionToPrecedeScalarBar()
    legend.SetPosition(0.82, 0.3)
    legend.SetWidth(0.1)
    legend.SetHeight(0.4)
    legend.SetBarRatio(0.3)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.AddViewProp(legend)
    renderer.SetBackground(0.25, 0.27, 0.3)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -1, 0.6)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Dolly(1.75)
    renderer.ResetCameraClippingRange()
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.SetSize(420, 270)
    window.SetMultiSamples(8)
    window.AddRenderer(renderer)
    window.Render()
    print(mesh.GetNumberOfCells(), "faces,", mapper.GetNumberOfDrawnTriangles(), "triangles")

    write_picture(picture, window)


arguments = read_arguments()
if len(arguments) not in (2, 3) or arguments[0] not in METRICS:
    sys.exit("usage: metrics.py METRIC PICTURE.png [MESH.ply]; METRIC is one of " + ", ".join(METRICS))
main(*arguments)
