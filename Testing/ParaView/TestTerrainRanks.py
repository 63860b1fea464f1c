# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: several ranks draw a terrain like one, and each draws a share. The first run,
on one rank, writes the pictures to a file:

mpirun -n RANKS pvbatch TestTerrainRanks.py FILE.npz"""

import os
import sys
import tempfile

import numpy
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule

import RelevoParaView as relevo

SIZE = 1025  # several tiles
NEAR = {"CameraPosition": [-150, -560, 190], "CameraFocalPoint": [0, -200, 20]}
FAR = {"CameraPosition": [300, -1500, 1100], "CameraFocalPoint": [0, 0, 0]}
TRANSLUCENT = 20  # of 60 000 pixels, because ParaView blends with 8 bits


def write_mountains(path):
    row, column = numpy.mgrid[:SIZE, :SIZE] / (SIZE - 1)
    heights = numpy.full((SIZE, SIZE), 60.0)
    for f in range(1, 40):
        phase = f * (column * numpy.cos(f) + row * numpy.sin(f))
        heights += 40 * numpy.sin(5 * phase + f) / f**1.2
    relevo.write_png(path, numpy.clip(heights, 0, None).astype(numpy.uint16))


class Scene:
    """A view of a terrain whose settings change from picture to picture."""

    def __init__(self, raster):
        self.view = relevo.view((300, 200))
        self.view.CameraViewUp = [0, 0, 1]
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [1, 0, 1]
        self.source = simple.TerrainReader(FileName=raster)
        self.shown = relevo.show(self.source, self.view, "Terrain", InteractiveScreenSpaceError=1)
        simple.ColorBy(self.shown, ("POINTS", "Height"))
        self.shown.LookupTable.RGBPoints = [0, 0, 0, 1, 60, 0, 1, 0, 200, 1, 0, 0]
        self.pictures, self.counts = {}, {}

    def add(self, name, camera, offset=0, **properties):
        for each, value in camera.items():
            setattr(self.view, each, list(numpy.add(value, [offset, offset, 0])))
        before = {each: getattr(self.shown, each) for each in properties}
        relevo.set_properties(self.shown, properties)
        self.pictures[name] = relevo.picture(self.view)
        self.counts[name] = relevo.statistic(self.view, "NumberOfDrawnTriangles")
        relevo.set_properties(self.shown, before)


def draw_all(raster):
    scene = Scene(raster)
    scene.add("near", NEAR, ContourInterval=10)
    scene.add("far", FAR, Ambient=1, Diffuse=0)
    scene.add("fine", NEAR, ScreenSpaceError=0.1, Exaggeration=2, TerrainColorMode="Hillshade")
    scene.add("base", FAR, UseBase=1, BaseHeight=-100)
    scene.add("translucent", FAR, Opacity=0.5)
    # Triangles that do not fit into memory are coarser, but there are no cracks.
    top = {"CameraPosition": [0, -1, 700], "CameraFocalPoint": [0, 0, 0]}
    scene.add("little memory", top, MemoryLimit=2**22, ScreenSpaceError=0.05)
    scene.source.Coordinates = "Raster"
    scene.add("raster", NEAR, SIZE / 2)
    scene.source.Coordinates = "Centered"
    simple.Hide(scene.source, scene.view)  # counts are those of the last actor
    simple.Show(scene.source, scene.view)
    sphere = simple.Sphere(Center=[0, -100, 60], Radius=120)
    relevo.show(sphere, scene.view, "Surface", Opacity=0.4)
    scene.shown.Opacity = 0.6
    scene.view.CameraPosition, scene.view.CameraFocalPoint = FAR.values()
    scene.pictures["translucent sphere"] = relevo.picture(scene.view)
    relevo.clear()
    return scene.pictures, scene.counts


def open_on_first_rank(raster):
    """A file that only the first rank has open: one error, which names a rank."""
    number = 777
    with open(raster, "rb") as file:
        os.dup2(file.fileno(), number)
    source = simple.TerrainReader(FileName=f"/proc/self/fd/{number}")
    with relevo.messages() as text:
        source.UpdatePipeline()
    os.close(number)
    relevo.clear()
    return text()


def main(path):
    with tempfile.TemporaryDirectory() as folder:
        raster = os.path.join(folder, "mountains.png")
        write_mountains(raster)
        pictures, counts = draw_all(raster)
        message = open_on_first_rank(raster)
    limited = pictures.pop("little memory")
    failed = int((limited == (255, 0, 255)).all(axis=2).sum())
    print("holes with little memory:", failed, flush=True)
    limits = {name: TRANSLUCENT if "translucent" in name else 2 for name in pictures}
    failed += relevo.compare_with_one_rank(path, pictures, limits)
    ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    if ranks == 1:
        numpy.savez(path + ".counts.npz", **counts)
        return failed + (message != "")
    print(message, flush=True)
    failed += message.count("On rank 1, but not on all: ") != 1 or message.count("ERROR:") != 1
    expected = numpy.load(path + ".counts.npz")
    for name in ("near", "far", "fine", "raster"):
        share = counts[name] / int(expected[name])
        print(f"{ranks} ranks, {name}: rank 0 draws {share:.2f}", flush=True)
        failed += not 0.3 / ranks < share < 1.7 / ranks
    return failed


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
