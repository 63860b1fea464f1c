# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw surfaces over coarse meshes, without a display: surfaces.py NAME PICTURE.png [MESH.ply]

NAME is one of
  surfaces     a ring of 168 triangles with each surface
  inflections  a wave, of which the mesh has crests and troughs, with linear and quadratic normals
  fur          procedural fur of two amplitudes and two frequencies on a mesh of 1500 triangles, or
               on MESH.ply, which is decimated to as many
  parts        curved PN triangles, displacement, and both
  relief       one procedural texture as height map and as picture
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable

import relevo
from arguments import read_arguments
from figure import Figure, draw_coarse, draw_refined, make_actor, show_edges
from heights import displace, make_image
from meshes import (
    add_normals,
    make_dome,
    make_grid,
    make_mapped_ring,
    make_ring,
    make_wave,
    read_decimated,
    set_point_array,
)
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPerlinNoise
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTexture

# GLSL for vtkProceduralSurface: ripples around the ring.
RIPPLES = """
float proceduralHeight(vec3 position, vec3 normal, vec3 weights)
{
  float angle = atan(position.y, position.x);
  float v = atan(position.z, length(position.xy) - 1.0);
  return sin(relevoFrequency * angle) * (0.5 + 0.5 * cos(v));
}
"""


def drape(actor: vtkActor, image: vtkImageData, interpolate: bool = True) -> None:
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetInterpolate(interpolate)
    texture.SetMipmap(interpolate)
    texture.RepeatOff()
    texture.EdgeClampOn()
    texture.SetColorModeToDirectScalars()
    actor.SetTexture(texture)
    actor.GetProperty().SetColor(1, 1, 1)


def make_fur(
    amplitude: float, frequency: float, base: relevo.vtkRefinementSurface | None = None
) -> relevo.vtkProceduralSurface:
    surface = relevo.vtkProceduralSurface()
    surface.SetBaseSurface(base)
    surface.SetAmplitude(amplitude)
    surface.SetFrequency(frequency)
    return surface


def surfaces() -> Figure:
    """Draw a ring with each surface."""
    around, across = 14, 6
    ring = add_normals(make_ring(around, across))
    # A crease along the ring's outer edge.
    sharp, along = [], []
    for i in range(ring.GetNumberOfPoints()):
        x, y, _ = ring.GetPoint(i)
        on_edge = i % across == 0
        sharp.append(float(on_edge))
        along.append((-y, x, 0.0) if on_edge else (0.0, 0.0, 0.0))
    set_point_array(ring, "Sharpness", sharp)
    set_point_array(ring, "Direction", along)
    ripples = make_fur(0.05, 28, relevo.vtkPNTriangleSurface())
    ripples.SetShaderFunction(RIPPLES)
    panels = (
        ("linear: 168 triangles", relevo.vtkLinearSurface()),
        ("curved PN triangles", relevo.vtkPNTriangleSurface()),
        ("Phong tessellation", relevo.vtkPhongSurface()),
        ("G1 patches", relevo.vtkG1Surface()),
        ("scalar tags: a crease", relevo.vtkScalarTaggedSurface()),
        ("fur", make_fur(0.15, 3)),
        ("your own GLSL, on PN", ripples),
    )
    figure = Figure(4, 2, (300, 210), (0, -1, 0.7), (0, 0, 1), 1.75)
    figure.add(panels[0][0], draw_coarse(ring))
    for label, surface in panels[1:]:
        figure.add(label, draw_refined(ring, surface, 4))
    bumps = make_image(
        96, 32, 1, VTK_FLOAT, lambda x, y: (math.sin(18 * math.pi * x) * math.sin(6 * math.pi * y),)
    )
    figure.add(
        "PN and a height map",
        draw_refined(make_mapped_ring(around, across), relevo.vtkPNTriangleSurface(), 5, displace(bumps, 0.05)),
    )
    return figure


def inflections() -> Figure:
    """Draw a wave. Linear normals miss the inflections between crests and troughs."""
    wave = make_wave()
    linear = relevo.vtkPNTriangleSurface()
    linear.QuadraticNormalsOff()
    figure = Figure(3, 1, (400, 230), (-0.2, -1, 1.2), (0, 0, 1), 1.55)
    figure.add("the mesh: crests and troughs", draw_coarse(wave))
    figure.add("PN, linear normals", draw_refined(wave, linear, 5))
    figure.add("PN, quadratic normals", draw_refined(wave, relevo.vtkPNTriangleSurface(), 5))
    return figure


def fur(filename: str | None = None) -> Figure:
    """Draw fur with amplitudes and frequencies of Lenz 2009, figures 5.11 to 5.13."""
    position, up = ((0.35, 0.3, 1), (0, 1, 0)) if filename else ((0, -1, 0.7), (0, 0, 1))
    mesh = read_decimated(filename, 1500) if filename else add_normals(make_ring(62, 12))
    figure = Figure(3, 2, (250, 220), position, up, 1.3 if filename else 1.7)
    figure.add(f"{mesh.GetNumberOfCells()} triangles", draw_coarse(mesh))
    for frequency in (1, 3):
        for amplitude in (0, 0.03, 0.08):
            if amplitude or frequency > 1:
                figure.add(
                    f"amplitude {amplitude}, frequency {frequency}" if amplitude else "amplitude 0",
                    draw_refined(mesh, make_fur(amplitude, frequency), 4),
                )
    return figure


def parts() -> Figure:
    """Draw the parts of Lenz 2009, figure 5.29."""
    dome = make_dome()
    values = (0.0, 1.0, 0.35, 0.7)

    def walls(x: float, y: float) -> tuple[float]:
        """Return one of four heights, from the border to the middle."""
        return (values[min(int(8 * min(x, y, 1 - x, 1 - y)), 3)],)

    heights = displace(make_image(24, 24, 1, VTK_FLOAT, walls), 0.22)
    figure = Figure(3, 2, (340, 270), (-0.45, -1, 0.75), (0, 0, 1), 1.15)
    figure.add("a: the mesh", draw_coarse(dome))
    edges = draw_refined(dome, relevo.vtkLinearSurface(), 4)
    show_edges(edges)
    figure.add("b: refined", edges)
    figure.add("c: PN triangles", draw_refined(dome, relevo.vtkPNTriangleSurface(), 6))
    figure.add("d: height map", draw_refined(dome, relevo.vtkLinearSurface(), 6, heights))
    figure.add("e: both", draw_refined(dome, relevo.vtkPNTriangleSurface(), 6, heights))
    square = vtkPolyDataMapper()
    square.SetInputData(make_grid(1, 1, lambda x, y: (x, y, 0)))
    picture = make_actor(square)
    picture.GetProperty().LightingOff()
    greys = make_image(24, 24, 3, VTK_UNSIGNED_CHAR, lambda x, y: 3 * (255 * walls(x, y)[0],))
    drape(picture, greys, interpolate=False)
    figure.add("f: the height map's four values", picture, (0, 0, 1), (0, 1, 0), 1.1)
    return figure


def relief() -> Figure:
    """Use one function for heights and colours, as in Lenz 2009, figure 5.34."""
    noise = vtkPerlinNoise()
    noise.SetFrequency(1, 1, 1)

    def height(x: float, y: float) -> float:
        """Return ridges of four octaves."""
        return sum(
            0.5**k * (1 - 2 * abs(noise.EvaluateFunction(9 * 2**k * x, 3 * 2**k * y, 7.3 * k)))
            for k in range(4)
        )

    def moss(x: float, y: float) -> tuple[float, ...]:
        """Return colours: dark between the ridges, green on them, pale on top."""
        t = max(0.0, min(1.0, 0.2 + 0.5 * height(x, y)))
        dark, green, pale = (52, 40, 28), (84, 122, 46), (206, 212, 142)
        low, high, s = (dark, green, 2 * t) if t < 0.5 else (green, pale, 2 * t - 1)
        return tuple(a + s * (b - a) for a, b in zip(low, high))

    ring = make_mapped_ring()
    size = (384, 128)
    heights = displace(make_image(*size, 1, VTK_FLOAT, lambda x, y: (height(x, y),)), 0.07)
    figure = Figure(2, 1, (450, 300), (0, -1, 0.7), (0, 0, 1), 1.7)
    figure.add(f"the mesh: {ring.GetNumberOfCells()} triangles", draw_coarse(ring))
    actor = draw_refined(ring, relevo.vtkPNTriangleSurface(), 6, heights)
    actor.GetProperty().SetSpecular(0)
    drape(actor, make_image(*size, 3, VTK_UNSIGNED_CHAR, moss))
    figure.add("heights and colours of one function", actor)
    return figure


DRAWN: tuple[Callable[..., Figure], ...] = (surfaces, inflections, fur, parts, relief)
FIGURES = {figure.__name__: figure for figure in DRAWN}


def main(name: str, picture: str, *mesh: str) -> None:
    print(FIGURES[name](*mesh).write(picture), "triangles")


arguments = read_arguments()
if (
    len(arguments) not in (2, 3)
    or arguments[0] not in FIGURES
    or (len(arguments) == 3 and arguments[0] != "fur")
):
    sys.exit("usage: surfaces.py NAME PICTURE.png [MESH.ply]; NAME is one of " + ", ".join(FIGURES))
main(*arguments)
