# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the plugin for ParaView; run.sh beside this file says in which order.

    [mpirun -n RANKS] pvbatch plugin.py ranks FILE.npz
    pvbatch plugin.py raster write|Relevo|ParaView FILE.png

Prints rows of Markdown tables.
"""

import resource
import statistics
import sys
import time

import numpy
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule

import RelevoParaView as relevo

RANKS = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
SURFACE = "Surface"
REFINED = "Adaptive Refinement"


def median_ms(actions, frames=5):
    """Of actions that are done in turn; the first round does not count."""
    times = {name: [] for name in actions}
    for frame in range(frames + 1):
        for name, action in actions.items():
            start = time.perf_counter()
            action(frame)
            times[name].append(1000 * (time.perf_counter() - start))
    return {name: statistics.median(values[1:]) for name, values in times.items()}


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def look_from(view, position):
    view.CameraPosition = position
    view.CameraFocalPoint = [0, 0, 0]


def ranks(path):
    """Pictures against those of one rank, and frames while the camera moves."""
    wavelet = simple.Wavelet(WholeExtent=[-60, 60, -60, 60, -60, 60])
    contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])
    curved = {"MaximumLevel": 3, "Surface": "PN Triangles"}
    looks = {
        "Surface": (SURFACE, {}),
        "Surface, translucent": (SURFACE, {"Opacity": 0.5}),
        "Refined": (REFINED, curved),
        "Refined, translucent": (REFINED, {**curved, "Opacity": 0.5}),
        "Level 0": (REFINED, {"MaximumLevel": 0, "Metric": "None"}),
    }
    pictures, times = {}, {}
    for name, (representation, properties) in looks.items():
        view = relevo.view((1280, 800))
        view.UseFXAA = 0
        relevo.show(contour, view, representation, **properties)
        simple.Render(view)  # the first frame of a session moves the camera
        look_from(view, [120, 90, 180])
        pictures[name] = relevo.picture(view)

        def move(frame, view=view):
            look_from(view, [120 + frame, 90, 180])
            simple.Render(view)

        times.update(median_ms({name: move}))
        simple.Delete(view)
    faces = contour.GetDataInformation().GetNumberOfCells()
    if RANKS == 1:
        numpy.savez(path, **pictures)
    expected = numpy.load(path)
    for name, drawn in pictures.items():
        differing = relevo.differing(drawn, expected[name])
        row(RANKS, f"{name}, {faces} faces", differing, f"{times[name]:.0f} ms")


def raster(way, path):
    """From a file of 4096 x 4096 heights, which `raster write` makes, to the first picture."""
    if way == "write":
        relevo.write_heights(path, 4097)
        return
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.perf_counter()
    view = relevo.view((800, 600))
    if way == "Relevo":
        terrain = simple.TerrainSource(FileName=path, Resolution=64)
        shown = relevo.show(terrain, view, MaximumLevel=6, Displacement="Height Map")
        shown.Displacement.HeightMapFileName = path
        shown.Displacement.AlongNormals = 0
    else:
        image = simple.PNGSeriesReader(FileNames=[path])
        warped = simple.WarpByScalar(Input=image, Scalars=["POINTS", "PNGImage"])
        surface = simple.ExtractSurface(Input=warped)
        relevo.show(simple.GenerateSurfaceNormals(Input=surface), view, SURFACE)
    simple.ResetCamera(view)
    simple.Render(view)
    seconds = time.perf_counter() - start
    more = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    row(way, f"{seconds:.1f} s", f"{more / 2**20:.2f} GiB")


if __name__ == "__main__":
    globals()[sys.argv[1]](*sys.argv[2:])
