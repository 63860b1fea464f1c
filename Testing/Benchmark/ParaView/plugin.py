# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the plugin for ParaView. run.sh in this folder shows the order of the calls.

    [mpirun -n RANKS] pvbatch plugin.py ranks FILE.npz
    [mpirun -n RANKS] pvbatch plugin.py meshes FILE.npz
    mpirun -n RANKS pvbatch plugin.py agreement
    mpirun -n RANKS pvbatch --sym plugin.py interactive SECONDS...
    pvbatch plugin.py plain
    pvbatch plugin.py curved
    pvbatch plugin.py displaced FILE.png
    pvbatch plugin.py raster write|Relevo|ParaView FILE.png

Prints rows of Markdown tables.
"""

import re
import resource
import statistics
import sys
import time

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import RelevoParaView as relevo
from measurement import RANKS, Times, row

SURFACE = "Surface"
REFINED = "Adaptive Refinement"
CURVED = {"MaximumLevel": 3, "Surface": "PN Triangles"}
LEVEL_0 = {"MaximumLevel": 0, "Metric": "None"}


def median_ms(actions, frames=5):
    times = Times(actions, frames)
    return {name: times.wall(name) for name in actions}


def look_from(view, position):
    view.CameraPosition = position
    view.CameraFocalPoint = [0, 0, 0]


def isosurface(half=60):
    """An isosurface of a cube with this many cells from its centre to a side."""
    wavelet = simple.Wavelet(WholeExtent=3 * [-half, half])
    return simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])


def shown_in_view(source, representation=REFINED, **properties):
    """Shows a surface and returns it with its view, whose camera may be moved."""
    view = relevo.view((1280, 800))
    view.UseFXAA = 0
    shown = relevo.show(source, view, representation, **properties)
    simple.Render(view)  # ParaView moves the camera in the first frame of a session
    return shown, view


def over_ranks(operation, number):
    """Reduces a value over all ranks with MAX_OP, MIN_OP or SUM_OP."""
    result = vtkDoubleArray()
    result.SetNumberOfValues(1)
    vtkMultiProcessController.GetGlobalController().AllReduce(
        numpy_to_vtk(numpy.array([float(number)])), result, getattr(vtkCommunicator, operation)
    )
    return result.GetValue(0)


def refined_actor(view):
    actors = view.GetClientSideObject().GetRenderer().GetActors()
    name = "vtkAdaptiveRefinementMapper"
    return next(each for each in actors if each.GetVisibility() and each.GetMapper().IsA(name))


def ranks(path):
    """Compares pictures with those of one rank, and measures frames while the camera moves."""
    contour = isosurface()
    looks = {
        "Surface": (SURFACE, {}),
        "Surface, translucent": (SURFACE, {"Opacity": 0.5}),
        "Refined": (REFINED, CURVED),
        "Refined, translucent": (REFINED, {**CURVED, "Opacity": 0.5}),
        "Level 0": (REFINED, LEVEL_0),
    }
    pictures, times = {}, {}
    for name, (representation, properties) in looks.items():
        _, view = shown_in_view(contour, representation, **properties)
        look_from(view, [120, 90, 180])
        pictures[name] = relevo.picture(view)

        def move(frame, view=view):
            look_from(view, [120 + frame, 90, 180])
            simple.Render(view)

        times.update(median_ms({name: move}))
        simple.Delete(view)
    faces = contour.GetDataInformation().GetNumberOfCells()
    if RANKS == 1:
        numpy.savez(path, **pictures)
    expected = numpy.load(path)
    for name, drawn in pictures.items():
        differing = relevo.differing(drawn, expected[name])
        row(RANKS, f"{name}, {faces} faces", differing, f"{times[name]:.0f} ms")


def meshes(path):
    """Compares the refined pieces of all ranks with the mesh of one rank."""
    contour = isosurface(30)
    contour.UpdatePipeline()
    mesh = simple.AdaptiveRefinement(
        Input=contour, MaximumLevel=3, Metric="Curvature", Surface="PN Triangles"
    )
    start = time.perf_counter()
    mesh.UpdatePipeline()
    seconds = time.perf_counter() - start
    triangles = relevo.corners(mesh, [])
    ordered = relevo.in_order(triangles)
    if RANKS == 1:
        numpy.savez(path, triangles=ordered)
    same = numpy.array_equal(ordered, numpy.load(path)["triangles"])
    row(
        RANKS,
        len(triangles),
        relevo.count_open_edges(triangles),
        "the same" if same else "others",
        f"{seconds:.1f} s",
    )


def agreement():
    """Measures the communication before each frame while the camera moves."""
    contour = isosurface()
    contour.UpdatePipeline()
    faces = contour.GetDataInformation().GetNumberOfCells()
    for name, properties in {
        "Refined": CURVED,
        "Refined, curvature": {**CURVED, "Metric": "Curvature"},
        "Refined, 500000 triangles": {**CURVED, "TargetNumberOfTriangles": 500000},
    }.items():
        _, view = shown_in_view(contour, **properties)
        renderer = view.GetClientSideObject().GetRenderer()
        moments = []

        def note_time(*_, moments=moments):
            moments.append(time.perf_counter())

        for priority in -0.9, -1.1:  # Relevo's observer has -1
            renderer.AddObserver("StartEvent", note_time, priority)

        def move(frame, view=view):
            look_from(view, [120 + frame, 90, 180])
            simple.Render(view)

        frame = median_ms({name: move}, 9)[name]
        agreed = 1000 * statistics.median(numpy.diff(moments)[-17::2])
        row(f"{name}, {faces} faces", f"{agreed:.1f} ms", f"{frame:.0f} ms")
        simple.Delete(view)


def interactive(*seconds):
    """Limits the frame time while the camera moves around a sphere. Level 0 takes the least
    possible time. All ranks must use the same level offset, so that there are no cracks."""
    sphere = simple.Sphere(ThetaResolution=1000, PhiResolution=1001)
    shown, view = shown_in_view(sphere, **LEVEL_0)
    renderer = view.GetClientSideObject().GetRenderer()
    allowed = [1 / 15]  # ParaView's default

    def give_time(*_):
        renderer.SetAllocatedRenderTime(allowed[-1])

    # Runs on all ranks before they agree on levels.
    renderer.AddObserver("StartEvent", give_time, -0.5)

    def move(frame):
        look_from(view, [0.8, 0.1 * frame, 0.8])
        view.SMProxy.InteractiveRender()

    def measure(name):
        frame = median_ms({name: move}, 9)[name]
        triangles = over_ranks("SUM_OP", relevo.statistic(view, "NumberOfDrawnTriangles"))
        mapper = str(refined_actor(view).GetMapper())
        offset = float(re.search(r"\bLevelOffset: (\S+)", mapper).group(1))
        spread = over_ranks("MAX_OP", offset) - over_ranks("MIN_OP", offset)
        asked = 1000 * allowed[-1]
        row(name, f"{asked:.0f} ms", f"{frame:.0f} ms", f"{triangles:.0f}", f"{spread:g}")

    measure("Level 0")
    relevo.set_properties(shown, {**CURVED, "Metric": "Edge Length on Screen"})
    shown.Metric.ReferenceLength = 0.1
    for each in map(float, seconds):
        allowed.append(each)
        measure("Refined")


def plain():
    """Measures frames of ParaView's view and of a VTK window with the same mapper, in turn."""
    for name, source, properties in (
        ("Level 0", isosurface(), LEVEL_0),
        ("Refined", isosurface(), CURVED),
        ("Refined, sphere of 96 faces", simple.Sphere(Radius=100), CURVED),
    ):
        _, view = shown_in_view(source, **properties)
        whole = view.GetClientSideObject().GetRenderer()
        actor, renderer, window = vtkActor(), vtkRenderer(), vtkRenderWindow()
        original = refined_actor(view)
        mapper = original.GetMapper().NewInstance()
        mapper.ShallowCopy(original.GetMapper())
        mapper.SetInputDataObject(original.GetMapper().GetInputDataObject(0, 0))
        actor.SetMapper(mapper)
        actor.SetProperty(original.GetProperty())
        renderer.AddActor(actor)
        renderer.SetBackground(whole.GetBackground())
        renderer.SetActiveCamera(whole.GetActiveCamera())
        renderer.AutomaticLightCreationOff()
        for light in whole.GetLights():
            renderer.AddLight(light)
        window.SetSize(view.ViewSize)
        window.SetMultiSamples(0)
        window.AddRenderer(renderer)

        def in_paraview(frame, view=view):
            look_from(view, [120 + frame, 90, 180])
            simple.Render(view)
            view.GetRenderWindow().WaitForCompletion()

        def in_plain_vtk(_, window=window):
            window.Render()
            window.WaitForCompletion()

        times = median_ms({"ParaView": in_paraview, "VTK": in_plain_vtk}, 9)
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(window)
        grabber.Update()
        differing = relevo.differing(relevo.picture(view), relevo.pixels(grabber.GetOutput()))
        row(name, *(f"{each:.0f} ms" for each in times.values()), differing)
        window.Finalize()
        simple.Delete(view)


# The mesh of Patches/BenchmarkPatchMeshes.cxx.
BENT = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
grid = output.VTKObject
grid.DeepCopy(inputs[0].VTKObject)
x = vtk_to_numpy(grid.GetPoints().GetData()).astype(float).T / 8 - 1
wave = 2 * numpy.pi / (3 / 8)
x = x + 0.15 / 8 * numpy.sin(wave * x[[1, 2, 0]]) * numpy.cos(wave * x[[2, 0, 1]])
cos, sin = numpy.cos(0.4 * x[2]), numpy.sin(0.4 * x[2])
x = numpy.stack([cos * x[0] - sin * x[1], sin * x[0] + cos * x[1], x[2]])
grid.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(x.T), deep=1))
field = numpy.sin(5 * x[0]) + numpy.cos(4 * x[1] + 1) + numpy.sin(3 * x[2] * x[0])
field = numpy_to_vtk(field, deep=1)
field.SetName("Field")
grid.GetPointData().AddArray(field)
"""


def curved():
    """Measures 4096 bent cubic hexahedra as Surface at Nonlinear Subdivision Level 4, and as Adaptive
    Patches, in processor time. Memory is that of the data that the mapper draws, without its
    buffers."""
    cells = simple.UnstructuredCellTypes(BlocksDimensions=[16, 16, 16], CellOrder=3)
    cells.CellType = "Lagrange Hexahedron"
    source = simple.ProgrammableFilter(Input=cells, Script=BENT)
    views, starts, sizes = {}, {}, {}
    for name, properties in {
        "Adaptive Patches": {"ScreenSpaceError": 0.5},
        "Surface": {"NonlinearSubdivisionLevel": 4},
    }.items():
        source.UpdatePipeline()
        start = time.perf_counter()
        view = views[name] = relevo.view((1024, 768))
        view.UseFXAA = 0
        shown = relevo.show(source, view, name, **properties)
        simple.ColorBy(shown, ("POINTS", "Field"))
        shown.SetScalarBarVisibility(view, False)
        simple.Render(view)
        view.GetRenderWindow().WaitForCompletion()
        starts[name] = time.perf_counter() - start
        found = list(view.GetClientSideObject().GetRenderer().GetActors())
        mapped = [each.GetMapper().GetInputDataObject(0, 0) for each in found if each.GetMapper()]
        # Not max(): a programmable filter replaces the built-in function by another of this name.
        sizes[name] = sorted(each.GetActualMemorySize() for each in mapped if each)[-1] / 1024
    for distance in 1.7, 1:

        def move(frame, view, distance=distance):
            look_from(view, [distance * (2.2 + 0.02 * frame), distance * 1.8, distance * 3.4])
            simple.Render(view)
            view.GetRenderWindow().WaitForCompletion()

        moves = {name: lambda frame, view=views[name]: move(frame, view) for name in views}
        times = Times(moves, 9)
        covered = relevo.foreground(relevo.drawn(view)) / (1024 * 768)
        for name in moves:
            row(
                f"{name}, {100 * covered:.0f} % of the pixels",
                f"{1000 * starts[name]:.0f} ms",
                f"{times.wall(name):.0f} ms",
                f"{times.processor(name):.0f} ms",
                f"{times.ratio(name, 'Surface'):.2f}",
                f"{sizes[name]:.2f} MiB",
                f"{sizes[name] / sizes['Surface']:.3f}",
            )


def displaced(path):
    """Measures 512 x 512 heights that are scaled or seen from another side in every frame."""
    simple.LoadPlugin(relevo.find_plugin("EmbossingRepresentations"), remote=False, ns=globals())
    y, x = numpy.mgrid[:512, :512] / 511 - 0.5
    waves = (numpy.sin(12 * x) * numpy.cos(9 * y) + 1) / 2
    relevo.write_png(path, (65535 * waves).astype(numpy.uint16))
    fine = simple.Calculator(
        Input=simple.Plane(XResolution=511, YResolution=511),
        Function="(sin(12*coordsX)*cos(9*coordsY)+1)/2",
    )
    coarse = simple.Plane(XResolution=64, YResolution=64)
    extruded = {"ExtrusionInputDataArray": ["POINTS", "Result"], "ExtrusionNormalizeData": 0}
    refined = {"Displacement": "Height Map", "MaximumLevel": 3}
    looks = {
        "Extrusion Surface": (fine, "Extrusion Surface", extruded),
        "Adaptive Refinement": (coarse, REFINED, refined),
        "Adaptive Refinement, level 3 all over": (coarse, REFINED, {**refined, "Metric": "None"}),
    }
    scaled, moved, bounds = {}, {}, {}
    for name, (source, representation, properties) in looks.items():
        shown, view = shown_in_view(source, representation, **properties)
        if source is coarse:
            shown.Displacement.HeightMapFileName = path
        look_from(view, [0, -1, 1])

        def scale(frame, view=view, shown=shown):
            if shown.Representation == REFINED:
                shown.Displacement.Scale = (0.1 + 0.01 * frame) / 65535
            else:
                shown.ExtrusionFactor = 10 + frame
            simple.Render(view)

        def move(frame, view=view):
            look_from(view, [0.01 * frame, -1, 1])
            simple.Render(view)

        scaled[name], moved[name] = scale, move
        bounds[name] = view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds
    times = median_ms(scaled, 9), median_ms(moved, 9)
    for name in looks:
        heights = " to ".join(f"{height:.3f}" for height in bounds[name]()[4:])
        row(name, f"{times[0][name]:.0f} ms", f"{times[1][name]:.0f} ms", heights)


def raster(way, path):
    """Measures the time from a file of 4096 x 4096 heights, created by `raster write`, to the first
    picture."""
    if way == "write":
        relevo.write_heights(path, 4097)
        return
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.perf_counter()
    view = relevo.view((800, 600))
    if way == "Relevo":
        terrain = simple.TerrainSource(FileName=path, Resolution=64)
        shown = relevo.show(terrain, view, MaximumLevel=6, Displacement="Height Map")
        shown.Displacement.HeightMapFileName = path
        shown.Displacement.AlongNormals = 0
    else:
        image = simple.PNGSeriesReader(FileNames=[path])
        warped = simple.WarpByScalar(Input=image, Scalars=["POINTS", "PNGImage"])
        surface = simple.ExtractSurface(Input=warped)
        relevo.show(simple.GenerateSurfaceNormals(Input=surface), view, SURFACE)
    simple.ResetCamera(view)
    simple.Render(view)
    seconds = time.perf_counter() - start
    more = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    row(way, f"{seconds:.1f} s", f"{more / 2**20:.2f} GiB")


if __name__ == "__main__":
    globals()[sys.argv[1]](*sys.argv[2:])
