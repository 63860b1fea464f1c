# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# script-version: 2.0
"""A Catalyst script. In each step of a simulation it draws the field as Adaptive Volume, with an
isosurface inside it as Adaptive Refinement, and saves step_000000.png and so on. This runs it in a
simulation that is part of ParaView:

    . build-paraview/env.sh
    mpirun -n 4 pvbatch --sym -m paraview.demos.wavelet_miniapp --timesteps 5 --size 21 \
      --script Examples/ParaView/catalyst.py

The simulation passes its data in the channel "input", with the point array RTData. Without a
simulation, `pvbatch catalyst.py` draws one step of a test source.
"""

from paraview import catalyst
from paraview.simple import *

# In a simulation, ParaView replaces a source with this name by the data of the channel.
data = Wavelet(registrationName="input")
surface = Contour(Input=data, ContourBy=["POINTS", "RTData"], Isosurfaces=[190], ComputeNormals=0)

view = CreateView("RenderView")
view.OrientationAxesVisibility = 0
view.UseFXAA = 0  # FXAA would make the picture depend on the number of ranks
view.UseColorPaletteForBackground = 0
view.Background = [0.96, 0.97, 0.98]
view.CameraPosition = [38, -30, 24]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]

# The ranges are fixed, so that a colour means the same in all steps.
volume = Show(data, view)
volume.Representation = "Adaptive Volume"
ColorBy(volume, ("POINTS", "RTData"))
volume.LookupTable.ApplyPreset("Turbo", True)
volume.LookupTable.RescaleTransferFunction(40, 340)
# Values, opacities, midpoints and sharpness.
volume.ScalarOpacityFunction.Points = [40, 0, 0.5, 0, 150, 0.1, 0.5, 0, 340, 0.3, 0.5, 0]
volume.ScalarOpacityUnitDistance = 2

refined = Show(surface, view)
refined.Representation = "Adaptive Refinement"
refined.Surface = "PN Triangles"
refined.Metric.ReferenceLength = 4
ColorBy(refined, None)
refined.DiffuseColor = [0.9, 0.9, 0.9]

png = CreateExtractor("PNG", view, registrationName="PNG")
png.Writer.FileName = "step_{timestep:06d}{camera}.png"
png.Writer.ImageResolution = [600, 400]

options = catalyst.Options()
options.ExtractsOutputDirectory = "."

if __name__ == "__main__":
    SaveExtractsUsingCatalystOptions(options)
