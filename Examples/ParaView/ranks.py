# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A coarse mesh on several ranks, as ParaView's Surface and refined, coloured by rank.

    . build-paraview/env.sh
    mpirun -n 4 pvbatch Examples/ParaView/ranks.py [ranks.png [MESH.ply]]

Without a mesh it is an isosurface. Borders between ranks have neither gaps nor edges to see.
"""

import os
import sys
import tempfile

from paraview.simple import *

if len(sys.argv) > 2:
    mesh = Decimate(Input=PLYReader(FileNames=[sys.argv[2]]), TargetReduction=0.97)
    mesh = Transform(Input=mesh)
    mesh.Transform.Rotate = [0, 20, 0]
else:
    wavelet = Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    mesh = Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[160])
later = GetParaViewVersion().major >= 6
normals = (SurfaceNormals if later else GenerateSurfaceNormals)(Input=mesh, FeatureAngle=180)
parts = RedistributeDataSet(Input=normals, BoundaryMode="Assign to one region")
if later:
    ranks, array = ProcessIds(Input=parts, GenerateCellData=1), "CellProcessIds"
else:
    ranks, array = PointDatatoCellData(Input=ProcessIdScalars(Input=parts)), "ProcessId"
    ranks.ProcessAllArrays = 0
    ranks.PointDataArraytoprocess = [array]
    ranks.PassPointData = 1
ranks.UpdatePipeline()

layout = CreateLayout("Ranks")
right = layout.SplitHorizontal(0, 0.5)
for place, name in (right, "Surface"), (right + 1, "Adaptive Refinement"):
    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    shown = Show(ranks, view)
    shown.Representation = name
    ColorBy(shown, ("CELLS", array))
    shown.RescaleTransferFunctionToDataRange()
    if name == "Adaptive Refinement":
        shown.MaximumLevel = 4
        shown.Surface = "PN Triangles"
        shown.Metric.ReferenceLength = 4
    HideScalarBarIfNotNeeded(shown.LookupTable, view)
    view.OrientationAxesVisibility = 0
    ResetCamera(view)
    view.CameraParallelProjection = 1
    view.CameraParallelScale *= 0.7

layout.SetSize(800, 400)
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "ranks.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), layout):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)
