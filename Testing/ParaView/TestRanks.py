# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: several ranks show the same as one. The first run, on one rank, writes the
pictures to a file:

mpirun -n RANKS pvbatch TestRanks.py FILE.npz"""

import sys

from paraview import simple
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
}


def set_case(shown, case):
    properties = {**PLAIN, **case}
    for_metric = properties.pop("of_metric", {})
    for_displacement = properties.pop("of_displacement", {})
    relevo.set_properties(shown, properties)
    relevo.set_properties(shown.Metric, for_metric)
    relevo.set_properties(shown.Displacement, for_displacement)


def draw_all():
    pictures = {}
    for name, (source, position, focal_point) in make_sources().items():
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


def main(path):
    still, moving = count_triangles()
    print(f"{still} triangles, {moving} while the view moves", flush=True)
    pictures = draw_all()
    failed = relevo.compare_with_one_rank(path, pictures, dict.fromkeys(pictures, MOST_PIXELS))
    kept = keeps_projection()
    print(f"the camera {'keeps' if kept else 'loses'} its projection", flush=True)
    return failed + (abs(moving - still) > 0.1 * still) + (not kept)


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
