# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: databases of reliefs are read with their time steps, Relief gives the picture
of its mapper in plain VTK, and views show reliefs while they move."""

import os
import re

import numpy
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkActor

import RelevoParaView as relevo
from ReliefData import (
    SIZE,
    move,
    pair,
    passes,
    plain,
    relief,
    write_database,
    write_image,
)

WINDOW = (160, 120)


def mappers(view):
    """The mappers of the visible reliefs of a view, as text."""
    actors = list(view.GetClientSideObject().GetRenderer().GetActors())
    texts = [str(each.GetMapper()) for each in actors if each.GetVisibility()]
    return [text for text in texts if text.startswith("vtkReliefMapper")]


def aim(view):
    view.CameraPosition = [SIZE, -70, -90]
    view.CameraFocalPoint = [SIZE, 0.5 * SIZE, 5]
    view.CameraViewUp = [0, -1, 0]


def new_view():
    """A view without antialiasing, as in plain VTK."""
    view = relevo.view(WINDOW)
    view.UseFXAA = 0
    return view


class TestCase(relevo.TestCase):
    def setUp(self):
        self.folder = self.make_folder()
        self.reliefs = pair()

    def database(self, *arguments, name="my.cdb"):
        return write_database(os.path.join(self.folder, name), *arguments)

    def open(self, *arguments):
        return simple.OpenDataFile(self.database(*(arguments or [self.reliefs])))

    def scene(self, source=None):
        view = new_view()
        shown = simple.Show(source or self.open(), view)
        relevo.picture(view)
        aim(view)
        return view, shown


class TestReading(TestCase):
    def test_picture(self):
        source = self.open()
        self.assertEqual(source.SMProxy.GetXMLName(), "ReliefDatabaseReader")
        view, shown = self.scene(source)
        self.assertEqual(shown.Representation, "Relief")
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs))
        table = os.path.join(self.folder, "my.cdb", "data.csv")
        view, _ = self.scene(simple.ReliefDatabaseReader(FileName=table))
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs))

    def test_time(self):
        """Each time step, also from the cache of an animation."""
        reliefs = [relief(height=h) for h in (1, 3, 5)]
        source = self.open(reliefs, [0.5, 1.5, 4])
        self.assertEqual(list(source.TimestepValues), [0.5, 1.5, 4])
        settings = simple.GetSettingsProxy("GeneralSettings")
        settings.CacheGeometryForAnimation = 1
        self.addCleanup(setattr, settings, "CacheGeometryForAnimation", 0)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        view, _ = self.scene(source)
        pictures = []
        for time, expected in zip((0.5, 1.5, 4, 0.5, 1.5, 4), 2 * reliefs):
            scene.AnimationTime = time
            pictures.append(relevo.picture(view))
            self.assert_alike(pictures[-1], plain(view, [expected]))
        self.assertGreater(relevo.differing(*pictures[:2]), 300)

    def test_bounds(self):
        """The camera fits the surfaces, not the images."""
        view, _ = self.scene()
        low, high = 2, 8  # depths
        bounds = view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds()
        expected = (0, 2 * SIZE + 3, 0, SIZE - 1, low, high)
        numpy.testing.assert_allclose(bounds, expected, atol=0.05)
        simple.ResetCamera(view)
        numpy.testing.assert_allclose(
            view.CameraFocalPoint, [SIZE + 1.5, (SIZE - 1) / 2, 5], atol=0.05
        )

    def test_file_of_one_relief(self):
        """An image of any reader is drawn as Relief on request."""
        path = os.path.join(self.folder, "one.vti")
        write_image(self.reliefs[0], path)
        view, shown = self.scene(simple.OpenDataFile(path))
        self.assertNotEqual(shown.Representation, "Relief")
        shown.Representation = "Relief"
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs[:1]))

    def test_writer(self):
        """A database that ParaView writes has the same reliefs."""
        path = os.path.join(self.folder, "copy.cdb")
        simple.SaveData(path, self.open())
        self.assertTrue(os.path.exists(os.path.join(path, "data.csv")))
        view, _ = self.scene(simple.OpenDataFile(path))
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs))


class TestSettings(TestCase):
    def test_methods(self):
        view, shown = self.scene()
        pictures = []
        for method, search in ((0, 3), (1, 3), (1, 0), (1, 1), (1, 2), (2, 3)):
            shown.ReliefMethod = method
            shown.ReliefSearch = search
            pictures.append(relevo.picture(view))
            self.assertIn(f"Method: {method}\n", mappers(view)[-1])
            self.assertIn(f"Search: {search}\n", mappers(view)[-1])
            expected = plain(view, self.reliefs, Method=method, Search=search)
            self.assert_alike(pictures[-1], expected)
        self.assertGreater(relevo.differing(pictures[0], pictures[1]), 10)

    def test_pictures(self):
        """Each setting changes the picture, and all are equal in plain VTK."""
        view, shown = self.scene()
        for name, own, value in (
            ("MaximumStretch", "MaximumStretch", 1.2),
            ("MaximumStretch", "MaximumStretch", 8),
            ("FillCracks", "FillCracks", 0),
            ("FillCracks", "FillCracks", 1),
        ):
            setattr(shown, name, value)
            self.assert_alike(relevo.picture(view), plain(view, self.reliefs, **{own: value}))

    def test_light(self):
        view, shown = self.scene()
        captured = relevo.picture(view)
        shown.ReliefShading = "Lit"
        lit = relevo.picture(view)
        self.assertGreater(relevo.differing(lit, captured), 2000)
        shown.Ambient = 1
        shown.Diffuse = 0
        self.assert_alike(relevo.picture(view), captured)
        shown.SelfShadow = 1
        self.assertIn("SelfShadow: 1\n", mappers(view)[-1])
        relevo.picture(view)

    def test_transform_and_opacity(self):
        view, shown = self.scene()
        place = {"Position": [0, 5, 10], "Scale": [0.9, 1, 1], "Orientation": [20, 0, 10]}
        relevo.set_properties(shown, place)
        actor = vtkActor()
        actor.SetPosition(0, 5, 10)
        actor.SetScale(0.9, 1, 1)
        actor.SetOrientation(20, 0, 10)
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs, actor))
        shown.Opacity = 0.4
        opaque = relevo.picture(view)
        shown.Opacity = 1
        self.assertGreater(relevo.differing(relevo.picture(view), opaque), 2000)

    def test_blocks(self):
        view, shown = self.scene()
        shown.BlockSelectors = ["/Root/relief0"]
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs[:1]))
        shown.BlockSelectors = ["/"]
        self.assert_alike(relevo.picture(view), plain(view, self.reliefs))

    def test_static_frames(self):
        """A moving camera rebuilds nothing."""
        view, shown = self.scene()
        relevo.picture(view)

        def memory():
            names = "NumberOfBufferBuilds", "NumberOfShaderBuilds"
            return [re.findall(rf"{name}: (\d+)", mappers(view)[-1]) for name in names]

        known = memory()
        self.assertEqual([len(each) for each in known], [1, 1])
        view.GetActiveCamera().Azimuth(20)
        relevo.picture(view)
        self.assertEqual(memory(), known)


class TestSessions(TestCase):
    def change(self, shown):
        shown.ReliefMethod = "Ray March"
        shown.ReliefSearch = "Linear And Binary"
        shown.ReliefShading = "Lit"
        shown.MaximumStretch = 5
        shown.FillCracks = 0
        shown.Opacity = 0.8
        relevo.set_properties(shown, {"Position": [0, 3, 0]})

    def test_large_screenshot(self):
        view, _ = self.scene()
        size = [2 * each for each in WINDOW]
        path = os.path.join(self.folder, "large.png")
        simple.SaveScreenshot(path, view, ImageResolution=size)
        large = relevo.read_png(path)
        view.ViewSize = size
        self.assertEqual(large.shape, (size[1], size[0], 3))
        self.assert_alike(large, relevo.picture(view))

    def test_state_files(self):
        view, shown = self.scene()
        self.change(shown)
        expected = relevo.picture(view)
        script = smstate.get_state()
        path = os.path.join(self.folder, "state.pvsm")
        simple.SaveState(path)
        for load in lambda: simple.LoadState(path), lambda: exec(script, {"__name__": "state"}):
            relevo.clear()
            load()
            view = simple.GetActiveViewOrCreate("RenderView")
            view.UseFXAA = 0  # a setting of the application
            self.assert_alike(relevo.picture(view), expected)

    def test_trace(self):
        smtrace.start_trace()
        view, shown = self.scene()
        with relevo.traced(shown):
            self.change(shown)
        script = smtrace.stop_trace()
        for name in "ReliefDatabaseReader", "ReliefMethod", "MaximumStretch", "FillCracks":
            self.assertIn(name, script)
        expected = relevo.picture(view)
        relevo.clear()
        exec(script, {"__name__": "trace"})
        view = simple.GetActiveView()
        view.ViewSize = WINDOW
        view.OrientationAxesVisibility = 0
        view.UseFXAA = 0
        aim(view)
        self.assert_alike(relevo.picture(view), expected)

    def test_undo(self):
        undo = relevo.Undo()
        self.addCleanup(undo.end)
        view, shown = self.scene()
        pictures = [relevo.picture(view)]
        for name, value in {
            "ReliefMethod": "Warp",
            "ReliefShading": "Lit",
            "MaximumStretch": 4,
            "Representation": "Outline",
        }.items():
            undo.record(name, lambda: setattr(shown, name, value))
            pictures.append(relevo.picture(view))
        for expected in reversed(pictures[:-1]):
            undo.step(undo.stack.Undo)
            self.assert_alike(relevo.picture(view), expected)
        for expected in pictures[1:-1]:
            undo.step(undo.stack.Redo)
            self.assert_alike(relevo.picture(view), expected)


class TestSources(TestCase):
    def test_depth_camera(self):
        """The texels of a picture of depths lie where the calibration says."""
        rows, columns = numpy.mgrid[:30, :40]
        depths = numpy.where(numpy.hypot(columns - 20, rows - 15) < 10, 1500, 2000)
        depths[:, :3] = 0  # no depth
        path = os.path.join(self.folder, "depths.png")
        relevo.write_png(path, depths[::-1].astype(numpy.uint16))
        colors = numpy.stack([6 * columns, 8 * rows, 255 - 6 * rows], axis=-1).astype(numpy.uint8)
        picture = os.path.join(self.folder, "colors.png")
        relevo.write_png(picture, colors[::-1])
        source = simple.DepthImageToRelief(
            Input=simple.PNGSeriesReader(FileNames=[path]),
            Colors=simple.PNGSeriesReader(FileNames=[picture]),
            Intrinsics=[35, 36, 19.5, 14.5],
            DepthScale=0.001,
        )
        view = new_view()
        shown = simple.Show(source, view)
        self.assertEqual(shown.Representation, "Relief")
        view.CameraPosition = [0.3, -0.3, -1]
        view.CameraFocalPoint = [0, 0, 2]
        view.CameraViewUp = [0, -1, 0]
        drawn = relevo.picture(view)
        data = servermanager.Fetch(source)
        self.assert_alike(drawn, plain(view, [data]))
        found = vtk_to_numpy(data.GetPointData().GetArray("Depth")).reshape(30, 40)
        expected = numpy.where(depths > 0, depths * 0.001, numpy.nan)
        numpy.testing.assert_allclose(found[::-1], expected, atol=1e-6)
        bounds = view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds()
        x = [2 * (column - 19.5) / 35 for column in (3, 39)]
        y = [2 * (row - 14.5) / 36 for row in (0, 29)]
        numpy.testing.assert_allclose(bounds, [*x, *y, 1.5, 2], atol=1e-3)

    def test_terrain(self):
        path = os.path.join(self.folder, "heights.png")
        relevo.write_heights(path, 33)
        source = simple.TerrainRelief(FileName=path, Exaggeration=2)
        view = new_view()
        shown = simple.Show(source, view)
        self.assertEqual(shown.Representation, "Relief")
        relevo.picture(view)
        bounds = view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds()
        numpy.testing.assert_allclose(bounds, [-16, 16, -16, 16, 0, 20], atol=1e-3)
        view.CameraPosition = [0, -50, 50]
        view.CameraFocalPoint = [0, 0, 0]
        view.CameraViewUp = [0, 0, 1]
        self.assert_alike(relevo.picture(view), plain(view, [servermanager.Fetch(source)]))


class TestMotion(TestCase):
    """ShowReliefsWhileMoving of a render view."""

    def ball(self, **properties):
        view = new_view()
        ball = simple.Sphere(ThetaResolution=40, PhiResolution=30)
        shown = simple.Show(simple.Elevation(Input=ball), view)
        simple.ColorBy(shown, ("POINTS", "Elevation"))
        shown.SetScalarBarVisibility(view, False)
        relevo.set_properties(shown, properties)
        relevo.picture(view)
        simple.ResetCamera(view)
        relevo.picture(view)
        return view, shown

    def test_frames(self):
        """Moving frames are reliefs of the data, and still frames are the data, to the bit."""
        view, _ = self.ball()
        view.ShowReliefsWhileMoving = 1
        before = relevo.picture(view)
        self.assertEqual(passes(view), (0, 0))
        frames = [move(view, 2) for _ in range(6)]
        captures, shown = passes(view)
        self.assertEqual(shown, 6)
        self.assertLess(captures, 3)
        exact = relevo.picture(view)
        self.assertEqual(passes(view), (captures, shown))
        self.assertGreater(relevo.differing(before, exact), 1000)
        # The frame shows the data from its own camera, and is no frame of the data.
        self.assertLess(relevo.differing(frames[-1], exact, 20), 0.1 * relevo.foreground(exact))
        self.assertGreater(relevo.differing(frames[-1], exact, 0), 0)
        # The next motion uses the same captures.
        move(view)
        self.assertEqual(passes(view), (captures, 7))
        view.ShowReliefsWhileMoving = 0
        self.assertEqual(relevo.differing(relevo.picture(view), exact, 0), 0)
        self.assertEqual(relevo.differing(move(view), exact, 0), 0)
        self.assertEqual(passes(view), (captures, 7))

    def test_changes(self):
        """A change of the data or their colours is captured again."""
        view, shown = self.ball()
        view.ShowReliefsWhileMoving = 1
        relevo.picture(view)
        move(view, 1)
        known = passes(view)[0]
        shown.LookupTable.RescaleTransferFunction(0, 5)
        exact = relevo.picture(view)
        frame = move(view)
        self.assertEqual(passes(view)[0], known + 1)
        self.assertLess(relevo.differing(frame, exact, 20), 0.05 * relevo.foreground(exact))

    def test_settings(self):
        view, _ = self.ball()
        view.ShowReliefsWhileMoving = 1
        view.ReliefMaximumAngle = 1
        view.ReliefMaximumHoleShare = 1
        relevo.picture(view)
        for _ in range(4):
            move(view, 3)
        few = passes(view)[0]
        view.ReliefMaximumAngle = 180
        for _ in range(4):
            move(view, 3)
        self.assertGreater(few, 1)
        self.assertEqual(passes(view)[0], few)

    def test_other_objects(self):
        """Translucent objects and lines are drawn with the reliefs, and not captured."""
        view, _ = self.ball()
        glass = simple.Show(simple.Box(XLength=0.6, YLength=1.4, ZLength=1.4), view)
        glass.Opacity = 0.3
        lines = simple.Show(simple.Sphere(Radius=0.7), view)
        lines.Representation = "Wireframe"
        view.ShowReliefsWhileMoving = 1
        exact = relevo.picture(view)
        frame = move(view)
        self.assertEqual(passes(view), (1, 1))
        self.assertLess(relevo.differing(frame, exact, 20), 0.05 * relevo.foreground(exact))

    def test_level_of_detail(self):
        """The view has no level of detail while reliefs are enabled, but keeps the setting."""
        view, _ = self.ball()
        client = view.GetClientSideObject()
        view.LODThreshold = 0.0
        relevo.picture(view)
        move(view)
        self.assertTrue(client.GetUsedLODForLastRender())
        view.ShowReliefsWhileMoving = 1
        relevo.picture(view)
        move(view)
        self.assertFalse(client.GetUsedLODForLastRender())
        self.assertEqual(view.LODThreshold, 0.0)
        view.ShowReliefsWhileMoving = 0
        relevo.picture(view)
        move(view)
        self.assertTrue(client.GetUsedLODForLastRender())

    def test_sessions(self):
        """State files and traces have the property."""
        smtrace.start_trace()
        view, _ = self.ball()
        with relevo.traced(view):
            view.ShowReliefsWhileMoving = 1
            view.ReliefMaximumAngle = 9
        script = smtrace.stop_trace()
        for assignment in "ShowReliefsWhileMoving *= *1", "ReliefMaximumAngle *= *9":
            self.assertRegex(script, assignment)  # ParaView 6 traces a call of Set()
        path = os.path.join(self.folder, "state.pvsm")
        simple.SaveState(path)
        relevo.clear()
        simple.LoadState(path)
        view = simple.GetActiveViewOrCreate("RenderView")
        self.assertEqual(view.ShowReliefsWhileMoving, 1)
        self.assertEqual(view.ReliefMaximumAngle, 9)
        relevo.picture(view)
        move(view, 1)
        self.assertEqual(passes(view), (1, 1))


class TestBadInput(TestCase):
    """One message for each fault, from the proxy's object."""

    def assert_told(self, make, words, of_class, least=0):
        with relevo.messages() as told:
            view = new_view()
            simple.Show(make(), view).Representation = "Relief"
            relevo.picture(view)
            aim(view)
            for _ in range(2):
                picture = relevo.picture(view)
        found = re.findall(r"(vtk\w+) \(0x\w+\): (.*)", told())
        # ParaView's executives repeat errors of readers and filters, and its geometry filter then
        # misses their output.
        found = [each for each in found if not re.search("Pipeline|vtkPVGeometryFilter", each[0])]
        self.assertEqual(len({text for _, text in found}), 1, told())
        self.assertEqual(found[0][0], of_class)
        self.assertIn(words, found[0][1])
        self.assertGreaterEqual(relevo.foreground(picture), least)
        if not least:
            self.assertEqual(relevo.foreground(picture), 0)

    def test_no_relief(self):
        words = "The image has 5 x 5 x 5 points; a relief has n x m x 1"
        make = lambda: simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 4])
        self.assert_told(make, words, "vtkReliefRepresentation")

    def test_polygons(self):
        words = "A relief must be a vtkImageData, not a vtkPolyData"
        self.assert_told(relevo.sphere, words, "vtkReliefRepresentation")

    def test_no_arrays(self):
        words = "A relief needs the point array 'Color'"
        make = lambda: simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 0])
        self.assert_told(make, words, "vtkReliefRepresentation")

    def test_block_that_is_no_relief(self):
        def make():
            one = simple.OpenDataFile(path)
            other = simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 4], registrationName="Wavelet")
            return simple.GroupDatasets(Input=[one, other])

        path = os.path.join(self.folder, "one.vti")
        write_image(self.reliefs[0], path)
        words = 'Block 2 (Wavelet): The image has 5 x 5 x 5 points'
        self.assert_told(make, words, "vtkReliefRepresentation", 1000)

    def test_damaged_file(self):
        self.database(self.reliefs)
        with open(os.path.join(self.folder, "my.cdb", "1.vti"), "wb") as file:
            file.write(b"<VTKFile")
        make = lambda: simple.OpenDataFile(os.path.join(self.folder, "my.cdb"))
        self.assert_told(make, "1.vti", "vtkReliefDatabaseReader", 1000)

    def test_missing_table(self):
        make = lambda: simple.ReliefDatabaseReader(FileName=os.path.join(self.folder, "none.cdb"))
        self.assert_told(make, "none.cdb", "vtkReliefDatabaseReader")

    def test_missing_raster(self):
        make = lambda: simple.TerrainRelief(FileName=os.path.join(self.folder, "none.png"))
        self.assert_told(make, "none.png", "vtkTerrainReliefSource")

    def test_no_calibration(self):
        path = os.path.join(self.folder, "depths.png")
        relevo.write_heights(path)
        make = lambda: simple.DepthImageToRelief(Input=simple.PNGSeriesReader(FileNames=[path]))
        self.assert_told(make, "neither intrinsics nor a camera", "vtkDepthImageToRelief")


if __name__ == "__main__":
    relevo.main()
