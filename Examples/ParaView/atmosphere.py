# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain, and the air above it as a volume in the same coordinates.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/atmosphere.py [atmosphere.png [RASTER]]

RASTER is a height raster with coordinates in metres, such as those of UTM. Without one, the script
makes hills. The volume is a plume above the highest point; replace it by your data.
"""

import os
import sys
import tempfile

import numpy
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter


def write_hills(path):
    """A raster of 16 bits without a georeference: its coordinates are columns and rows."""
    x, y = numpy.meshgrid(*2 * [numpy.linspace(-3, 3, 512)])
    waves = sum(numpy.sin(f * (x * numpy.cos(f) + y * numpy.sin(f))) / f**1.4 for f in range(1, 14))
    heights = 20 * numpy.clip(waves + 2, 0, None) + 80 * numpy.exp(-(x**2) - y**2)
    image = vtkImageData()
    image.SetDimensions(512, 512, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(heights.astype(numpy.uint16).ravel(), deep=1))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()
    return path


def write_plume(path, bounds, vent):
    """Values from 0 to 1 on a grid above the terrain, in the coordinates of the raster."""
    size = 64
    low = numpy.array([bounds[0], bounds[2], vent[2]])
    width = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    spacing = numpy.array([bounds[1] - bounds[0], bounds[3] - bounds[2], 0.3 * width]) / (size - 1)
    z, y, x = numpy.mgrid[:size, :size, :size] * spacing[::-1].reshape(3, 1, 1, 1) / width
    x, y = x - (vent[0] - low[0]) / width, y - (vent[1] - low[1]) / width
    drift = 1.2 * z**1.5  # to the east
    radius = 0.008 + 0.22 * z
    distance = numpy.hypot(x - drift, y) / radius
    puffs = 1 + 0.4 * numpy.sin(9 * distance + 90 * z) * numpy.cos(70 * y)
    density = numpy.exp(-(distance**2) * puffs) * numpy.clip(1 - z / 0.3, 0, 1)
    image = vtkImageData()
    image.SetOrigin(low)
    image.SetSpacing(spacing)
    image.SetDimensions(size, size, size)
    array = numpy_to_vtk(density.ravel(), deep=1)
    array.SetName("density")
    image.GetPointData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()
    return path


with tempfile.TemporaryDirectory() as folder:
    raster = sys.argv[2] if len(sys.argv) > 2 else write_hills(os.path.join(folder, "hills.png"))
    terrain = TerrainReader(FileName=os.path.abspath(raster), Coordinates="Raster")
    mesh = servermanager.Fetch(terrain)  # small, whatever the size of the raster
    heights = vtk_to_numpy(mesh.GetPointData().GetArray("Height"))
    vent = mesh.GetPoint(int(numpy.nanargmax(heights)))
    plume = OpenDataFile(write_plume(os.path.join(folder, "plume.vti"), mesh.GetBounds(), vent))

    view = CreateView("RenderView")
    view.ViewSize = [800, 450]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.82, 0.88, 0.94]

    shown = Show(terrain, view)
    ColorBy(shown, ("POINTS", "Height"))
    low, high = float(numpy.nanmin(heights)), float(numpy.nanmax(heights))
    nodes = ((0, 0.25, 0.42, 0.25), (0.3, 0.55, 0.6, 0.35), (0.6, 0.6, 0.5, 0.42), (1, 1, 1, 1))
    shown.LookupTable.RGBPoints = [
        number for s, *color in nodes for number in (low + s * (high - low), *color)
    ]
    shown.ContourInterval = (high - low) / 12
    shown.ContourColor = [0.3, 0.25, 0.2]
    shown.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(shown.LookupTable, view)
    unit = mesh.GetFieldData().GetAbstractArray("HeightUnit").GetValue(0)
    bar.Title = f"Height [{unit}]" if unit else "Height"
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]

    air = Show(plume, view)
    air.Representation = "Adaptive Volume"
    ColorBy(air, ("POINTS", "density"))
    air.LookupTable.RGBPoints = [0, 1, 1, 1, 1, 0.35, 0.33, 0.33]
    air.ScalarOpacityFunction.Points = [0, 0, 0.5, 0, 0.05, 0, 0.5, 0, 1, 0.9, 0.5, 0]

    view.CameraFocalPoint = vent
    view.CameraPosition = [vent[0] + 0.2, vent[1] - 1, vent[2] + 0.45]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    view.GetActiveCamera().Zoom(1.9)
    path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "atmosphere.png")
    with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
        if not SaveScreenshot(os.path.join(part, "part.png"), view):
            sys.exit(f"cannot write {path!r}")
        os.replace(os.path.join(part, "part.png"), path)
