# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: streaks continue across the borders of ranks. The first run, on one rank,
writes the pictures to a file:

mpirun -n RANKS pvbatch TestLICRanks.py FILE.npz"""

import sys

from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule

import RelevoParaView as relevo

RANKS = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
# Random faces: one on the first of several ranks, none on the second.
PIECE = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkContourFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
source = vtkRTAnalyticSource()
contour = vtkContourFilter()
contour.SetInputConnection(source.GetOutputPort())
contour.SetValue(0, 150)
contour.Update()
mesh = contour.GetOutput()
if RANK != MISSING:
    x, y, z = vtk_to_numpy(mesh.GetPoints().GetData()).T
    flow = numpy_to_vtk(numpy.stack([y + z, -x, 3 + x], axis=1), deep=1)
    flow.SetName("Flow")
    mesh.GetPointData().AddArray(flow)
faces = vtk_to_numpy(mesh.GetPolys().GetData()).reshape(-1, 4)
owners = numpy.random.RandomState(1).randint(2, numpy.maximum(RANKS, 3), len(faces))
owners[0] = 0
own = faces[owners % RANKS == RANK]
cells = vtkCellArray()
cells.SetCells(len(own), numpy_to_vtkIdTypeArray(own.ravel(), deep=1))
mesh.SetPolys(cells)
clean = vtkCleanPolyData() # removes points that only other ranks use
clean.PointMergingOff()
clean.SetInputData(mesh)
clean.Update()
output.ShallowCopy(clean.GetOutput())
"""
RANK = """
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
"""
# Pixels of 60000 that may differ.
LIMITS = {"Streaks": 10, "Ranges": 10, "Close": 20}
# Settings that depend on the vectors and colours of all ranks.
RANGES = {
    "EnhanceContrast": "LIC and Color",
    "LICIntensity": 0.6,
    "AntiAlias": 1,
    "NormalizeVectors": 0,
    "StepSize": 0.2,
}


def pieces(missing=-1):
    """A surface in parts. The rank `missing` has no vectors."""
    return simple.ProgrammableSource(
        Script=f"{RANK}MISSING = {missing}\n{PIECE}", OutputDataSetType="vtkPolyData"
    )


def bricks():
    """A surface split into compact parts."""
    flow = simple.Calculator(Input=simple.Wavelet(), ResultArrayName="Flow")
    flow.Function = "iHat*(coordsY+coordsZ)-jHat*coordsX+kHat*(3+coordsX)"
    return simple.Contour(Input=flow, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])


def look_from(view, x):
    view.CameraPosition = [x, 0.8 * x, 1.6 * x]
    view.CameraFocalPoint = [0, 0, 0]


def show(source, **properties):
    """A view of streaks and its picture."""
    view = relevo.view()
    vectors = {"SelectInputVectors": ["POINTS", "Flow"]}
    relevo.show(source, view, "Adaptive LIC", MaximumLevel=0, Metric="None", **vectors, **properties)
    look_from(view, 25)
    relevo.picture(view)  # ParaView moves the camera in the first frame of a session
    look_from(view, 25)
    return view, relevo.picture(view)


def count_convolutions(view):
    """Number of convolutions for a repeated picture and for two others."""
    counts = [relevo.statistic(view, "NumberOfConvolutions")]
    for x in 25, 24, 23:
        look_from(view, x)
        relevo.picture(view)
        counts.append(relevo.statistic(view, "NumberOfConvolutions"))
    return [count - counts[0] for count in counts[1:]]


def main(path):
    pictures = {}
    view, pictures["Streaks"] = show(pieces())
    counts = count_convolutions(view)
    print(f"{RANKS} ranks: convolutions {counts}")
    simple.Delete(view)
    view, pictures["Ranges"] = show(pieces(), **RANGES)
    simple.Delete(view)
    view, _ = show(bricks())
    look_from(view, 4)  # IceT skips ranks with nothing in view
    pictures["Close"] = relevo.picture(view)
    simple.Delete(view)
    # Other ranks do not wait for a rank without vectors.
    view, picture = show(pieces(missing=2))
    simple.Delete(view)
    failed = relevo.compare_with_one_rank(path, pictures, LIMITS)
    return failed + (counts != [0, 1, 2]) + (relevo.foreground(picture) < 1000)


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
