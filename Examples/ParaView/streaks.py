# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Streaks along the flow in an unstructured mesh, on its walls and on a cut.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/streaks.py [streaks.png [MESH VECTORS]]

The mesh is any file of cells that ParaView opens, as of a reactor; without one it is a box of
tetrahedra in which air turns.
"""

import os
import sys
import tempfile

from paraview.simple import *

if len(sys.argv) > 3:
    mesh, vectors = OpenDataFile(sys.argv[2]), sys.argv[3]
    if hasattr(mesh, "PointVariables"):
        mesh.PointVariables = [vectors]
else:
    box = Tetrahedralize(Input=Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8]))
    function = "iHat*(coordsY-coordsZ/2)-jHat*coordsX+kHat*sin(coordsX/2)"
    mesh, vectors = Calculator(Input=box, ResultArrayName="Flow", Function=function), "Flow"
cut = Clip(Input=mesh, ClipType="Plane")
cut.ClipType.Normal = [-0.6, 0.8, 0]
cut.ClipType.Origin = [0, 0, 0]

view = CreateView("RenderView")
view.ViewSize = [600, 600]
view.OrientationAxesVisibility = 0
shown = Show(cut, view)
shown.SelectInputVectors = ["POINTS", vectors]
shown.Representation = "Adaptive LIC"
shown.LICIntensity = 0.6
shown.EnhanceContrast = "LIC and Color"
ColorBy(shown, ("POINTS", vectors, "Magnitude"))
HideScalarBarIfNotNeeded(shown.LookupTable, view)
view.CameraPosition = [-18, 24, 14]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]
ResetCamera(view)
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "streaks.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), view):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)
