# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: several ranks show the same as one. The first run, on one rank, writes the
pictures to a file, and compares surfaces in pieces with the same surfaces in one piece:

mpirun -n RANKS pvbatch TestRanks.py FILE.npz"""

import sys

import numpy
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule
from vtkmodules.vtkCommonMath import vtkMatrix4x4

import RelevoParaView as relevo

# Of the 30000 pixels of a picture. ParaView's Surface differs too if ranks are blended.
MOST_PIXELS = 4

# Polygons, a strip, lines and a vertex, distributed over the ranks. Some ranks have one cell or
# none.
SCATTERED = """
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
ranks = controller.GetNumberOfProcesses()
rank = controller.GetLocalProcessId()

size = 9
points = vtkPoints()
for i in range(size * size):
    x, y = i % size, i // size
    points.InsertNextPoint(x, y, ((x * x + 3 * y) % 5) / 3)
points.InsertNextPoint(float("nan"), 0, 0)
quads = [(i, i + 1, i + size + 1, i + size)
         for i in range(size * (size - 1)) if i % size < size - 2]
verts, lines, polys, strips = (vtkCellArray() for _ in range(4))
def add(cells, ids):
    cells.InsertNextCell(len(ids))
    for each in ids:
        cells.InsertCellPoint(each)
players = ranks - 2 if ranks > 2 else 1
for number, ids in enumerate(quads):
    if rank == (ranks - 1 if number == 7 else number % players):
        add(polys, ids)
if rank == 0:
    add(verts, [size * size - 1])
    add(lines, [0, size, 2 * size])
    add(strips, [y * size + x for y in range(size) for x in (size - 2, size - 1)])
    add(polys, [0, 1, size * size])
output = self.GetPolyDataOutput()
output.SetPoints(points)
output.SetVerts(verts)
output.SetLines(lines)
output.SetPolys(polys)
output.SetStrips(strips)
"""

# A bumpy ball as seven pieces, concave, scattered and a single face, which do not share points. In
# one piece if UNCUT. At creases and where texture coordinates turn back, points are split.
BALL = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
ranks = controller.GetNumberOfProcesses()
rank = controller.GetLocalProcessId()

def make(points, faces, **data):
    mesh, coordinates, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetData(numpy_to_vtk(points.astype(numpy.float32), deep=1))
    mesh.SetPoints(coordinates)
    offsets = numpy.arange(0, 3 * len(faces) + 1, 3)
    to_ids = lambda ids: numpy_to_vtk(ids.astype(numpy.int64).ravel(), deep=1)
    cells.SetData(to_ids(offsets), to_ids(faces))
    mesh.SetPolys(cells)
    for name, values in data.items():
        array = numpy_to_vtk(values.astype(numpy.float32), deep=1)
        array.SetName(name)
        getattr(mesh.GetPointData(), "Set" + name)(array)
    return mesh

ball = vtkSphereSource()
ball.SetThetaResolution(SIZE)
ball.SetPhiResolution(SIZE)
ball.SetRadius(1)
ball.Update()
points = vtk_to_numpy(ball.GetOutput().GetPoints().GetData()).astype(float)
faces = vtk_to_numpy(ball.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
x, y, z = points.T
points *= (1 + BUMPS * numpy.sin(3 * x) * numpy.cos(4 * y + z))[:, None]
normals = vtkPolyDataNormals()
normals.SetInputData(make(points, faces))
normals.SetSplitting(CREASES)
normals.SetFeatureAngle(15)
normals.ConsistencyOff()
normals.Update()
mesh = normals.GetOutput()
points = vtk_to_numpy(mesh.GetPoints().GetData())
faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
data = {"Normals": vtk_to_numpy(mesh.GetPointData().GetNormals())}

x, y, z = points.T
middle = points[faces].mean(axis=1)
u = numpy.abs(numpy.arctan2(y, x)) / numpy.pi
v = numpy.arccos(numpy.clip(z / numpy.linalg.norm(points, axis=1), -1, 1)) / numpy.pi
if TURNS_BACK:
    faces = numpy.where((middle[:, 1] < 0)[:, None], faces + len(points), faces)
    points, data["Normals"] = (numpy.tile(each, (2, 1)) for each in (points, data["Normals"]))
    u, v = numpy.concatenate([u, 1 - u]), numpy.tile(v, 2)
data["TCoords"] = numpy.column_stack([u, v])

owners = numpy.floor(3 * (middle[:, 0] + 0.3 * numpy.sin(5 * middle[:, 1]) + 2)).astype(int) % 5
owners[numpy.random.RandomState(3).rand(len(faces)) < 0.05] = 5
owners[17] = 6
append = vtkAppendPolyData()
append.AddInputData(vtkPolyData())
for piece in range(7):
    own = faces[(owners == piece) | UNCUT]
    if piece % ranks == rank and (piece == 0 or not UNCUT):
        used, ids = numpy.unique(own, return_inverse=True)
        piece_data = {name: values[used] for name, values in data.items()}
        append.AddInputData(make(points[used], ids.reshape(-1, 3), **piece_data))
append.Update()
self.GetPolyDataOutput().ShallowCopy(append.GetOutput())
"""


def ball(uncut, size=30, bumps=0.15, creases=False, turns_back=False):
    names = {"UNCUT": uncut, "SIZE": size, "BUMPS": bumps, "CREASES": creases}
    names["TURNS_BACK"] = turns_back
    script = "".join(f"{name} = {value}\n" for name, value in names.items()) + BALL
    return simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=script)


def balls(uncut):
    return {
        "creases": (ball(uncut, bumps=0.5, creases=True), [-2.5, -1.6, 2.1], [0, 0, 0]),
        "mirrored": (ball(uncut), [-2.5, -1.6, 2.1], [0, 0, 0]),
        "turned back": (ball(uncut, turns_back=True), [-2.5, -1.6, 2.1], [0, 0, 0]),
    }


def make_sources():
    """Each source with the camera's position and focal point."""
    wavelet = simple.Wavelet()
    contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])
    field = simple.Calculator(
        Input=contour, ResultArrayName="Field", Function="coordsX*coordsY+coordsZ^2"
    )
    bare = simple.Contour(
        Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[180], ComputeNormals=0
    )
    border = simple.RedistributeDataSet(Input=bare)
    scattered = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=SCATTERED)
    return {
        "contour": (field, [25, 20, 40], [0, 0, 0]),
        "without normals": (border, [20, 16, 32], [0, 0, 0]),
        "scattered": (scattered, [4, 1, 17], [4, 4, 0]),
        **balls(False),
    }


PLAIN = {
    "Metric": "None",
    "MaximumLevel": 2,
    "Surface": "None",
    "Displacement": "None",
    "LevelRule": "Per Vertex",
    "SegmentPolicy": "Powers of Two",
    "TargetNumberOfTriangles": 0,
    "RefinementColorMode": "Scalars",
}


def curved(surface="PN Triangles", **properties):
    """Differences from PLAIN. Dictionaries are properties of the chosen proxies."""
    return {
        "MaximumLevel": 4,
        "Metric": "Edge Length on Screen",
        "of_metric": {"ReferenceLength": 2.0, "Measure": "Projected Length"},
        "Surface": surface,
        **properties,
    }


def metric(name, **properties):
    return curved(Metric=name, RefinementColorMode="Metric", of_metric=properties)


RASTERS = {name: f"{sys.argv[1]}.{name}.png" for name in ("any", "symmetric")}


def write_rasters():
    """129 x 129 heights of 16 bits: any, and symmetric from left to right."""
    v, u = numpy.mgrid[:129, :129] / 128
    waves = numpy.sin(9 * u + 2 * v) * numpy.cos(7 * v) + 0.2 * numpy.sin(40 * v) * numpy.sin(50 * u)
    both = numpy.cos(12 * u - 6) * numpy.cos(7 * v) + 0.2 * numpy.cos(60 * u - 30)
    for name, heights in ("any", waves), ("symmetric", both):
        relevo.write_png(RASTERS[name], (20000 * (heights + 1.3)).astype(numpy.uint16))


def displaced(raster, **properties):
    heights = {"HeightMapFileName": RASTERS[raster], "Scale": 4e-6}
    return curved(Displacement="Height Map", of_displacement=heights, **properties)


CASES = {
    "contour": {
        "flat": {"MaximumLevel": 0},
        "uniform": {"Surface": "PN Triangles"},
        "PN": curved(),
        "Phong": curved("Phong Tessellation"),
        "G1": curved("G1"),
        "procedural": curved("Procedural"),
        "per edge": curved(LevelRule="Per Edge"),
        "whole numbers": curved(SegmentPolicy="Whole Numbers"),
        "displaced": curved(Displacement="Height Map", of_displacement={"Offset": 1.5}),
        "target": curved(TargetNumberOfTriangles=60000, RefinementColorMode="Level"),
        "ball": metric("Edge Length on Screen", Measure="Sphere Diameter"),
        "distance": metric("Distance to the Camera"),
        "mean side": metric("Distance to the Camera", ReferenceLength=8.0),
        "Gaussian": metric("Curvature", CurvatureType="Gaussian"),
        "mean curvature": metric("Curvature", CurvatureType="Mean"),
        "bent": metric("Bent and Seen Edge-On"),
        "angle": metric("Silhouette", Criterion="Normal Angle"),
        "outline": metric("Silhouette", Criterion="Contour"),
        "variation": metric("Variation of an Array", ArrayName="Field"),
        "region": metric("Region", Center=[3.0, 3.0, 3.0], Radius=2.0),
    },
    "without normals": {
        "PN": curved(),
        "G1": curved("G1"),
        "displaced": curved(Displacement="Height Map", of_displacement={"Offset": 0.5}),
        "Gaussian": metric("Curvature", CurvatureType="Gaussian"),
    },
    "scattered": {
        "flat": {"MaximumLevel": 0},
        "PN": curved(),
        "mean curvature": metric("Curvature", CurvatureType="Mean"),
        "outline": metric("Silhouette", Criterion="Contour"),
    },
    "creases": {
        "coarse": {"MaximumLevel": 0, "Surface": "PN Triangles"},
        "uniform": {"Surface": "PN Triangles"},
        "Phong": curved("Phong Tessellation"),
        "displaced": displaced("any"),
    },
    "mirrored": {
        "displaced": displaced("any"),
        "flat": displaced("any", Surface="None", Metric="None", MaximumLevel=2, of_metric={}),
        "mean curvature": displaced("any", Metric="Curvature", of_metric={"CurvatureType": "Mean"}),
    },
    "turned back": {
        "displaced": displaced("symmetric"),
        "flat": displaced("symmetric", Surface="None", Metric="None", MaximumLevel=2, of_metric={}),
    },
}


def set_case(shown, case):
    properties = {**PLAIN, **case}
    for_metric = properties.pop("of_metric", {})
    for_displacement = properties.pop("of_displacement", {})
    relevo.set_properties(shown, properties)
    relevo.set_properties(shown.Metric, for_metric)
    relevo.set_properties(shown.Displacement, for_displacement)


def draw_all(sources):
    pictures = {}
    for name, (source, position, focal_point) in sources.items():
        view = relevo.view((200, 150))
        shown = relevo.show(source, view)
        simple.Render(view)  # ParaView moves the camera in the first frame of a session
        view.CameraPosition = position
        view.CameraFocalPoint = focal_point
        for case, properties in CASES[name].items():
            set_case(shown, properties)
            pictures[f"{name}, {case}"] = relevo.picture(view)
        simple.Delete(view)
    return pictures


def count_triangles():
    """Pictures of still and interactive frames; several ranks draw the latter with fewer pixels."""
    view = relevo.view((200, 150))
    relevo.show(
        relevo.sphere(),
        view,
        MaximumLevel=5,
        TargetNumberOfTriangles=10000,
        UseAllocatedRenderTime=0,
    )
    counts = []
    for render in simple.Render, lambda each: each.InteractiveRender():
        render(view)  # ParaView moves the camera in the first frame of a session
        render(view)
        counts.append(relevo.statistic(view, "NumberOfDrawnTriangles"))
    simple.Delete(view)
    return counts


def keeps_projection():
    """A camera with an explicit projection matrix, in interactive frames."""
    view = relevo.view((200, 150))
    relevo.show(relevo.sphere(), view)
    simple.Render(view)
    camera = view.GetActiveCamera()
    projection = vtkMatrix4x4()
    projection.DeepCopy(camera.GetProjectionTransformMatrix(200 / 150, -1, 1))
    kept = True
    for use in True, False:
        camera.SetExplicitProjectionTransformMatrix(projection)
        camera.SetUseExplicitProjectionTransformMatrix(use)
        view.InteractiveRender()
        kept = kept and camera.GetExplicitProjectionTransformMatrix() is projection
        kept = kept and camera.GetUseExplicitProjectionTransformMatrix() == use
    simple.Delete(view)
    return kept


def compare_with_uncut(pictures):
    """Returns the number of surfaces in pieces that differ from the same in one piece."""
    failed = 0
    for name, uncut in draw_all(balls(True)).items():
        different = relevo.differing(pictures[name], uncut)
        print(f"1 rank, {name}: {different} pixels differ from the uncut surface", flush=True)
        failed += different > MOST_PIXELS
    return failed


def main(path):
    write_rasters()
    still, moving = count_triangles()
    print(f"{still} triangles, {moving} while the view moves", flush=True)
    pictures = draw_all(make_sources())
    failed = relevo.compare_with_one_rank(path, pictures, dict.fromkeys(pictures, MOST_PIXELS))
    if vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() == 1:
        failed += compare_with_uncut(pictures)
    kept = keeps_projection()
    print(f"the camera {'keeps' if kept else 'loses'} its projection", flush=True)
    return failed + (abs(moving - still) > 0.1 * still) + (not kept)


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
