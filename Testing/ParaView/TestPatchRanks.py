# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: several ranks draw the curved cells and curves of their pieces like one rank,
without cracks and without the faces between pieces. The first run, on one rank, writes the pictures
to a file:

mpirun -n RANKS pvbatch TestPatchRanks.py FILE.npz"""

import sys

import numpy
from paraview import simple
from vtkmodules import vtkCommonDataModel

import RelevoParaView as relevo

# Of the 30000 pixels of a picture. ParaView blends ranks with 8 bits.
MOST_PIXELS, MOST_BLENDED_PIXELS = 4, 20
# FXAA changes the neighbours of a pixel where curves of two ranks have the same depth.
MOST_CROSSED_PIXELS = 12

# A bent block of curved cells that are dealt out to seven pieces, and from there to the ranks. Its
# coordinates are floats, as in most files.
BLOCK = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkFiltersCore import vtkExtractCells
from vtkmodules.vtkFiltersSources import vtkCellTypeSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
ranks, rank = controller.GetNumberOfProcesses(), controller.GetLocalProcessId()
source = vtkCellTypeSource()
source.SetCellType(TYPE)
source.SetCellOrder(3)
source.SetBlocksDimensions(3, 3, 3)
source.Update()
grid = source.GetOutput()
x, y, z = vtk_to_numpy(grid.GetPoints().GetData()).astype(float).T - 1.5
points = numpy.column_stack([x + 0.3 * numpy.sin(2 * y), y + 0.3 * numpy.sin(2 * z + x),
                             z + 0.3 * numpy.sin(2 * x)])
grid.GetPoints().SetData(numpy_to_vtk(points.astype(numpy.float32), deep=1))
cells = grid.GetNumberOfCells()

def add(data, name, values):
    array = numpy_to_vtk(values, deep=1)
    array.SetName(name)
    data.AddArray(array)

add(grid.GetPointData(), "Field", numpy.sin(3 * x) * numpy.cos(2 * y) + z)
add(grid.GetCellData(), "Number", numpy.arange(cells) % 5 / 2.0 - 1)
middles = numpy.array([numpy.mean([points[grid.GetCell(cell).GetPointId(k)] for k in range(4)],
                                  axis=0) for cell in range(cells)])
random = numpy.random.RandomState(3)
if DEAL == "random":
    owners = random.randint(0, 7, cells)
elif DEAL == "slabs":
    owners = numpy.clip(numpy.floor((middles[:, 0] + 1.8) / 3.6 * 7), 0, 6).astype(int)
else:
    seeds = random.uniform(-1.5, 1.5, (7, 3))
    owners = numpy.argmin(((middles[:, None] - seeds) ** 2).sum(axis=2), axis=1)
ids = vtkIdList()
for cell in numpy.flatnonzero(owners % ranks == rank):
    ids.InsertNextId(int(cell))
extract = vtkExtractCells()
extract.SetInputData(grid)
extract.SetCellList(ids)
extract.Update()
self.GetUnstructuredGridOutput().ShallowCopy(extract.GetOutput())
"""

# Curves of degree 3 beside each other, dealt out to the ranks.
CURVES = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_CURVE
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
grid, points = self.GetUnstructuredGridOutput(), vtkPoints()
grid.Allocate(12)
for number in range(controller.GetLocalProcessId(), 12, controller.GetNumberOfProcesses()):
    ids = vtkIdList()
    for s in 0, 1, 1 / 3, 2 / 3:
        y = 0.4 * number - 2.2 + numpy.sin(9 * s + number)
        ids.InsertNextId(points.InsertNextPoint(4 * s - 2, y, numpy.cos(5 * s + 2 * number)))
    grid.InsertNextCell(VTK_LAGRANGE_CURVE, ids)
grid.SetPoints(points)
heights = [points.GetPoint(i)[2] for i in range(points.GetNumberOfPoints())]
values = numpy_to_vtk(numpy.array(heights), deep=1)
values.SetName("Field")
grid.GetPointData().AddArray(values)
"""

HEXAHEDRA = vtkCommonDataModel.VTK_LAGRANGE_HEXAHEDRON
FIELD, NUMBER = ("POINTS", "Field"), ("CELLS", "Number")
LINES = {"PatchEdges": 1, "IsolineSpacing": 0.25}
# The cells, how they are dealt out, the array, and properties. One rank draws data that are smaller
# than the threshold, in MB.
CASES = {
    "random": (HEXAHEDRA, "random", FIELD, LINES),
    "slabs": (HEXAHEDRA, "slabs", FIELD, {"IsolineSpacing": 0.5}),
    "blobs": (HEXAHEDRA, "blobs", FIELD, {"ScreenSpaceError": 4.0}),
    "tetrahedra": (vtkCommonDataModel.VTK_BEZIER_TETRAHEDRON, "random", NUMBER, {"PatchEdges": 1}),
    "quadratic": (vtkCommonDataModel.VTK_QUADRATIC_WEDGE, "blobs", FIELD, {}),
    "collected": (HEXAHEDRA, "random", NUMBER, {}, 1000),
    "translucent": (HEXAHEDRA, "random", FIELD, {"Opacity": 0.4}),
}


PLAIN = {"PatchEdges": 0, "IsolineSpacing": 0, "ScreenSpaceError": 0.5, "Opacity": 1}


class Scene:
    """A source that is shown in a view of all pictures: shaders of other windows would be built
    again, and showing another source takes many messages between ranks."""

    def __init__(self, view, representation):
        self.view = view
        self.source = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
        self.source.Script = make_script(HEXAHEDRA, "random")
        self.shown = relevo.show(self.source, view, representation)
        simple.Render(view)  # ParaView moves the camera in the first frame of a session

    def draw(self, script, array, properties):
        self.source.Script = script
        relevo.set_properties(self.shown, {**PLAIN, **properties})
        simple.ColorBy(self.shown, array)
        simple.GetColorTransferFunction(array[1]).RescaleTransferFunction(-2, 2)
        self.shown.SetScalarBarVisibility(self.view, False)
        self.view.CameraPosition, self.view.CameraFocalPoint = [5, 4, 7], [0, 0, 0]
        return relevo.picture(self.view)


def make_view():
    view = relevo.view((200, 150))
    view.UseColorPaletteForBackground = 0
    view.Background = [0, 1, 0]  # contrasts with the colours
    return view


def make_script(cell_type, deal):
    return f"TYPE = {cell_type}\nDEAL = {deal!r}\n" + BLOCK


def draw_patches(scene, cell_type, deal, array, properties, threshold=0):
    scene.view.RemoteRenderThreshold = threshold
    return scene.draw(make_script(cell_type, deal), array, properties)


def count_holes(picture):
    """Number of pixels of the background that others enclose."""
    is_empty = (picture == [0, 255, 0]).all(axis=2)
    is_outside = numpy.zeros_like(is_empty)
    is_outside[[0, -1]], is_outside[:, [0, -1]] = is_empty[[0, -1]], is_empty[:, [0, -1]]
    number = 0
    while number != is_outside.sum():
        number = is_outside.sum()
        for axis in 0, 1:
            for shift in 1, -1:
                is_outside |= numpy.roll(is_outside, shift, axis) & is_empty
    return int((is_empty & ~is_outside).sum())


def main(path):
    view = make_view()
    patches = Scene(view, "Adaptive Patches")
    pictures = {name: draw_patches(patches, *case) for name, case in CASES.items()}
    holes = {name: count_holes(picture) for name, picture in pictures.items()}
    patches.shown.Visibility = 0
    curves = Scene(view, "Adaptive Curves")
    for shape in "Lines", "Tubes":
        properties = {"CurveRepresentation": shape, "LineWidth": 5, "Radius": 0.1}
        pictures[shape] = curves.draw(CURVES, FIELD, properties)
    limits = {**dict.fromkeys(pictures, MOST_PIXELS), "translucent": MOST_BLENDED_PIXELS}
    limits["Lines"] = limits["Tubes"] = MOST_CROSSED_PIXELS
    failed = relevo.compare_with_one_rank(path, pictures, limits)
    print(f"pixels of holes: {holes}", flush=True)
    return failed + len([name for name in holes if holes[name] > 0])


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
