# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells as Surface, and as Adaptive Patches with isolines and the edges of cells.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/patches.py [patches.png [MESH ARRAY]]

The mesh is any file of quadratic, Lagrange or Bézier cells that ParaView opens. Without one, it is
a bent block of cells of degree 4.
"""

import os
import sys
import tempfile

from paraview.simple import *

BEND = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
grid = output.VTKObject
grid.DeepCopy(inputs[0].VTKObject)
x, y, z = vtk_to_numpy(grid.GetPoints().GetData()).astype(float).T - 1
angle = 0.9 * x
points = numpy.column_stack([(1.6 + z) * numpy.sin(angle), y * (1.2 - 0.3 * x * x),
                             (1.6 + z) * numpy.cos(angle)])
grid.GetPoints().SetData(numpy_to_vtk(points, deep=1))
field = numpy_to_vtk(numpy.sin(3 * x + y) * numpy.cos(2 * y) + 0.5 * z, deep=1)
field.SetName("Field")
grid.GetPointData().AddArray(field)
"""

if len(sys.argv) > 3:
    mesh, field = OpenDataFile(sys.argv[2]), sys.argv[3]
else:
    block = UnstructuredCellTypes(BlocksDimensions=[2, 2, 2], CellOrder=4)
    block.CellType = "Lagrange Hexahedron"
    mesh, field = ProgrammableFilter(Input=block, Script=BEND), "Field"
mesh.UpdatePipeline()
low, high = mesh.PointData[field].GetRange()

layout = CreateLayout("Patches")
right = layout.SplitHorizontal(0, 0.5)
for place in right, right + 1:
    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.96, 0.97, 0.98]
    shown = Show(mesh, view)
    shown.Representation = "Surface"
    ColorBy(shown, ("POINTS", field))
    shown.LookupTable.ApplyPreset("Turbo", True)
    shown.LookupTable.RescaleTransferFunction(low, high)
    if place == right + 1:
        shown.Representation = "Adaptive Patches"
        shown.ScreenSpaceError = 0.25
        shown.IsolineSpacing = (high - low) / 12
        shown.PatchEdges = 1
        shown.EdgeColor = [1, 1, 1]
        shown.LineWidth = 2
    view.CameraPosition = [1.4, -2, 2.6]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    view.CameraViewAngle = 26

layout.SetSize(800, 400)
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "patches.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), layout):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)
