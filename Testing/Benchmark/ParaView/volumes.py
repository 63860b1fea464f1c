# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures Adaptive Volume in ParaView. run.sh in this folder shows the order of the calls.

    [mpirun -n RANKS] pvbatch volumes.py ranks FILE.npz
    mpirun -n RANKS pvbatch --sym volumes.py frames
    pvbatch volumes.py post

Prints rows of Markdown tables. RELEVO_TEST_DATA names the folder of the post."""

import math
import os
import re
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonSystem import vtkTimerLog
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import RelevoParaView as relevo
import TestVolume as plain
import TestVolumeRanks as pieces
from measurement import RANKS, Times, row

SIZE = (400, 300)
MODES = "Composite", "Maximum", "Minimum", "Average", "Additive", "Isosurface"
DEALINGS = "random", "slabs", "blobs"

# The oxygen post in PLOT3D, which has numbers of 4 bytes with the highest first, as tetrahedra. A
# rank keeps the cells that it owns.
POST = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkCellCenters, vtkExtractCells
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
with open("FOLDER/postxyz.bin", "rb") as file:
    size = numpy.fromfile(file, ">i4", 3)
    number = int(numpy.prod(size))
    places = numpy.fromfile(file, ">f4", 3 * number).reshape(3, number).T
    blanks = numpy.fromfile(file, ">i4", number)
with open("FOLDER/postq.bin", "rb") as file:
    numpy.fromfile(file, ">i4", 3 + 4)
    flow = numpy.fromfile(file, ">f4", 2 * number).reshape(2, number)
grid = vtkStructuredGrid()
grid.SetDimensions(*map(int, size))
points = vtkPoints()
points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places, "f4"), deep=1))
grid.SetPoints(points)
values = numpy_to_vtk(numpy.ascontiguousarray(flow[1], "f4"), deep=1)
values.SetName("Momentum")
grid.GetPointData().SetScalars(values)
for point in numpy.nonzero(blanks == 0)[0]:
    grid.BlankPoint(int(point))
split = vtkDataSetTriangleFilter()
split.SetInputData(grid)
split.TetrahedraOnlyOn()
split.Update()
mesh = split.GetOutput()
if ranks > 1:
    finder = vtkCellCenters()
    finder.SetInputData(mesh)
    finder.Update()
    centers = vtk_to_numpy(finder.GetOutput().GetPoints().GetData())
    dice = numpy.random.default_rng(1)
    if "DEALING" == "slabs":
        share = centers[:, 2].argsort().argsort()
        owners = ranks * share // len(centers)
    elif "DEALING" == "blobs":
        seeds = centers[dice.integers(0, len(centers), ranks)]
        owners = numpy.linalg.norm(centers[:, None] - seeds, axis=2).argmin(axis=1)
    else:
        owners = dice.integers(0, ranks, len(centers))
    own = vtkIdList()
    for i in numpy.nonzero(owners == rank)[0]:
        own.InsertNextId(int(i))
    extract = vtkExtractCells()
    extract.SetInputData(mesh)
    extract.SetCellList(own)
    extract.Update()
    mesh = extract.GetOutput()
output.VTKObject.ShallowCopy(mesh)
"""
RANGE = -0.22, 1.37  # of the momentum
LENGTH = 1.6  # three mean cells


def ranks(path):
    """Compares pictures with those of one rank: Adaptive Volume, and ParaView's Volume, which has no
    other blend mode for cells."""
    pieces.SIZE = SIZE
    source = pieces.deal()
    view, shown = pieces.scene(source, IsoSurfaceValues=[130, 200])
    pictures = {}
    for dealing in DEALINGS if RANKS > 1 else DEALINGS[:1]:
        source.Script = pieces.script(dealing)
        for mode, name in enumerate(MODES):
            shown.BlendMode = mode
            pictures[dealing, name] = relevo.picture(view)
        shown.BlendMode = 0
        shown.Representation = "Volume"
        pictures[dealing, "Volume"] = relevo.picture(view)
        shown.Representation = "Adaptive Volume"
    if RANKS == 1:
        numpy.savez(path, **{name: picture for (_, name), picture in pictures.items()})
        return
    expected = numpy.load(path)
    for dealing in DEALINGS:
        count = {
            name: [relevo.differing(pictures[dealing, name], expected[name], limit) for limit in (2, 1)]
            for name in (*MODES, "Volume")
        }
        far, near = (sorted(count[name][i] for name in MODES)[-1] for i in (0, 1))
        exact = 100 - 100 * near / (SIZE[0] * SIZE[1])
        row(RANKS, dealing, *count["Composite"], far, near, f"{exact:.3f} %", *count["Volume"])


def make_script(dealing):
    folder = os.path.join(os.environ["RELEVO_TEST_DATA"], "volume")
    return POST.replace("FOLDER", folder).replace("DEALING", dealing)


def show_post(dealing, view, representation="Adaptive Volume", **properties):
    """Shows the momentum along x with 11 nodes in the functions."""
    source = simple.ProgrammableSource(
        OutputDataSetType="vtkUnstructuredGrid", Script=make_script(dealing)
    )
    source.UpdatePipeline()
    shown = simple.Show(source, view)
    shown.Representation = representation
    simple.ColorBy(shown, ("POINTS", "Momentum"), separate=True)
    colors, opacities = [], []
    for i in range(11):
        x, jump = i / 10, 0.1 if i % 2 == 0 else -0.1
        value = RANGE[0] + x * (RANGE[1] - RANGE[0])
        turn = 2 * math.pi * x
        red, green = 0.5 + 0.4 * math.cos(turn) + jump, 0.5 + 0.4 * math.sin(turn) - jump
        colors += [value, red, green, 0.1 + 0.8 * x + jump]
        opacities += [value, 0.15 + 0.4 * x + jump, 0.5, 0]
    shown.LookupTable.AutomaticRescaleRangeMode = "Never"
    shown.LookupTable.ColorSpace = "RGB"
    shown.LookupTable.RGBPoints = colors
    shown.ScalarOpacityFunction.Points = opacities
    shown.ScalarOpacityUnitDistance = LENGTH
    shown.SetScalarBarVisibility(view, False)
    relevo.set_properties(shown, properties)
    return source


def make_view(size):
    view = relevo.view(size)
    view.UseFXAA = 0
    simple.Render(view)  # ParaView moves the camera in the first frame of a session
    view.CameraFocalPoint = [0, 0, 2.4]
    view.CameraViewUp = [0, 0, 1]
    turn(view, 0)
    return view


def turn(view, number):
    """Turns the camera by 7 degrees per frame."""
    angle = math.radians(20 + 7 * number)
    view.CameraPosition = [60 * math.cos(angle), 60 * math.sin(angle), 45]


def render(view, number):
    turn(view, number)
    simple.Render(view)
    view.GetRenderWindow().WaitForCompletion()


def plain_frame(view, data):
    """Returns a function that draws in a window of plain VTK, with the camera of the view."""
    window = plain.plain_window(view, data, "Momentum")
    renderer = window.GetRenderers().GetFirstRenderer()

    def draw(_):
        renderer.GetActiveCamera().DeepCopy(view.GetClientSideObject().GetActiveCamera())
        renderer.ResetCameraClippingRange()
        window.Render()
        window.WaitForCompletion()

    return draw


def on_ranks(number):
    """A number of each rank."""
    own = numpy_to_vtk(numpy.array([float(number)]))
    together = vtkDoubleArray()
    together.SetNumberOfValues(RANKS)
    vtkMultiProcessController.GetGlobalController().AllGather(own, together)
    return vtk_to_numpy(together)


def count_bytes():
    """The bytes of segments that this rank sent for a volume, from ParaView's timer log."""
    events = map(vtkTimerLog.GetEventString, range(vtkTimerLog.GetNumberOfEvents()))
    found = [re.match(r"Adaptive Volume: send (\d+) bytes", event) for event in events]
    return int([each.group(1) for each in found if each][-1])


def frames():
    """Measures frames of the post on several ranks, in processor time, and frames of each rank's cells
    in plain VTK. With a processor for each rank, a frame would end when the root has merged the
    segments, after the slowest rank has cast its rays. Merging is the time that the root needs in
    addition to its own rays, compared with the other ranks. run.sh lets ranks sleep while they wait."""
    view = make_view(SIZE)
    source = show_post("slabs", view)
    shown = simple.GetRepresentation(source, view)
    shown.Visibility = 0
    empty = on_ranks(Times({"view": lambda number: render(view, number)}, 9).processor("view"))
    shown.Visibility = 1
    for dealing in "slabs", "blobs":
        source.Script = make_script(dealing)
        simple.Render(view)
        mapper = plain.volumes(view)[-1].GetMapper()
        own_frame = plain_frame(view, mapper.GetInputDataObject(0, 0))
        vtkTimerLog.SetMaxEntries(1000)
        times = Times({"view": lambda number: render(view, number), "own": own_frame}, 9)
        whole, own = (on_ranks(times.processor(name)) for name in ("view", "own"))
        sent = on_ranks(count_bytes()).sum()
        added = whole - own - empty
        merging = added[0] - numpy.median(added[1:])
        casting = numpy.append(whole[0] - merging, whole[1:])
        frame = casting.max() + merging
        row(
            RANKS,
            dealing,
            f"{own.max():.0f} ms",
            f"{casting.max():.0f} ms",
            f"{empty.max():.0f} ms",
            f"{merging:.0f} ms",
            f"{frame:.0f} ms",
            f"{frame / own.max():.2f}",
            f"{sent / 2**20:.2f} MiB",
        )


def post():
    """Measures frames of 513 375 tetrahedra."""
    draws = {}
    for name, properties in {
        "Adaptive Volume": {"representation": "Adaptive Volume"},
        "Volume, projected tetrahedra": {"representation": "Volume", "SelectMapper": "Projected tetra"},
        "Volume, ray casting": {"representation": "Volume", "SelectMapper": "Bunyk ray cast"},
    }.items():
        view = make_view((512, 512))
        source = show_post("", view, **properties)
        draws[name] = lambda number, view=view: render(view, number)
        if name == "Adaptive Volume":
            simple.Render(view)
            draws["the same mapper in plain VTK"] = plain_frame(view, relevo.mesh(source))
    times = Times(draws, 5)
    for name in draws:
        row(
            name,
            f"{times.wall(name):.0f} ms",
            f"{times.processor(name):.0f} ms",
            f"{times.ratio('Adaptive Volume', name):.2f}",
        )


if __name__ == "__main__":
    globals()[sys.argv[1]](*sys.argv[2:])
