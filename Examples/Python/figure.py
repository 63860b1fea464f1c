# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw pictures of several labelled panels without a display, for the scripts in this folder."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import relevo
import vtkmodules.vtkRenderingFreeType  # draws the labels
from relevo.files import write_picture
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkTextActor,
    vtkVolume,
)

Vector = tuple[float, float, float]


def draw_mesh(mesh: vtkPolyData) -> vtkActor:
    """Draw the mesh with VTK's mapper."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    return make_actor(mapper)


def draw_coarse(mesh: vtkPolyData) -> vtkActor:
    """Draw the mesh with VTK's mapper, with flat shading and edges."""
    actor = draw_mesh(mesh)
    actor.GetProperty().SetInterpolationToFlat()
    show_edges(actor)
    return actor


def draw_refined(
    mesh: vtkPolyData,
    surface: relevo.vtkRefinementSurface,
    level: int,
    displacement: relevo.vtkDisplacement | None = None,
) -> vtkActor:
    """Draw the mesh with 2^level segments on every edge."""
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(level)
    recipe.SetSurface(surface)
    recipe.SetDisplacement(displacement)
    return draw_recipe(mesh, recipe)


def draw_recipe(mesh: vtkPolyData, recipe: relevo.vtkAdaptiveRefinement) -> vtkActor:
    mapper = relevo.vtkAdaptiveRefinementMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    mapper.ScalarVisibilityOff()
    return make_actor(mapper)


def make_actor(mapper: vtkMapper) -> vtkActor:
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(0.84, 0.78, 0.68)
    look.SetAmbient(0.1)
    look.SetDiffuse(0.8)
    look.SetSpecular(0.3)
    look.SetSpecularPower(30)
    look.SetInterpolationToPhong()
    return actor


def get_mapper(actor: vtkActor | vtkVolume) -> Any:
    """Return the mapper, whose class type checkers do not know."""
    return actor.GetMapper()


def show_edges(actor: vtkActor) -> None:
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.2, 0.2, 0.25)


class Figure:
    """Panels in rows, by default all seen from the same direction."""

    def __init__(
        self,
        columns: int,
        rows: int,
        size: tuple[int, int],
        position: Vector,
        up: Vector,
        zoom: float = 1.0,
    ) -> None:
        self.columns, self.rows = columns, rows
        self.position, self.up, self.zoom = position, up, zoom
        self.panels = 0
        self.labels: list[vtkTextActor] = []
        self.window = relevo.vtkEGLOffscreenRenderWindow()
        self.window.SetSize(columns * size[0], rows * size[1])
        self.window.SetMultiSamples(8)

    def add(
        self,
        label: str,
        actor: vtkActor | vtkVolume,
        position: Vector | None = None,
        up: Vector | None = None,
        zoom: float | None = None,
        bounds: Sequence[float] | None = None,
    ) -> vtkRenderer:
        """Add a panel, from left to right and from top to bottom, and return its renderer."""
        column, row = self.panels % self.columns, self.rows - 1 - self.panels // self.columns
        self.panels += 1
        renderer = vtkRenderer()
        renderer.SetViewport(
            column / self.columns,
            row / self.rows,
            (column + 1) / self.columns,
            (row + 1) / self.rows,
        )
        renderer.SetBackground(0.25, 0.27, 0.3)
        renderer.AddActor(actor)
        for x, y, z, intensity in ((-1, 1, 1, 0.9), (1, 0.2, 0.6, 0.3), (0.3, 1, -1, 0.25)):
            light = vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(x, y, z)
            light.SetIntensity(intensity)
            renderer.AddLight(light)
        text = vtkTextActor()
        text.SetInput(label)
        text.GetTextProperty().SetFontSize(15)
        text.SetPosition(9, 8)
        renderer.AddViewProp(text)
        self.labels.append(text)
        self.window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(position or self.position)
        camera.SetViewUp(up or self.up)
        renderer.ResetCamera(bounds or get_mapper(actor).GetInputDataObject(0, 0).GetBounds())
        camera.Dolly(zoom or self.zoom)
        camera.SetWindowCenter(0, -0.1)  # room for the label
        renderer.ResetCameraClippingRange()
        return renderer

    def write(self, filename: str) -> int:
        """Write the picture and return the number of triangles of all refined panels."""
        self.window.Render()
        write_picture(filename, self.window)
        triangles = 0
        for renderer in self.window.GetRenderers():
            for actor in renderer.GetActors():
                if actor.GetMapper().IsA("vtkAdaptiveRefinementMapper"):
                    triangles += actor.GetMapper().GetNumberOfDrawnTriangles()
        return triangles
