# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Filters on several ranks make what they make on one, to the bit. The first run, on one rank, writes
that to a file:

mpirun -n RANKS pvbatch TestFilterRanks.py FILE.npz
"""

import sys

import numpy
from paraview import servermanager, simple
from paraview.modules.vtkRemotingCore import vtkProcessModule
from vtkmodules.util.numpy_support import vtk_to_numpy

import RelevoParaView as relevo
import TestRanks

CASES = {
    "uniform": {"MaximumLevel": 1, "Surface": "PN Triangles"},
    "curvature": {"Metric": "Curvature", "Surface": "PN Triangles"},
    "region": {"Metric": "Region", "of_metric": {"Center": [3, 3, 3], "Radius": 2}},
    "per edge": {"Metric": "Curvature", "LevelRule": "Per Edge", "Surface": "G1"},
    "displaced": {
        "MaximumLevel": 1,
        "Surface": "Phong Tessellation",
        "Displacement": "Height Map",
        "of_displacement": {"Offset": 0.5},
    },
}
VARIATION = {
    "Metric": "Variation of an Array",
    "of_metric": {"ArrayName": "Field"},
    "SegmentPolicy": "Whole Numbers",
    "Surface": "G1",
}
CASES_OF_SOURCES = {
    "contour": {**CASES, "variation": VARIATION},
    "without normals": {case: CASES[case] for case in ("curvature", "displaced")},
    "scattered": {case: CASES[case] for case in ("uniform", "curvature", "per edge")},
    "blocks": {"curvature": CASES["curvature"]},
}

WITHOUT_FIELD = """
from vtkmodules.vtkParallelCore import vtkMultiProcessController
output = self.GetPolyDataOutput()
output.ShallowCopy(self.GetPolyDataInput())
if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1:
    output.GetPointData().RemoveArray("Field")
"""

WITH_IDS = """
from vtkmodules.vtkCommonCore import vtkIdTypeArray
output = self.GetPolyDataOutput()
output.ShallowCopy(self.GetPolyDataInput())
ids = vtkIdTypeArray()
ids.SetName("Own")
for cell in range(output.GetNumberOfCells()):
    ids.InsertNextValue(cell)
output.GetCellData().AddArray(ids)
"""


def leaves(source):
    """The meshes of all ranks."""
    data = servermanager.Fetch(source)
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    result = []
    while not iterator.IsDoneWithTraversal():
        result.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return result


def corners(source, names):
    """Triangles x 3 corners x coordinates and point data."""
    results = []
    for mesh in leaves(source):
        data = [mesh.GetPoints().GetData(), *map(mesh.GetPointData().GetArray, names)]
        points = numpy.column_stack([vtk_to_numpy(each) for each in data])
        ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
        results.append(points[ids].reshape(-1, 3, points.shape[1]))
    return numpy.concatenate(results)


def in_order(triangles):
    """Each with its smallest corner first, and they in order: whoever has them, and as what."""
    corner = numpy.unique(triangles.reshape(-1, triangles.shape[2]), axis=0, return_inverse=True)[1]
    first = corner.reshape(-1, 3).argmin(axis=1)
    turns = (first[:, None] + numpy.arange(3)) % 3
    turned = numpy.take_along_axis(triangles, turns[:, :, None], axis=1)
    rows = turned.reshape(len(triangles), -1)
    return rows[numpy.lexsort(rows.T[::-1])]


def count_open_edges(triangles):
    """Edges that a single triangle has, by coordinates."""
    points = triangles[:, :, :3].reshape(-1, 3)
    ids = numpy.unique(points, axis=0, return_inverse=True)[1].reshape(-1, 3)
    edges = numpy.sort(numpy.concatenate([ids[:, [0, 1]], ids[:, [1, 2]], ids[:, [2, 0]]]), axis=1)
    return numpy.count_nonzero(numpy.unique(edges, axis=0, return_counts=True)[1] == 1)


def refine(source, case):
    properties = dict(case)
    for_metric = properties.pop("of_metric", {})
    for_displacement = properties.pop("of_displacement", {})
    mesh = simple.AdaptiveRefinement(Input=source)
    relevo.set_properties(mesh, properties)
    relevo.set_properties(mesh.Metric, for_metric)
    relevo.set_properties(mesh.Displacement, for_displacement)
    return mesh


def make_sources():
    sources = {}
    for name, (source, _, _) in TestRanks.make_sources().items():
        if name == "without normals":
            source = simple.Calculator(  # what ParaView distributes has points of type double
                Input=simple.ExtractSurface(Input=source),
                CoordinateResults=1,
                Function="coords",
                ResultArrayType="Double",
            )
        sources[name] = source
    sources["blocks"] = simple.GroupDatasets(Input=[sources["contour"], sources["scattered"]])
    return sources


def make_all():
    results = {}
    for name, source in make_sources().items():
        for case, properties in CASES_OF_SOURCES[name].items():
            triangles = corners(refine(source, properties), ["Field"] if name == "contour" else [])
            results[f"{name}, {case}"] = in_order(triangles)
            results[f"{name}, {case}, open edges"] = numpy.array(count_open_edges(triangles))
        for rule in "Per Vertex", "Per Edge":
            tags = simple.DepthTags(Input=source, Metric="Curvature", LevelRule=rule)
            results[f"{name}, tags {rule}"] = in_order(tagged_corners(tags))
    return results


def tagged_corners(tags):
    """Like corners(), with tags and the levels of edges; of triangles alone."""
    results = []
    # As a block: ParaView 6 loses cell data where it puts pieces together one of which is empty.
    for mesh in leaves(simple.GroupDatasets(Input=[tags])):
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        tag = vtk_to_numpy(mesh.GetPointData().GetArray("DepthTag"))
        levels = mesh.GetCellData().GetArray("EdgeLevels")
        mesh.BuildCells()
        for cell in range(mesh.GetNumberOfCells()):
            if mesh.GetCellType(cell) == 5:  # a triangle
                ids = [mesh.GetCell(cell).GetPointId(i) for i in range(3)]
                results.append(
                    numpy.column_stack([points[ids], tag[ids], levels.GetTuple3(cell)])
                )
    return numpy.array(results)


def count_wrong_ids():
    """Refined cells whose vtkOriginalCellIds are not the ids that they had on their rank."""
    source = TestRanks.make_sources()["scattered"][0]
    numbered = simple.ProgrammableFilter(
        Input=source, OutputDataSetType="vtkPolyData", Script=WITH_IDS
    )
    wrong = 0
    for mesh in leaves(refine(numbered, CASES["uniform"])):
        own, ids = (mesh.GetCellData().GetArray(name) for name in ("Own", "vtkOriginalCellIds"))
        wrong += numpy.count_nonzero(vtk_to_numpy(own) != vtk_to_numpy(ids))
    return wrong


def goes_on_after_an_error():
    """Where an array is missing on one rank, that rank alone has no output, and does not wait for the
    others when the pipeline is updated again."""
    source = TestRanks.make_sources()["contour"][0]
    broken = simple.ProgrammableFilter(
        Input=source, OutputDataSetType="vtkPolyData", Script=WITHOUT_FIELD
    )
    counts = []
    for each in source, broken:
        mesh = refine(each, VARIATION)
        mesh.UpdatePipeline()
        simple.ExtractSurface(Input=mesh).UpdatePipeline()
        counts.append(mesh.GetDataInformation().GetNumberOfCells())
    return 0 < counts[1] < counts[0]


def main(path):
    results = make_all()
    ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    failed = ["vtkOriginalCellIds"] if count_wrong_ids() > 0 else []
    if ranks == 1:
        numpy.savez(path, **results)
        failed += [name for name, result in results.items() if result.size == 0]
    else:
        failed += [] if goes_on_after_an_error() else ["after an error"]
        expected = numpy.load(path)
        failed += [
            name
            for name in results
            if not numpy.array_equal(results[name], expected[name], equal_nan=True)
        ]
    print(f"{ranks} ranks, {len(results)} meshes and tags, failed: {failed}", flush=True)
    return len(failed)


if __name__ == "__main__":
    status = main(sys.argv[1])
    if status:  # else pvbatch ends MPI
        sys.exit(status)
