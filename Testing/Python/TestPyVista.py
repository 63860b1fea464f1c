# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that meshes and plotters of PyVista 0.48 have the attribute `relevo`, that importing PyVista
does not import this package, and that drawings can be added to plotters of PyVista 0.44. Without
PyVista, the tests use the stand-in of this folder."""

import importlib.metadata
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import DrawingData  # skips without numpy, EGL and GDAL
import numpy
from relevo._raster import RasterFile
from vtkmodules.vtkCommonCore import vtkVersion

FOLDER = pathlib.Path(__file__).parent
SOURCE = FOLDER.parent.parent
DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or FOLDER / "none")
POINTS = ("pyvista.accessors", "pyvista.plotter_components")

if sys.version_info < (3, 11):
    print("skipped: the metadata of the package need Python 3.11")
    sys.exit(125)

# Each program begins like this.
START = """
import sys
import numpy
import pyvista
assert not any(name.partition(".")[0] == "relevo" for name in sys.modules), "imported early"
from DrawingData import BOUNDS, make_block, make_curved_block, make_heights, make_sphere
mesh = pyvista.wrap(make_sphere())
"""


def get_path(needed=(0, 48)):
    """Return the folders of modules, with that of the stand-in if there is no such PyVista."""
    folders = [str(FOLDER), *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    try:
        version = importlib.metadata.version("pyvista")
        is_new = tuple(map(int, version.split(".")[:2])) >= needed
    except importlib.metadata.PackageNotFoundError:
        is_new = False
    return folders if is_new else [str(FOLDER / "StandIn"), *folders]


def get_environment(*needed):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(get_path(*needed))}
    if not environment.get("DISPLAY"):
        # Otherwise VTK 9.4 and later print that there is no X server.
        environment["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkEGLRenderWindow"
    return environment


class TestPyVista(unittest.TestCase):
    def check(self, program, *needed):
        run = subprocess.run(
            [sys.executable, "-c", START + program],
            env=get_environment(*needed),
            capture_output=True,
            text=True,
        )
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)

    def test_entry_points(self):
        """The metadata name modules that exist."""
        for group in POINTS:
            (point,) = importlib.metadata.entry_points(group=group, name="relevo")
            self.assertIsNotNone(importlib.util.find_spec(point.value))

    def test_meshes(self):
        """mesh.relevo has the functions for meshes, whose results are of PyVista."""
        self.check(
            """
assert mesh.relevo is mesh.relevo
refined = mesh.relevo.refined(surface="pn", metric="curvature", max_level=3)
assert type(refined.mesh()) is pyvista.PolyData
assert refined.mesh().GetNumberOfCells() > mesh.GetNumberOfCells()
assert type(mesh.relevo.lic("V").mesh()) is pyvista.PolyData
assert type(mesh.relevo.intersection(make_block()).curves) is pyvista.PolyData
block = pyvista.wrap(make_block())
assert block.relevo.volume("DistanceToCenter", unit_distance=0.1).actor.IsA("vtkVolume")
assert pyvista.wrap(make_curved_block()).relevo.patches(edges=True).mapper.GetPatchEdges()
blocks = pyvista.MultiBlock()
blocks.SetBlock(0, make_sphere())
assert blocks.relevo.refined().screenshot(size=(64, 64)).std() > 1
try:
    mesh.relevo.refined(max_levels=3)
except TypeError as error:
    assert "max_level" in str(error)
else:
    raise AssertionError("no error")
"""
        )

    def test_plotters(self):
        """plotter.relevo draws in the plotter, and its actors can be removed."""
        self.check(
            """
plotter = pyvista.Plotter(off_screen=True, window_size=(300, 200))
empty = None
for add in (
    lambda: plotter.relevo.add_terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326"),
    lambda: plotter.relevo.add_refined(mesh, max_level=2),
    lambda: plotter.relevo.add_volume(make_block(), "DistanceToCenter"),
    lambda: plotter.relevo.add_patches(make_curved_block()),
    lambda: plotter.relevo.add_lic(mesh, "V"),
    lambda: plotter.relevo.add_streamlines(make_block(), "Shift"),
    lambda: plotter.relevo.add_micromesh(mesh),
    lambda: plotter.relevo.add_refined(make_block(), clip=((0.5, 0.5, 0.5), (0, 0, 1))),
    lambda: plotter.relevo.add_relief(make_heights()),
    lambda: plotter.relevo.add_intersection(mesh, make_block()),
):
    drawing = add()
    plotter.reset_camera()
    picture = plotter.screenshot()
    plotter.remove_actor(drawing.actors)
    empty = plotter.screenshot() if empty is None else empty
    numpy.testing.assert_array_equal(plotter.screenshot(), empty)
    assert (picture != empty).any(axis=2).sum() > 1000, type(drawing).__name__
"""
        )

    def test_example(self):
        """The example of a topographic map; the stored picture is that of real data."""
        example = SOURCE / "Examples/Python/pyvista_terrain.py"
        heights = DrawingData.make_heights()
        bounds, crs = DrawingData.BOUNDS, "EPSG:4326"
        made = RasterFile(heights, bounds, crs), RasterFile((heights / 20).astype("u1"), bounds, crs)
        files = [raster.name for raster in made]
        real = DATA / "relief/rmnp-dem.tif"
        if real.exists():
            files = [str(real), str(DATA / "relief/rmnp-rgb.tif")]
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run(
                [sys.executable, example, *files, "out.png"],
                env=get_environment(),
                cwd=folder,
                capture_output=True,
                text=True,
            )
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertRegex(run.stdout, r"^[1-9]\d+ triangles, exact to 1 pixel\n$")
            picture, kept = (
                DrawingData.read_picture(path)
                for path in (f"{folder}/out.png", example.with_suffix(".png"))
            )
        self.assertEqual(picture.shape, kept.shape)
        self.assertGreater(DrawingData.count_colours(picture), 200)
        if real.exists() and str(FOLDER / "StandIn") in get_path():
            difference = numpy.abs(picture.astype(float) - kept).mean()
            self.assertLess(difference, 2)

    def test_add_to(self):
        """add_to() draws in plotters of PyVista 0.44, with their camera, clipping and picking."""
        version = vtkVersion()
        needs_display = (version.GetVTKMajorVersion(), version.GetVTKMinorVersion()) < (9, 4)
        if needs_display and str(FOLDER / "StandIn") not in get_path((0, 44)):
            if not os.environ.get("DISPLAY"):
                self.skipTest("PyVista needs a display before VTK 9.4")
        self.check(
            """
import relevo
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkCellPicker
plotter = pyvista.Plotter(off_screen=True, window_size=(300, 200))
drawing = relevo.refined(mesh, surface="pn", metric="curvature", max_level=3)
drawing.add_to(plotter)
assert type(drawing.mesh()) is pyvista.PolyData
plotter.view_vector((0, -1, 0), viewup=(0, 0, 1))
whole = plotter.screenshot()
# The camera of the plotter gives the same picture.
shown = drawing.screenshot(size=(300, 200), camera=plotter.camera)
def find(picture):
    return (abs(picture.astype(int) - picture[:, :1]).max(axis=2) > 12)[:, 40:-40]
assert (find(whole) != find(shown)).mean() < 0.02
picker = vtkCellPicker()
assert picker.Pick(150, 100, 0, plotter.renderer)
assert picker.GetViewProp() is drawing.actor
numpy.testing.assert_allclose(picker.GetPickPosition(), (0, -0.5, 0), atol=0.02)
plane = vtkPlane()
plane.SetNormal(1, 0, 0)
drawing.mapper.AddClippingPlane(plane)
plotter.render()
half = plotter.screenshot()
assert 0.4 < find(half).sum() / find(whole).sum() < 0.6
plotter.remove_actor(drawing.actors)
assert not find(plotter.screenshot()).any()
""",
            (0, 44),
        )

    def test_colour_modes(self):
        """A mode that is set after add_to() has its own colours."""
        self.check(
            """
import relevo
terrain = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
plotter = pyvista.Plotter(off_screen=True, window_size=(300, 200))
terrain.add_to(plotter)
mapper = terrain.mapper
mapper.SetLoadingModeToComplete()
by_height = mapper.GetLookupTable()
before = plotter.screenshot()
mapper.SetColorModeToSlope()
assert mapper.GetLookupTable() is not by_height
plotter.render()
slope = plotter.screenshot()
assert (slope != before).any(axis=2).sum() > 1000
del terrain
mapper.SetColorModeToElevation()
assert mapper.GetLookupTable() is by_height
plotter.render()
height = plotter.screenshot()
assert (slope != height).any(axis=2).sum() > 1000
table = by_height.NewInstance()
mapper.SetLookupTable(table)
mapper.SetColorModeToAspect()
assert mapper.GetLookupTable() is table
"""
        )


if __name__ == "__main__":
    unittest.main(argv=["TestPyVista"])
