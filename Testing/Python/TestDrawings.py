# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves python.md: one line draws a terrain, a refined surface, a volume, curved cells, streaks,
streamlines, reliefs, micro-meshes and intersections, with the picture of relevo-view."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import warnings
from unittest import mock

from DrawingData import (
    BOUNDS,
    count_colours,
    make_block,
    make_curved_block,
    make_heights,
    make_sphere,
    numpy,
    read_picture,
    relevo,
)
from relevo import _legend
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkIOImage import vtkTIFFWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridWriter
from vtkmodules.vtkRenderingCore import (
    vtkCamera,
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
)

SIZE = (320, 200)
VIEWER = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin/relevo-view"


def write(writer, path, mesh):
    writer.SetFileName(str(path))
    writer.SetInputData(mesh)
    writer.Write()
    return path


def make_cone():
    cone = vtkConeSource()
    cone.SetHeight(2)
    cone.SetResolution(20)
    cone.Update()
    return cone.GetOutput()


class TestDrawings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def make_all(self):
        return {
            "terrain": relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326"),
            "refined": relevo.refined(make_sphere(), surface="pn", metric="curvature"),
            "volume": relevo.volume(make_block(), "DistanceToCenter"),
            "patches": relevo.patches(make_curved_block(), warp="Shift", edges=True),
            "lic": relevo.lic(make_sphere(), "V"),
            "streamlines": relevo.streamlines(make_sphere(), "V"),
            "relief": relevo.relief(make_heights()),
            "micromesh": relevo.micromesh(make_sphere(), tolerance="2%"),
            "intersection": relevo.intersection(make_sphere(), make_cone()),
        }

    def test_pictures(self):
        """Every function draws without options, into an array and a file, top row first."""
        for name, drawing in self.make_all().items():
            with self.subTest(name):
                path = self.folder / f"{name}.png"
                picture = drawing.screenshot(path, size=SIZE)
                self.assertEqual((picture.shape, picture.dtype), ((200, 320, 3), numpy.uint8))
                self.assertTrue(picture.flags.c_contiguous and picture.flags.owndata)
                numpy.testing.assert_array_equal(read_picture(path), picture)
                self.assertGreater(count_colours(picture), 200)
                # The object is in the middle, and the background is a vertical gradient.
                background = picture[:, -1].astype(int)
                self.assertGreater(numpy.abs(picture[100, 160] - background[100]).max(), 10)
                numpy.testing.assert_array_equal(drawing.screenshot(size=SIZE), picture)
                self.assertTrue(drawing._repr_png_().startswith(b"\x89PNG"))

    def test_objects(self):
        """The wrapped classes are reachable."""
        classes = {
            "terrain": "vtkTerrainMapper",
            "refined": "vtkAdaptiveRefinementMapper",
            "volume": "vtkGPUUnstructuredGridVolumeMapper",
            "patches": "vtkAdaptivePatchMapper",
            "lic": "vtkAdaptiveLICMapper",
            "relief": "vtkReliefMapper",
            "micromesh": "vtkAdaptiveRefinementMapper",
            "streamlines": "vtkAdaptiveRefinementMapper",
            "intersection": "vtkPolyDataMapper",
        }
        for name, drawing in self.make_all().items():
            self.assertTrue(drawing.mapper.IsA(classes[name]), name)
            self.assertTrue(drawing.actor.IsA("vtkProp3D"), name)
            has_recipe = name in ("refined", "patches", "lic", "micromesh", "streamlines")
            self.assertEqual(hasattr(drawing, "recipe"), has_recipe, name)
        self.assertEqual(relevo.refined(make_sphere(), max_level=2).recipe.GetMaximumLevel(), 2)

    def test_lighting(self):
        """Without lighting, colours do not depend on normals."""
        drawing = relevo.refined(make_sphere(), surface="pn", lighting=False)
        picture = drawing.screenshot(size=SIZE).reshape(-1, 3)
        wanted = numpy.rint(255 * numpy.array((0.80, 0.78, 0.74)))
        self.assertGreater((abs(picture - wanted).max(axis=1) <= 1).mean(), 0.2)
        for make, values in (
            (lambda own: relevo.terrain(make_heights(), lighting=own), (True, False)),
            (lambda own: relevo.lic(make_sphere(), "V", lighting=own), (True, False)),
            (lambda own: relevo.patches(make_curved_block(), lighting=own), (True, False)),
            (lambda own: relevo.relief(make_heights(), lighting=own), (None, False)),
            (lambda own: relevo.volume(make_block(), lighting=own), (None, True)),
        ):
            first, second = (make(own).screenshot(size=SIZE).astype(int) for own in values)
            self.assertGreater(abs(first - second).max(), 10)

    def test_meshes(self):
        for name, drawing in self.make_all().items():
            self.assertGreater(drawing.mesh().GetNumberOfPoints(), 0, name)
        refined = relevo.refined(make_sphere(), metric="curvature", max_level=3).mesh()
        self.assertGreater(refined.GetNumberOfCells(), make_sphere().GetNumberOfCells())
        self.assertTrue(refined.GetPointData().HasArray("V"))

    def test_meshes_of_cameras(self):
        """A nearer camera has more triangles."""
        drawing = relevo.refined(make_sphere())
        cells = []
        for distance in (40, 4):
            camera = vtkCamera()
            camera.SetPosition(0, 0, distance)
            cells.append(drawing.mesh(camera).GetNumberOfCells())
        self.assertLess(*cells)
        terrain = relevo.terrain(make_heights(), bounds=BOUNDS, crs=4326)
        self.assertGreater(terrain.mesh((180, 60)).GetNumberOfCells(), 100)

    def test_cameras(self):
        drawing = relevo.refined(make_cone())
        front, side = (drawing.screenshot(size=SIZE, camera=view) for view in ((0, 0), (90, 0)))
        self.assertTrue((front != side).any())
        camera = vtkCamera()
        camera.SetPosition(0, 0, 9)
        picture = drawing.screenshot(size=SIZE, camera=camera)
        self.assertEqual(camera.GetPosition(), (0, 0, 9))
        self.assertTrue((picture != drawing.screenshot(size=SIZE)).any())

    def test_vertical_axes(self):
        """Each axis can be the one that points upwards in the picture."""
        for name, make in (
            ("refined", lambda up: relevo.refined(make_cone(), up=up)),
            ("volume", lambda up: relevo.volume(make_block(), up=up)),
            ("patches", lambda up: relevo.patches(make_curved_block(), up=up)),
            ("lic", lambda up: relevo.lic(make_sphere(), up=up)),
        ):
            for axis in range(3):
                up = make("xyz"[axis])._make_camera((30, 10)).GetViewUp()
                self.assertEqual(int(numpy.argmax(up)), axis, name)
        heights = make_heights()
        turned = [relevo.refined(make_sphere(), height=heights, up=up).mesh() for up in "yz"]
        self.assertNotEqual(turned[0].GetBounds(), turned[1].GetBounds())

    def test_same_as_relevo_view(self):
        """Levels, material, lights, view and legend are those of relevo-view, up to rounding."""
        if not VIEWER.exists():
            self.skipTest("built without relevo-view")
        sphere = write(vtkPLYWriter(), self.folder / "sphere.ply", make_sphere(16))
        coarse = write(vtkPLYWriter(), self.folder / "coarse.ply", make_sphere(7))
        block = write(vtkXMLUnstructuredGridWriter(), self.folder / "b.vtu", make_block())
        curved = write(vtkXMLUnstructuredGridWriter(), self.folder / "c.vtu", make_curved_block())
        heights = self.folder / "heights.tif"
        write(vtkTIFFWriter(), heights, relevo.arrays.image(make_heights() // 100))
        cases = [
            (relevo.refined(sphere), [sphere], 0),
            (relevo.refined(coarse), [coarse], 0),
            (relevo.refined(sphere, up="x"), [sphere, "--up", "x"], 0),
            (relevo.refined(sphere, up="z"), [sphere, "--up", "z"], 0),
            (
                relevo.refined(sphere, surface="phong", max_level=3, metric="distance"),
                [sphere, "--surface", "phong", "--max-level", "3", "--metric", "distance"],
                0,
            ),
            (relevo.volume(block), [block, "--volume", "DistanceToCenter"], 1),
            (
                relevo.patches(curved, scalars="DistanceToCenter", edges=True, isolines=6),
                [curved, "--array", "DistanceToCenter", "--patch-edges", "--isolines", "6"],
                0,
            ),
            (relevo.terrain(heights), [heights], 0),
            (relevo.terrain(heights, exaggeration=3), [heights, "--exaggeration", "3"], 0),
        ]
        for drawing, options, tolerance in cases:
            with self.subTest(options=options):
                path = self.folder / "viewer.png"
                command = [VIEWER, *options, "--size", "320x200", "--output", path]
                run = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(run.returncode, 0, run.stderr)
                difference = drawing.screenshot(size=SIZE).astype(int) - read_picture(path)
                # Cameras differ by rounding, which can change single pixels of an edge.
                others = (numpy.abs(difference) > tolerance).any(axis=2)
                self.assertLess(others.sum(), 5)

    def test_colour_bars(self):
        """A bar has the range and the unit of the values, and does not cover the object."""
        drawing = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
        table, title = drawing._get_legend()
        self.assertEqual(title, "Height [m]")
        low, high = table.GetRange()
        self.assertAlmostEqual(low, float(make_heights().min()), places=2)
        self.assertAlmostEqual(high, float(make_heights().max()), places=2)
        self.assertIsNone(relevo.refined(make_sphere())._table)
        self.assertEqual(relevo.lic(make_sphere(), "V")._title, "V (magnitude)")
        patches = relevo.patches(make_curved_block(), scalars="DistanceToCenter")
        own = vtkLookupTable()
        patches.mapper.SetLookupTable(own)
        self.assertIs(patches._get_legend()[0], own)
        patches.mapper.ScalarVisibilityOff()
        self.assertIsNone(patches._get_legend()[0])
        grid = make_block()
        scalars = grid.GetPointData().GetArray("DistanceToCenter")
        scalars.GetInformation().Set(scalars.UNITS_LABEL(), "mm")
        self.assertEqual(relevo.volume(grid)._title, "DistanceToCenter [mm]")
        shown = relevo.volume(grid)
        picture = shown.screenshot(size=SIZE)
        shown._table = None
        self.assertTrue((picture[:, :40] != shown.screenshot(size=SIZE)[:, :40]).any())

    def test_tolerances_of_curved_cells(self):
        block = make_curved_block()
        mapper = relevo.volume(block).mapper
        self.assertEqual((mapper.GetShapeTolerance(), mapper.GetFieldTolerance()), (5e-4, 4e-3))
        mapper = relevo.volume(block, shape_tolerance=1e-3, field_tolerance=1).mapper
        self.assertEqual((mapper.GetShapeTolerance(), mapper.GetFieldTolerance()), (1e-3, 1.0))
        for name in ("shape_tolerance", "field_tolerance"):
            for value, error in ((0, ValueError), (2, ValueError), ("1", TypeError)):
                with self.assertRaisesRegex(error, f"^{name} must be"):
                    relevo.volume(block, **{name: value})

    def test_titles_of_colour_bars(self):
        """Titles break between words; long words break after joining characters, if possible."""
        font = _legend._make_font()
        for title, lines in (
            ("Height [m]", ["Height [m]"]),
            ("displacement (magnitude)", ["displacement", "(magnitude)"]),
            ("surface_temperature_of_water [K]", ["surface_", "temperature_", "of_water [K]"]),
            ("", [""]),
        ):
            self.assertEqual(_legend._wrap(title, font, 110), (lines, True))
        lines, is_whole = _legend._wrap("W" * 40, font, 110)
        self.assertFalse(is_whole)
        self.assertEqual("".join(lines), "W" * 40)
        self.assertTrue(all(_legend._get_size(line, font)[0] <= 110 for line in lines))
        text = _legend._set_title("Word " * 200, font, 110)
        self.assertEqual((len(text.split("\n")), text[-4:]), (6, "\n..."))

    def test_tables_of_colour_bars(self):
        table = vtkLookupTable()
        table.SetRange(1, 10000)
        self.assertEqual([text for _, text in _legend._make_rows(table, 20)], ["1", "10000"])
        table.SetScaleToLog10()
        labels = [text for _, text in _legend._make_rows(table, 200)]
        self.assertEqual(labels, ["1", "10", "100", "1000", "10000"])
        table.IndexedLookupOn()
        table.SetAnnotation(1, "water")
        table.SetAnnotation(2, "sand")
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 0, 0, 1)
        table.SetTableValue(1, 1, 1, 0)
        self.assertEqual(_legend._make_rows(table, 200), [(0.25, "water"), (0.75, "sand")])
        self.assertEqual(_legend._get_colour(table, 0.25), [0, 0, 1])
        self.assertEqual(_legend._get_colour(table, 0.75), [1, 1, 0])
        self.assertEqual(len(_legend.make_legend(table, "Ground", (320, 200))[0]), 5)
        self.assertEqual(_legend.make_legend(table, "Ground", (239, 200)), ([], (0, 0)))

    def test_colours_of_terrains(self):
        """Each colour mode has its own table and colour bar, unless the caller sets a table."""
        drawing = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
        mapper = drawing.mapper
        by_height = drawing.screenshot(size=SIZE)
        mapper.SetColorModeToSlope()
        by_slope = drawing.screenshot(size=SIZE)
        table, title = drawing._get_legend()
        self.assertEqual((title, table.GetRange()), ("Slope [degrees]", (0, 90)))
        mapper.SetColorModeToHillshade()
        drawing.screenshot(size=SIZE)
        self.assertEqual(drawing._get_legend()[1], "Hillshade")
        mapper.SetColorModeToSolid()
        drawing.screenshot(size=SIZE)
        self.assertIsNone(drawing._get_legend()[0])
        mapper.SetColorModeToElevation()
        numpy.testing.assert_array_equal(drawing.screenshot(size=SIZE), by_height)
        mapper.SetColorModeToSlope()
        numpy.testing.assert_array_equal(drawing.screenshot(size=SIZE), by_slope)
        own = vtkColorTransferFunction()
        own.AddRGBPoint(0, 0, 0, 1)
        own.AddRGBPoint(60, 1, 0, 0)
        mapper.SetLookupTable(own)
        self.assertTrue((drawing.screenshot(size=SIZE) != by_slope).any())
        self.assertIs(mapper.GetLookupTable(), own)

    def test_meshes_of_terrains(self):
        """A mesh has the base and the frame of the mapper."""
        drawing = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326", exaggeration=2)
        view = drawing._make_camera(None)
        surface = drawing.mesh(view)
        drawing.mapper.UseBaseOn()
        drawing.mapper.SetBaseHeight(-1000)
        solid = drawing.mesh(view)
        self.assertAlmostEqual(solid.GetBounds()[4], -2000)
        self.assertGreater(solid.GetNumberOfCells(), 2 * surface.GetNumberOfCells())
        drawing.mapper.UseBaseOff()
        drawing.mapper.SetFrameToGeocentric()
        globe = drawing.mesh()
        self.assertGreater(globe.GetNumberOfCells(), 100)
        radii = numpy.linalg.norm(vtk_to_numpy(globe.GetPoints().GetData()), axis=1)
        self.assertTrue(((radii > 6.36e6) & (radii < 6.39e6)).all())
        self.assertFalse(globe.GetFieldData().HasArray("Origin"))
        # The viewer is above the terrain, not above the equator's plane.
        position = numpy.array(drawing._make_camera(None).GetPosition())
        self.assertGreater(numpy.linalg.norm(position), radii.max())
        picture = drawing.screenshot(size=SIZE)
        self.assertGreater(count_colours(picture), 200)
        away = vtkCamera()
        away.SetPosition(0, -2e7, 0)
        away.SetFocalPoint(0, -3e7, 0)
        with self.assertRaisesRegex(relevo.Error, "sees no part of the terrain"):
            drawing.mesh(away)

    def test_elevation(self):
        heights = make_heights()
        terrain = relevo.terrain(heights, bounds=BOUNDS, crs="EPSG:4326")
        west, east, south, north = BOUNDS
        rows, columns = heights.shape
        lon = west + (numpy.arange(columns) + 0.5) * (east - west) / columns
        lat = north - (numpy.arange(rows) + 0.5) * (north - south) / rows
        found = terrain.elevation(lon[None, :], lat[:, None])
        self.assertEqual(found.shape, heights.shape)
        numpy.testing.assert_allclose(found, heights, atol=0.01)
        self.assertIsInstance(terrain.elevation(86.9, 28.0), float)
        outside = terrain.elevation([86.9, 80.0, numpy.nan], [28.0, 28.0, 28.0])
        self.assertEqual(numpy.isnan(outside).tolist(), [False, True, True])
        self.assertEqual(terrain.elevation([], []).shape, (0,))
        self.assertTrue(numpy.isnan(terrain.elevation(86.9, 95.0)))
        for bad in ("86.9", None, [1j], numpy.array([1], object)):
            with self.assertRaisesRegex(TypeError, "lon must be real numbers"):
                terrain.elevation(bad, 28.0)
        with self.assertRaises(ValueError):
            terrain.elevation([1, 2, 3], [1, 2])

    def test_elevation_of_projected_rasters(self):
        """Longitude and latitude are converted to metres of UTM."""
        ramp = numpy.tile(numpy.arange(100.0), (80, 1))
        terrain = relevo.terrain(ramp, bounds=(400000, 500000, 4400000, 4480000), crs="EPSG:32613")
        # The zone's meridian, 105 degrees west, is at x = 500 km, on the border.
        self.assertTrue(numpy.isnan(terrain.elevation(-104.9, 40.0)))
        west, east = terrain.elevation([-105.8, -105.2], 40.0)
        self.assertAlmostEqual(east - west, 0.6 * 85.39, delta=0.3)  # km
        plain = relevo.terrain(ramp)
        self.assertAlmostEqual(plain.elevation(10.5, 40.5), 10.0)

    def test_terrain_is_complete(self):
        """Pictures wait for all tiles."""
        terrain = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
        terrain.screenshot(size=SIZE)
        self.assertLessEqual(terrain.mapper.GetScreenSpaceErrorInUse(), 1.0)

    def test_volume_options(self):
        grid = make_block()
        pictures = {}
        for blend in ("composite", "maximum", "minimum", "average", "additive", "isosurface"):
            pictures[blend] = relevo.volume(grid, blend=blend).screenshot(size=SIZE)
        for name, picture in pictures.items():
            self.assertTrue(
                all((picture != other).any() for key, other in pictures.items() if key != name)
            )
        plain = pictures["composite"]
        nodes = [(0, 1, 0, 0, 0.1), (4, 0, 0, 1, 0.9)]
        path = self.folder / "nodes.txt"
        numpy.savetxt(path, nodes)
        from_array = relevo.volume(grid, transfer=nodes).screenshot(size=SIZE)
        numpy.testing.assert_array_equal(
            relevo.volume(grid, transfer=path).screenshot(size=SIZE), from_array
        )
        for drawing in (
            relevo.volume(grid, transfer=nodes),
            relevo.volume(grid, unit_distance=0.1),
            relevo.volume(grid, isosurfaces=[2.0]),
            relevo.volume(grid, isosurfaces=2.0, clip=((2, 2, 2), (0, 0, -1))),
            relevo.volume(grid, "Shift"),
        ):
            self.assertTrue((drawing.screenshot(size=SIZE) != plain).any())
        same = relevo.volume(grid, transfer=relevo.volume(grid).actor.GetProperty())
        numpy.testing.assert_array_equal(same.screenshot(size=SIZE), plain)

    def test_patch_options(self):
        grid = make_curved_block()
        plain = relevo.patches(grid)
        warped = relevo.patches(grid, warp="Shift", factor=2)
        self.assertGreater(warped.actor.GetBounds()[3], plain.actor.GetBounds()[3] + 1)
        self.assertEqual(grid.GetBounds(), make_curved_block().GetBounds())
        coarse = relevo.patches(grid, warp="Shift", error=20).mesh().GetNumberOfCells()
        fine = relevo.patches(grid, warp="Shift", error=0.1).mesh().GetNumberOfCells()
        self.assertLess(coarse, fine)
        picture = plain.screenshot(size=SIZE)
        for options in ({"edges": True}, {"scalars": "Shift"}, {"scalars": "Shift", "isolines": 5}):
            other = relevo.patches(grid, **options).screenshot(size=SIZE)
            self.assertTrue((other != picture).any(), options)

    def test_displaced_surfaces(self):
        heights = make_heights()
        flat = relevo.refined(make_sphere())
        for height in (heights, relevo.arrays.height_map(heights)):
            raised = relevo.refined(make_sphere(), height=height)
            length = make_sphere().GetLength()
            points = vtk_to_numpy(raised.mesh().GetPoints().GetData())
            radii = numpy.linalg.norm(points, axis=1)
            self.assertGreater(radii.max(), 0.5 + 0.04 * length)
            self.assertLess(radii.max(), 0.5 + 0.06 * length)
        larger = relevo.refined(make_sphere(), height=heights, scale=1e-3)
        self.assertEqual(larger.recipe.GetDisplacement().GetScale(), 1e-3)
        self.assertIsNone(flat.recipe.GetDisplacement())

    def test_micro_meshes(self):
        """A micro-mesh is within its tolerance, and can be saved, read and refined."""
        sphere = make_sphere()
        drawing = relevo.micromesh(sphere, tolerance=0.02)
        self.assertLessEqual(drawing.deviation, 0.02)
        self.assertLess(drawing.micro.GetNumberOfCells(), sphere.GetNumberOfCells())
        self.assertRegex(repr(drawing), r"^<relevo.micromesh: \d+ faces, within 0\.0\d+")
        dense = drawing.mesh()
        self.assertTrue(dense.GetPointData().HasArray("V"))
        self.assertGreater(dense.GetNumberOfCells(), drawing.micro.GetNumberOfCells())
        far = vtkCamera()
        far.SetPosition(0, 0, 1000)
        self.assertLess(drawing.mesh(far).GetNumberOfCells(), dense.GetNumberOfCells())
        path = self.folder / "m.rmm"
        drawing.save(path)
        again = relevo.micromesh(path)
        self.assertEqual(again.deviation, drawing.deviation)
        self.assertEqual(again.mesh().GetNumberOfCells(), dense.GetNumberOfCells())
        numpy.testing.assert_array_equal(
            again.screenshot(size=SIZE), drawing.screenshot(size=SIZE))
        drawing.save(self.folder / "m.ply")
        share = relevo.micromesh(sphere, tolerance="1%").deviation / sphere.GetLength()
        self.assertTrue(0 < share <= 0.01)
        for bad in ("1", "x%", "-1%", "nan%", 0, -1.0, float("nan")):
            with self.assertRaisesRegex(ValueError, "tolerance"):
                relevo.micromesh(sphere, tolerance=bad)
        with self.assertRaisesRegex(TypeError, "tolerance must be a number"):
            relevo.micromesh(sphere, tolerance=[1])
        for source in (path, drawing.micro):
            for options in ({"tolerance": "1%"}, {"max_level": 3}):
                with self.assertRaisesRegex(ValueError, f"{[*options][0]} is for meshes that are enc"):
                    relevo.micromesh(source, **options)
        with self.assertRaisesRegex(ValueError, "tolerance is for meshes that are encoded"):
            relevo.show(path, tolerance=0.1)
        with self.assertRaisesRegex(ValueError, "max_level must be in"):
            relevo.micromesh(sphere, max_level=9)
        with self.assertRaisesRegex(ValueError, "error must be in"):
            relevo.micromesh(path, error=0)
        path.write_bytes(path.read_bytes()[:-1])
        with self.assertRaisesRegex(relevo.Error, "m.rmm: the file is truncated: it has"):
            relevo.micromesh(path)

    def test_micro_meshes_of_volumes(self):
        """Of 3D cells, isosurfaces are encoded, or the outer surface with a warning."""
        size = 24
        middle = 0.5 * (size - 1)
        distance = numpy.linalg.norm(numpy.mgrid[:size, :size, :size] - middle, axis=0)
        image = vtkImageData()
        image.SetDimensions(size, size, size)
        for name, values in (("Other", 0 * distance), ("Density", 200 - 10 * distance)):
            array = numpy_to_vtk(values.ravel(), deep=True)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        image.GetPointData().SetActiveScalars("Density")
        with self.assertWarnsRegex(UserWarning, "has 3D cells, and the micro-mesh is their outer"):
            outer = relevo.micromesh(image)
        self.assertEqual(outer.micro.GetBounds(), (0, size - 1) * 3)
        append = vtkAppendFilter()
        append.SetInputData(image)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, image)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for mesh in (image, append, blocks):
                drawing = relevo.micromesh(mesh, isosurfaces=120, tolerance="0.5%")
                points = vtk_to_numpy(drawing.mesh().GetPoints().GetData())
                radii = numpy.linalg.norm(points - middle, axis=1)
                self.assertLess(abs(radii - 8).max(), 0.005 * image.GetLength() + 0.1)
            two = relevo.micromesh(image, isosurfaces=[120, 150], array="Density")
            radii = numpy.linalg.norm(vtk_to_numpy(two.micro.GetPoints().GetData()) - middle, axis=1)
            self.assertAlmostEqual(radii.min(), 5, delta=0.3)
            self.assertAlmostEqual(radii.max(), 8, delta=0.3)
        for mesh, options, text in (
            (image, {"isosurfaces": 900}, "no isosurface at these values: 'Density' is from 0.8"),
            (image, {"array": "Density"}, "array needs isosurfaces"),
            (image, {"isosurfaces": 1, "array": "none"}, "no array 'none'; its arrays are 'Other'"),
            (make_sphere(), {"isosurfaces": 1}, "isosurfaces needs 3D cells"),
            (two.micro, {"isosurfaces": 1}, "isosurfaces is for meshes that are encoded"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                relevo.micromesh(mesh, **options)

    def test_intersections(self):
        found = relevo.intersection(make_sphere(), make_cone())
        self.assertGreater(found.curves.GetNumberOfLines(), 0)
        self.assertEqual(found.overlaps.GetNumberOfCells(), 0)
        first, second = found.contacts
        kinds = set(vtk_to_numpy(first.GetCellData().GetArray("Contact")).tolist())
        self.assertLessEqual({0, 2}, kinds)
        self.assertEqual(second.GetNumberOfCells(), make_cone().GetNumberOfCells())
        alone = relevo.intersection(make_sphere())
        self.assertEqual((alone.curves.GetNumberOfCells(), len(alone.contacts)), (0, 1))

    def test_saved_files(self):
        drawing = relevo.lic(make_sphere(), "V")
        for name in ("refined.vtp", "refined.ply", "refined.stl"):
            drawing.save(self.folder / name)
            self.assertGreater((self.folder / name).stat().st_size, 10000)
            relevo.refined(self.folder / name)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "refined.vtp"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), drawing.mesh().GetNumberOfCells())
        relevo.volume(make_block()).save(self.folder / "volume.vtu")
        relevo.relief(make_heights()).save(self.folder / "relief.vti")
        relevo.relief(self.folder / "relief.vti").save(self.folder / "relief.jpg")
        self.assertEqual(relevo.volume(self.folder / "volume.vtu").mesh().GetNumberOfCells(), 64)
        with self.assertRaisesRegex(ValueError, "must end with .png"):
            drawing.save(self.folder / "refined.xyz")
        with self.assertRaisesRegex(ValueError, "is a vtkPolyData, not a vtkUnstructuredGrid"):
            drawing.save(self.folder / "refined.vtu")
        for name in ("refined.vtp", "refined.png"):
            with self.assertRaisesRegex(FileNotFoundError, "missing'$"):
                drawing.save(self.folder / "missing" / name)

    def test_renderers(self):
        """Drawings are ordinary actors of a renderer, a window or a plotter."""

        class Plotter:
            def __init__(self):
                self.actors = []

            def add_actor(self, actor):
                self.actors.append(actor)

        for drawing in self.make_all().values():
            renderer = vtkRenderer()
            drawing.add_to(renderer)
            self.assertTrue(renderer.HasViewProp(drawing.actor))
            window = vtkRenderWindow()
            window.AddRenderer(vtkRenderer())
            drawing.add_to(window)
            self.assertTrue(window.GetRenderers().GetFirstRenderer().HasViewProp(drawing.actor))
            plotter = Plotter()
            drawing.add_to(plotter)
            self.assertTrue(plotter.actors == drawing.actors)
        for bad in (None, "plotter", vtkRenderWindow()):
            with self.assertRaisesRegex(TypeError, "plotter must be"):
                drawing.add_to(bad)

    def test_show_without_display(self):
        with mock.patch.dict(os.environ):
            for name in ("DISPLAY", "WAYLAND_DISPLAY"):
                os.environ.pop(name, None)
            with self.assertRaisesRegex(relevo.Error, "needs a display.* use screenshot"):
                relevo.show(make_sphere())

    def test_show_chooses(self):
        """show() draws anything with the function that suits the data and the options."""
        drawing = relevo._drawing.Drawing
        with mock.patch.object(drawing, "show", lambda self: None):
            for source, options, name in (
                (make_heights(), {"exaggeration": 2}, "Terrain"),
                (make_sphere(), {}, "Refined"),
                (make_sphere(), {"surface": "linear"}, "Refined"),
                (make_sphere(), {"vectors": "V"}, "LIC"),
                (make_block(), {}, "Refined"),
                (make_block(), {"isosurfaces": [1]}, "Volume"),
                (make_block(), {"scalars": "Shift"}, "Refined"),
                (make_block(), {"scalars": "Shift", "edges": True}, "Patches"),
                (make_curved_block(), {}, "Patches"),
                (make_curved_block(), {"array": "Shift"}, "Volume"),
                (relevo.relief(make_heights()).mesh(), {}, "Relief"),
            ):
                self.assertEqual(type(relevo.show(source, **options)).__name__, name)
            with self.assertRaisesRegex(TypeError, "'isosurface'; did you mean isosurfaces"):
                relevo.show(make_block(), isosurface=1)
            with self.assertRaisesRegex(TypeError, "belong to different functions"):
                relevo.show(make_block(), isosurfaces=1, surface="pn")

    def test_windows(self):
        """A window has the picture of a screenshot."""
        if not os.environ.get("DISPLAY"):
            self.skipTest("no display")
        script = (
            "import relevo\n"
            "from vtkmodules.vtkFiltersSources import vtkSphereSource\n"
            "drawing = relevo.refined(vtkSphereSource())\n"
            "interactor = drawing._open((200, 150))\n"
            "interactor.AddObserver('TimerEvent', lambda caller, event: caller.TerminateApp())\n"
            "interactor.CreateOneShotTimer(1)\n"
            "interactor.Start()\n"
            "print(interactor.GetRenderWindow().GetActualSize())\n"
            "interactor.GetRenderWindow().Finalize()\n"
            "print(drawing.screenshot(size=(200, 150)).shape)\n"
        )
        run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(run.stdout, "(200, 150)\n(150, 200, 3)\n")

    def test_program(self):
        """python3 -m relevo is relevo-view."""
        if not VIEWER.exists():
            self.skipTest("built without relevo-view")
        run = subprocess.run(
            [sys.executable, "-m", "relevo", "--version"], capture_output=True, text=True
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn(relevo.__version__, run.stdout)


if __name__ == "__main__":
    unittest.main(argv=["TestDrawings"])
