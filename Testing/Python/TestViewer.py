# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md: exit codes, messages, pictures without a display, and exported meshes of
relevo-view."""

import math
import os
import pathlib
import re
import subprocess
import unittest

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ViewerProgram import PROGRAM, ViewerProgram
from ViewerScenes import write_hill

DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent")


METRICS = (
    "distance",
    "screen-edge",
    "curvature",
    "silhouette",
    "contour",
    "view-dependent",
    "field",
    "region",
    "height",
)


class TestViewer(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)

    def picture(self, *arguments):
        name = self.folder / "picture.png"
        self.view(self.heights, "--output", name, *arguments)
        reader = vtkPNGReader()
        reader.SetFileName(str(name))
        reader.Update()
        return reader.GetOutput()

    def mesh(self, *arguments, heights=None):
        name = self.folder / "mesh.vtp"
        self.view(heights or self.heights, "--export", name, *arguments)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(name))
        reader.Update()
        return reader.GetOutput()

    def test_help(self):
        """Options without a value are followed by two spaces, which Examples/run.sh relies on."""
        usage = self.view("--help").stdout
        self.assertIn("--exaggeration", usage)
        flags = set(re.findall(r"^  (--[a-z-]+)  ", usage, re.MULTILINE))
        self.assertIn("--no-legend", flags)
        self.assertNotIn("--output", flags)
        for flag in flags - {"--help", "--version"}:
            self.assert_error(2, ["no file is given"], flag)

    def test_bad_usage(self):
        self.assert_error(2, ["no file is given"])
        self.assert_error(2, ["--colour"], self.heights, "--colour", "red")
        self.assert_error(2, ["more than one file"], self.heights, self.heights)
        self.assert_error(2, ["--output", "value"], self.heights, "--output")
        self.assert_error(2, [".png", "a.jpg"], self.heights, "--output", "a.jpg")
        self.assert_error(2, [".vtp", "a.off"], self.heights, "--export", "a.off")
        self.assert_error(2, ["--max-level", "'8'"], self.heights, "--max-level", "8")
        self.assert_error(2, ["--max-level", "'-1'"], self.heights, "--max-level", "-1")
        self.assert_error(2, ["--max-level", "'2.5'"], self.heights, "--max-level", "2.5")
        self.assert_error(2, ["--exaggeration", "'nan'"], self.heights, "--exaggeration", "nan")
        self.assert_error(2, ["--exaggeration", "'2x'"], self.heights, "--exaggeration", "2x")
        self.assert_error(2, ["--metric", "region", "'slope'"], self.heights, "--metric", "slope")
        self.assert_error(2, ["--color-by", "'hue'"], self.heights, "--color-by", "hue")
        self.assert_error(2, ["--segments", "'3'"], self.heights, "--segments", "3")
        self.assert_error(2, ["--pixels", "'0'"], self.heights, "--pixels", "0")
        self.assert_error(2, ["--pixels", "screen-edge"], self.heights, "--pixels", "3")
        self.assert_error(2, ["--reach", "distance"], self.heights, "--metric=field", "--reach=9")
        for region in ("1,2", "1,2,0", "1,2,3,4", "1,x,2"):
            self.assert_error(
                2, ["--region"], self.heights, "--metric", "region", "--region", region
            )
        self.assert_error(2, ["--region", "region"], self.heights, "--region", "1,2,3")
        self.assert_error(2, ["--height requires a mesh"], self.heights, "--height", self.heights)
        self.assert_error(2, ["--level"], self.heights, "--level=2", "--metric=curvature")
        self.assert_error(
            2, ["--error requires --metric height"], self.heights, "--error=1", "--metric=distance"
        )
        self.assert_error(2, ["--error cannot be"], self.heights, "--error=1", "--level=1")
        self.assert_error(2, ["--tolerance requires --export"], self.heights, "--tolerance=1")
        for tolerance in ("0", "-1", "nan"):
            self.assert_error(2, ["--tolerance"], self.heights, f"--tolerance={tolerance}")
        export = ("--export", "a.vtp", "--tolerance=1")
        self.assert_error(2, ["--error"], self.heights, *export, "--error=1")
        self.assert_error(2, ["--metric height"], self.heights, *export, "--metric=curvature")
        self.assert_error(2, ["--tolerance cannot be"], self.heights, *export, "--level=1")
        self.assert_error(2, ["--surface", "'nurbs'"], self.heights, "--surface", "nurbs")
        self.assert_error(2, ["--method", "'fast'"], self.heights, "--method", "fast")
        self.assert_error(2, ["--view", "elevation"], self.heights, "--view", "0,90.5")
        self.assert_error(2, ["--budget", "'0'"], self.heights, "--budget", "0")
        self.assert_error(2, ["--budget"], self.heights, "--budget=9", "--export", "a.vtp")
        for bands in ("1,2", "1,2,3,4", "1,2,x", "0,1,2"):
            self.assert_error(2, ["--imagery-bands"], self.heights, "--imagery-bands", bands)
        self.assert_error(2, ["--size", "'640'"], self.heights, "--size", "640")
        self.assert_error(2, ["--size", "'0'"], self.heights, "--size", "0x480")

    def test_bad_input(self):
        out = ("--output", self.folder / "never.png")
        self.assert_error(1, ["missing.tif"], "missing.tif", *out)
        text = self.folder / "text.tif"
        text.write_text("not an image")
        self.assert_error(1, ["text.tif"], text, *out)
        (self.folder / "empty.png").write_bytes(b"")
        self.assert_error(1, ["empty.png"], self.folder / "empty.png", *out)
        self.assert_error(1, ["missing.jpg"], self.heights, "--imagery", "missing.jpg", *out)
        self.assert_error(1, ["nowhere"], self.heights, "--output", "nowhere/a.png")
        self.assert_error(1, ["nowhere"], self.heights, "--export", "nowhere/a.vtp")
        self.assert_error(1, ["display", "--output"], self.heights)
        self.assertFalse((self.folder / "never.png").exists())

    def test_display_out_of_reach(self):
        run = subprocess.run(
            [str(PROGRAM), str(self.heights)],
            env={**os.environ, "DISPLAY": "no-such-host:0"},
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 1, run.stderr)
        # VTK 9.4 and later may print a warning first.
        self.assertRegex(run.stderr, r"(?m)^relevo-view: error: .+DISPLAY=no-such-host.+\n\Z")

    def test_picture_without_display(self):
        image = self.picture("--size", "320x200")
        self.assertEqual(image.GetDimensions(), (320, 200, 1))
        colours = set()
        for j in range(0, 200, 10):
            for i in range(0, 320, 10):
                colours.add(tuple(image.GetScalarComponentAsFloat(i, j, 0, c) for c in range(3)))
        self.assertGreater(len(colours), 50)
        # The view fits: the left and right borders show sky, the middle shows terrain.
        for i in (0, 319):
            for j in range(0, 200, 10):
                sky = [image.GetScalarComponentAsFloat(i, j, 0, c) for c in range(3)]
                self.assertGreater(sky[2], sky[0])

    @unittest.skipUnless(os.environ.get("DISPLAY"), "no display")
    def test_window(self):
        window = subprocess.Popen(
            [str(PROGRAM), str(self.heights), "--stats", "--size", "300x200"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            # Statistics appear when the window has drawn. It stays open.
            self.assertTrue(any("frame time" in window.stdout.readline() for _ in range(9)))
            with self.assertRaises(subprocess.TimeoutExpired):
                window.wait(1)
        finally:
            window.kill()
            self.assertEqual(window.communicate()[1], "")

    def test_wireframe_differs(self):
        solid = self.picture("--size", "160x100")
        wires = self.picture("--size", "160x100", "--wireframe", "--resolution", "4")
        different = sum(
            solid.GetScalarComponentAsFloat(i, j, 0, 1) != wires.GetScalarComponentAsFloat(i, j, 0, 1)
            for i in range(160)
            for j in range(100)
        )
        self.assertGreater(different, 1000)

    def test_stretch(self):
        dark = vtkImageData()
        dark.SetDimensions(16, 16, 1)
        dark.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
        for j in range(16):
            for i in range(16):
                for band in range(3):
                    dark.SetScalarComponentFromDouble(i, j, 0, band, 20 + i + j)
        name = self.folder / "dark.png"
        writer = vtkPNGWriter()
        writer.SetFileName(str(name))
        writer.SetInputData(dark)
        writer.Write()

        def brightest(*arguments):
            image = self.picture("--size", "80x50", "--imagery", name, *arguments)
            middle = [(i, j) for i in range(30, 50) for j in range(20, 30)]
            return max(image.GetScalarComponentAsFloat(i, j, 0, 0) for i, j in middle)

        self.assertLess(brightest(), 80)
        self.assertGreater(brightest("--stretch"), 120)

    def test_statistics(self):
        run = self.view(
            self.heights, "--stats", "--max-level", "2", "--output", "s.png", "--size=200x100"
        )
        lines = dict(line.split(": ") for line in run.stdout.splitlines())
        self.assertEqual(
            list(lines),
            [
                "coarse faces",
                "culled faces",
                "drawn triangles",
                "culled triangles",
                "patterns",
                "draw calls",
                "graphics memory",
                "selection time",
                "frame time",
            ],
        )
        self.assertGreaterEqual(int(lines["culled faces"]), 0)
        self.assertGreater(int(lines["patterns"]), 0)
        self.assertGreaterEqual(float(lines["selection time"].removesuffix(" ms")), 0.0)
        self.assertGreaterEqual(int(lines["drawn triangles"]), int(lines["coarse faces"]))
        self.assertGreater(int(lines["draw calls"]), 0)
        self.assertGreater(float(lines["graphics memory"].removesuffix(" MiB")), 0.0)
        self.assertGreater(float(lines["frame time"].removesuffix(" ms")), 0.0)
        # The picture is the same without the option.
        self.view(self.heights, "--max-level", "2", "--output", "plain.png", "--size=200x100")
        pictures = [(self.folder / name).read_bytes() for name in ("s.png", "plain.png")]
        self.assertEqual(*pictures)

    def triangles(self, *arguments):
        return self.statistic("drawn triangles", self.heights, *arguments)

    def test_metrics(self):
        counts = {
            metric: self.triangles("--metric", metric, "--max-level", "3", "--resolution", "12")
            for metric in METRICS
        }
        coarse = self.triangles("--level", "0", "--resolution", "12")
        self.assertTrue(all(coarse < n < 64 * coarse for n in counts.values()), counts)
        self.assertGreater(len(set(counts.values())), 6, counts)

    def test_parameters_of_metrics(self):
        common = ("--max-level", "4", "--resolution", "6")

        def falls(metric, option, small, large):
            self.assertGreater(
                self.triangles(*common, "--metric", metric, option, small),
                self.triangles(*common, "--metric", metric, option, large),
            )

        falls("screen-edge", "--pixels", "2", "20")
        falls("distance", "--reach", "1000", "100")
        falls("region", "--region", "0,0,12", "0,0,2")
        per_vertex = self.triangles(*common, "--metric", "screen-edge")
        self.assertLess(self.triangles(*common, "--metric", "screen-edge", "--per-edge"), per_vertex)

    def test_budget(self):
        for metric in ("distance", "screen-edge"):
            count = self.triangles(
                "--metric", metric, "--max-level=5", "--resolution=12", "--budget=20000"
            )
            self.assertLess(abs(count - 20000), 1000)

    def test_export_of_a_region(self):
        """The mesh is finest around the region's centre."""
        mesh = self.mesh(
            "--metric=region", "--region=12,8,2", "--max-level=3", "--resolution=6"
        )
        near = [0, 0]
        for i in range(mesh.GetNumberOfPoints()):
            x, y, _ = mesh.GetPoint(i)
            for k, (px, py) in enumerate(((12, 8), (-12, -8))):
                near[k] += math.hypot(x - px, y - py) < 4
        self.assertGreater(near[0], 8 * near[1])

    def test_segments(self):
        powers = self.triangles("--metric=screen-edge", "--no-geomorphing", "--resolution=6")
        whole = self.triangles("--metric=screen-edge", "--segments=whole", "--resolution=6")
        self.assertNotEqual(powers, whole)

    def test_export_has_no_geomorphing(self):
        """The mesh is the same with and without geomorphing: in a file, vertices have their final
        positions."""
        meshes = [
            self.mesh("--metric=screen-edge", "--resolution=6", *arguments)
            for arguments in ((), ("--no-geomorphing",))
        ]
        self.assertEqual(*(mesh.GetNumberOfCells() for mesh in meshes))
        self.assertEqual(*(mesh.GetBounds() for mesh in meshes))
        self.assertEqual(
            *([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())] for mesh in meshes)
        )

    def test_colors(self):
        """A legend beside the terrain has the colours of the mode."""
        common = ("--size", "480x300", "--max-level", "2", "--resolution", "12")
        colors = {}
        for mode in ("level", "pattern", "metric"):
            image = self.picture(*common, "--metric", "region", "--color-by", mode)
            colors[mode] = {
                tuple(image.GetScalarComponentAsFloat(i, j, 0, c) for c in range(3))
                for i in range(4, 45)
                for j in range(300)
            }
        # The ends of Viridis, violet and yellow, appear in the legends of levels and metric.
        for mode in ("level", "metric"):
            self.assertTrue(any(r < 80 and g < 20 and b < 110 for r, g, b in colors[mode]), mode)
            self.assertTrue(any(r > 230 and g > 200 and b < 80 for r, g, b in colors[mode]), mode)
        self.assertGreater(len(colors["metric"]), len(colors["level"]))
        self.assertTrue(any(r > 215 and b > 195 and g < 120 for r, g, b in colors["pattern"]))

    def test_export_is_the_displaced_terrain(self):
        mesh = self.mesh("--exaggeration", "2", "--max-level", "3", "--metric", "distance")
        bounds = mesh.GetBounds()
        # Without georeference one texel is one unit, and the origin is the centre.
        for bound, expected in zip(bounds, (-24, 24, -16, 16)):
            self.assertAlmostEqual(bound, expected, places=3)
        self.assertAlmostEqual(bounds[4], 0.0, delta=1.0)
        self.assertAlmostEqual(bounds[5], 60.0, delta=1.0)
        top = max(range(mesh.GetNumberOfPoints()), key=lambda i: mesh.GetPoint(i)[2])
        x, y, _ = mesh.GetPoint(top)
        self.assertAlmostEqual(x, 48 * 0.65 - 24, delta=1.5)
        self.assertAlmostEqual(y, 32 * 0.65 - 16, delta=1.5)

    def test_export_faces_up(self):
        mesh = self.mesh("--metric", "curvature")
        self.assertGreater(mesh.GetNumberOfCells(), 1000)
        normals = vtkPolyDataNormals()
        normals.SetInputData(mesh)
        normals.ComputePointNormalsOff()
        normals.ComputeCellNormalsOn()
        normals.ConsistencyOff()
        normals.SplittingOff()
        normals.Update()
        cells = normals.GetOutput().GetCellData().GetNormals()
        self.assertEqual(cells.GetNumberOfTuples(), mesh.GetNumberOfCells())
        self.assertTrue(all(cells.GetComponent(i, 2) > 0 for i in range(cells.GetNumberOfTuples())))

    def test_export_level(self):
        common = ("--metric", "distance", "--resolution", "6")
        coarse = self.mesh("--max-level", "0", *common)
        fine = self.mesh("--max-level", "2", *common)
        self.assertEqual(coarse.GetNumberOfCells(), 2 * 6 * 4)
        self.assertGreater(fine.GetNumberOfCells(), coarse.GetNumberOfCells())
        self.assertLessEqual(fine.GetNumberOfCells(), 16 * coarse.GetNumberOfCells())

    def test_export_to_a_tolerance(self):
        """The view does not matter, and a smaller tolerance takes more triangles."""
        if self.run_program(self.heights, "--export=t.vtp", "--tolerance=9").returncode != 0:
            self.skipTest("a build without GDAL")
        counts = [
            self.mesh("--tolerance", *options).GetNumberOfCells()
            for options in (("1",), ("1", "--zoom=9"), ("0.1",))
        ]
        self.assertEqual(counts[0], counts[1])
        self.assertGreater(counts[2], counts[0])

    def test_error_of_heights(self):
        common = ("--resolution=6", "--max-level=6")
        counts = [self.triangles("--error", error, *common) for error in ("1", "4", "16")]
        self.assertGreater(counts[0], counts[1])
        self.assertGreater(counts[1], counts[2])
        self.assertEqual(counts[0], self.triangles("--metric", "height", *common))

    def test_uniform_level(self):
        mesh = self.mesh("--level", "2", "--resolution", "6")
        self.assertEqual(mesh.GetNumberOfCells(), 2 * 6 * 4 * 4**2)

    def test_no_data(self):
        name = DATA / "relief" / "luxembourg_elev.tif"
        if not name.exists():
            self.skipTest("no RELEVO_TEST_DATA")
        hole = self.mesh("--max-level", "1", heights=name)
        filled = self.mesh("--max-level", "1", "--no-data", "fill", heights=name)
        self.assertLess(hole.GetNumberOfCells(), filled.GetNumberOfCells())
        for mesh in (hole, filled):
            self.assertGreater(mesh.GetBounds()[4], 0)
            self.assertLess(mesh.GetBounds()[5], 600)
        borders = vtkFeatureEdges()
        borders.SetInputData(filled)
        borders.FeatureEdgesOff()
        borders.NonManifoldEdgesOff()
        borders.ManifoldEdgesOff()
        borders.Update()
        for i in range(borders.GetOutput().GetNumberOfPoints()):
            x, y, _ = borders.GetOutput().GetPoint(i)
            bounds = filled.GetBounds()
            inside = min(x - bounds[0], bounds[1] - x, y - bounds[2], bounds[3] - y)
            self.assertLess(inside, 0.01 * (bounds[1] - bounds[0]))


if __name__ == "__main__":
    unittest.main(argv=["TestViewer"])
