# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Animate streaks along vectors, without a display: flowloop.py PICTURE.gif [FRAMES]

The loop is seamless and has 16 frames by default. The flow runs around a ring, faster at the
outside, and across it where the ring is thin. The ring has curved PN triangles.
"""

from __future__ import annotations

import math
import sys

import relevo
from arguments import read_arguments
from gif import photograph, write_gif
from meshes import add_normals, make_ring, set_point_array
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkMapper,
    vtkRenderer,
    vtkRenderWindow,
)

AROUND, ACROSS = 30, 12
SIZE = (360, 230)
SECONDS = 0.06  # per frame
COLOURS = 64


def make_flow() -> vtkPolyData:
    """Return the ring with vectors at its points."""
    mesh = add_normals(make_ring(AROUND, ACROSS))
    points = [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]
    vectors = []
    for i, (x, y, z) in enumerate(points):
        ring, place = divmod(i, ACROSS)
        u = 2 * math.pi * ring / AROUND
        around = (-y, x, 0.4 * math.cos(2 * u))
        following = points[ring * ACROSS + (place + 1) % ACROSS]
        preceding = points[ring * ACROSS + (place - 1) % ACROSS]
        across = tuple(a - b for a, b in zip(following, preceding))
        share = math.cos(3 * u)  # 1 where the ring is thick, -1 where it is thin
        vectors.append(
            tuple((0.75 + 0.25 * share) * a + 2 * (0.5 - 0.5 * share) * b for a, b in zip(around, across))
        )
    set_point_array(mesh, "Flow", vectors)
    return mesh


def make_mapper(mesh: vtkPolyData) -> relevo.vtkAdaptiveLICMapper:
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetSurface(relevo.vtkPNTriangleSurface())
    recipe.SetMaximumLevel(4)
    mapper = relevo.vtkAdaptiveLICMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    mapper.SetInputArrayToProcess(0, 0, 0, 0, "Flow")  # the last 0: point data
    mapper.SetColorModeToMultiply()
    colours = vtkColorTransferFunction()
    for length, colour in ((0.7, (0.2, 0.4, 0.75)), (1.1, (0.75, 0.85, 0.85)), (1.5, (0.95, 0.6, 0.3))):
        colours.AddRGBPoint(length, *colour)
    colours.SetVectorModeToMagnitude()
    mapper.SetLookupTable(colours)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Flow")
    mapper.InterpolateScalarsBeforeMappingOn()
    return mapper


def show(mapper: vtkMapper) -> vtkRenderWindow:
    """Return a window that shows the mapper."""
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.1)
    actor.GetProperty().SetDiffuse(1)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(-0.4, 0.5, 1)
    # A bright light raises the contrast. SetEnhanceContrast() would stretch each frame differently
    # and flicker.
    light.SetIntensity(2.3)
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -1, 0.9)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Dolly(1.65)
    renderer.ResetCameraClippingRange()
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.SetSize(*SIZE)
    window.SetMultiSamples(4)
    window.AddRenderer(renderer)
    return window


def main(filename: str, frames: str = "16") -> None:
    mapper = make_mapper(make_flow())
    window = show(mapper)
    images = []
    for i in range(int(frames)):
        mapper.SetPhase(i / int(frames))
        images.append(photograph(window))
    write_gif(filename, images, SECONDS, COLOURS)
    print(f"{len(images)} frames, {mapper.GetNumberOfConvolutions()} convolutions")


arguments = read_arguments()
if len(arguments) not in (1, 2):
    sys.exit("usage: flowloop.py PICTURE.gif [FRAMES]")
main(*arguments)
