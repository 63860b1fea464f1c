# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: Adaptive Volume gives the picture of its mapper in plain VTK, and works like
ParaView's Volume."""

import os
import re

import numpy
import vtkmodules.vtkRenderingVolume  # so that Python has the methods of these mappers
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty

import RelevoParaView as relevo

POST = os.path.join(os.environ.get("RELEVO_TEST_DATA", ""), "volume", "post.vtk")
SIZE = (100, 80)


RECTILINEAR = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
image = self.GetInputDataObject(0, 0)
grid = output.VTKObject
grid.SetExtent(image.GetExtent())
for axis, setter in enumerate((grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates)):
    places = vtkDoubleArray()
    for i in range(image.GetExtent()[2 * axis], image.GetExtent()[2 * axis + 1] + 1):
        places.InsertNextValue(i + 0.05 * i * i)
    setter(places)
grid.GetPointData().ShallowCopy(image.GetPointData())
"""
COLORS = """
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
colors = vtkUnsignedCharArray()
colors.SetName("Colors")
colors.SetNumberOfComponents(4)
for i in range(inputs[0].GetNumberOfPoints()):
    colors.InsertNextTuple((255, 20, 0, 200))
output.VTKObject.GetPointData().AddArray(colors)
"""
TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetExecutive().GetOutputInformation(0)
information.Set(Pipeline.TIME_STEPS(), [0.0, 1.0, 2.0], 3)
information.Set(Pipeline.TIME_RANGE(), [0.0, 2.0], 2)
information.Set(Pipeline.WHOLE_EXTENT(), [-4, 4, -3, 3, -3, 3], 6)
"""
SHRINKING = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
information = self.GetExecutive().GetOutputInformation(0)
time = information.Get(Pipeline.UPDATE_TIME_STEP()) if information.Has(
    Pipeline.UPDATE_TIME_STEP()) else 0
size = 4 - int(time)
source = vtkRTAnalyticSource()
source.SetWholeExtent(-size, size, -3, 3, -3, 3)
source.Update()
output.ShallowCopy(source.GetOutput())
"""
BAD_POINT = """
from vtkmodules.vtkCommonCore import vtkPoints
points = vtkPoints()
points.DeepCopy(output.VTKObject.GetPoints())
points.SetPoint(150, float("nan"), 0, 0)
output.VTKObject.SetPoints(points)
"""
BAD_VALUE = """
from vtkmodules.vtkCommonCore import vtkFloatArray
values = vtkFloatArray()
values.DeepCopy(output.VTKObject.GetPointData().GetArray("RTData"))
values.SetValue(7 * 7 * 3 + 7 * 3 + 3, float("nan"))
output.VTKObject.GetPointData().AddArray(values)
"""


def wavelet(**properties):
    return simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3], **properties)


def show(source, view, name="RTData", association="POINTS", component=None, **properties):
    """Shows a source as Adaptive Volume, coloured by an array with the default functions."""
    shown = simple.Show(source, view)
    shown.Representation = "Adaptive Volume"
    color(shown, name, association, component)
    relevo.set_properties(shown, properties)
    return shown


def color(shown, name, association="POINTS", component=None):
    choice = (association, name) if component is None else (association, name, component)
    simple.ColorBy(shown, choice, separate=True)
    shown.RescaleTransferFunctionToDataRange(False, True)


def volumes(view):
    """The visible volumes of a view."""
    found = list(view.GetClientSideObject().GetRenderer().GetVolumes())
    return [each for each in found if each.GetVisibility()]


def settings(view):
    """The mapper of the last volume as text, by names."""
    mapper = volumes(view)[-1].GetMapper()
    found = dict(re.findall(r"^\s*(\w+): (.*)$", str(mapper), re.MULTILINE))
    return {**found, "BlendMode": str(mapper.GetBlendMode())}


def builds(view):
    names = "NumberOfBufferBuilds", "NumberOfShaderBuilds", "NumberOfTableBuilds"
    return [int(settings(view)[name]) for name in names]


def plain_window(view, data, name="RTData", are_cells=False, **properties):
    """A window of plain VTK with the mapper, the camera, the functions and the unit distance of a
    view."""
    proxy = servermanager.ProxyManager().NewProxy("relevo", "AdaptiveVolumeMapper")
    proxy.UpdateVTKObjects()
    for each, value in properties.items():
        proxy.GetProperty(each).SetElement(0, value)
    proxy.UpdateVTKObjects()
    mapper = proxy.GetClientSideObject()
    mapper.SetInputDataObject(data)
    if are_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(name)
    theirs = volumes(view)[-1].GetProperty()
    colors, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
    colors.DeepCopy(theirs.GetRGBTransferFunction())
    colors.SetVectorModeToComponent()
    opacities.DeepCopy(theirs.GetScalarOpacity())
    look = vtkVolumeProperty()
    look.SetColor(colors)
    look.SetScalarOpacity(opacities)
    look.SetScalarOpacityUnitDistance(theirs.GetScalarOpacityUnitDistance())
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(look)
    return relevo.plain_window(view, volume)


def plain(*arguments, **properties):
    """The picture of plain VTK."""
    window = plain_window(*arguments, **properties)
    window.Render()
    return relevo.read_window(window)


class TestCase(relevo.TestCase):
    def setUp(self):
        self.folder = self.make_folder()

    def scene(self, source, *array, **properties):
        view = relevo.view(SIZE)
        shown = show(source, view, *array, **properties)
        relevo.picture(view)
        simple.ResetCamera(view)
        view.GetActiveCamera().Azimuth(30)
        view.GetActiveCamera().Elevation(20)
        return view, shown


class TestPictures(TestCase):
    def assert_plain(self, view, *arguments, **properties):
        self.assert_alike(relevo.picture(view), plain(view, *arguments, **properties))

    def test_every_data_set(self):
        image = wavelet()
        moved = simple.Transform(Input=image)
        moved.Transform.Translate = [7, 0, 0]
        cells = simple.Tetrahedralize(Input=image)
        parts = simple.GroupDatasets(Input=[image, moved])
        kinds = {
            "image": image,
            "structured": moved,
            "rectilinear": simple.ProgrammableFilter(
                Input=image, OutputDataSetType="vtkRectilinearGrid", Script=RECTILINEAR
            ),
            "unstructured": cells,
            "images": simple.GroupDatasets(Input=[image, wavelet(Center=[2, 0, 0])]),
            "blocks of several types": parts,
            "partitions": simple.ConvertToPartitionedDataSetCollection(Input=parts),
        }
        for name, source in kinds.items():
            with self.subTest(name):
                view, _ = self.scene(source)
                self.assert_plain(view, relevo.mesh(source))

    def test_refined_grids(self):
        source = simple.AMRGaussianPulseSource(Dimension=3)
        view, _ = self.scene(source, "Gaussian-Pulse", "CELLS")
        self.assert_plain(view, relevo.mesh(source), "Gaussian-Pulse", True)

    def test_post(self):
        if not os.path.exists(POST):
            self.skipTest("no data")
        source = simple.OpenDataFile(POST)
        view, _ = self.scene(source, "Pressure")
        self.assert_plain(view, relevo.mesh(source), "Pressure")

    def test_arrays(self):
        """Arrays by name and association, components and magnitudes."""
        vectors = simple.Calculator(Input=wavelet(), ResultArrayName="V")
        vectors.Function = "iHat*coordsX+jHat*RTData/50-kHat*coordsZ"
        source = simple.Calculator(Input=vectors, ResultArrayName="X", Function="coordsX")
        source = simple.Calculator(Input=source, ResultArrayName="Length", Function="mag(V)")
        source = simple.Calculator(Input=source, ResultArrayName="Z", Function="V_Z")
        source = simple.PointDatatoCellData(Input=source, PassPointData=1)
        data = relevo.mesh(source)
        view, shown = self.scene(source)
        for arguments, twin in (
            (("X",), ("X", False)),
            (("RTData", "CELLS"), ("RTData", True)),
            (("V", "POINTS", "Magnitude"), ("Length", False)),
            (("V", "POINTS", "Z"), ("Z", False)),
            (("V", "CELLS", "Z"), ("Z", True)),
            (("RTData",), ("RTData", False)),
        ):
            with self.subTest(arguments):
                color(shown, *arguments)
                self.assert_plain(view, data, *twin)
        color(shown, "V", "POINTS", "Magnitude")
        shown.VectorMode = "Component"
        shown.VectorComponent = 2
        for function in shown.LookupTable, shown.ScalarOpacityFunction:
            function.RescaleTransferFunction(-3, 3)  # ParaView follows the magnitudes
        self.assert_plain(view, data, "Z")

    def test_blocks(self):
        left = wavelet(registrationName="Left")
        right = simple.Transform(Input=left, registrationName="Right")
        right.Transform.Translate = [7, 0, 0]
        both = simple.GroupDatasets(Input=[left, right])
        view, shown = self.scene(both)
        shown.ScalarOpacityUnitDistance = 2
        everything = relevo.picture(view)
        self.assertEqual(settings(view)["NumberOfDrawnCells"], "432")
        shown.BlockSelectors = ["/Root/Right"]
        one = relevo.picture(view)
        self.assertEqual(settings(view)["NumberOfDrawnCells"], "216")
        self.assertGreater(relevo.differing(one, everything), 600)
        self.assert_alike(one, plain(view, relevo.mesh(right)))
        shown.BlockSelectors = ["/"]
        self.assert_alike(relevo.picture(view), everything, tolerance=0)


class TestSettings(TestCase):
    def test_properties_reach_the_mapper(self):
        view, shown = self.scene(wavelet())
        for name, value, expected in (
            ("Method", "Cell Projection", "1"),
            ("Method", "Uniform", "0"),  # of Adaptive Refinement
            ("Method", "Cell Projection", "1"),
            ("Method", "Ray Casting", "0"),
            ("Integration", "Pre-Integrated", "1"),
            ("Integration", "Pre-Integrated 2D", "2"),
            ("TableSize", 64, "64"),
            ("BlendMode", 1, "1"),
            ("BlendMode", "Isosurface", "5"),
            ("BlendMode", "Composite", "0"),
            ("MaximumSegments", 100, "100"),
            ("ShapeTolerance", 0.01, "0.01"),
            ("FieldTolerance", 0.1, "0.1"),
            ("IsoSurfaces", 1, "On"),
            ("ImageSampleDistance", 2, "2"),
            ("AutoAdjustSampleDistances", 1, "On"),
        ):
            setattr(shown, name, value)
            relevo.picture(view)
            self.assertEqual(settings(view)[name], expected, name)

    def test_shared_names(self):
        """Method and BlendMode are properties of other representations, too."""
        view, shown = self.scene(simple.Tetrahedralize(Input=wavelet()))
        for mode, text in enumerate(
            ("Composite", "Maximum", "Minimum", "Average", "Additive", "Isosurface")
        ):
            shown.BlendMode = text if mode in (0, 4, 5) else f"{text} Intensity"
            relevo.picture(view)
            self.assertEqual(settings(view)["BlendMode"], str(mode))
        shown.Method = "Cell Projection"
        shown.Representation = "Adaptive Refinement"
        with relevo.messages() as told:
            self.assertGreater(relevo.foreground(relevo.picture(view)), 600)
            shown.Method = "Uniform"
            self.assertGreater(relevo.foreground(relevo.picture(view)), 600)
        self.assertEqual(told(), "")
        self.assertEqual(shown.Method, "Uniform")

    def test_modes_of_volume(self):
        """Maxima and minima are those of ParaView's Volume, which finds them by samples."""
        view, shown = self.scene(simple.Wavelet(WholeExtent=[-15, 15, -15, 15, -15, 15]))
        for shown.BlendMode in 1, 2:
            pictures = []
            for shown.Representation in "Volume", "Adaptive Volume":
                pictures.append(relevo.picture(view))
            self.assert_alike(*pictures, tolerance=6)

    def test_slices(self):
        """ParaView's Volume of images has a mode that Adaptive Volume lacks."""
        with relevo.messages() as told:
            view, shown = self.scene(wavelet())
            expected = relevo.picture(view)
            shown.BlendMode = "Slice"
            for _ in range(2):
                self.assert_alike(relevo.picture(view), expected, tolerance=0)
            shown.Representation = "Volume"
            relevo.picture(view)
        self.assertEqual(told().count("The BlendMode Slice is not available"), 1, told())

    def test_pictures(self):
        """Each setting changes the picture, and all are equal in plain VTK."""
        view, shown = self.scene(wavelet())
        data = relevo.mesh(simple.GetActiveSource())
        before = relevo.picture(view)
        for mode in range(1, 5):
            shown.BlendMode = mode
            picture = relevo.picture(view)
            self.assertGreater(relevo.differing(picture, before), 600, mode)
            self.assert_alike(picture, plain(view, data, BlendMode=mode))
        shown.BlendMode = 0
        shown.Method = "Cell Projection"
        self.assert_alike(relevo.picture(view), plain(view, data, Method=1))
        shown.Method = "Ray Casting"
        self.assert_alike(relevo.picture(view), before, tolerance=0)

    def test_live(self):
        """Edits of the functions and of the property rebuild nothing."""
        view, shown = self.scene(wavelet())
        shown.ClippingPlane = "Plane"
        shown.IsoSurfaces = 1
        shown.IsoSurfaceValues = [150]
        shown.Shade = 1
        pictures = [relevo.picture(view)]
        known = builds(view)
        opacities, colors = shown.ScalarOpacityFunction, shown.LookupTable
        changes = {
            "opacity": lambda: setattr(opacities, "Points", [50, 0, 0.5, 0, 200, 0.4, 0.5, 0]),
            "nodes": lambda: setattr(
                opacities, "Points", [50, 0, 0.5, 0, 120, 0.9, 0.5, 0, 200, 0.1, 0.5, 0]
            ),
            "colours": lambda: setattr(colors, "RGBPoints", [50, 1, 0, 0, 200, 0, 1, 0]),
            "preset": lambda: colors.ApplyPreset("Jet", True),
            "range": lambda: colors.RescaleTransferFunction(60, 180),
            "unit distance": lambda: setattr(shown, "ScalarOpacityUnitDistance", 0.7),
            "light": lambda: setattr(shown, "Ambient", 0.5),
            "isovalue": lambda: setattr(shown, "IsoSurfaceValues", [130, 180]),
            "plane": lambda: setattr(shown.ClippingPlane, "Origin", [0, 0, 1]),
            "normal": lambda: setattr(shown.ClippingPlane, "Normal", [1, 0, 0]),
            "camera": lambda: view.GetActiveCamera().Azimuth(20),
        }
        for name, change in changes.items():
            change()
            pictures.append(relevo.picture(view))
            self.assertGreater(relevo.differing(*pictures[-2:], 0), 100, name)
            self.assertEqual(builds(view), known, name)

    def test_clipping(self):
        view, shown = self.scene(wavelet())
        whole = relevo.foreground(relevo.picture(view))
        shown.ClippingPlane = "Plane"
        shown.ClippingPlane.Origin = [0, 0, 0]
        shown.ClippingPlane.Normal = [0, 1, 0]
        half = relevo.foreground(relevo.picture(view))
        self.assertLess(half, 0.8 * whole)
        self.assertGreater(half, 0.2 * whole)
        shown.ClippingPlane = "None"
        self.assertEqual(relevo.foreground(relevo.picture(view)), whole)

    def test_unit_distance(self):
        """The default follows the data until it is set."""

        def used():
            relevo.picture(view)
            return volumes(view)[-1].GetProperty().GetScalarOpacityUnitDistance()

        source = wavelet()
        view, shown = self.scene(source)
        default = numpy.sqrt(3)  # as all cells are unit cubes
        self.assertAlmostEqual(shown.ScalarOpacityUnitDistance, default, 12)
        self.assertAlmostEqual(used(), default, 12)
        source.WholeExtent = [-3, 3, -2, 2, -1, 1]
        self.assertAlmostEqual(used(), numpy.sqrt(36 + 16 + 4) / numpy.cbrt(6 * 4 * 2), 12)
        shown.ScalarOpacityUnitDistance = 3
        self.assertEqual(used(), 3)
        source.WholeExtent = [-3, 3, -3, 3, -3, 3]
        self.assertEqual(used(), 3)

    def test_opacity_array(self):
        """A separate array for opacity, like that of Volume."""
        source = simple.Calculator(Input=wavelet(), ResultArrayName="X", Function="coordsX*20+100")
        view, shown = self.scene(source)
        one = relevo.picture(view)
        shown.OpacityArrayName = ["POINTS", "X"]
        shown.UseSeparateOpacityArray = 1
        two = relevo.picture(view)
        self.assertGreater(relevo.differing(one, two), 600)
        shown.OpacityArrayName = ["POINTS", "RTData"]
        self.assert_alike(relevo.picture(view), one)

    def test_colours_as_values(self):
        """Arrays of 4 components as colours with opacity."""
        source = simple.ProgrammableFilter(Input=wavelet(), Script=COLORS)
        view, shown = self.scene(source, "Colors")
        shown.MapScalars = 0
        self.assertGreater(relevo.foreground(relevo.picture(view)), 600)
        picture = relevo.picture(view)
        middle = picture[SIZE[1] // 2, SIZE[0] // 2].astype(int)
        self.assertGreater(middle[0], middle[2] + 50)


class TestSessions(TestCase):
    def test_time(self):
        """Data that change with time, also from the cache of an animation."""
        source = simple.ProgrammableSource(
            OutputDataSetType="vtkImageData", Script=SHRINKING, ScriptRequestInformation=TIMES
        )
        view, shown = self.scene(source)
        simple.GetSettingsProxy("GeneralSettings").CacheGeometryForAnimation = 1
        self.addCleanup(
            setattr, simple.GetSettingsProxy("GeneralSettings"), "CacheGeometryForAnimation", 0
        )
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        pictures, distances = [], []
        for time in 0, 1, 2, 0, 1, 2:
            scene.AnimationTime = time
            pictures.append(relevo.picture(view))
            distances.append(volumes(view)[-1].GetProperty().GetScalarOpacityUnitDistance())
            source.UpdatePipeline(time)
            self.assert_alike(pictures[-1], plain(view, relevo.mesh(source)))
        for first, second in zip(pictures[:3], pictures[3:]):
            self.assert_alike(first, second, tolerance=0)
        self.assertEqual(distances[:3], distances[3:])
        self.assertEqual(len(set(distances)), 3)

    def test_large_screenshot(self):
        view, shown = self.scene(wavelet())
        size = [2 * each for each in SIZE]
        relevo.picture(view)
        path = os.path.join(self.folder, "large.png")
        simple.SaveScreenshot(path, view, ImageResolution=size)
        large = relevo.read_png(path)
        view.ViewSize = size
        self.assertEqual(large.shape, (size[1], size[0], 3))
        self.assert_alike(large, relevo.picture(view))

    def change(self, shown):
        shown.Method = "Cell Projection"
        shown.BlendMode = "Composite"
        shown.Integration = "Exact"
        shown.IsoSurfaces = 1
        shown.IsoSurfaceValues = [140, 190]
        shown.ImageSampleDistance = 1
        shown.Shade = 1
        shown.Ambient = 0.4
        shown.ScalarOpacityUnitDistance = 2.5
        shown.ClippingPlane = "Plane"
        shown.ClippingPlane.Origin = [1, 0, 0]
        shown.ClippingPlane.Normal = [1, 1, 0]
        shown.ScalarOpacityFunction.Points = [50, 0, 0.5, 0, 200, 0.6, 0.5, 0]

    def test_state_files(self):
        for make in wavelet, lambda: simple.Tetrahedralize(Input=wavelet()):
            view, shown = self.scene(make())
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
                self.assert_alike(relevo.picture(view), expected, tolerance=0)
                relevo.clear()

    def test_trace(self):
        smtrace.start_trace()
        view, shown = self.scene(wavelet())
        shown.Representation = "Outline"
        with relevo.traced(shown):
            shown.Representation = "Adaptive Volume"
            self.change(shown)
        script = smtrace.stop_trace()
        for name in "Method", "IsoSurfaceValues", "Normal":
            self.assertIn(name, script)
        self.assertRegex(script, "ScalarOpacityUnitDistance ?= ?2.5")
        self.assertNotIn("DefaultScalarOpacityUnitDistance", script)
        camera = view.GetActiveCamera()
        expected = relevo.picture(view)
        place = camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()
        relevo.clear()
        exec(script, {"__name__": "trace"})
        view = simple.GetActiveView()
        view.ViewSize = SIZE
        view.OrientationAxesVisibility = 0
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = place
        self.assert_alike(relevo.picture(view), expected)

    def test_undo(self):
        undo = relevo.Undo()
        self.addCleanup(undo.end)
        view, shown = self.scene(wavelet())
        pictures = [relevo.picture(view)]
        changes = {
            "IsoSurfaces": 1,
            "IsoSurfaceValues": [150],
            "BlendMode": 1,
            "ClippingPlane": "Plane",
            "Representation": "Surface",
        }
        for name, value in changes.items():
            undo.record(name, lambda: setattr(shown, name, value))
            pictures.append(relevo.picture(view))
        for expected in reversed(pictures[:-1]):
            undo.step(undo.stack.Undo)
            self.assert_alike(relevo.picture(view), expected, tolerance=0)
        for expected in pictures[1:]:
            undo.step(undo.stack.Redo)
            self.assert_alike(relevo.picture(view), expected, tolerance=0)

    def test_scalar_bar_and_surface(self):
        """Solid objects hide the volume, and the scalar bar shows its colours."""
        view, shown = self.scene(wavelet())
        shown.SetScalarBarVisibility(view, True)
        with_bar = relevo.picture(view)
        shown.SetScalarBarVisibility(view, False)
        without = relevo.picture(view)
        self.assertGreater(relevo.differing(with_bar, without), 200)
        ball = simple.Show(simple.Sphere(Radius=3), view)
        ball.DiffuseColor = [0, 1, 0]
        self.assertGreater(relevo.differing(relevo.picture(view), without), 500)


class TestBadInput(TestCase):
    """One message of the representation for each fault."""

    def assert_told(self, source, words, *arguments, prepare=None):
        with relevo.messages() as told:
            view = relevo.view(SIZE)
            shown = show(source, view, *arguments)
            if prepare:
                prepare(shown)
            for _ in range(2):
                relevo.picture(view)
                simple.ResetCamera(view)
            picture = relevo.picture(view)
        self.assert_message(told(), words, "vtkAdaptiveVolumeRepresentation")
        return relevo.foreground(picture)

    def test_polygons(self):
        with relevo.messages() as told:
            view = relevo.view(SIZE)
            show(simple.Sphere(), view)
            for _ in range(2):
                relevo.picture(view)
        self.assertEqual(told().count("has no 3D cells"), 1, told())
        self.assertNotIn("No array is selected", told())

    def test_no_array(self):
        drawn = self.assert_told(
            wavelet(),
            "No array is selected. Select one in Coloring",
            prepare=lambda shown: simple.ColorBy(shown, None),
        )
        self.assertEqual(drawn, 0)

    def test_unknown_array(self):
        def choose(shown):
            shown.ColorArrayName = ["POINTS", "Unknown"]

        drawn = self.assert_told(
            wavelet(), 'has no array "Unknown"; select an array in Coloring', prepare=choose
        )
        self.assertEqual(drawn, 0)

    def test_array_of_cells(self):
        def choose(shown):
            shown.ColorArrayName = ["CELLS", "RTData"]

        words = "Select the point array in Coloring"
        self.assertEqual(self.assert_told(wavelet(), words, prepare=choose), 0)

    def test_block_without_array(self):
        bare = simple.PassArrays(Input=wavelet(Center=[7, 0, 0]), registrationName="Bare")
        bare.PointDataArrays = []
        both = simple.GroupDatasets(Input=[wavelet(registrationName="Full"), bare])
        self.assertGreater(self.assert_told(both, 'Block 2 ("Bare") has no array "RTData"'), 600)

    def test_no_solid_cells(self):
        surface = simple.ExtractSurface(Input=wavelet())
        self.assertEqual(self.assert_told(surface, "has no 3D cells"), 0)

    def test_bad_points(self):
        cells = simple.Tetrahedralize(Input=wavelet())
        source = simple.ProgrammableFilter(Input=cells, Script=BAD_POINT, CopyArrays=1)
        self.assertGreater(self.assert_told(source, "points that are not finite"), 600)

    def test_functions(self):
        def remove(shown):
            shown.ScalarOpacityFunction.GetClientSideObject().RemoveAllPoints()

        words = "an opacity transfer function without nodes"
        self.assertEqual(self.assert_told(wavelet(), words, prepare=remove), 0)

    def test_opacity_array(self):
        def choose(shown):
            shown.OpacityArrayName = ["POINTS", "Unknown"]
            shown.UseSeparateOpacityArray = 1

        with relevo.messages() as told:
            view, shown = self.scene(wavelet())
            choose(shown)
            relevo.picture(view)
        self.assertIn('Opacity array "Unknown" must be in every block', told())

    def test_bad_values(self):
        """Cells with NaN are transparent, with one warning."""
        source = simple.ProgrammableFilter(Input=wavelet(), Script=BAD_VALUE, CopyArrays=1)
        with relevo.messages() as told:
            view, shown = self.scene(source)
            self.assertGreater(relevo.foreground(relevo.picture(view)), 600)
            self.assertEqual(settings(view)["NumberOfDrawnCells"], "208")
        words = '8 of 216 cells have values of the array "RTData" that are not finite; they are'
        self.assert_message(told(), words, "vtkAdaptiveVolumeRepresentation")


if __name__ == "__main__":
    relevo.main()
