# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: Adaptive Volume on several ranks gives the picture of one rank, for pieces of
any shape.

    mpirun -n N pvbatch TestVolumeRanks.py PICTURES.npz

One rank writes the pictures, several ranks compare theirs with them. The name of a picture ends with
" / " and the way to deal out cells, if one rank has drawn it with another way."""

import re
import sys

import numpy
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule

import RelevoParaView as relevo

SIZE = (160, 120)
# The numbers of pixels that may differ by more than 2 and more than 1 of 255. Translucent objects are
# cut at ParaView's boxes of space.
EXACT = (0, 19)
TRANSLUCENT = (6, 19)
RANKS = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()

# Every rank creates the whole mesh and keeps its cells. If HEXAHEDRA is true, faces are not flat.
DEAL = """
import numpy
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkCellCenters, vtkExtractCells
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
source = vtkRTAnalyticSource()
source.SetWholeExtent(-4, 4, -4, 4, -4, 4)
convert = vtkAppendFilter() if HEXAHEDRA else vtkDataSetTriangleFilter()
convert.SetInputConnection(source.GetOutputPort())
convert.Update()
mesh = convert.GetOutput()
places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
places += 0.2 * numpy.sin(7 * places[:, [1, 2, 0]] + 3 * places)
points = vtkPoints()
points.SetData(numpy_to_vtk(places, deep=1))
mesh.SetPoints(points)
values = numpy_to_vtk(places + vtk_to_numpy(mesh.GetPointData().GetArray("RTData"))[:, None] / 50)
values.SetName("V")
mesh.GetPointData().AddArray(values)
finder = vtkCellCenters()
finder.SetInputData(mesh)
finder.Update()
centers = vtk_to_numpy(finder.GetOutput().GetPoints().GetData())
numbers = numpy_to_vtk(centers[:, 0] * centers[:, 1] + 2 * centers[:, 2], deep=1)
numbers.SetName("Numbers")
mesh.GetCellData().AddArray(numbers)
dice = numpy.random.default_rng(ranks)
if "DEALING" == "slabs":
    share = centers.sum(axis=1)
    owners = (ranks * (share - share.min()) / (1e-9 + share.max() - share.min())).astype(int)
elif "DEALING" == "blobs":
    seeds = dice.uniform(-4, 4, (ranks, 3))
    owners = numpy.linalg.norm(centers[:, None] - seeds, axis=2).argmin(axis=1)
elif "DEALING" == "awkward":  # no cell on the last rank, a single one on the rank before
    owners = dice.integers(0, ranks - 2 if ranks > 2 else 1, len(centers))
    owners[len(centers) // 2] = ranks - 2 if ranks > 2 else 0
else:
    owners = dice.integers(0, ranks, len(centers))
own = vtkIdList()
for i in numpy.nonzero(owners == rank)[0]:
    own.InsertNextId(int(i))
extract = vtkExtractCells()
extract.SetInputData(mesh)
extract.SetCellList(own)
extract.Update()
piece = extract.GetOutput()
FAULT
output.VTKObject.ShallowCopy(piece)
"""


def script(dealing="random", hexahedra=False, fault=""):
    text = DEAL.replace("DEALING", dealing).replace("HEXAHEDRA", str(hexahedra))
    return text.replace("FAULT", fault)


def deal(*arguments, **choices):
    return simple.ProgrammableSource(
        OutputDataSetType="vtkUnstructuredGrid", Script=script(*arguments, **choices)
    )


def show(source, view, array=("POINTS", "RTData"), **properties):
    """Shows a volume with a busy transfer function."""
    shown = simple.Show(source, view)
    shown.Representation = "Adaptive Volume"
    simple.ColorBy(shown, array, separate=True)
    ranges = {"RTData": (40, 280), "V": (-4, 8), "Numbers": (-15, 20)}
    low, high = ranges.get(array[1], (0, 0.7))
    colors, opacities = shown.LookupTable, shown.ScalarOpacityFunction
    middle = 0.3 * low + 0.7 * high
    colors.AutomaticRescaleRangeMode = "Never"
    colors.ColorSpace = "RGB"
    colors.RGBPoints = [low, 0.1, 0.2, 0.9, middle, 0.9, 0.9, 0.8, high, 0.9, 0.2, 0.1]
    opacities.Points = [low, 0, 0.5, 0, middle, 0.8, 0.5, 0, middle + 1, 0.1, 0.5, 0, high, 0.5, 0.5, 0]
    relevo.set_properties(shown, properties)
    return shown


def scene(source, *arguments, **properties):
    """Shows a volume in the view of all pictures: shaders of other windows would be built again."""
    view = VIEW or make_view()
    shown = show(source, view, *arguments, **properties)
    view.CameraPosition = [10, -18, 11]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 30
    return view, shown


VIEW = None


def make_view():
    view = relevo.view(SIZE)
    view.ImageReductionFactor = 1  # several ranks would draw fewer pixels while the view moves
    simple.Render(view)  # ParaView moves the camera in the first frame of a session
    globals()["VIEW"] = view
    return view


def clear():
    """Deletes all sources, but not the view."""
    for source in list(simple.GetSources().values()):
        simple.Delete(simple.GetRepresentation(source, VIEW))
        simple.Delete(source)


# Each rank also gets a third of the cells of others, as ghost cells.
WITH_GHOSTS = """
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes
kept = numpy.nonzero((owners == rank) | (numpy.arange(len(owners)) % 3 == 0))[0]
own.Reset()
for i in kept:
    own.InsertNextId(int(i))
extract.SetCellList(own)
extract.Update()
piece = extract.GetOutput()
types = numpy.where(owners[kept] == rank, 0, vtkDataSetAttributes.DUPLICATECELL)
ghosts = numpy_to_vtk(types.astype(numpy.uint8), deep=1)
ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
piece.GetCellData().AddArray(ghosts)
"""


def draw_modes(pictures):
    """Other cells in the same source: a new one takes many messages between ranks."""
    dealings = {"slabs": (0, 2, 5), "blobs": (1, 3, 4), "awkward": (0, 1)} if RANKS > 1 else {}
    source = deal()
    view, shown = scene(source, IsoSurfaceValues=[130, 200])
    for dealing, modes in {**dealings, "random": range(6)}.items():
        source.Script = script(dealing)
        for mode in modes:
            shown.BlendMode = mode
            name = f"mode {mode}" if dealing == "random" else f"mode {mode} / {dealing}"
            pictures[name] = relevo.picture(view)
    if RANKS > 1:
        shown.BlendMode = "Additive"  # twice as bright where a cell is drawn twice
        source.Script = script(fault=WITH_GHOSTS)
        pictures["mode 4 / ghost cells"] = relevo.picture(view)
        source.Script = script()
    draw_settings(view, shown, pictures)
    clear()


def draw_settings(view, shown, pictures):
    shown.BlendMode = "Composite"
    shown.IsoSurfaces = 1
    pictures["isosurfaces inside"] = relevo.picture(view)
    shown.Shade = 1
    pictures["shading"] = relevo.picture(view)
    shown.Shade = 0
    shown.ClippingPlane = "Plane"
    shown.ClippingPlane.Origin = [0.5, 0, 0]
    shown.ClippingPlane.Normal = [0.7, 0.3, -0.6]
    pictures["clipping"] = relevo.picture(view)
    shown.Method = "Cell Projection"
    pictures["clipping / cell projection"] = relevo.picture(view)
    shown.Method = "Ray Casting"
    shown.TableSize = 32
    shown.Integration = "Pre-Integrated 2D"
    shown.IsoSurfaces = 0
    pictures["tables"] = relevo.picture(view)


def draw_data(pictures):
    for name, make, array in (
        ("hexahedra", lambda: deal("blobs", hexahedra=True), ("POINTS", "RTData")),
        ("cell data", deal, ("CELLS", "Numbers")),
        ("magnitude", deal, ("POINTS", "V", "Magnitude")),
        ("image", lambda: simple.Wavelet(WholeExtent=[-4, 4] * 3), ("POINTS", "RTData")),
    ):
        view, _ = scene(make(), array)
        pictures[name] = relevo.picture(view)
        clear()


def draw_others(pictures):
    """Opaque objects, a second volume, and pictures while the view moves."""
    view, shown = scene(deal("random", hexahedra=True))
    boxes = []
    for center in (2, 2, 2), (-7, 0, 0), (3, -3, 3):
        box = simple.Box(XLength=3, YLength=3, ZLength=3, Center=center)
        each = simple.Show(box, view)
        each.DiffuseColor = [0.2, 0.9, 0.3]
        boxes.append(each)
    pictures["opaque boxes"] = relevo.picture(view)
    for each in boxes:
        each.Visibility = 0
    other = show(deal("slabs"), view, BlendMode="Additive", ScalarOpacityUnitDistance=20)
    relevo.set_properties(other, {"Position": [5, 3, 0]})
    pictures["two volumes"] = relevo.picture(view)
    shown.Visibility = 0
    pictures["second volume"] = relevo.picture(view)
    shown.Visibility = 1
    other.Visibility = 0
    pictures["hexahedra / others hidden"] = relevo.picture(view)
    view.SMProxy.InteractiveRender()
    pictures["hexahedra / moving"] = relevo.drawn(view)
    view.CameraPosition = [14, 14, -3]
    pictures["turned"] = relevo.picture(view)
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 6
    pictures["parallel"] = relevo.picture(view)
    view.CameraParallelProjection = 0
    clear()


def show_sphere(view, center, color):
    sphere = simple.Sphere(Radius=2, Center=center, ThetaResolution=16, PhiResolution=12)
    shown = simple.Show(sphere, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = color
    shown.Opacity = 0.4
    return shown


def draw_translucent(pictures):
    """Translucent objects in front of, inside and behind a volume. ParaView cuts them at its boxes
    of space."""
    view, shown = scene(deal("random"), IsoSurfaceValues=[130])
    view.MaximumNumberOfPeels = 10
    front = show_sphere(view, (-3, -5, 1), [0.9, 0.3, 0.2])
    inside = show_sphere(view, (1, 0, 0), [0.2, 0.9, 0.3])
    show_sphere(view, (2, 6, 2), [0.2, 0.3, 0.9])
    pictures["translucent"] = relevo.picture(view)
    shown.BlendMode = 1
    pictures["translucent, maximum"] = relevo.picture(view)
    shown.BlendMode = 0
    shown.IsoSurfaces = 1
    front.Opacity = 1
    inside.Representation = "Adaptive Refinement"
    pictures["translucent, refined, opaque"] = relevo.picture(view)
    clear()


ON_ONE_RANK = """
if rank == 1:
    """
WITHOUT_CELLS = """
if rank == 1:
    from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
    surface = vtkGeometryFilter()
    surface.SetInputData(piece)
    append = vtkAppendFilter()
    append.SetInputConnection(surface.GetOutputPort())
    append.Update()
    piece = append.GetOutput()
"""
NOT_FINITE = """
if rank == 1:
    piece.GetPoints().SetPoint(0, float("nan"), 0, 0)
"""
NOT_A_NUMBER = """
if rank == 1:
    piece.GetPointData().GetArray("RTData").SetValue(0, float("nan"))
"""
OF_TEXT = """
from vtkmodules.vtkCommonCore import vtkStringArray
if rank == 1:
    texts = vtkStringArray()
    texts.SetName("RTData")
    texts.SetNumberOfValues(piece.GetNumberOfPoints())
    piece.GetPointData().AddArray(texts)
"""
OF_PAIRS = """
if rank == 1:
    pairs = numpy_to_vtk(numpy.ones((piece.GetNumberOfPoints(), 2)), deep=1)
    pairs.SetName("RTData")
    piece.GetPointData().AddArray(pairs)
"""


def remove_nodes(shown):
    shown.ScalarOpacityFunction.Points = []


def allow_one_segment(shown):
    shown.MaximumSegments = 1


def show_translucent(_):
    show_sphere(VIEW, (0, 0, 0), [0.2, 0.9, 0.3])


def check_faults():
    """Each fault on one rank gives one message of the representation, and the others go on."""
    remove_array = ON_ONE_RANK + 'piece.GetPointData().RemoveArray("RTData")'
    failed = 0
    source = deal()
    view, shown = scene(source)
    for name, fault, prepare, words in (
        ("no array", remove_array, None, 'Rank 1: The input has no array "RTData"'),
        ("no cells", WITHOUT_CELLS, None, "Rank 1: The input has no 3D cells"),
        ("bad points", NOT_FINITE, None, "points that are not finite"),
        ("bad values", NOT_A_NUMBER, None, 'values of the array "RTData" that are not finite'),
        ("text", OF_TEXT, None, 'Rank 1: The input has no array "RTData"'),
        ("pairs", OF_PAIRS, None, 'Rank 1: Array "RTData" has 2 components, but 1 on rank 0'),
        ("segments", "", allow_one_segment, "have more than 1 segments on a rank"),
        ("fragments", "", show_translucent, "have more than 1 fragments of translucent objects"),
        ("function", "", remove_nodes, "has an opacity transfer function without nodes"),
    ):
        with relevo.messages() as told:
            source.Script = script(fault=fault)
            if prepare:
                prepare(shown)
            simple.Render(view)
            visible = relevo.foreground(relevo.picture(view))
        found = re.findall(r"vtkAdaptiveVolumeRepresentation \(0x\w+\): (.*)", told())
        is_right = len(found) == 1 and words in found[0]
        is_drawn = visible > 1000 or prepare == remove_nodes
        print(f"{name}: {found}, {visible} pixels", flush=True)
        failed += not is_right or not is_drawn
    clear()
    return failed


def draw_all():
    pictures = {}
    draw_modes(pictures)
    draw_data(pictures)
    draw_others(pictures)
    draw_translucent(pictures)
    return pictures


def count_failures(path, pictures):
    """Every pixel within 2 of 255, except with translucent objects, and 99.9 % within 1."""
    if RANKS == 1:
        own = {name: picture for name, picture in pictures.items() if "/" not in name}
        return relevo.compare_with_one_rank(path, own, {})
    expected = numpy.load(path)
    failed = 0
    for name, picture in pictures.items():
        wanted = expected[name.split(" / ")[0]]
        far, near = (relevo.differing(picture, wanted, tolerance) for tolerance in (2, 1))
        print(f"{RANKS} ranks, {name}: {far} pixels over 2, {near} over 1", flush=True)
        most = TRANSLUCENT if name.startswith("translucent") else EXACT
        failed += far > most[0] or near > most[1]
    return failed


if __name__ == "__main__":
    faults = check_faults() if RANKS == 2 else 0
    pictures = draw_all()
    relevo.clear()
    if count_failures(sys.argv[1], pictures) + faults:
        raise SystemExit(1)
