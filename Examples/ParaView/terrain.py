# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A raster of heights as terrain, with a photo over it.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/terrain.py [terrain.png [HEIGHTS PHOTO SCALE]]

Without files it makes hills, and a picture of them. SCALE is the factor from heights to texels.
"""

import os
import sys
import tempfile

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter


def write_png(path, values):
    """Rows x columns x components, the lowest row first."""
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, values.shape[2]), deep=1))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()
    return path


def make_hills(folder):
    """Two files: heights up to 1000, and their colours from meadows to snow."""
    x, y = numpy.meshgrid(*2 * [numpy.linspace(-3, 3, 512)])
    waves = [numpy.sin(f * (x * numpy.cos(f) + y * numpy.sin(f))) / f**1.5 for f in range(1, 14)]
    heights = numpy.interp(sum(waves), [-2, 2], [0, 1])[..., numpy.newaxis]
    meadow, rock, snow = numpy.array([[60, 110, 50], [120, 100, 80], [250, 250, 250]])
    share = numpy.clip(4 * heights - 1, 0, 2)
    colours = numpy.where(
        share < 1, meadow + share * (rock - meadow), rock + (share - 1) * (snow - rock)
    )
    return (
        write_png(os.path.join(folder, "heights.png"), (1000 * heights).astype(numpy.uint16)),
        write_png(os.path.join(folder, "photo.png"), colours.astype(numpy.uint8)),
    )


with tempfile.TemporaryDirectory() as folder:
    heights, photo = sys.argv[2:4] if len(sys.argv) > 4 else make_hills(folder)
    terrain = TerrainSource(FileName=heights, Resolution=64)
    view = CreateView("RenderView")
    view.ViewSize = [800, 450]
    view.OrientationAxesVisibility = 0
    shown = Show(terrain, view)
    shown.Representation = "Adaptive Refinement"
    shown.MaximumLevel = 6
    shown.Metric.ReferenceLength = 4
    shown.Displacement = "Height Map"
    shown.Displacement.HeightMapFileName = heights
    shown.Displacement.Scale = float(sys.argv[4]) if len(sys.argv) > 4 else 0.12
    shown.Displacement.AlongNormals = 0
    shown.Texture = CreateTexture(photo)
    shown.Texture.UpdateVTKObjects()  # ParaView 5.13 has not read it yet
    shown.ColorArrayName = ["POINTS", ""]
    view.CameraPosition = [0, -1.2, 0.8]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    view.GetActiveCamera().Zoom(1.6)
    path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "terrain.png")
    with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
        if not SaveScreenshot(os.path.join(part, "part.png"), view):
            sys.exit(f"cannot write {path!r}")
        os.replace(os.path.join(part, "part.png"), path)
