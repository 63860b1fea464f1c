# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: several ranks blend translucent surfaces like one. The first run, on one
rank, writes the pictures to a file:

mpirun -n RANKS pvbatch TestTranslucent.py FILE.npz"""

import os
import sys
import tempfile

from paraview import simple

import RelevoParaView as relevo

NONE = {"MaximumLevel": 2, "Metric": "None"}
PN = {"Surface": "PN Triangles", **NONE}
CAMERA = {"CameraPosition": [2, 1.5, 2.5], "CameraFocalPoint": [0, 0, 0], "CameraViewUp": [0, 1, 0]}


def draw(view, *shown, changes=()):
    """Shows (source, representation, opacity, properties), then changes the last one."""
    representations = []
    for source, style, opacity, properties in shown:
        last = relevo.show(source, view, style, Opacity=opacity)
        representations.append(last)
        for name, value in properties.items():
            target, _, setting = name.rpartition(".")
            relevo.set_properties(getattr(last, target) if target else last, {setting: value})
    for name, value in changes:
        relevo.picture(view)
        setattr(last, name, value)
    result = relevo.picture(view)
    for each in representations:
        simple.Delete(each)
    return result


def refined(source, opacity=0.5, **properties):
    return source, "Adaptive Refinement", opacity, properties


def offset(distance, **properties):
    return {"Displacement": "Height Map", "Displacement.Offset": distance, **properties}


def draw_all(raster):
    ball = relevo.sphere()
    wavelet = simple.Wavelet(WholeExtent=[-6, 6] * 3)
    waves = simple.Transform(
        Input=simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[200])
    )
    waves.Transform.Scale = [0.1] * 3
    plane = simple.Plane(Origin=[0, -0.5, -0.5], Point1=[0, 0.5, -0.5], Point2=[0, -0.5, 0.5])
    plane.XResolution = plane.YResolution = 4  # flat, and on the first rank only
    blocks = simple.GroupDatasets(Input=[ball, plane])
    hill = {"Displacement.HeightMapFileName": raster, "Displacement.Scale": 0.06}
    curvature = {"Metric.MinimumCurvature": 0.1, "Metric.MaximumCurvature": 5, "Geomorphing": "Off"}
    moved = {"Position": [0.3, 0.1, 0], "Scale": [1, 2, 1], "Orientation": [20, 30, 40]}
    surface = ball, "Surface", 0.5, {}
    cases = {
        "Surface": [(waves, "Surface", 0.5, {})],
        "Curvature": [refined(waves, **{**PN, "Metric": "Curvature", **curvature})],
        "Offset": [refined(ball, **PN, **offset(0.4))],
        "Raster": [refined(plane, **NONE, **offset(0.5), **hill)],
        "Two": [refined(ball, **PN, **moved), refined(waves, **PN)],
        "Beside Surface": [surface, refined(waves, **PN)],
        "Opaque": [surface, refined(waves, opacity=1, **PN)],
        "Blocks": [refined(blocks, **PN, **offset(0.2))],
    }
    changes = [("Opacity", 1), ("Opacity", 0.4), ("Visibility", 0), ("Visibility", 1)]
    view = relevo.view((200, 150))
    view.UseFXAA = 0  # it would blur edges before ranks are blended with the background
    draw(view, surface)  # ParaView moves the camera in the first frame of a session
    relevo.set_properties(view, CAMERA)
    pictures = {name: draw(view, *shown) for name, shown in cases.items()}
    pictures["Changes"] = draw(view, refined(ball, **PN), changes=changes)
    return pictures


def main(path):
    with tempfile.TemporaryDirectory() as folder:
        raster = os.path.join(folder, "heights.png")
        relevo.write_heights(raster)
        pictures = draw_all(raster)
    # ParaView blends ranks with 8 bits.
    return relevo.compare_with_one_rank(path, pictures, dict.fromkeys(pictures, 20))


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
