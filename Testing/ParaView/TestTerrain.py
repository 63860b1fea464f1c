# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: the representation Terrain draws a raster at full resolution."""

import os
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

import RelevoParaView as relevo

SIZE = 65
SPACING = 1.0  # a raster without georeference has one unit per sample


def heights_of_hills(size=SIZE):
    """Whole numbers, which a raster of 16 bits stores, lowest row first."""
    row, column = numpy.mgrid[:size, :size] / (size - 1)
    waves = numpy.sin(7 * column) * numpy.cos(5 * row) + 0.4 * numpy.sin(31 * column * row)
    return numpy.round(6 * waves + 10).astype(numpy.uint16)


def bilinear(heights, x, y):
    """Heights at positions relative to the centre of the raster; NaN outside."""
    size = heights.shape[0]
    column, row = x / SPACING + (size - 1) / 2, y / SPACING + (size - 1) / 2
    inside = (column >= 0) & (column <= size - 1) & (row >= 0) & (row <= size - 1)
    i = numpy.clip(column.astype(int), 0, size - 2)
    j = numpy.clip(row.astype(int), 0, size - 2)
    u, v = column - i, row - j
    values = heights.astype(float)
    low = values[j, i] + u * (values[j, i + 1] - values[j, i])
    high = values[j + 1, i] + u * (values[j + 1, i + 1] - values[j + 1, i])
    return numpy.where(inside, low + v * (high - low), numpy.nan)


def positions(view):
    """World coordinates of the points that the pixels of the latest frame show, rows x columns x 3,
    and whether a pixel shows the background."""
    window = view.GetRenderWindow()
    columns, rows = window.GetSize()
    depths = vtkFloatArray()
    window.GetZbufferData(0, 0, columns - 1, rows - 1, depths)
    depth = vtk_to_numpy(depths).reshape(rows, columns).astype(float)
    camera, to_world = view.GetActiveCamera(), vtkMatrix4x4()
    aspect = view.GetRenderer().GetTiledAspectRatio()
    vtkMatrix4x4.Invert(camera.GetCompositeProjectionTransformMatrix(aspect, 0, 1), to_world)
    matrix = numpy.array([[to_world.GetElement(i, j) for j in range(4)] for i in range(4)])
    row, column = numpy.mgrid[:rows, :columns]
    x, y = 2 * (column + 0.5) / columns - 1, 2 * (row + 0.5) / rows - 1
    points = numpy.einsum("ij,jrc->rci", matrix, numpy.array([x, y, depth, 0 * depth + 1]))
    return points[..., :3] / points[..., 3:], depth >= 1


def terrain_view(**camera):
    view = relevo.view((300, 220))
    view.UseColorPaletteForBackground = 0
    view.Background = [0.1, 0.2, 0.3]
    defaults = {
        "CameraPosition": [10, -75, 60],
        "CameraFocalPoint": [0, 0, 5],
        "CameraViewUp": [0, 0, 1],
    }
    for name, value in {**defaults, **camera}.items():
        setattr(view, name, value)
    return view


class TestTerrain(relevo.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.heights = heights_of_hills()
        cls.raster = cls.path("hills.png")
        relevo.write_png(cls.raster, cls.heights)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    def open(self, name=None, **properties):
        return simple.TerrainReader(FileName=name or self.raster, **properties)

    def show(self, view, source=None, **properties):
        return relevo.show(source or self.open(), view, "Terrain", **properties)

    def bounds(self, view):
        renderer = view.GetRenderer()
        simple.Render(view)
        return numpy.array(renderer.ComputeVisiblePropBounds())

    def test_reader(self):
        """The mesh has the heights of the raster, at the places of its samples."""
        source = self.open(Resolution=SIZE)
        mesh = servermanager.Fetch(source)
        self.assertEqual(mesh.GetNumberOfPoints(), SIZE * SIZE)
        self.assertEqual(mesh.GetNumberOfCells(), 2 * (SIZE - 1) ** 2)
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        heights = vtk_to_numpy(mesh.GetPointData().GetArray("Height"))
        expected = bilinear(self.heights, points[:, 0], points[:, 1])
        numpy.testing.assert_allclose(heights, expected, atol=1e-9)
        numpy.testing.assert_allclose(points[:, 2], expected, atol=1e-9)
        triangles = relevo.corners(source, [])[..., :3]
        sides = triangles[:, 1:] - triangles[:, :1]
        self.assertTrue((numpy.cross(sides[:, 0], sides[:, 1])[:, 2] > 0).all())
        small = servermanager.Fetch(self.open(Resolution=20))
        self.assertLess(small.GetNumberOfPoints(), 20 * 20 + 1)

    def test_border(self):
        """Small meshes end where the raster ends, and have its heights there, too."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hills.png")
            heights = heights_of_hills()[:47, :62]
            relevo.write_png(path, heights)
            for resolution in 2, 3, 17, 30, 31, 32:
                mesh = servermanager.Fetch(simple.TerrainReader(FileName=path, Resolution=resolution))
                points = vtk_to_numpy(mesh.GetPoints().GetData())
                found = [*points.min(axis=0)[:2], *points.max(axis=0)[:2]]
                numpy.testing.assert_allclose(found, [-30.5, -23, 30.5, 23], atol=1e-9)
                self.assertLessEqual(len(numpy.unique(points[:, 0])), resolution)
                column, row = (points[:, :2] + [30.5, 23]).round().astype(int).T
                numpy.testing.assert_allclose(points[:, 2], heights[row, column], atol=1e-9)

    def test_clamp(self):
        """Heights at full resolution, at any points and along lines."""
        source = self.open(Resolution=5)
        corners = [-20.25, 10.5, 3, 17, -30.75, 0]
        line = simple.Line(Point1=corners[:3], Point2=corners[3:], Resolution=7)
        clamp = simple.TerrainClamp(Input=line, Terrain=source, Exaggeration=2, Offset=0.5)
        mesh = servermanager.Fetch(clamp)
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        self.assertGreater(len(points), 40)  # one at each edge of the surface
        expected = bilinear(self.heights, points[:, 0], points[:, 1])
        numpy.testing.assert_allclose(points[:, 2], 2 * expected + 0.5, atol=1e-6)
        heights = vtk_to_numpy(mesh.GetPointData().GetArray("Height"))
        numpy.testing.assert_allclose(heights, expected, atol=1e-6)
        ends = points[[points[:, 0].argmin(), points[:, 0].argmax()], :2]
        numpy.testing.assert_allclose(ends, [corners[:2], corners[3:5]], atol=1e-6)

    def test_opens_as_terrain(self):
        """Terrain is the default, with the bounds of all samples."""
        view = relevo.view()
        source = self.open(Resolution=9)
        shown = simple.Show(source, view)
        self.assertEqual(shown.Representation, "Terrain")
        half = (SIZE - 1) / 2
        expected = [-half, half, -half, half, self.heights.min(), self.heights.max()]
        numpy.testing.assert_allclose(self.bounds(view), expected, atol=1e-6)

    def test_heights(self):
        """Each pixel shows the surface of full resolution, within ScreenSpaceError pixels."""
        view = terrain_view()
        for error, factor in ((1, 1), (0.25, 1), (1, 3)):
            shown = self.show(view, ScreenSpaceError=error, Exaggeration=factor)
            relevo.picture(view)
            points, is_background = positions(view)
            points = points[~is_background]
            self.assertGreater(len(points), 10000)
            distance = points[:, 2] - factor * bilinear(self.heights, points[:, 0], points[:, 1])
            eye = numpy.linalg.norm(points - view.CameraPosition, axis=1)
            angle = numpy.radians(view.GetActiveCamera().GetViewAngle())
            pixels = numpy.abs(distance) * view.ViewSize[1] / (2 * numpy.tan(angle / 2) * eye)
            print("error", error, "exaggeration", factor, "largest", numpy.nanmax(pixels))
            self.assertLessEqual(numpy.nanmax(pixels), 1.02 * error)
            simple.Delete(shown)

    def test_colours(self):
        """Height is mapped by ParaView's colour map, at each pixel."""
        view = terrain_view()
        source = self.open(Resolution=9)
        shown = self.show(view, source, Ambient=1.0, Diffuse=0.0)
        simple.ColorBy(shown, ("POINTS", "Height"))
        low, high = int(self.heights.min()), int(self.heights.max())
        table = shown.LookupTable
        table.RGBPoints = [low, 1, 0, 0, high, 0, 0, 1]
        table.ColorSpace = "RGB"
        picture = relevo.picture(view)
        points, is_background = positions(view)
        heights = bilinear(self.heights, points[..., 0], points[..., 1])
        # Not at borders, and not where the mean over a pixel differs.
        inner = ~is_background & ~numpy.isnan(heights)
        share = (heights[inner] - low) / (high - low)
        difference = numpy.abs(picture[inner][:, 2] / 255 - share)
        self.assertLess(numpy.median(difference), 0.01)
        self.assertLess(numpy.quantile(difference, 0.98), 0.06)
        simple.ColorBy(shown, None)
        self.assertGreater(relevo.differing(relevo.picture(view), picture), 10000)

    def test_slope_and_aspect(self):
        """A plane has one slope and one aspect."""
        column = numpy.mgrid[:33, :33][1]
        name = self.path("plane.png")
        relevo.write_png(name, column.astype(numpy.uint16))
        source = self.open(name)
        mesh = servermanager.Fetch(source)
        slopes = vtk_to_numpy(mesh.GetPointData().GetArray("Slope"))
        aspects = vtk_to_numpy(mesh.GetPointData().GetArray("Aspect"))
        numpy.testing.assert_allclose(slopes, 45, atol=1e-4)
        numpy.testing.assert_allclose(aspects, 270, atol=1e-3)  # falls to the west
        view = terrain_view(CameraPosition=[0, 0, 90], CameraViewUp=[0, 1, 0])
        shown = self.show(view, source, Ambient=1.0, Diffuse=0.0)
        for array, value in (("Slope", 45), ("Aspect", 270)):
            simple.ColorBy(shown, ("POINTS", array))
            shown.LookupTable.ColorSpace = "RGB"
            shown.LookupTable.RGBPoints = [0, 0, 0, 0, 2 * value, 1, 1, 1]
            picture = relevo.picture(view)
            numpy.testing.assert_allclose(picture[110, 150], 128, atol=2, err_msg=array)

    def test_images(self):
        """Hillshade, imagery and the values of another raster."""
        photo = numpy.zeros((64, 64, 3), numpy.uint8)
        photo[:, :32] = 255, 0, 0
        photo[:, 32:] = 0, 255, 0
        relevo.write_png(self.path("photo.png"), photo)
        values = numpy.zeros((64, 64), numpy.uint8)
        values[:, 32:] = 200
        relevo.write_png(self.path("values.png"), values)
        view = terrain_view(CameraPosition=[0, 0, 160], CameraViewUp=[0, 1, 0])
        shown = self.show(view, Ambient=1.0, Diffuse=0.0)
        plain = relevo.picture(view)
        shown.ImageryFileName = self.path("photo.png")
        self.assertEqual(relevo.differing(relevo.picture(view), plain, 0), 0)
        shown.TerrainColorMode = "Imagery"
        picture = relevo.picture(view)
        self.assertEqual(picture[110, 130].tolist(), [255, 0, 0])
        self.assertEqual(picture[110, 170].tolist(), [0, 255, 0])
        shown.TerrainColorMode = "Hillshade"
        grey = relevo.picture(view)[80:140, 120:180].astype(int)
        self.assertEqual(numpy.abs(grey - grey[..., :1]).max(), 0)
        self.assertGreater(grey.std(), 5)
        shown.ColorRasterFileName = self.path("values.png")
        shown.TerrainColorMode = "Raster"
        picture = relevo.picture(view).astype(int)
        self.assertGreater(numpy.abs(picture[110, 130] - picture[110, 170]).max(), 100)

    def test_contours(self):
        view = terrain_view()
        shown = self.show(view)
        plain = relevo.picture(view)
        set_to = {"ContourInterval": 4, "ContourWidth": 2, "ContourColor": [1, 0, 0]}
        relevo.set_properties(shown, set_to)
        lines = relevo.picture(view)
        changed = numpy.abs(lines.astype(int) - plain).max(axis=2) > 60
        self.assertGreater(changed.sum(), 500)
        red = lines[changed]
        self.assertGreater((red[:, 0] > 1.5 * red[:, 1].astype(int)).mean(), 0.9)
        points = positions(view)[0][changed]
        heights = bilinear(self.heights, points[:, 0], points[:, 1])
        off = numpy.abs((heights + 2) % 4 - 2)
        self.assertLess(numpy.nanmedian(off), 0.5)

    def test_bounds(self):
        """The view's bounds follow exaggeration, base, transform and coordinates."""
        view = terrain_view()
        source = self.open()
        shown = self.show(view, source, Exaggeration=2.0, UseBase=1, BaseHeight=-5)
        high = 2 * int(self.heights.max())
        numpy.testing.assert_allclose(self.bounds(view)[4:], [-10, high], atol=1e-6)
        simple.ResetCamera(view)
        self.assertAlmostEqual(view.CameraFocalPoint[2], (high - 10) / 2, 4)
        shown.Scale, shown.Origin = [2, 1, 1], [4, 0, 0]
        relevo.set_properties(shown, {"Position": [1, 2, 3]})
        half = (SIZE - 1) / 2
        expected = [5 - 2 * half - 8, 5 + 2 * half - 8, 2 - half, 2 + half, -7, high + 3]
        numpy.testing.assert_allclose(self.bounds(view), expected, atol=1e-6)
        source.Coordinates = "Raster"
        centre = SIZE / 2
        expected = [2 * centre - 3 - 2 * half, 2 * centre - 3 + 2 * half]
        numpy.testing.assert_allclose(self.bounds(view)[:2], expected, atol=1e-6)

    def test_raster_coordinates(self):
        """The terrain and the mesh move to the coordinates of the raster together."""
        view = terrain_view()
        source = self.open()
        self.show(view, source)
        centered = relevo.picture(view)
        source.Coordinates = "Raster"
        offset = servermanager.Fetch(source).GetFieldData().GetArray("Offset").GetTuple3(0)
        self.assertEqual(offset, (SIZE / 2, SIZE / 2, 0))
        low = servermanager.Fetch(source).GetBounds()[0]
        self.assertAlmostEqual(low, 0.5)
        for name in ("CameraPosition", "CameraFocalPoint"):
            setattr(view, name, list(numpy.array(getattr(view, name)) + offset))
        moved = relevo.picture(view)
        self.assertLess(relevo.differing(moved, centered, 3), 30)

    def test_background(self):
        """With LoadingMode Background, frames end in the complete picture."""
        view = terrain_view()
        shown = self.show(view)
        complete = relevo.picture(view)
        simple.Delete(shown)
        shown = self.show(view, LoadingMode="Background")
        frames = [relevo.picture(view)]
        while relevo.differing(frames[-1], complete) > 0 and len(frames) < 200:
            frames.append(relevo.picture(view))
        self.assertLess(len(frames), 200)

    def test_background_of_interactor(self):
        """A view with an interactor renders again until all tiles are drawn."""
        view = terrain_view()
        shown = self.show(view)
        complete = relevo.picture(view)
        simple.Delete(shown)
        interactor, timers = vtkGenericRenderWindowInteractor(), []
        interactor.TimerEventResetsTimerOff()
        interactor.AddObserver("CreateTimerEvent", lambda *_: timers.append(True))
        view.SMProxy.SetupInteractor(interactor)
        self.show(view, LoadingMode="Background")
        view.StillRender()
        self.assertTrue(timers)
        for _ in range(200):
            if not timers:
                break
            timers.clear()
            interactor.TimerEvent()
        self.assertFalse(timers)
        self.assertEqual(relevo.differing(relevo.drawn(view), complete), 0)

    def test_large_picture(self):
        """A screenshot that is larger than the window has more detail, without seams."""
        view = terrain_view()
        self.show(view)
        small, large = self.path("small.png"), self.path("large.png")
        simple.SaveScreenshot(small, view, ImageResolution=[300, 220])
        simple.SaveScreenshot(large, view, ImageResolution=[1200, 880])
        small, large = relevo.read_png(small), relevo.read_png(large)
        self.assertEqual(large.shape[:2], (880, 1200))
        mean = large.reshape(220, 4, 300, 4, 3).mean(axis=(1, 3))
        self.assertLess(numpy.median(numpy.abs(mean - small)), 4)

    def test_state(self):
        view = terrain_view()
        self.show(view, Exaggeration=2, ContourInterval=3, TerrainColorMode="Hillshade")
        expected = relevo.picture(view)
        simple.SaveState(self.path("state.pvsm"))
        relevo.clear()
        simple.LoadState(self.path("state.pvsm"))
        view = simple.GetActiveViewOrCreate("RenderView")
        source = next(iter(simple.GetSources().values()))
        shown = simple.GetRepresentation(source, view)
        self.assertEqual(shown.Representation, "Terrain")
        self.assertEqual(shown.ContourInterval, 3)
        self.assertEqual(relevo.differing(relevo.picture(view), expected), 0)


class TestErrors(relevo.TestCase):
    """Each problem is reported once, in words of ParaView."""

    def reported(self, act):
        with relevo.messages() as text:
            act()
        return text()

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "text.tif")
            with open(name, "w", encoding="utf-8") as file:
                file.write("no raster")
            for path, word in (("/no/such.tif", "such.tif"), (name, "text.tif"), ("", "FileName")):
                view = relevo.view()
                source = simple.TerrainReader(FileName=path)
                text = self.reported(lambda: (simple.Show(source, view), simple.Render(view)))
                self.assertEqual(text.count("ERROR:"), 1, text)
                self.assertIn(word, text)

    def test_missing_values(self):
        """Missing samples do not enlarge the bounds; a raster without data gives one warning."""
        with tempfile.TemporaryDirectory() as folder:
            some = "104 103 102 -9 105 106 107 108 109 110 111 112"
            for values, lowest in ((some, 102), (12 * "-9 ", None)):
                path = os.path.join(folder, f"{lowest}.asc")
                with open(path, "w", encoding="utf-8") as file:
                    file.write("ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n")
                    file.write(f"NODATA_value -9\n{values}\n")
                source = simple.TerrainReader(FileName=path)
                text = self.reported(source.UpdatePipeline)
                if lowest:
                    self.assertEqual(text, "")
                    self.assertEqual(source.GetDataInformation().GetBounds()[4], lowest)
                else:
                    self.assertIn("has no surface", text)

    def test_other_data(self):
        view = relevo.view()
        sphere = relevo.sphere()
        text = self.reported(lambda: (relevo.show(sphere, view, "Terrain"), simple.Render(view)))
        self.assertIn("Terrain Reader", text)
        self.assertEqual(text.count("ERROR:"), 1, text)

    def test_settings(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hills.png")
            relevo.write_png(path, heights_of_hills())
            source = simple.TerrainReader(FileName=path)
            view = terrain_view()
            shown = relevo.show(source, view, "Terrain")
            relevo.picture(view)
            for name, value, word in (
                ("ImageryFileName", "/no/photo.png", "/no/photo.png"),
                ("BaseHeight", 1e6, "BaseHeight"),
            ):
                shown.TerrainColorMode = "Imagery" if name == "ImageryFileName" else "Coloring"
                shown.UseBase = int(name == "BaseHeight")
                setattr(shown, name, value)
                text = self.reported(lambda: (relevo.picture(view), relevo.picture(view)))
                self.assertIn(word, text)
                self.assertEqual(text.count("ERROR:"), 1, text)
            shown.UseBase = 0
            shown.Exaggeration = 1e9
            text = self.reported(lambda: (relevo.picture(view), relevo.picture(view)))
            self.assertEqual(text.count("With an Exaggeration of 1e+09, the terrain is"), 1, text)
            shown.Exaggeration = 5
            self.assertEqual(self.reported(lambda: relevo.picture(view)), "")
            with self.assertRaises(Exception):
                shown.TerrainColorMode = "Unknown"

    def test_clamp(self):
        line = simple.Line()
        text = self.reported(simple.TerrainClamp(Input=line, Terrain=line).UpdatePipeline)
        self.assertEqual(text.count("Terrain is not the output of a Terrain Reader."), 1, text)
        self.assertEqual(text.count("ERROR:"), 1, text)

    def test_photo(self):
        """A picture is read as heights, with a warning. A smooth grey picture may be heights."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "photo.png")
            for components, expected in ((4, 1), (3, 1), (1, 0)):
                values = numpy.add.outer(numpy.arange(72), numpy.arange(96))
                values = numpy.repeat(values[:, :, None], components, axis=2)
                relevo.write_png(path, values.astype(numpy.uint8))
                view = relevo.view()
                source = simple.TerrainReader(FileName=path)
                text = self.reported(
                    lambda: (relevo.show(source, view, "Terrain"), relevo.picture(view))
                )
                self.assertEqual(text.count("has three or more bands of bytes"), expected, text)
                self.assertEqual(text.count("In vtk"), expected, text)
                relevo.clear()


if __name__ == "__main__":
    relevo.main()
