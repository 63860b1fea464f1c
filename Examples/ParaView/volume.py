# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The inside of a mesh as Adaptive Volume, and with an isosurface, light and a cut.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/volume.py [volume.png [MESH ARRAY]]

The mesh is any file of 3D cells that ParaView opens. Without one, it is a box of tetrahedra.
"""

import os
import sys
import tempfile

from paraview.simple import *

if len(sys.argv) > 3:
    mesh, array = OpenDataFile(sys.argv[2]), sys.argv[3]
else:
    mesh, array = Tetrahedralize(Input=Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])), "RTData"
mesh.UpdatePipeline()
low, high = mesh.PointData[array].GetRange()

layout = CreateLayout("Volume")
right = layout.SplitHorizontal(0, 0.5)
for place in right, right + 1:
    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.07, 0.08, 0.1]
    shown = Show(mesh, view)
    shown.Representation = "Adaptive Volume"
    ColorBy(shown, ("POINTS", array))
    colors = shown.LookupTable
    colors.ApplyPreset("Turbo", True)
    colors.RescaleTransferFunction(low, high)
    # Values, opacities, midpoints and sharpness: a layer, a haze, and the highest values.
    points = [(0, 0), (0.2, 0), (0.28, 0.5), (0.36, 0.03), (0.75, 0.01), (0.85, 0.08), (1, 1)]
    shown.ScalarOpacityFunction.Points = [
        x for share, opacity in points for x in (low + share * (high - low), opacity, 0.5, 0.0)
    ]
    if place == right + 1:
        shown.IsoSurfaces = 1
        shown.IsoSurfaceValues = [low + 0.28 * (high - low)]
        shown.Shade = 1
        shown.Ambient = 0.3
        shown.Diffuse = 0.7
        shown.ClippingPlane = "Plane"
        shown.ClippingPlane.Normal = [0, 1, -0.4]
    view.CameraPosition = [0.6, -3, 2]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    view.CameraViewAngle = 26

layout.SetSize(800, 400)
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "volume.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), layout):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)
