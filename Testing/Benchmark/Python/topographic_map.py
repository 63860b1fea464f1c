#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compare with PyVista's example of a topographic map: topographic_map.py FOLDER [SAMPLES]

Draws SAMPLES x SAMPLES heights (default: 4096) with an image in a plotter of PyVista, as its example
does and with relevo. FOLDER is for data and pictures. It prints a table of whole programs: seconds of
all processor cores, and the largest use of memory. It needs PyVista 0.48 or later, and a display or
VTK 9.4.
"""

from __future__ import annotations

import pathlib
import subprocess
import sys
from typing import Any

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkTIFFWriter

CELL = 30.0  # metres

# Each program adds its scene to a plotter.
SCENES = {
    "a sphere": ["plotter.add_mesh(pyvista.Sphere())"],
    "PyVista": [
        'surface = pyvista.read("heights.tif").warp_by_scalar()',
        "surface.texture_map_to_plane(inplace=True)",
        'plotter.add_mesh(surface, texture=pyvista.read_texture("image.tif"))',
    ],
    "relevo, first picture": ['plotter.relevo.add_terrain("heights.tif", imagery="image.tif")'],
    "relevo, later pictures": ['plotter.relevo.add_terrain("heights.tif", imagery="image.tif")'],
}

PROGRAM = """
import resource
import pyvista
plotter = pyvista.Plotter(off_screen=True, window_size=[640, 400])
{scene}
plotter.view_vector((0.4, -1.0, 0.9), viewup=(0, 0, 1))
plotter.screenshot("{name}.png")
used = resource.getrusage(resource.RUSAGE_SELF)
with open("/proc/self/status") as status:
    peak = next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
print(used.ru_utime + used.ru_stime, peak / 1024)
"""


def write(path: pathlib.Path, samples: Any) -> None:
    """Write an array whose row 0 is in the north as a TIFF file."""
    image = vtkImageData()
    image.SetDimensions(samples.shape[1], samples.shape[0], 1)
    image.SetSpacing(CELL, CELL, 1)
    components = samples.shape[2] if samples.ndim == 3 else 1
    scalars = numpy_to_vtk(samples[::-1].reshape(-1, components), deep=True)
    scalars.SetName("Heights")
    image.GetPointData().SetScalars(scalars)
    writer = vtkTIFFWriter()
    writer.SetCompressionToNoCompression()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    number = int(sys.argv[2]) if len(sys.argv) > 2 else 4096
    y, x = numpy.mgrid[0 : 1 : number * 1j, 0 : 1 : number * 1j].astype(numpy.float32)
    noise = numpy.random.default_rng(1).random(x.shape, numpy.float32)
    heights = 800 * numpy.sin(9 * x) * numpy.cos(7 * y) + 60 * numpy.sin(190 * x * y) + 5 * noise
    write(folder / "heights.tif", heights.astype(numpy.float32))
    colours = (127 + 120 * numpy.sin(30 * x), 127 + 100 * numpy.cos(20 * y), 90 + 0 * x)
    write(folder / "image.tif", numpy.stack(colours, axis=2).astype(numpy.uint8))
    for index in folder.glob("*.relevo-index"):
        index.unlink()
    print("| program | seconds | MiB |\n|---|---:|---:|")
    for name, scene in SCENES.items():
        code = PROGRAM.format(scene="\n".join(scene), name=name.replace(",", ""))
        run = subprocess.run(
            [sys.executable, "-c", code], cwd=folder, check=True, stdout=subprocess.PIPE, text=True
        )
        seconds, memory = map(float, run.stdout.split()[-2:])
        print(f"| {name} | {seconds:.1f} | {memory:.0f} |", flush=True)


if __name__ == "__main__":
    main()
