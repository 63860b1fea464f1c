# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A coarse isosurface as ParaView's Surface, and refined, curved and coloured by level.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/refined.py [refined.png]
"""

import os
import sys
import tempfile

from paraview.simple import *

wavelet = Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
coarse = Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[160])

layout = CreateLayout("Refined")
right = layout.SplitHorizontal(0, 0.5)
for place, name in (right, "Surface With Edges"), (right + 1, "Adaptive Refinement"):
    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    shown = Show(coarse, view)
    shown.Representation = name
    shown.ColorArrayName = ["POINTS", ""]
    if name == "Adaptive Refinement":
        shown.MaximumLevel = 5
        shown.Metric = "Edge Length on Screen"
        shown.Metric.ReferenceLength = 6
        shown.Surface = "PN Triangles"
        shown.RefinementColorMode = "Level"
    view.OrientationAxesVisibility = 0
    view.CameraPosition = [14, 10, 22]
    view.CameraFocalPoint = [0, 0, 0]

layout.SetSize(800, 400)
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "refined.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), layout):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)
