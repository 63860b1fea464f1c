# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: Adaptive Patches gives the picture of its mapper in plain VTK with the error
in pixels, Adaptive Curves draws curves, and both work like ParaView's representations."""

import os

import numpy
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

import RelevoParaView as relevo

DATA = os.environ.get("RELEVO_TEST_DATA", "")
SIZE = (120, 90)

# One curved quadrilateral with two point arrays and one cell array, at different times.
SHEET = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_QUADRILATERAL
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersSources import vtkCellTypeSource
information = self.GetExecutive().GetOutputInformation(0)
time = information.Get(Pipeline.UPDATE_TIME_STEP()) if information.Has(
    Pipeline.UPDATE_TIME_STEP()) else 0
source = vtkCellTypeSource()
source.SetCellType(VTK_LAGRANGE_QUADRILATERAL)
source.SetCellOrder(4)
source.SetBlocksDimensions(CELLS, CELLS, 1)
source.Update()
grid = source.GetOutput()
x, y, z = 4 * vtk_to_numpy(grid.GetPoints().GetData()).astype(float).T / CELLS
points = numpy.column_stack([x + numpy.sin(y) * (1 + time / 4), y + 0.5 * numpy.cos(2 * x), 0 * x])
grid.GetPoints().SetData(numpy_to_vtk(points, deep=1))
def add(data, name, values):
    array = numpy_to_vtk(values, deep=1)
    array.SetName(name)
    data.AddArray(array)
add(grid.GetPointData(), "Field", numpy.sin(2 * x) * numpy.cos(2 * y))
add(grid.GetPointData(), "Vectors", points)
add(grid.GetCellData(), "Number", numpy.arange(grid.GetNumberOfCells()) / 2.0 - 1)
if BAD_CELL:
    values = vtk_to_numpy(grid.GetPoints().GetData())
    values[0] = numpy.nan
self.GetUnstructuredGridOutput().ShallowCopy(grid)
"""
TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetExecutive().GetOutputInformation(0)
information.Set(Pipeline.TIME_STEPS(), [0.0, 1.0, 2.0], 3)
information.Set(Pipeline.TIME_RANGE(), [0.0, 2.0], 2)
"""
# Cubic curves, a quadratic edge and a triangle, which is no curve.
CURVES = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_CURVE, VTK_QUADRATIC_EDGE, VTK_TRIANGLE
grid, points, values = self.GetUnstructuredGridOutput(), vtkPoints(), []
grid.Allocate(10)
def add(cell_type, corners):
    ids = vtkIdList()
    for each in corners:
        ids.InsertNextId(points.InsertNextPoint(*each))
        values.append(each[1])
    grid.InsertNextCell(cell_type, ids)
add(VTK_TRIANGLE, [(0, 9, 0), (1, 9, 0), (0, 10, 0)])
for k in range(4):
    add(VTK_LAGRANGE_CURVE, [(6 * s, 1.5 * k + 2 * numpy.sin(4 * s + k), 0) for s in (0, 1, 1/3, 2/3)])
add(VTK_QUADRATIC_EDGE, [(0, -2, 0), (6, -2, 0), (3, -5, 0)])
grid.SetPoints(points)
array = numpy_to_vtk(numpy.array(values), deep=1)
array.SetName("Field")
grid.GetPointData().AddArray(array)
"""


def sheet(cells=3, bad_cell=False, **properties):
    script = f"CELLS = {cells}\nBAD_CELL = {bad_cell}\n" + SHEET
    return simple.ProgrammableSource(
        OutputDataSetType="vtkUnstructuredGrid",
        Script=script,
        ScriptRequestInformation=TIMES,
        **properties,
    )


def curves():
    return simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid", Script=CURVES)


def find_actor(view):
    """The visible actor of patches in a view."""
    found = list(view.GetClientSideObject().GetRenderer().GetActors())
    return next(
        each
        for each in found
        if each.GetVisibility() and each.GetMapper().IsA("vtkAdaptivePatchMapper")
    )


def plain(view, data, **properties):
    """The picture of the mapper in plain VTK, with the camera, colours and property of a view."""
    proxy = servermanager.ProxyManager().NewProxy("relevo", "AdaptivePatchMapper")
    for each, value in properties.items():
        proxy.GetProperty(each).SetElement(0, value)
    proxy.UpdateVTKObjects()
    theirs = find_actor(view)
    mapper = proxy.GetClientSideObject()
    mapper.SetInputDataObject(data)
    mapper.SetLookupTable(theirs.GetMapper().GetLookupTable())
    mapper.SetUseLookupTableScalarRange(1)
    mapper.SetScalarMode(theirs.GetMapper().GetScalarMode())
    mapper.SetColorMode(theirs.GetMapper().GetColorMode())
    mapper.SetScalarVisibility(theirs.GetMapper().GetScalarVisibility())
    mapper.SetInterpolateScalarsBeforeMapping(
        theirs.GetMapper().GetInterpolateScalarsBeforeMapping()
    )
    mapper.SelectColorArray(theirs.GetMapper().GetArrayName())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().DeepCopy(theirs.GetProperty())
    window = relevo.plain_window(view, actor)
    window.Render()
    return relevo.read_window(window)


def tessellate(data, steps=60):
    """The cells of a grid as fine quadrilaterals, by the cells' own EvaluateLocation()."""
    points, quads = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    position, weights = [0.0] * 3, [0.0] * 100
    for number in range(data.GetNumberOfCells()):
        cell, first = data.GetCell(number), points.GetNumberOfPoints()
        for j in range(steps + 1):
            for i in range(steps + 1):
                cell.EvaluateLocation(reference(0), [i / steps, j / steps, 0], position, weights)
                points.InsertNextPoint(position)
        for j in range(steps):
            for i in range(steps):
                quads.InsertNextCell(4)
                for di, dj in (0, 0), (1, 0), (1, 1), (0, 1):
                    quads.InsertCellPoint(first + (j + dj) * (steps + 1) + i + di)
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(quads)
    return result


def distance(one, other):
    """How far pixels of one mask are from the other: the number of pixels by which both masks must
    grow to contain each other."""

    def grow(mask):
        grown = mask.copy()
        for axis in 0, 1:
            for shift in 1, -1:
                grown |= numpy.roll(mask, shift, axis)
        return grown

    number, first, second = 0, one, other
    while (one & ~second).any() or (other & ~first).any():
        first, second, number = grow(first), grow(second), number + 1
    return number


def mask(picture):
    return (picture != picture[0, 0]).any(axis=2)


class TestCase(relevo.TestCase):
    def setUp(self):
        self.folder = self.make_folder()

    def scene(self, source, array=("POINTS", "Field"), angle=0, **properties):
        view = relevo.view(SIZE)
        view.UseFXAA = 0  # the window of plain VTK has no anti-aliasing
        shown = simple.Show(source, view)
        shown.Representation = "Adaptive Patches"
        if array:
            simple.ColorBy(shown, array)
            shown.RescaleTransferFunctionToDataRange()
        else:
            shown.ColorArrayName = ["POINTS", ""]
        relevo.set_properties(shown, properties)
        relevo.picture(view)
        simple.ResetCamera(view)
        view.GetActiveCamera().Azimuth(angle)
        view.GetActiveCamera().Elevation(0.6 * angle)
        return view, shown

    def assert_changes(self, view, change, least=50):
        before = relevo.picture(view)
        change()
        self.assertGreater(relevo.differing(relevo.picture(view), before), least)


class TestPictures(TestCase):
    def test_plain(self):
        """The mapper draws the same in plain VTK, except for single pixels, as the coarse
        triangles are in another order."""
        cases = {
            "Field": (("POINTS", "Field"), {}),
            "isolines": (("POINTS", "Field"), {"IsolineSpacing": 0.3}),
            "edges": (("POINTS", "Field"), {"PatchEdges": 1}),
            "interpolated": (("POINTS", "Field"), {"ExactScalars": 0}),
            "magnitude": (("POINTS", "Vectors"), {}),
            "cells": (("CELLS", "Number"), {}),
            "grey": (None, {}),
        }
        source = sheet()
        data = relevo.mesh(source)
        pictures = {}
        for name, (array, properties) in cases.items():
            with self.subTest(name):
                view, _ = self.scene(source, array, 20, **properties)
                pictures[name] = relevo.picture(view)
                self.assert_alike(pictures[name], plain(view, data, **properties), 20, tolerance=2)
                simple.Delete(view)
        for name in "isolines", "edges", "interpolated":
            self.assertGreater(relevo.differing(pictures[name], pictures["Field"]), 100, name)

    def test_data(self):
        """Real meshes of quadratic cells, and cells of several types in blocks."""
        files = {
            "result/notch_disp.vtu": ("POINTS", "Nodal Displacement"),
            "result/TriQuadraticHexahedron.vtu": ("CELLS", "material"),
            "result/Disc_BiQuadraticQuads_0_0.vtu": ("POINTS", "origNodeNums"),
            "volume/CylinderQuadratic.vtk": None,
        }
        paths = {os.path.join(DATA, name): array for name, array in files.items()}
        if not os.path.exists(os.path.join(DATA, "volume", "CylinderQuadratic.vtk")):
            self.skipTest("no data")
        for path, array in paths.items():
            with self.subTest(path):
                source = simple.OpenDataFile(path)
                view, _ = self.scene(source, array, 30)
                source.UpdatePipeline()
                data = source.GetClientSideObject().GetOutputDataObject(0)
                self.assert_alike(relevo.picture(view), plain(view, data), 20, tolerance=2)
                simple.Delete(view)

    def test_error(self):
        """The silhouette is as far from that of a fine tessellation as ScreenSpaceError allows."""
        source = sheet(1)
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(tessellate(relevo.mesh(source)))
        view, shown = self.scene(source, None)
        view.GetActiveCamera().Zoom(0.8)
        shown.Visibility = 0
        fine = relevo.show(producer, view, "Surface")
        expected = mask(relevo.picture(view))
        self.assertGreater(expected.sum(), 400)
        fine.Visibility = 0
        shown.Visibility = 1
        triangles, distances = [], []
        for pixels in 0.5, 2.0, 10.0:
            shown.ScreenSpaceError = pixels
            distances.append(distance(mask(relevo.picture(view)), expected))
            triangles.append(relevo.statistic(view, "NumberOfDrawnTriangles"))
            self.assertLessEqual(distances[-1], 1 + numpy.ceil(pixels))
        self.assertLessEqual(distances[0], 1)
        self.assertGreater(distances[2], 2)
        self.assertGreater(triangles[0], 4 * triangles[2])

    def test_linear_cells(self):
        """Linear cells, and faces of other data sets, look like those of Surface."""
        solid = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]))
        polygons = simple.Sphere(ThetaResolution=9, PhiResolution=7)
        both = simple.GroupDatasets(Input=[solid, polygons])
        for source in solid, both:
            views = relevo.view(SIZE), relevo.view(SIZE)
            for view, name in zip(views, ("Surface", "Adaptive Patches")):
                relevo.show(source, view, name)
            simple.ResetCamera(views[0])
            relevo.copy_camera(*views)
            expected, drawn = (relevo.picture(view) for view in views)
            self.assertGreater(mask(expected).sum(), 1000)
            self.assertLessEqual(distance(mask(expected), mask(drawn)), 1)


class TestSettings(TestCase):
    def test_properties(self):
        """Each property changes the picture."""
        view, shown = self.scene(sheet(), PatchEdges=1, IsolineSpacing=0.3)
        for name, value in (
            ("LineWidth", 4),
            ("EdgeColor", [1, 0, 0]),
            ("IsolineSpacing", 0.5),
            ("IsolineWidth", 3),
            ("IsolineColor", [0, 1, 0]),
            ("PatchEdges", 0),
            ("Opacity", 0.4),
            ("Position", [1, 0, 0]),
        ):
            with self.subTest(name):
                self.assert_changes(view, lambda: relevo.set_properties(shown, {name: value}))
        colors = simple.GetColorTransferFunction("Field")
        self.assert_changes(view, lambda: colors.RescaleTransferFunction(-5, 5))
        self.assert_changes(view, lambda: shown.SetScalarBarVisibility(view, True))

    def test_blocks(self):
        left = sheet(registrationName="Left")
        right = simple.Transform(Input=left, registrationName="Right")
        right.Transform.Translate = [8, 0, 0]
        for kind in "vtkMultiBlockDataSet", "vtkPartitionedDataSetCollection":
            with self.subTest(kind):
                both = simple.GroupDatasets(Input=[left, right], OutputType=kind)
                view, shown = self.scene(both)
                everything = relevo.picture(view)
                shown.BlockSelectors = ["/Root/Right"]
                one = relevo.picture(view)
                self.assertGreater(relevo.differing(one, everything), 300)
                self.assertLess(relevo.foreground(one), 0.6 * relevo.foreground(everything))
                shown.BlockSelectors = ["/"]
                self.assert_alike(relevo.picture(view), everything)
                shown.BlockColors = ["/Root/Left", "0", "1", "0"]
                self.assertGreater(relevo.differing(relevo.picture(view), everything), 300)
                simple.Delete(view)

    def test_bounds(self):
        """The bounds contain the curved cells, which reach beyond their nodes."""
        view, _ = self.scene(sheet(1), None)
        bounds = numpy.array(view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds())
        exact = numpy.array(tessellate(relevo.mesh(simple.GetActiveSource())).GetBounds())
        nodes = numpy.array(relevo.mesh(simple.GetActiveSource()).GetBounds())
        sign = numpy.tile([-1, 1], 3)
        self.assertTrue((sign * (exact - nodes) > -1e-9).all() and (exact != nodes).any())
        self.assertTrue((sign * (bounds - exact) > -1e-6).all())
        self.assertLess(abs(bounds - exact).max(), 4.0)

    def test_moving(self):
        """No decimated surface replaces the patches while the view moves."""
        view, shown = self.scene(sheet(), UseAllocatedRenderTime=0)
        view.LODThreshold = 0
        expected = relevo.picture(view)
        view.InteractiveRender()
        self.assert_alike(relevo.drawn(view), expected)


class TestSessions(TestCase):
    def test_time(self):
        """Data that change with time, also from the cache of an animation."""
        view, shown = self.scene(sheet())
        general = simple.GetSettingsProxy("GeneralSettings")
        general.CacheGeometryForAnimation = 1
        self.addCleanup(setattr, general, "CacheGeometryForAnimation", 0)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        pictures = []
        for time in 0, 1, 2, 0, 1, 2:
            scene.AnimationTime = time
            pictures.append(relevo.picture(view))
        for first, second in zip(pictures[:3], pictures[3:]):
            self.assert_alike(first, second)
        self.assertGreater(relevo.differing(*pictures[:2]), 200)

    def test_large_screenshot(self):
        view, shown = self.scene(sheet(), ScreenSpaceError=0.1)
        size = [2 * each for each in SIZE]
        path = os.path.join(self.folder, "large.png")
        simple.SaveScreenshot(path, view, ImageResolution=size)
        large = relevo.read_png(path)
        view.ViewSize = size
        self.assertEqual(large.shape, (size[1], size[0], 3))
        self.assert_alike(large, relevo.picture(view), 20, tolerance=2)

    def change(self, shown):
        shown.ScreenSpaceError = 3.0
        shown.PatchEdges = 1
        shown.IsolineSpacing = 0.5
        shown.IsolineColor = [1.0, 1.0, 0.0]

    def test_state_files(self):
        view, shown = self.scene(sheet())
        self.change(shown)
        expected = relevo.picture(view)
        script = smstate.get_state()
        path = os.path.join(self.folder, "state.pvsm")
        simple.SaveState(path)
        for load in (
            lambda: simple.LoadState(path),
            lambda: exec(script, {"__name__": "state"}),
        ):
            relevo.clear()
            load()
            view = simple.GetActiveViewOrCreate("RenderView")
            view.UseFXAA = 0  # states do not have it
            self.assert_alike(relevo.picture(view), expected)

    def test_trace(self):
        smtrace.start_trace()
        view, shown = self.scene(sheet())
        shown.Representation = "Outline"
        with relevo.traced(shown):
            shown.Representation = "Adaptive Patches"
            self.change(shown)
        script = smtrace.stop_trace()
        for line in "ScreenSpaceError ?= ?3.0", "PatchEdges ?= ?1", "IsolineSpacing ?= ?0.5":
            self.assertRegex(script, line)

    def test_undo(self):
        undo = relevo.Undo()
        self.addCleanup(undo.end)
        view, shown = self.scene(sheet())
        pictures = [relevo.picture(view)]
        for name, value in {"IsolineSpacing": 0.5, "PatchEdges": 1}.items():
            undo.record(name, lambda: setattr(shown, name, value))
            pictures.append(relevo.picture(view))
        for expected in reversed(pictures[:-1]):
            undo.step(undo.stack.Undo)
            self.assert_alike(relevo.picture(view), expected)
        for expected in pictures[1:]:
            undo.step(undo.stack.Redo)
            self.assert_alike(relevo.picture(view), expected)

    def test_selection(self):
        """Cells and points have the ids of Surface."""
        found = []
        source = sheet()
        for name in "Surface", "Adaptive Patches":
            view, shown = self.scene(source, None)
            shown.Representation = name
            relevo.picture(view)
            simple.SetActiveSource(source)
            simple.ClearSelection(source)
            simple.SelectSurfaceCells(View=view, Rectangle=[40, 30, 80, 60])
            selection = servermanager._getPyProxy(source.GetSelectionInput(0))
            found.append(sorted(selection.Input[0].IDs))
            simple.ClearSelection(source)
            simple.Delete(view)
        self.assertGreater(len(found[0]), 3)
        self.assertEqual(*found)


class TestCurves(TestCase):
    def curves(self, **properties):
        view = relevo.view(SIZE)
        shown = relevo.show(curves(), view, "Adaptive Curves", **properties)
        simple.ResetCamera(view)
        return view, shown

    def test_error(self):
        """Lines cover the points of the curves, and few segments miss some."""
        view, shown = self.curves(LineWidth=2)
        relevo.picture(view)
        data = relevo.mesh(simple.GetActiveSource())
        renderer = view.GetClientSideObject().GetRenderer()
        pixels, position, weights = [], [0.0] * 3, [0.0] * 10
        for number in range(1, data.GetNumberOfCells()):
            for step in range(41):
                cell = data.GetCell(number)
                cell.EvaluateLocation(reference(0), [step / 40, 0, 0], position, weights)
                renderer.SetWorldPoint(*position, 1)
                renderer.WorldToDisplay()
                column, row, _ = renderer.GetDisplayPoint()
                pixels.append((int(row), int(column)))
        rows, columns = numpy.array(pixels).T

        def count_missed(error):
            shown.ScreenSpaceError = error
            drawn = mask(relevo.picture(view))
            grown = drawn.copy()
            for axis in 0, 1:
                for shift in 1, -1:
                    grown |= numpy.roll(drawn, shift, axis)
            return int((~grown[rows, columns]).sum())

        self.assertEqual(count_missed(0.5), 0)
        self.assertGreater(count_missed(20), 5)

    def test_properties(self):
        view, shown = self.curves()
        self.assert_changes(view, lambda: setattr(shown, "LineWidth", 4))
        self.assert_changes(view, lambda: setattr(shown, "CurveRepresentation", "Tubes"))
        self.assert_changes(view, lambda: setattr(shown, "Radius", 0.2))
        self.assert_changes(view, lambda: simple.ColorBy(shown, ("POINTS", "Field")))
        self.assert_changes(view, lambda: setattr(shown, "CurveRepresentation", "Ribbons"))
        self.assert_changes(view, lambda: setattr(shown, "Opacity", 0.3))

    def test_lines(self):
        """Polygonal data and blocks of them."""
        names = "Lower", "Upper"
        lines = [
            simple.Line(Point1=[0, y, 0], Point2=[4, y + 1, 0], registrationName=name)
            for y, name in enumerate(names)
        ]
        view = relevo.view(SIZE)
        shown = relevo.show(simple.GroupDatasets(Input=lines), view, "Adaptive Curves", LineWidth=5)
        simple.ResetCamera(view)
        self.assertGreater(relevo.foreground(relevo.picture(view)), 300)
        self.assert_changes(view, lambda: setattr(shown, "BlockSelectors", ["/Root/Upper"]))


class TestBadInput(TestCase):
    """One message of the representation for each fault."""

    def assert_told(self, source, words, name="Adaptive Patches", **properties):
        with relevo.messages() as told:
            view = relevo.view(SIZE)
            relevo.show(source, view, name, **properties)
            for _ in range(2):
                relevo.picture(view)
                simple.ResetCamera(view)
            picture = relevo.picture(view)
        of_class = {"Adaptive Patches": "Patch", "Adaptive Curves": "Curve"}[name]
        self.assert_message(told(), words, f"vtkAdaptive{of_class}Representation")
        return relevo.foreground(picture)

    def test_no_faces(self):
        words = "The data have no 2D or 3D cells"
        self.assertEqual(self.assert_told(simple.Line(), words), 0)

    def test_no_curves(self):
        words = "The data have no line cells"
        self.assertEqual(self.assert_told(sheet(), words, "Adaptive Curves"), 0)

    def test_isolines(self):
        words = "There are no isolines without an array. Select a point array in Coloring."
        self.assertGreater(self.assert_told(sheet(), words, IsolineSpacing=1), 600)
        words = 'no isolines of "Number": a cell array is constant in each cell. Convert it with Cell'
        array = ["CELLS", "Number"]
        self.assert_told(sheet(), words, IsolineSpacing=1, ColorArrayName=array)

    def test_bad_cell(self):
        drawn = self.assert_told(sheet(bad_cell=True), "not finite")
        self.assertGreater(drawn, 600)

    def test_bad_block(self):
        both = simple.GroupDatasets(Input=[sheet(), sheet(bad_cell=True)])
        self.assert_told(both, "Block 2: ")


if __name__ == "__main__":
    relevo.main()
