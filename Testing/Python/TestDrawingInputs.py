# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves python.md: drawings take files, numpy arrays and the objects of VTK, PyVista, vedo, xarray
and rasterio, and report bad input as exceptions, with nothing on standard error."""

import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import types
import unittest
import warnings

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
from relevo import _inputs, _messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SIZE = (160, 100)
MASKED_NODES = numpy.ma.masked_array([[0, 1, 1, 1, 1], [1] * 5], [[0, 0, 0, 0, 1], [0] * 5])


@contextlib.contextmanager
def standard_error():
    """Collect what Python and C++ write to standard error, as the text of the yielded list."""
    texts = []
    with tempfile.TemporaryFile() as file:
        old = os.dup(2)
        sys.stderr.flush()
        os.dup2(file.fileno(), 2)
        try:
            yield texts
        finally:
            sys.stderr.flush()
            os.dup2(old, 2)
            os.close(old)
            file.seek(0)
            texts.append(file.read().decode())


def make_class(module, name, *bases, **attributes):
    """Return a class that seems to be of another package."""
    return type(name, bases, {"__module__": module, **attributes})


class TestDrawingInputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check_heights(self, terrain, heights):
        """The terrain has the heights of an array, row 0 in the north."""
        west, east, south, north = BOUNDS
        rows, columns = heights.shape
        lon = west + (numpy.arange(columns) + 0.5) * (east - west) / columns
        lat = north - (numpy.arange(rows) + 0.5) * (north - south) / rows
        found = terrain.elevation(lon[None, :], lat[:, None])
        numpy.testing.assert_allclose(found, heights, rtol=1e-4, atol=0.05)

    def test_types_of_heights(self):
        """All real types, byte orders and memory layouts."""
        wide = make_heights(16, 24) // 20
        integers = ("u1", "i1", "<i2", ">i2", "u2", ">u4", "i4", "i8", "u8")
        for dtype in (*integers, "<f2", ">f4", ">f8", "longdouble"):
            heights = (wide - wide.min() if "u" in dtype[:2] else wide).astype(dtype)
            if dtype == "i1":
                heights = (wide / 4).astype(dtype)
            terrain = relevo.terrain(heights, bounds=BOUNDS, crs="EPSG:4326")
            self.check_heights(terrain, heights.astype(float))
        read_only = wide.copy()
        read_only.flags.writeable = False
        for heights in (wide[::2, ::3], wide.T, numpy.asfortranarray(wide), wide[::-1], read_only):
            self.check_heights(relevo.terrain(heights, bounds=BOUNDS, crs=4326), heights)

    def test_missing_heights(self):
        heights = make_heights(16, 24)
        heights[3, 4] = numpy.nan
        masked = numpy.ma.masked_array(make_heights(16, 24).astype("i2"), numpy.isnan(heights))
        for given in (heights, masked):
            terrain = relevo.terrain(given, bounds=BOUNDS, crs="EPSG:4326")
            lon = BOUNDS[0] + 4.5 / 24 * 0.2
            lat = BOUNDS[3] - 3.5 / 16 * 0.2
            self.assertTrue(numpy.isnan(terrain.elevation(lon, lat)))
            self.assertFalse(numpy.isnan(terrain.elevation(86.9, 28.0)))

    def test_bad_coordinates(self):
        terrain = relevo.terrain(make_heights(16, 24), bounds=BOUNDS, crs="EPSG:4326")
        masked = numpy.ma.masked_array([86.9, 86.9], [False, True])
        self.assertEqual(numpy.isnan(terrain.elevation(masked, 28.0)).tolist(), [False, True])
        self.assertTrue(numpy.isnan(terrain.elevation(numpy.nan, 28.0)))
        self.assertEqual(terrain.elevation([], []).shape, (0,))
        swapped = numpy.array([86.9], ">f8")
        self.assertEqual(terrain.elevation(swapped, 28.0)[0], terrain.elevation(86.9, 28.0))
        for lon, error, text in (
            ("86.9", TypeError, "lon must be real numbers"),
            (None, TypeError, "lon must be real numbers, not object"),
            (1j, TypeError, "lon must be real numbers, not complex"),
            ([1, 2, 3], ValueError, r"lon and lat must have shapes that fit, not \(3,\) and \(2,\)"),
        ):
            with self.assertRaisesRegex(error, text):
                terrain.elevation(lon, [27.95, 28.0])

    def test_heights_do_not_change_later(self):
        heights = make_heights(16, 24)
        terrain = relevo.terrain(heights)
        before = terrain.screenshot(size=SIZE)
        heights[:] = 0
        del heights
        numpy.testing.assert_array_equal(terrain.screenshot(size=SIZE), before)

    def test_bad_heights(self):
        for bad, error, text in (
            (numpy.zeros(4), ValueError, "must be a 2-D array"),
            (numpy.zeros((2, 2, 2)), ValueError, "must be a 2-D array"),
            (numpy.array(3.0), ValueError, "must be a 2-D array"),
            (numpy.zeros((0, 5)), ValueError, "at least 2 x 2, not 0 x 5"),
            (numpy.zeros((1, 5)), ValueError, "at least 2 x 2, not 1 x 5"),
            (numpy.zeros((3, 3), object), ValueError, "real numbers, not object"),
            (numpy.zeros((3, 3), complex), ValueError, "real numbers, not complex"),
            (numpy.array([["a", "b"], ["c", "d"]]), ValueError, "real numbers, not <U1"),
            (numpy.full((3, 3), numpy.nan), relevo.Error, "^the array .* all heights are missing"),
            (numpy.full((3, 3), numpy.inf), relevo.Error, "all heights are missing"),
            (numpy.ma.masked_all((3, 3)), relevo.Error, "all heights are missing"),
            ([["a", 1], [2, 3]], ValueError, "real numbers"),
            (None, TypeError, "not None"),
            (7, ValueError, "must be a 2-D array"),
            (object(), ValueError, "real numbers"),
        ):
            with standard_error() as written:
                with self.assertRaisesRegex(error, text):
                    relevo.terrain(bad)
            self.assertEqual(written, [""])

    def test_bad_locations(self):
        heights = make_heights(8, 8)
        for options, error, text in (
            ({"crs": "EPSG:4326"}, ValueError, "crs needs bounds"),
            ({"bounds": BOUNDS, "crs": "nowhere"}, ValueError, "'nowhere' is not a coordinate"),
            ({"bounds": BOUNDS, "crs": 3.5}, TypeError, "crs must be a text"),
            ({"bounds": (1, 0, 0, 1)}, ValueError, "west < east"),
            ({"bounds": (0, numpy.inf, 0, 1)}, ValueError, "west < east"),
            ({"bounds": (0, 1, 0)}, TypeError, "bounds must be"),
            ({"bounds": "abcd"}, TypeError, "bounds must be"),
            ({"exaggeration": 0}, ValueError, "xaggeration"),
            ({"exaggeration": "2"}, TypeError, "exaggeration must be a number, not '2'"),
            ({"imagery": heights}, TypeError, "^imagery must be the path of an image, not ndarray"),
            ({"imagery": self.folder / "none.png"}, FileNotFoundError, "none.png"),
            ({"exagerration": 2}, TypeError, "'exagerration'; did you mean exaggeration"),
            ({"colour": 2}, TypeError, "no option 'colour'; it has .*imagery"),
        ):
            with standard_error() as written:
                with self.assertRaisesRegex(error, text):
                    relevo.terrain(heights, **options)
            self.assertEqual(written, [""], options)
        path = self.folder / "heights.tif"
        path.write_text("no raster")
        with self.assertRaisesRegex(ValueError, "a file has its own"):
            relevo.terrain(path, bounds=BOUNDS)

    def test_bad_files(self):
        text = self.folder / "text.tif"
        text.write_text("no raster")
        empty = self.folder / "empty.vtp"
        empty.write_text("")
        for function, path, error in (
            (relevo.terrain, self.folder / "none.tif", FileNotFoundError),
            (relevo.terrain, str(self.folder / "none.tif"), FileNotFoundError),
            (relevo.terrain, text, relevo.Error),
            (relevo.refined, self.folder / "none.ply", FileNotFoundError),
            (relevo.refined, empty, relevo.Error),
            (relevo.refined, text, ValueError),
            (relevo.relief, self.folder / "none", FileNotFoundError),
            (relevo.relief, self.folder, relevo.Error),
            (relevo.volume, self.folder / "none.vtu", FileNotFoundError),
            (relevo.patches, self.folder / "none.vtu", FileNotFoundError),
            (relevo.lic, self.folder / "none.vtp", FileNotFoundError),
            (relevo.intersection, self.folder / "none.vtp", FileNotFoundError),
            (relevo.show, self.folder / "none.vtp", FileNotFoundError),
        ):
            with standard_error() as written:
                with self.assertRaises(error) as raised:
                    function(path)
            self.assertEqual(written, [""], path)
            self.assertIn(pathlib.Path(path).name, str(raised.exception) + empty.name)

    def test_folders(self):
        with self.assertRaisesRegex(ValueError, "without reliefs; show.. takes a raster, a mesh"):
            relevo.show(self.folder)

    def test_damaged_ply_files(self):
        """The reader of VTK would crash."""
        path = self.folder / "mesh.ply"
        for text, message in (
            ("", "not a PLY file"),
            ("solid\n", "not a PLY file"),
            ("ply\nformat ascii 1.0\nelement vertex 3\n", "no end_header: the file is truncated"),
            ("ply\nelement vertex 0\nend_header\n", "no format line"),
        ):
            path.write_text(text)
            for function in (relevo.refined, relevo.lic, relevo.show):
                with self.assertRaisesRegex(relevo.Error, f"mesh.ply: it.*{message}"):
                    function(path)

    def test_damaged_files(self):
        """Readers of VTK would crash, or read a part of the file without an error."""
        solid = bytes(80) + (5).to_bytes(4, "little")
        gltf = b'{"asset": {"version": "2.0"}, "buffers": [{"uri": "none.bin", "byteLength": 4}]}'
        for name, contents, message in (
            ("mesh.obj", b"v 0 0 0\nf 1 2 3\n", "line 2 refers to point 3, but there are 1"),
            ("mesh.gltf", gltf, "none.bin"),
            ("mesh.glb", b"glTF", "not a glTF scene, or it is truncated"),
            ("mesh.ex2", b"CDF\x01\0\0\0\0", "netCDF header is not complete"),
            ("mesh.e", b"CDF\x01\0\0\0\0", "netCDF header is not complete"),
            ("mesh.vtu", b"<VTKFile>", "truncated: it does not end with </VTKFile>"),
            ("mesh.stl", solid + bytes(130), "declares 5 triangles, but there are 2"),
        ):
            path = self.folder / name
            path.write_bytes(contents)
            with self.assertRaisesRegex(relevo.Error, f"{name}: .*{message}"):
                relevo.refined(path)
        path = self.folder / "mesh.stl"
        triangle = numpy.array([0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0], "<f4").tobytes() + bytes(2)
        path.write_bytes(solid + 2 * triangle)
        with self.assertWarnsRegex(UserWarning, "declares 5 triangles, but there are 2"):
            relevo.refined(path)

    def test_bad_meshes(self):
        points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
        faces = [[0, 1, 2]]
        for bad, error, text in (
            (None, TypeError, "not NoneType"),
            (3.5, TypeError, "not float"),
            (vtkTable(), TypeError, "vtkTable is not a mesh"),
            (vtkPolyData(), ValueError, "no polygons"),
            ((points[:, :2], faces), ValueError, r"points must have the shape \(n, 3\), not"),
            ((points, [0, 1, 2]), ValueError, r"faces must have the shape \(n, 3\) or \(n, 4\)"),
            ((points, [[0, 1, 3]]), ValueError, "from 0 to 2"),
            ((points, [[0, 1, -1]]), ValueError, "from 0 to 2"),
            ((points, [[0.0, 1.0, 2.0]]), ValueError, "faces must be integers"),
            ((points * numpy.nan, faces), ValueError, "points must be finite"),
            ((points.astype(object), faces), ValueError, "real numbers"),
            ((points.astype(str), faces), ValueError, "real numbers"),
            ((points[:0], faces), ValueError, "empty"),
            ((points, numpy.zeros((0, 3), int)), ValueError, "empty"),
            ((numpy.array(1.0), faces), ValueError, r"points must have the shape \(n, 3\), not \(\)"),
            ((points, numpy.array(1)), ValueError, r"faces must have the shape .*, not \(\)"),
            ((points.astype(complex), faces), ValueError, "real numbers, not complex"),
            ((points, [[True, False, True]]), ValueError, "faces must be integers, not bool"),
            ((points, numpy.full((1, 3), 2**63, "u8")), ValueError, "from 0 to 2"),
            ((numpy.ma.masked_equal(points, 1), faces), ValueError, "points must have no masked"),
            ((points, numpy.ma.masked_equal(faces, 1)), ValueError, "faces must have no masked"),
            (([[0, 0], [1]], faces), ValueError, ""),
        ):
            for function in (relevo.refined, relevo.lic, relevo.intersection):
                with standard_error() as written:
                    with self.assertRaisesRegex(error, text):
                        function(bad)
                self.assertEqual(written, [""])

    def test_bad_options(self):
        grid, curved, sphere = make_block(), make_curved_block(), make_sphere()
        for call, error, text in (
            (lambda: relevo.refined(sphere, surface="round"), ValueError, "linear, pn, phong"),
            (lambda: relevo.refined(sphere, surface=3), TypeError, "surface must be a str or a"),
            (lambda: relevo.refined(sphere, metric="size"), ValueError, "screen-edge, curvature"),
            (lambda: relevo.refined(sphere, metric="field"), ValueError, "active point scalars"),
            (lambda: relevo.refined(sphere, max_level=9), ValueError, "evel"),
            (lambda: relevo.refined(sphere, max_level=2.5), TypeError, "^max_level must be an int"),
            (lambda: relevo.refined(sphere, scale="2"), TypeError, "^scale must be a number"),
            (lambda: relevo.refined(sphere, up="w"), ValueError, "up must be 'x', 'y' or 'z'"),
            (lambda: relevo.refined(sphere, up=2), ValueError, "up must be 'x', 'y' or 'z'"),
            (lambda: relevo.refined(sphere, scale=2), ValueError, "scale needs height"),
            (lambda: relevo.refined(sphere, height=3), TypeError, "height must be a path"),
            (lambda: relevo.refined(sphere, height=numpy.zeros(3)), ValueError, "2-D"),
            (lambda: relevo.refined(sphere, maxlevel=3), TypeError, "did you mean max_level"),
            (lambda: relevo.volume(grid, "Distance"), ValueError, "are 'DistanceToCenter', "),
            (lambda: relevo.volume(grid, 3), TypeError, "by its name"),
            (lambda: relevo.volume(sphere), ValueError, "no 3D cells; relevo.refined"),
            (lambda: relevo.volume(grid, blend="mean"), ValueError, "composite, maximum"),
            (lambda: relevo.volume(grid, clip=3), TypeError, "clip must be"),
            (lambda: relevo.volume(grid, clip=((0, 0, 0), (0, 0, 0))), ValueError, "normal"),
            (lambda: relevo.volume(grid, isosurfaces="abc"), TypeError, "must be numbers"),
            (lambda: relevo.volume(grid, isosurfaces=[numpy.nan]), ValueError, "finite"),
            (lambda: relevo.volume(grid, unit_distance=0), ValueError, "greater than 0"),
            (lambda: relevo.volume(grid, unit_distance="1"), TypeError, "^unit_distance must be"),
            (lambda: relevo.volume(grid, transfer=[[0, 1]]), ValueError, r"shape \(n, 5\)"),
            (lambda: relevo.volume(grid, transfer=[[0, 1, 1, 1, 2]]), ValueError, "from 0 to 1"),
            (lambda: relevo.volume(grid, transfer=[[0] * 5, [0] * 5]), ValueError, "increase"),
            (lambda: relevo.patches(curved, scalars="Stress"), ValueError, "no array 'Stress'"),
            (lambda: relevo.patches(curved, warp="DistanceToCenter"), ValueError, "3 components"),
            (lambda: relevo.patches(vtkMultiBlockDataSet()), ValueError, "the mesh is empty"),
            (lambda: relevo.volume(grid, transfer=MASKED_NODES), ValueError, "no masked values"),
            (lambda: relevo.volume(grid, isosurfaces=numpy.array(["a"])), TypeError, "numbers"),
            (lambda: relevo.volume(grid, isosurfaces=[[1, 2]]), TypeError, "must be numbers"),
            (lambda: relevo.patches(curved, factor=2), ValueError, "factor needs warp"),
            (lambda: relevo.patches(curved, factor=numpy.inf), ValueError, "^factor must be fin"),
            (lambda: relevo.patches(curved, isolines=2.5), ValueError, "number of lines"),
            (lambda: relevo.patches(curved, isolines=2), ValueError, "isolines need scalars"),
            (lambda: relevo.patches(curved, error=0), ValueError, ""),
            (lambda: relevo.patches(curved, error="1"), TypeError, "^error must be a number"),
            (lambda: relevo.patches(curved, factor="1"), TypeError, "^factor must be a number"),
            (lambda: relevo.lic(sphere, "W"), ValueError, "no array 'W'; its arrays are 'V'"),
            (lambda: relevo.lic(grid, "DistanceToCenter"), ValueError, "1 components"),
            (lambda: relevo.lic(vtk_sphere()), ValueError, "no array of 2 or 3 components"),
            (lambda: relevo.intersection(sphere, 3), TypeError, "b must be a path"),
            (lambda: relevo.relief(sphere).screenshot(), relevo.Error, ""),
            (lambda: relevo.refined(sphere).screenshot(size=3), TypeError, "size must be"),
            (lambda: relevo.refined(sphere).screenshot(size=(0, 5)), ValueError, "from 1 x 1"),
            (lambda: relevo.refined(sphere).screenshot(camera="top"), TypeError, "camera must be"),
            (lambda: relevo.refined(sphere).mesh((10, 91)), ValueError, "-90 to 90 degrees"),
            (lambda: relevo.refined(sphere).mesh((10, numpy.nan)), ValueError, "-90 to 90 degrees"),
            (lambda: relevo.refined(sphere).mesh((numpy.inf, 9)), ValueError, "finite azimuth"),
            (lambda: relevo.refined(sphere).screenshot("p.gif"), ValueError, "must end with .png"),
        ):
            with standard_error() as written:
                with self.assertRaisesRegex(error, text):
                    call()
            self.assertEqual(written, [""], text)

    def test_warnings(self):
        """Warnings of VTK's objects are Python's, for the line that called the package."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            with standard_error() as written:
                relevo.terrain(make_heights(8, 8), bounds=(86, 87, 27, 28))
        self.assertEqual(len(caught), 1)
        self.assertIn("no coordinate system", str(caught[0].message))
        self.assertEqual(pathlib.Path(caught[0].filename).name, "TestDrawingInputs.py")
        self.assertEqual(written, [""])

    def test_errors_elsewhere(self):
        """Other errors are still printed after an exception."""
        with self.assertRaises(FileNotFoundError):
            relevo.terrain("none.tif")
        with self.assertRaises(relevo.Error):
            (self.folder / "bad.tif").write_text("x")
            relevo.terrain(self.folder / "bad.tif")
        with standard_error() as written:
            relevo.vtkTerrainMapper().SetScreenSpaceError(-1)
        self.assertIn("ERR", written[0])

    def test_errors_in_threads(self):
        """Blocks of several threads overlap, and later errors are printed."""
        first, second = _messages.Messages(), _messages.Messages()
        with standard_error() as written:
            first.__enter__()
            thread = threading.Thread(target=second.__enter__)
            thread.start()
            thread.join()
            first.__exit__(None, None, None)
            relevo.vtkTerrainMapper().SetScreenSpaceError(-1)
            with self.assertRaisesRegex(relevo.Error, "^ScreenSpaceError must be"):
                second.__exit__(None, None, None)
        self.assertEqual(written, [""])
        with standard_error() as written:
            relevo.vtkTerrainMapper().SetScreenSpaceError(-1)
        self.assertIn("ERR", written[0])

    def test_objects_of_vtk(self):
        source = vtkSphereSource()
        source.Update()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, source.GetOutput())
        pictures = [
            relevo.refined(item, surface="linear").screenshot(size=SIZE)
            for item in (source, source.GetOutput(), actor, blocks)
        ]
        for picture in pictures[1:]:
            numpy.testing.assert_array_equal(picture, pictures[0])

    def test_arrays_of_meshes(self):
        """Float points in C order are shared."""
        points = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
        mesh = _inputs.make_mesh(points, numpy.array([[0, 1, 2], [0, 2, 3]]))
        self.assertTrue(numpy.shares_memory(vtk_to_numpy(mesh.GetPoints().GetData()), points))
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()), (4, 2))
        same = [
            relevo.refined((given, faces)).mesh().GetNumberOfCells()
            for given in (points, points.astype(">f4"), points.tolist(), points[::-1][::-1])
            for faces in ([[0, 1, 2], [0, 2, 3]], numpy.array([[0, 1, 2], [0, 2, 3]], "u1"))
        ]
        self.assertEqual(set(same), {2})
        self.assertGreater(relevo.refined((points, [[0, 1, 2, 3]])).mesh().GetNumberOfCells(), 0)
        read_only = points.copy()
        read_only.flags.writeable = False
        wide = numpy.repeat([[0, 1, 2], [0, 2, 3]], 2, axis=1)[:, ::2]
        for given in (read_only, numpy.asfortranarray(points), numpy.repeat(points, 2, axis=0)[::2]):
            self.assertEqual(relevo.refined((given, wide.astype(">i2"))).mesh().GetNumberOfCells(), 2)

    def test_arrays_that_the_caller_frees(self):
        """Drawings, and actors that outlive them, keep the arrays that they share."""
        sphere = make_sphere(10)
        points = vtk_to_numpy(sphere.GetPoints().GetData()).astype(float)
        faces = vtk_to_numpy(sphere.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        for make in (
            relevo.refined,
            lambda mesh: relevo.refined(mesh, surface="linear", max_level=1),
            relevo.patches,
            relevo.intersection,
        ):
            kept = make((points, faces)).screenshot(size=SIZE)
            drawing = make((points.copy(), faces.copy()))
            # New arrays take the memory of freed ones.
            garbage = [numpy.full_like(points, 1e9) for _ in range(50)]
            garbage += [numpy.full_like(faces, 1 << 40) for _ in range(50)]
            numpy.testing.assert_array_equal(drawing.screenshot(size=SIZE), kept)
            bounds = make((points, faces)).actor.GetBounds()
            actor = make((points.copy(), faces.copy())).actor
            garbage += [numpy.full_like(points, 1e9) for _ in range(50)]
            self.assertEqual(actor.GetBounds(), bounds)
            self.assertEqual(len(garbage), 150)

    def test_pyvista(self):
        """Results are PyVista's for meshes of PyVista, which is not imported for others."""
        self.assertNotIn("pyvista", sys.modules)
        mesh_class = make_class("pyvista.core.pointset", "PolyData", vtkPolyData)
        own_class = make_class("own", "Own", mesh_class)
        module = types.ModuleType("pyvista")

        def wrap(data):
            wrapped = mesh_class()
            wrapped.ShallowCopy(data)
            return wrapped

        module.wrap = wrap
        sys.modules["pyvista"] = module
        self.addCleanup(sys.modules.pop, "pyvista")
        for kind in (mesh_class, own_class):
            mesh = kind()
            mesh.ShallowCopy(make_sphere())
            self.assertIs(type(relevo.refined(mesh).mesh()), mesh_class)
            self.assertIs(type(relevo.lic(mesh, "V").mesh()), mesh_class)
            self.assertIs(type(relevo.intersection(mesh, make_block()).curves), mesh_class)
        # VTK 9.5 and later have subclasses of their own in Python.
        self.assertIs(type(relevo.refined(make_sphere()).mesh()), type(vtkPolyData()))

    def test_vedo(self):
        script = (
            "import relevo, vedo\n"
            "from DrawingData import make_block, make_heights\n"
            "mesh = vedo.Sphere(res=8).pos(3, 0, 0)\n"
            "drawing = relevo.refined(mesh)\n"
            "assert type(drawing.mesh()) is vedo.Mesh\n"
            "assert drawing.actor.GetBounds()[0] > 1.5\n"
            "Grid = getattr(vedo, 'UnstructuredGrid', None) or vedo.UGrid\n"
            "grid = relevo.volume(Grid(make_block()), 'DistanceToCenter')\n"
            "assert type(grid.mesh()) is Grid\n"
            "plotter = vedo.Plotter(offscreen=True, size=(200, 150))\n"
            "pictures = [own.screenshot(size=(64, 48)) for own in (drawing, grid)]\n"
            "drawing.add_to(plotter)\n"
            "grid.add_to(plotter)\n"
            "plotter.show()\n"
            "assert plotter.screenshot(asarray=True).std() > 5\n"
            # Pictures are right while the plotter uses OpenGL.
            "for own, picture in zip((drawing, grid), pictures):\n"
            "    difference = abs(own.screenshot(size=(64, 48)).astype(int) - picture)\n"
            "    assert difference.mean() < 2, difference.mean()\n"
            "terrain = relevo.terrain(make_heights())\n"
            "plotter = vedo.Plotter(offscreen=True, size=(200, 150))\n"
            "terrain.add_to(plotter)\n"
            "plotter.show()\n"
            "assert terrain.mapper.IsComplete()\n"
            "assert plotter.screenshot(asarray=True).std() > 5\n"
        )
        run = self.run_vedo("-c", script)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)

    def run_vedo(self, *arguments):
        """Run Python in another process, where vedo needs a display."""
        run = subprocess.run([sys.executable, "-c", "import vedo"], capture_output=True)
        if run.returncode or not os.environ.get("DISPLAY"):
            self.skipTest("no vedo, or no display")
        return subprocess.run(
            [sys.executable, *arguments],
            cwd=pathlib.Path(__file__).parent,
            capture_output=True,
            text=True,
        )

    def test_vedo_example(self):
        """The example draws streaks like those of the stored picture."""
        example = pathlib.Path(os.environ["RELEVO_SOURCE_DIR"]) / "Examples/Python/vedo_lic.py"
        path = self.folder / "out.png"
        run = self.run_vedo(example, path)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertRegex(run.stdout, r"^[1-9]\d{3,} triangles\n$")
        picture, kept = (read_picture(own) for own in (path, example.with_suffix(".png")))
        self.assertEqual(picture.shape, kept.shape)
        self.assertGreater(count_colours(picture), 1000)
        blocks = (numpy.float64(own).reshape(20, 20, 32, 20, 3) for own in (picture, kept))
        means = [own.mean(axis=(1, 3)) for own in blocks]
        self.assertLess(numpy.abs(means[0] - means[1]).max(), 20)

    def make_data_array(self, heights, lat, lon, **attributes):
        """Return a stand-in for a DataArray of xarray."""

        class Coordinate:
            def __init__(self, values):
                self.values = values

        kind = make_class("xarray.core.dataarray", "DataArray", squeeze=lambda self, drop: self)
        array = kind()
        array.dims = ("lat", "lon")
        array.values = heights
        array.coords = {"lat": Coordinate(lat), "lon": Coordinate(lon)}
        array.attrs = attributes
        return array

    def test_xarray(self):
        heights = make_heights(16, 24)
        west, east, south, north = BOUNDS
        lon = west + (numpy.arange(24) + 0.5) * (east - west) / 24
        lat = north - (numpy.arange(16) + 0.5) * (north - south) / 16
        for array in (
            self.make_data_array(heights, lat, lon, crs="EPSG:4326"),
            self.make_data_array(heights[::-1], lat[::-1], lon, crs="EPSG:4326"),
            self.make_data_array(heights[:, ::-1], lat, lon[::-1], crs="EPSG:4326"),
        ):
            self.check_heights(relevo.terrain(array), heights)
        plain = self.make_data_array(heights, lat, lon)
        self.check_heights(relevo.terrain(plain, crs="EPSG:4326"), heights)
        uneven = self.make_data_array(heights, lat**3, lon)
        with self.assertRaisesRegex(ValueError, "'lat' must have equal steps"):
            relevo.terrain(uneven)
        dataset = make_class("xarray.core.dataset", "Dataset", values=lambda self: None)()
        with self.assertRaisesRegex(TypeError, "must be a DataArray, .* not a Dataset"):
            relevo.terrain(dataset)

    def test_installed_xarray(self):
        try:
            import xarray
        except ImportError:
            self.skipTest("no xarray")
        heights = make_heights(16, 24)
        west, east, south, north = BOUNDS
        coordinates = {
            "lat": north - (numpy.arange(16) + 0.5) * (north - south) / 16,
            "lon": west + (numpy.arange(24) + 0.5) * (east - west) / 24,
        }
        array = xarray.DataArray(heights[None], coordinates, ("band", "lat", "lon"))
        for given in (array, array[:, ::-1]):
            self.check_heights(relevo.terrain(given, crs="EPSG:4326"), heights)
        with self.assertRaisesRegex(TypeError, "not a Dataset"):
            relevo.terrain(array.to_dataset(name="heights"))

    def test_installed_rasterio(self):
        try:
            import rasterio
        except ImportError:
            self.skipTest("no rasterio")
        heights = make_heights(16, 24)
        west, east, south, north = BOUNDS
        options = {
            "driver": "GTiff",
            "height": 16,
            "width": 24,
            "count": 1,
            "dtype": "float32",
            "crs": "EPSG:4326",
            "transform": rasterio.transform.from_bounds(west, south, east, north, 24, 16),
        }
        path = self.folder / "heights.tif"
        with rasterio.open(path, "w", **options) as file:
            file.write(heights, 1)
        with rasterio.open(path) as file:
            terrain = relevo.terrain(file)
            self.assertEqual(terrain.mapper.GetPyramid().GetFileName(), str(path))
            self.check_heights(terrain, heights)
            self.check_heights(relevo.terrain(heights, bounds=BOUNDS, crs=file.crs), heights)
        with rasterio.MemoryFile(path.read_bytes()) as memory, memory.open() as file:
            self.check_heights(relevo.terrain(file), heights)

    def test_rasterio(self):
        heights = make_heights(16, 24)
        west, east, south, north = BOUNDS
        crs = make_class("rasterio.crs", "CRS", to_wkt=lambda self: "EPSG:4326")()
        kind = make_class(
            "rasterio.io", "DatasetReader", read=lambda self, band, masked: numpy.ma.array(heights)
        )
        dataset = kind()
        dataset.name = "/vsimem/heights.tif"
        dataset.bounds = (west, south, east, north)
        dataset.crs = crs
        self.check_heights(relevo.terrain(dataset), heights)
        dataset.name = str(self.folder / "file.tif")
        (self.folder / "file.tif").write_text("the file is read, not the object")
        with self.assertRaisesRegex(relevo.Error, "file.tif"):
            relevo.terrain(dataset)


def vtk_sphere():
    """Return a sphere without arrays."""
    mesh = vtkPolyData()
    mesh.CopyStructure(make_sphere())
    points = vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(make_sphere().GetPoints().GetData()), deep=True))
    mesh.SetPoints(points)
    return mesh


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingInputs"])
