# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A volume on several ranks as Adaptive Volume, and with a colour for each rank.

    . build-paraview/env.sh
    mpirun -n 4 pvbatch Examples/ParaView/volumeranks.py [volumeranks.png [MESH ARRAY]]

The mesh is any file of 3D cells that ParaView opens. Without one, it is a box of tetrahedra. Ranks
keep whole cells, so the borders between them are ragged. The first picture does not show them.
"""

import os
import sys
import tempfile

from paraview.simple import *

if len(sys.argv) > 3:
    mesh, array = OpenDataFile(sys.argv[2]), sys.argv[3]
else:
    mesh, array = Tetrahedralize(Input=Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])), "RTData"
parts = RedistributeDataSet(Input=mesh, BoundaryMode="Assign to one region")
later = GetParaViewVersion().major >= 6
if later:
    ranks, rank = ProcessIds(Input=parts), "PointProcessIds"
else:
    ranks, rank = ProcessIdScalars(Input=parts), "ProcessId"
ranks.UpdatePipeline()
low, high = ranks.PointData[array].GetRange()
span = high - low

layout = CreateLayout("Volume on ranks")
right = layout.SplitHorizontal(0, 0.5)
for place, name in (right, array), (right + 1, rank):
    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.07, 0.08, 0.1]
    shown = Show(ranks, view)
    shown.Representation = "Adaptive Volume"
    ColorBy(shown, ("POINTS", name), separate=True)
    if name == rank:
        shown.LookupTable.ApplyPreset("Spectral_lowBlue", True)
        shown.RescaleTransferFunctionToDataRange()
        shown.UseSeparateOpacityArray = 1
        shown.OpacityArrayName = ["POINTS", array]
    else:
        shown.LookupTable.ApplyPreset("Inferno" if later else "Inferno (matplotlib)", True)
        shown.LookupTable.RescaleTransferFunction(low, high)
    # Values, opacities, midpoints and sharpness: a haze, and two layers inside it.
    points = [(0, 0.01), (0.45, 0.1), (0.5, 0.7), (0.55, 0.1), (0.75, 0.3), (0.8, 1), (1, 1)]
    shown.ScalarOpacityFunction.Points = [
        x for share, opacity in points for x in (low + share * span, opacity, 0.5, 0.0)
    ]
    HideScalarBarIfNotNeeded(shown.LookupTable, view)
    view.CameraPosition = [0.6, -3, 2]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    view.CameraViewAngle = 26

layout.SetSize(800, 400)
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "volumeranks.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), layout):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)
