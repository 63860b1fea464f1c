# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks show what one shows. The first run, on one rank, writes the pictures to a file:

mpirun -n RANKS pvbatch TestRanks.py FILE.npz
"""

import sys

from paraview import simple

import RelevoParaView as relevo

# Pixels of 60000 that may differ.
CASES = {
    "Level 0": (10, {"MaximumLevel": 0, "Metric": "None"}),
    "Level 2": (10, {"MaximumLevel": 2, "Metric": "None"}),
    "PN Triangles": (10, {"MaximumLevel": 2, "Metric": "None", "Surface": "PN Triangles"}),
    "Curvature": (10, {"MaximumLevel": 4, "Metric": "Curvature", "Geomorphing": "Off"}),
    "Screen": (10, {"MaximumLevel": 4, "Geomorphing": "Off", "Surface": "PN Triangles"}),
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
    limits = {name: most for name, (most, _) in CASES.items()}
    return relevo.compare_with_one_rank(path, draw_all(), limits)


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # else pvbatch ends MPI
        sys.exit(status)
