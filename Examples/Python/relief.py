# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw reliefs, which are pictures with depth, without a display: relief.py NAME PICTURE.png [FILE]

NAME is one of
  box      a mesh beside the reliefs of its six sides; FILE is bunny.ply or teapot.g
  methods  a height map by each method; FILE is mt_rainier_90m.tif
  camera   the points of a depth camera's image beside its relief; FILE is can.vtu
  holes    a view between two captures, red where neither has seen the surface; FILE is bunny.ply
Without FILE the script generates a mesh or height map.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from typing import Any

import relevo
from arguments import check_file, read_arguments
from figure import Figure, draw_mesh, get_mapper, make_actor
from meshes import add_normals, make_ring, read
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkRenderingImage import vtkDepthImageToPointCloud
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

RED = (0.85, 0.1, 0.1)


def read_mesh(filename: str | None) -> vtkPolyData:
    return add_normals(read(filename) if filename else make_ring(120, 48))


def draw_matt(mesh: vtkPolyData) -> vtkActor:
    actor = draw_mesh(mesh)
    actor.GetProperty().SetSpecular(0)  # highlights depend on the view, and captures keep theirs
    return actor


def draw_reliefs(reliefs: vtkDataObject, method: str = "Automatic") -> vtkActor:
    mapper = relevo.vtkReliefMapper()
    mapper.SetInputDataObject(reliefs)
    getattr(mapper, "SetMethodTo" + method)()
    return make_actor(mapper)


def set_lights(renderer: vtkRenderer, *directions: Sequence[float]) -> None:
    """Set scene lights, so that the colours are the same in all captures."""
    renderer.RemoveAllLights()
    for x, y, z, intensity in directions:
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(x, y, z)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


LAMPS = ((-0.5, 1, 1, 0.8), (1, 0.3, -0.2, 0.4), (0.2, -0.6, -1, 0.3), (-1, 0, -0.5, 0.3))


def open_window(
    *actors: vtkActor, size: tuple[int, int] = (600, 500)
) -> tuple[vtkRenderWindow, vtkRenderer]:
    """Return an off-screen window and its renderer to capture from."""
    renderer = vtkRenderer()
    for actor in actors:
        renderer.AddActor(actor)
    set_lights(renderer, *LAMPS)
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.SetSize(*size)
    window.SetMultiSamples(0)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    return window, renderer


def capture(
    renderer: vtkRenderer, resolution: int, cameras: Sequence[vtkCamera] = ()
) -> vtkMultiBlockDataSet:
    """Return captures from the six sides of a box, or by these cameras."""
    source = relevo.vtkReliefCapture()
    source.SetRenderer(renderer)
    source.SetResolution(resolution, resolution)
    for camera in cameras:
        source.AddCamera(camera)
    source.Update()
    return source.GetOutput()


def count_texels(reliefs: vtkMultiBlockDataSet) -> int:
    """Count the texels that have a surface."""
    count = 0
    images: list[Any] = [reliefs.GetBlock(i) for i in range(reliefs.GetNumberOfBlocks())]
    for image in images:
        depths = image.GetPointData().GetArray("Depth")
        count += sum(map(math.isfinite, (depths.GetValue(i) for i in range(depths.GetNumberOfValues()))))
    return count


def box(filename: str | None = None) -> Figure:
    """Draw a mesh beside its six reliefs, which keep the light of the captures."""
    mesh = read_mesh(filename)
    window, renderer = open_window(draw_matt(mesh))
    reliefs = capture(renderer, 512)
    figure = Figure(2, 1, (420, 380), (0.35, 0.45, 1), (0, 1, 0), 1.3)
    for label, actor in (
        (f"{mesh.GetNumberOfPolys():,} triangles", draw_matt(mesh)),
        (f"{count_texels(reliefs):,} texels of six reliefs", draw_reliefs(reliefs)),
    ):
        set_lights(figure.add(label, actor, bounds=mesh.GetBounds()), *LAMPS)
    return figure


def make_height_map() -> relevo.vtkHeightMap:
    """Return hills of 300 x 300 samples, with a lake without data."""
    image = vtkImageData()
    image.SetDimensions(300, 300, 1)
    heights = vtkFloatArray()
    for row in range(300):
        for column in range(300):
            x, y = column / 300, row / 300
            height = 30 * math.sin(9 * x) * math.cos(7 * y) + 12 * math.sin(31 * x + 17 * y)
            lake = (x - 0.35) ** 2 + (y - 0.4) ** 2 < 0.003
            heights.InsertNextValue(math.nan if lake else height)
    image.GetPointData().SetScalars(heights)
    result = relevo.vtkHeightMap()
    result.SetImageData(image)
    result.SetNoDataValue(math.nan)
    return result


def read_height_map(filename: str) -> relevo.vtkHeightMap:
    heights = relevo.vtkHeightMap()
    heights.SetFileName(check_file(filename))
    return heights


def methods(filename: str | None = None) -> Figure:
    """Draw a relief by three methods, lit with its normals."""
    source = relevo.vtkHeightMapToRelief()
    source.SetHeightMap(read_height_map(filename) if filename else make_height_map())
    source.SetExaggeration(2)
    source.Update()
    relief = source.GetOutput()
    figure = Figure(3, 1, (360, 300), (-0.4, -0.9, 0.6), (0, 0, 1), 1.25)
    for method, label in (
        ("RayMarch", "rays"),
        ("Refinement", "refinement"),
        ("Warp", "pre-warp"),
    ):
        actor = draw_reliefs(relief, method)
        get_mapper(actor).SetShadingToLit()
        set_lights(figure.add(label, actor, bounds=actor.GetBounds()), (-1, 0.2, 0.8, 2.0))
    return figure


def read_can(filename: str) -> vtkPolyData:
    """Return the surface of the deformed can."""
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(check_file(filename))
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(40)
    normals.Update()
    return normals.GetOutput()


def take_picture(window: vtkRenderWindow, kind: str) -> vtkImageData:
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    getattr(grab, "SetInputBufferTypeTo" + kind)()
    grab.Update()
    return grab.GetOutput()


def camera(filename: str | None = None) -> Figure:
    """Draw points and relief of a depth image, seen from 25 degrees beside the camera."""
    mesh = read_can(filename) if filename else read_mesh(None)
    window, renderer = open_window(draw_matt(mesh), size=(320, 280))
    view = renderer.GetActiveCamera()
    view.SetPosition(0.3, 0.9, 0.8)
    view.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    view.Zoom(1.3)
    renderer.ResetCameraClippingRange()
    set_lights(renderer, (*view.GetPosition(), 1.0))
    depths, colours = take_picture(window, "ZBuffer"), take_picture(window, "RGB")

    points = vtkDepthImageToPointCloud()
    points.SetInputData(0, depths)
    points.SetInputData(1, colours)
    points.SetCamera(view)
    points.Update()
    cloud = vtkPolyDataMapper()
    cloud.SetInputData(points.GetOutput())

    relief = relevo.vtkDepthImageToRelief()
    relief.SetInputData(0, depths)
    relief.SetInputData(1, colours)
    relief.SetCamera(view)
    relief.Update()

    figure = Figure(2, 1, (420, 340), (0, -1, 0), (0, 0, 1), 1.0)
    for label, actor in (
        ("points of the depths", make_actor(cloud)),
        ("relief", draw_reliefs(relief.GetOutput())),
    ):
        panel = figure.add(label, actor, bounds=actor.GetBounds())
        actor.GetProperty().LightingOff()
        panel.GetActiveCamera().DeepCopy(view)
        panel.GetActiveCamera().Azimuth(25)
        panel.ResetCameraClippingRange()
    return figure


def turn(camera: vtkCamera, degrees: float) -> vtkCamera:
    turned = vtkCamera()
    turned.DeepCopy(camera)
    turned.Azimuth(degrees)
    return turned


def holes(filename: str | None = None) -> Figure:
    """Draw a view 15 degrees beside two captures, with holes in red."""
    mesh = read_mesh(filename)
    window, renderer = open_window(draw_matt(mesh), size=(512, 512))
    view = renderer.GetActiveCamera()
    view.SetPosition(0.35, 0.45, 1)
    renderer.ResetCamera()
    view.Zoom(1.2)
    cameras = [turn(view, -15), turn(view, 15)]
    figure = Figure(3, 1, (340, 320), (0.35, 0.45, 1), (0, 1, 0), 1.2)
    figure.window.SetNumberOfLayers(2)
    for label, chosen in (
        ("seen from the left", cameras[:1]),
        ("seen from the right", cameras[1:]),
        ("both", cameras),
    ):
        behind = draw_matt(mesh)
        behind.GetProperty().SetColor(RED)
        behind.GetProperty().LightingOff()
        panel = figure.add(label, behind)
        front = vtkRenderer()
        front.SetViewport(panel.GetViewport())
        front.SetActiveCamera(panel.GetActiveCamera())
        front.SetLayer(1)
        front.AddActor(draw_reliefs(capture(renderer, 640, chosen)))
        figure.window.AddRenderer(front)
    return figure


FIGURES: tuple[Callable[..., Figure], ...] = (box, methods, camera, holes)


def main(name: str, picture: str, *files: str) -> None:
    for figure in FIGURES:
        if figure.__name__ == name and len(files) < 2:
            figure(*files).write(picture)
            return
    names = ", ".join(figure.__name__ for figure in FIGURES)
    sys.exit(f"usage: relief.py NAME PICTURE.png [FILE]; NAME is one of {names}")


arguments = read_arguments()
if len(arguments) < 2:
    main("", "")
main(*arguments)
