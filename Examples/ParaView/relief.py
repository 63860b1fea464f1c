# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A view that moves: a still frame, reliefs in place of the data, and ParaView's level of detail.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/relief.py [relief.png [MESH]]

The mesh is any file of a surface that ParaView opens. Without one, it is a set of isosurfaces.
"""

import os
import sys
import tempfile

from paraview.simple import *
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

if len(sys.argv) > 2:
    mesh = OpenDataFile(sys.argv[2])
else:
    wavelet = Wavelet(WholeExtent=[-30, 30, -30, 30, -30, 30])
    wavelet.XFreq, wavelet.YFreq, wavelet.ZFreq = 24, 20, 18
    mesh = Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])
mesh.UpdatePipeline()
low, high = mesh.GetDataInformation().GetBounds()[4:]

view = CreateView("RenderView")
view.ViewSize = [300, 300]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.96, 0.97, 0.98]
height = Elevation(Input=mesh, LowPoint=[0, 0, low], HighPoint=[0, 0, high])
shown = Show(height, view)
ColorBy(shown, ("POINTS", "Elevation"))
later = GetParaViewVersion().major >= 6
shown.LookupTable.ApplyPreset("Viridis" if later else "Viridis (matplotlib)", True)
shown.SetScalarBarVisibility(view, False)
Render(view)
ResetCamera(view)
view.GetActiveCamera().Elevation(25)
view.GetActiveCamera().Zoom(1.4)


def grab():
    """The latest frame of the view."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(view.GetRenderWindow())
    grabber.ShouldRerenderOff()
    grabber.ReadFrontBufferOff()
    grabber.Update()
    return grabber.GetOutput()


def move(degrees):
    """An interactive frame, like those while a user drags the mouse."""
    view.GetActiveCamera().Azimuth(degrees)
    view.SMProxy.InteractiveRender()


view.ShowReliefsWhileMoving = 1
Render(view)
frames = [grab()]
move(1)
move(3)
frames.append(grab())
view.ShowReliefsWhileMoving = 0
view.LODThreshold = 0.0
Render(view)
move(0)
frames.append(grab())

row = vtkImageAppend()
for frame in frames:
    row.AddInputData(frame)
writer = vtkPNGWriter()
writer.SetInputConnection(row.GetOutputPort())
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "relief.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    writer.SetFileName(os.path.join(part, "part.png"))
    writer.Write()
    os.replace(os.path.join(part, "part.png"), path)
