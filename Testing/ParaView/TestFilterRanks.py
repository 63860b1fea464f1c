# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: filters give the same result on several ranks as on one, bit for bit. The
first run, on one rank, writes its results to a file:

mpirun -n RANKS pvbatch TestFilterRanks.py FILE.npz"""

import sys

import numpy
from paraview import simple
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
    "creases": {case: CASES[case] for case in ("uniform", "displaced")},
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

# Two pieces on the first rank, one on each other.
PIECES = """
from vtkmodules.vtkCommonDataModel import vtkMultiPieceDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
pieces = vtkMultiPieceDataSet()
for i in range(2 if rank == 0 else 1):
    sphere = vtkSphereSource()
    sphere.SetCenter(i, rank, 0)
    sphere.Update()
    pieces.SetPiece(i, sphere.GetOutput())
self.GetOutputDataObject(0).SetBlock(0, pieces)
"""


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
            source = simple.Calculator(  # ParaView redistributes points as doubles
                Input=simple.ExtractSurface(Input=source),
                CoordinateResults=1,
                Function="coords",
                ResultArrayType="Double",
            )
        if name in CASES_OF_SOURCES:
            sources[name] = source
    sources["blocks"] = simple.GroupDatasets(Input=[sources["contour"], sources["scattered"]])
    return sources


def make_all():
    results = {}
    for name, source in make_sources().items():
        for case, properties in CASES_OF_SOURCES[name].items():
            names = ["Field"] if name == "contour" else []
            triangles = relevo.corners(refine(source, properties), names)
            results[f"{name}, {case}"] = relevo.in_order(triangles)
            results[f"{name}, {case}, open edges"] = numpy.array(relevo.count_open_edges(triangles))
        for rule in "Per Vertex", "Per Edge":
            tags = simple.DepthTags(Input=source, Metric="Curvature", LevelRule=rule)
            results[f"{name}, tags {rule}"] = relevo.in_order(tagged_corners(tags))
    return results


def tagged_corners(tags):
    """Like relevo.corners(), with tags and edge levels, for triangles only."""
    results = []
    # As a block: ParaView 6 loses cell data when it merges pieces one of which is empty.
    for mesh in relevo.leaves(simple.GroupDatasets(Input=[tags])):
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        tag = vtk_to_numpy(mesh.GetPointData().GetArray("DepthTag"))
        levels = mesh.GetCellData().GetArray("EdgeLevels")
        mesh.BuildCells()
        for cell in range(mesh.GetNumberOfCells()):
            if mesh.GetCellType(cell) == 5:  # triangles
                ids = [mesh.GetCell(cell).GetPointId(i) for i in range(3)]
                results.append(
                    numpy.column_stack([points[ids], tag[ids], levels.GetTuple3(cell)])
                )
    return numpy.array(results)


def count_wrong_ids():
    """Refined cells whose vtkOriginalCellIds differ from the ids on their rank."""
    source = TestRanks.make_sources()["scattered"][0]
    numbered = simple.ProgrammableFilter(
        Input=source, OutputDataSetType="vtkPolyData", Script=WITH_IDS
    )
    wrong = 0
    for mesh in relevo.leaves(refine(numbered, CASES["uniform"])):
        own, ids = (mesh.GetCellData().GetArray(name) for name in ("Own", "vtkOriginalCellIds"))
        wrong += numpy.count_nonzero(vtk_to_numpy(own) != vtk_to_numpy(ids))
    return wrong


def goes_on_after_an_error():
    """If an array is missing on one rank, only this rank has an empty output, and it does not wait
    for the others in the next update."""
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


def goes_on_alone():
    """Without a controller, a rank with several pieces does not wait for others."""
    properties = {"Metric": ("metrics", "RegionDepthTagMetric"), "Controller": ("surfaces", "None")}
    make = relevo.define_filter("DepthTagsAlone", "vtkPDepthTagFilter", properties)
    source = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=PIECES)
    tags = make(Input=source, Metric="Region", Controller="None")
    tags.UpdatePipeline()
    return tags.PointData["DepthTag"].GetRange()[1] > 0


def main(path):
    results = make_all()
    ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    failed = ["vtkOriginalCellIds"] if count_wrong_ids() > 0 else []
    failed += [] if goes_on_alone() else ["alone"]
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
    if status:  # otherwise pvbatch ends MPI
        sys.exit(status)
