# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks show what one shows. The first run, on one rank, writes the pictures to a file:

mpirun -n RANKS pvbatch TestRanks.py FILE.npz
"""

import sys

import numpy
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule

import RelevoParaView as relevo

RANKS = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
# Pixels of 60000 that may differ; ParaView's own Surface differs, too, where ranks are blended.
CASES = {
    "Level 0": (10, {"MaximumLevel": 0, "Metric": "None"}),
    "Level 2": (10, {"MaximumLevel": 2, "Metric": "None"}),
    "PN Triangles": (10, {"MaximumLevel": 2, "Metric": "None", "Surface": "PN Triangles"}),
    "Curvature": (10, {"MaximumLevel": 4, "Metric": "Curvature", "Geomorphing": "Off"}),
    "Screen": (10, {"MaximumLevel": 4, "Geomorphing": "Off", "Surface": "PN Triangles"}),
    "Opacity": (100, {"MaximumLevel": 2, "Metric": "None", "Opacity": 0.5}),
}


def draw_all():
    wavelet = simple.Wavelet()
    surface = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])
    pictures = {}
    for name, (_, properties) in CASES.items():
        view = relevo.view()
        shown = relevo.show(surface, view, **properties)
        if name == "Curvature":
            # Quantiles are those of a rank's own faces.
            shown.Metric.MinimumCurvature = 0.01
            shown.Metric.MaximumCurvature = 0.5
        view.CameraPosition = [25, 20, 40]
        view.CameraFocalPoint = [0, 0, 0]
        relevo.picture(view)  # the first frame of a session moves the camera
        view.CameraPosition = [25, 20, 40]
        view.CameraFocalPoint = [0, 0, 0]
        pictures[name] = relevo.picture(view)
        simple.Delete(view)
    return pictures


def main(path):
    pictures = draw_all()
    if RANKS == 1:
        numpy.savez(path, **pictures)
        return 0 if all(relevo.foreground(each) > 1000 for each in pictures.values()) else 1
    failed = 0
    expected = numpy.load(path)
    for name, (most, _) in CASES.items():
        different = relevo.differing(pictures[name], expected[name])
        print(f"{RANKS} ranks, {name}: {different} pixels differ", flush=True)
        failed += different > most
    return failed


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # else pvbatch ends MPI
        sys.exit(status)
