# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that the Python examples run and draw something, and that the pages show their results."""

import ast
import atexit
import base64
import errno
import json
import math
import os
import pathlib
import re
import sys
import tempfile
import unittest

import relevo
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

from ForkedScripts import ForkedScripts
from GifFile import GifFile
from ViewerPictures import largest_difference, limit_for_decimated, mean_of_blocks

SOURCE = pathlib.Path(os.environ["RELEVO_SOURCE_DIR"])
FLOW = pathlib.Path(os.environ.get("RELEVO_TEST_DATA", ""), "flow")
VOLUME = FLOW.parent / "volume"
# README.md and all pages.
PAGES = "\n".join(
    page.read_text()
    for page in (SOURCE / "README.md", *sorted((SOURCE / "Module/Documentation").glob("*.md")))
)
if not hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
    print("skipped: built without rendering, or without EGL")
    sys.exit(125)
SCRIPTS = ForkedScripts()
atexit.register(SCRIPTS.close)


def write_heights(path, value):
    image = vtkImageData()
    image.SetDimensions(40, 40, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    for j in range(40):
        for i in range(40):
            image.SetScalarComponentFromDouble(i, j, 0, 0, value(i, j))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def colour_set(picture):
    scalars = picture.GetPointData().GetScalars()
    return {scalars.GetTuple(i)[:3] for i in range(picture.GetNumberOfPoints())}


class TestExamples(unittest.TestCase):
    def test_terrain(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "heights.png", lambda i, j: (i * j) // 160)
            run = self.run_example("terrain.py", folder, "heights.png", "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertRegex(run.stdout, r"^[1-9]\d* triangles, exact to 1 pixel\n$")
            reader = vtkPNGReader()
            reader.SetFileName(str(folder / "out.png"))
            reader.Update()
            picture = reader.GetOutput()
            self.assertEqual(picture.GetDimensions(), (800, 500, 1))
            shades = {
                picture.GetScalarComponentAsFloat(i, j, 0, 0)
                for j in range(0, 500, 25)
                for i in range(0, 800, 25)
            }
            self.assertGreater(len(shades), 10)

    def test_one_line(self):
        """Each function draws its files; the stored pictures are those of real data."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "heights.png", lambda i, j: (i * j) // 160)
            sphere = vtkSphereSource()
            writer = vtkPLYWriter()
            writer.SetFileName(str(folder / "mesh.ply"))
            writer.SetInputConnection(sphere.GetOutputPort())
            writer.Write()
            real = FLOW.parent
            drawings = {
                "terrain.jpg": ("heights.png", "heights.png"),
                "refined.png": ("mesh.ply",),
                "volume.png": (str(VOLUME / "can.vtu"),),
                "patches.png": (str(real / "mesh/teapot.bpt"),),
                "time.png": (str(real / "result/mug.e"),),
                "lic.jpg": (str(FLOW / "SurfaceVectors.vtk"),),
                "streamlines.jpg": (str(FLOW / "office.binary.vtk"),),
                "relief.jpg": ("heights.png",),
            }
            for file, inputs in drawings.items():
                kind = file.split(".")[0]
                self.assertIn(f"Examples/Python/oneline/{file}", PAGES)
                self.assertTrue((SOURCE / "Examples/Python/oneline" / file).exists())
                if not (folder / inputs[0]).exists():
                    continue
                run = self.run_example("oneline.py", folder, kind, f"{kind}.png", *inputs)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertRegex(run.stdout, rf"^{kind}: [1-9]\d+ points\n$")
                picture = read_picture(folder / f"{kind}.png")
                self.assertEqual(picture.GetDimensions(), (640, 400, 1))
                self.assertGreater(len(colour_set(picture)), 300)
            for arguments in (("terrain",), ("size", "p.png", "mesh.ply"), ("lic", "p.png")):
                run = self.run_example("oneline.py", folder, *arguments)
                self.assertEqual(run.returncode, 1)
                self.assertIn("usage: oneline.py NAME", run.stderr)

    def test_terrain_error(self):
        """The picture of a terrain is within one pixel of its data; the stored one is real data."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "heights.png", lambda i, j: 20 + (i - 20) * (j - 15) // 40)
            run = self.run_example("terrainerror.py", folder, "heights.png", "out.png")
            self.assertEqual(run.returncode, 0, run.stderr)
            error = re.fullmatch(r"\d+ triangles; largest error (\S+) pixels\n", run.stdout)
            self.assertLess(float(error[1]), 1.02)
            run = self.run_example("terrainerror.py", folder, "none.png", "out.png")
            self.assertEqual(run.returncode, 1)
            self.assertIn("cannot read 'none.png'", run.stderr)
            real = FLOW.parent / "relief/SainteHelens.dem"
            if not real.exists():
                return
            run = self.run_example("terrainerror.py", folder, str(real), "out.png")
            error = re.fullmatch(r"\d+ triangles; largest error (\S+) pixels\n", run.stdout)
            self.assertLess(float(error[1]), 1.02)
            self.assert_kept(folder / "out.png", SOURCE / "Examples/Python/terrainerror.png")

    def test_track(self):
        """The track and the area are drawn; the stored picture is that of real data."""
        kept = SOURCE / "Examples/Python/track.png"
        self.assertIn("Examples/Python/track.png", PAGES)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "heights.png", lambda i, j: 20 + (i - 20) * (j - 15) // 40)
            run = self.run_example("track.py", folder, "heights.png", "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            numbers = re.fullmatch(r"361 points, (\d+) on the terrain\n", run.stdout)
            self.assertGreater(int(numbers[1]), 400)
            colours = colour_set(read_picture(folder / "out.png"))
            self.assertTrue(any(r > 200 and g < 40 for r, g, b in colours))
            self.assertTrue(any(b > r + 60 for r, g, b in colours))
            run = self.run_example("track.py", folder, "heights.png", "out.png", "none.csv")
            self.assertEqual(run.returncode, 1)
            self.assertIn("cannot read 'none.csv'", run.stderr)
            real = FLOW.parent / "relief/SainteHelens.dem"
            if not real.exists():
                return
            run = self.run_example("track.py", folder, str(real), "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assert_kept(folder / "out.png", kept)
            (folder / "track.csv").write_text("-122.22,46.18\n-122.16,46.18\n-122.16,46.22\n")
            run = self.run_example("track.py", folder, str(real), "out.png", "track.csv")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            numbers = re.fullmatch(r"3 points, (\d+) on the terrain\n", run.stdout)
            self.assertGreater(int(numbers[1]), 100)

    def test_legend(self):
        """The legend names the colours; the stored picture is that of real data."""
        kept = SOURCE / "Examples/Python/legend.png"
        self.assertIn("Examples/Python/legend.png", PAGES)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "heights.png", lambda i, j: max(0, (i - 10) * j // 10))
            titles = {
                "height": "Height",
                "slope": "Slope [degrees]",
                "aspect": "Aspect [degrees]",
                "hillshade": "Hillshade",
                "heights.png": "Value",
            }
            for colours, title in titles.items():
                run = self.run_example("legend.py", folder, "heights.png", "out.png", colours)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertEqual(run.stdout, f"heights.png: {title}\n")
                scalars = read_picture(folder / "out.png").GetPointData().GetScalars()
                bar = {scalars.GetTuple(800 * y + 45)[:3] for y in range(170, 440, 9)}
                self.assertGreater(len(bar), 15)
            run = self.run_example("legend.py", folder, "heights.png", "out.png", "none.tif")
            self.assertEqual(run.returncode, 1)
            self.assertIn("cannot read 'none.tif'", run.stderr)
            real = FLOW.parent / "relief/N57E011.hgt"
            if not real.exists():
                return
            run = self.run_example("legend.py", folder, str(real), "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(run.stdout, "N57E011.hgt: Height [m]\n")
            self.assert_kept(folder / "out.png", kept)

    def test_solid(self):
        """The solid is closed and drawn; the stored picture is that of real data."""
        kept = SOURCE / "Examples/Python/solid.png"
        self.assertIn("Examples/Python/solid.png", PAGES)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "heights.png", lambda i, j: max(0, (i - 10) * j // 100))
            run = self.run_example("solid.py", folder, "heights.png", "out.png", "model.stl")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            numbers = re.fullmatch(r"(\d+) triangles, 0 open edges\n", run.stdout)
            self.assertEqual(
                (folder / "model.stl").stat().st_size, 84 + 50 * int(numbers[1]), run.stdout
            )
            self.assertGreater(len(colour_set(read_picture(folder / "out.png"))), 10)
            real = FLOW.parent / "relief/SainteHelens.dem"
            if not real.exists():
                return
            run = self.run_example("solid.py", folder, str(real), "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertIn("triangles, 0 open edges", run.stdout)
            self.assert_kept(folder / "out.png", kept)

    def test_dense_mesh(self):
        """The micro-mesh has few faces and the picture of its mesh; the stored one is a scan's."""
        kept = SOURCE / "Examples/Python/densemesh.png"
        self.assertIn("Examples/Python/densemesh.png", PAGES)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            run = self.run_example("densemesh.py", folder, "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            said = r"(\d+) faces, at most 0.10 % of the diagonal from the mesh\n"
            self.assertLess(int(re.fullmatch(said, run.stdout)[1]), 500)
            scalars = read_picture(folder / "out.png").GetPointData().GetScalars()
            pixels = [scalars.GetTuple(1280 * y + x) for y in range(60, 280) for x in range(320)]
            others = [
                scalars.GetTuple(1280 * y + x) for y in range(60, 280) for x in range(640, 960)
            ]
            different = sum(
                max(abs(a - b) for a, b in zip(*colours)) > 24 for colours in zip(pixels, others)
            )
            self.assertLess(different, 0.02 * len(pixels))
            scan = FLOW.parent / "mesh/bunny.ply"
            if not scan.exists():
                return
            run = self.run_example("densemesh.py", folder, "out.png", str(scan))
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assert_kept(folder / "out.png", kept)

    def test_dense_colors(self):
        """The micro-mesh of a scan has its colours at every pixel."""
        kept = SOURCE / "Examples/Python/densecolors.png"
        self.assertIn("Examples/Python/densecolors.png", PAGES)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            run = self.run_example("densecolors.py", folder, "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertRegex(run.stdout, r"^\d{5} triangles, error 0.001\d\n$")
            scalars = read_picture(folder / "out.png").GetPointData().GetScalars()
            places = [1280 * y + x for y in range(60, 280) for x in range(320)]
            different = sum(
                max(abs(a - b) for a, b in zip(scalars.GetTuple(i), scalars.GetTuple(i + 320))) > 40
                for i in places
            )
            self.assertLess(different, 0.02 * len(places))
            self.assert_kept(folder / "out.png", kept)

    def test_names(self):
        """File names with a hyphen need --. Control characters in messages are escaped."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "-l.png", lambda i, j: 20)
            run = self.run_example("beside.py", folder, "--", "-l.png", "-l.png", "-o.jpg")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertTrue((folder / "-o.jpg").exists())
            run = self.run_example("beside.py", folder, "a\x1b[2J\n.png", "o.jpg")
            self.assertEqual(run.returncode, 1)
            self.assertEqual(
                run.stderr, f"cannot read 'a\\x1b[2J\\n.png': {os.strerror(errno.ENOENT)}\n"
            )

    def test_stmesh(self):
        with tempfile.TemporaryDirectory() as name:
            run = self.run_example("stmesh.py", name, "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            numbers = re.fullmatch(r"376 faces, (\d+) triangles\n", run.stdout)
            self.assertAlmostEqual(int(numbers[1]), 10000, delta=1500)
            reader = vtkPNGReader()
            reader.SetFileName(str(pathlib.Path(name) / "out.png"))
            reader.Update()
            self.assertEqual(reader.GetOutput().GetDimensions(), (1200, 420, 1))

    def assert_kept(self, file, kept, limit=12):
        """Compares a picture with the stored one, except for noise."""
        self.assertLess(largest_difference(file, kept), limit, kept)

    def run_example(self, script, folder, *arguments):
        return SCRIPTS.run([SOURCE / "Examples/Python" / script, *arguments], folder)

    def test_metrics(self):
        names = [path.stem for path in (SOURCE / "Examples/Python/metrics").glob("*.png")]
        self.assertEqual(len(names), 9)
        triangles = set()
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for metric in names:
                self.assertIn(f"Examples/Python/metrics/{metric}.png", PAGES)
                run = self.run_example("metrics.py", folder, metric, "out.png")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                numbers = re.fullmatch(r"(\d+) faces, (\d+) triangles\n", run.stdout)
                self.assertGreater(int(numbers[2]), int(numbers[1]))
                triangles.add(numbers[2])
                reader = vtkPNGReader()
                reader.SetFileName(str(folder / "out.png"))
                reader.Update()
                self.assertEqual(reader.GetOutput().GetDimensions(), (420, 270, 1))
        self.assertEqual(len(triangles), 9)

    def test_beside(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_heights(folder / "left.png", lambda i, j: 20)
            write_heights(folder / "right.png", lambda i, j: 200)
            run = self.run_example("beside.py", folder, "left.png", "right.png", "out.jpg")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            reader = vtkJPEGReader()
            reader.SetFileName(str(folder / "out.jpg"))
            reader.Update()
            picture = reader.GetOutput()
            self.assertEqual(picture.GetDimensions(), (80, 40, 1))
            for column, value in ((10, 20), (70, 200)):
                shade = picture.GetScalarComponentAsFloat(column, 20, 0, 0)
                self.assertAlmostEqual(shade, value, delta=3)

    def test_metrics_of_a_mesh(self):
        sphere = vtkSphereSource()
        writer = vtkPLYWriter()
        writer.SetInputConnection(sphere.GetOutputPort())
        with tempfile.TemporaryDirectory() as name:
            writer.SetFileName(str(pathlib.Path(name) / "sphere.ply"))
            writer.Write()
            run = self.run_example("metrics.py", name, "contour", "out.png", "sphere.ply")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertTrue(run.stdout.startswith("96 faces, "), run.stdout)
            run = self.run_example("metrics.py", name, "slope", "out.png")
            self.assertEqual(run.returncode, 1)
            self.assertIn("screen-edge", run.stderr)

    def test_surfaces(self):
        """Each figure can be drawn, and a page shows the stored one."""
        names = [path.stem for path in (SOURCE / "Examples/Python/surfaces").glob("*.png")]
        self.assertEqual(set(names), {"surfaces", "inflections", "fur", "parts", "relief"})
        for name in names:
            self.assertIn(f"Examples/Python/surfaces/{name}.png", PAGES)
        with tempfile.TemporaryDirectory() as folder:
            for name in names:
                run = self.run_example("surfaces.py", folder, name, "out.png")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertRegex(run.stdout, r"\A[1-9]\d{4,} triangles\n\Z")
                reader = vtkPNGReader()
                reader.SetFileName(str(pathlib.Path(folder) / "out.png"))
                reader.Update()
                picture = reader.GetOutput()
                kept = vtkPNGReader()
                kept.SetFileName(str(SOURCE / f"Examples/Python/surfaces/{name}.png"))
                kept.Update()
                size = picture.GetDimensions()
                self.assertEqual(size, kept.GetOutput().GetDimensions())
                # Panels of all columns show something in their middle third.
                row = size[1] // 4
                for column in range(2):
                    shades = {
                        picture.GetScalarComponentAsFloat(i, row, 0, 0)
                        for i in range(column * size[0] // 2, (column + 1) * size[0] // 2, 3)
                    }
                    self.assertGreater(len(shades), 5, name)
            run = self.run_example("surfaces.py", folder, "nurbs", "out.png")
            self.assertEqual(run.returncode, 1)
            self.assertIn("inflections", run.stderr)

    def test_object_space(self):
        with tempfile.TemporaryDirectory() as name:
            run = self.run_example("objectspace.py", name, "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            coarse, fine, zoomed = map(int, re.findall(r"\d+(?= triangles,| by| with)", run.stdout))
            self.assertEqual(coarse, 2688)
            self.assertLess(2 * coarse, fine)
            self.assertLess(fine, zoomed)
            sizes = set()
            for path in (
                pathlib.Path(name) / "out.png",
                SOURCE / "Examples/Python/objectspace.png",
            ):
                reader = vtkPNGReader()
                reader.SetFileName(str(path))
                reader.Update()
                sizes.add(reader.GetOutput().GetDimensions())
            self.assertEqual(sizes, {(1080, 600, 1)})
            self.assertIn("Examples/Python/objectspace.png", PAGES)

    def test_wind(self):
        """The flow goes around a cone that rises through the lid."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)

            def cone(i, j):
                return max(0, 10 - math.hypot(i - 19.5, j - 19.5))

            write_heights(folder / "cone.png", cone)
            run = self.run_example("wind.py", folder, "cone.png", "out.png", "5")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            numbers = re.fullmatch(r"(\d+) triangles, wind up to (.+) m/s\n", run.stdout)
            self.assertGreaterEqual(int(numbers[1]), 2 * 40 * 40)
            self.assertGreater(float(numbers[2]), 13)
            self.assertLess(float(numbers[2]), 40)
            reader = vtkPNGReader()
            reader.SetFileName(str(folder / "out.png"))
            reader.Update()
            kept = vtkPNGReader()
            kept.SetFileName(str(SOURCE / "Examples/Python/wind.png"))
            kept.Update()
            size = kept.GetOutput().GetDimensions()
            self.assertEqual(reader.GetOutput().GetDimensions(), size)
            shades = {
                reader.GetOutput().GetScalarComponentAsFloat(i, size[1] // 2, 0, 0)
                for i in range(size[0] // 4, 3 * size[0] // 4)
            }
            self.assertGreater(len(shades), 30)
        self.assertIn("Examples/Python/wind.png", PAGES)

    def test_flow_around_a_cylinder(self):
        """Compares the wind of wind.py in a layer with a hole with the potential flow around it."""
        sys.path.append(str(SOURCE / "Examples/Python"))
        import numpy
        import wind

        size, radius = 200, 20.0
        x, y = numpy.meshgrid(numpy.arange(size) - 100.0, 1.5 * numpy.arange(size) - 150.0)
        r2 = x**2 + y**2
        u, v = wind.flow(numpy.where(r2 < radius**2, 0.0, 700.0), 1.0, 1.5)
        self.assertEqual(numpy.abs(u[r2 < radius**2]).max(), 0.0)
        angle = math.radians(wind.FROM + 180)
        far = wind.SPEED * complex(math.sin(angle), -math.cos(angle))  # conjugate velocity
        z = x + 1j * y
        expected = far - far.conjugate() * radius**2 / numpy.where(r2 > 0, z, 1) ** 2
        beside = (r2 > (1.3 * radius) ** 2) & (r2 < (2.5 * radius) ** 2)
        error = numpy.hypot(u - expected.real, v + expected.imag)[beside]
        self.assertLess(numpy.sqrt((error**2).mean()), 0.04 * wind.SPEED)
        self.assertGreater(numpy.abs(expected[beside]).max(), 1.5 * wind.SPEED)
        self.assertLess(numpy.abs(expected[beside]).min(), 0.5 * wind.SPEED)

    def test_flow_loop(self):
        """All frames differ, and the last and first differ no more than neighbours."""
        with tempfile.TemporaryDirectory() as name:
            run = self.run_example("flowloop.py", name, "out.gif", "6")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(run.stdout, "6 frames, 6 convolutions\n")
            loop = GifFile(pathlib.Path(name) / "out.gif")
        self.assertEqual((len(loop.frames), loop.repetitions), (6, 0))
        greens = [[loop.palette[index][1] for index in frame] for frame in loop.frames]
        steps = [
            math.dist(greens[i], greens[(i + 1) % 6]) / math.sqrt(len(greens[0])) for i in range(6)
        ]
        self.assertGreater(min(steps), 3)
        self.assertLess(max(steps), 1.15 * min(steps))
        kept = SOURCE / "Examples/Python/flowloop.gif"
        self.assertLess(kept.stat().st_size, 600000)
        self.assertEqual(GifFile(kept).size, loop.size)
        self.assertEqual(len(GifFile(kept).frames), 16)
        self.assertIn("Examples/Python/flowloop.gif", PAGES)

    def test_flow(self):
        """Each figure can be drawn and equals the stored one, except for noise."""
        files = {
            "plane": "SurfaceVectors.vtk",
            "disk": "disk_out_ref_surface.vtp",
            "office": "office.binary.vtk",
        }
        names = {path.stem for path in (SOURCE / "Examples/Python/flow").glob("*.png")}
        self.assertEqual(names, {"fields", "levels", "looks", "oriented", *files})
        with tempfile.TemporaryDirectory() as folder:
            for name in sorted(names):
                self.assertIn(f"Examples/Python/flow/{name}.png", PAGES)
                data = [str(FLOW / files[name])] if name in files else []
                if data and not FLOW.is_dir():
                    continue
                run = self.run_example("flow.py", folder, name, "out.png", *data)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertRegex(run.stdout, r"\A[1-9]\d{2,} triangles\n\Z")
                picture = mean_of_blocks(pathlib.Path(folder) / "out.png")
                kept = mean_of_blocks(SOURCE / f"Examples/Python/flow/{name}.png")
                self.assertEqual(len(picture), len(kept))
                differences = [
                    max(abs(a - b) for a, b in zip(*colours)) for colours in zip(picture, kept)
                ]
                self.assertLess(sum(differences) / len(differences), 4, name)
                self.assertLess(sorted(differences)[int(0.98 * len(differences))], 30, name)
            for arguments in (["vortex", "out.png"], ["plane", "out.png"]):
                run = self.run_example("flow.py", folder, *arguments)
                self.assertEqual(run.returncode, 1)
                self.assertIn("oriented", run.stderr)

    def test_volumes(self):
        """Each figure can be drawn for a generated mesh, and for real data equals the stored one.
        """
        files = {
            "fin": ["bluntfinxyz.bin", "bluntfinq.bin"],
            "post": ["postxyz.bin", "postq.bin"],
            "reactor": ["../flow/disk_out_ref.ex2"],
            "can": ["can.vtu"],
            "probe": ["postxyz.bin", "postq.bin"],
            "curved": [],
            "stress": [],
        }
        names = {path.stem for path in (SOURCE / "Examples/Python/volumes").glob("*.png")}
        self.assertEqual(names, set(files))
        with tempfile.TemporaryDirectory() as folder:
            for name, data in files.items():
                self.assertIn(f"Examples/Python/volumes/{name}.png", PAGES)
                run = self.run_example("volumes.py", folder, name, "made.png")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                cells = {"curved": "4 cells\n1536 cells\n", "stress": "224 cells\n224 cells\n"}
                self.assertRegex(run.stdout, cells.get(name, r"\A[1-9]\d{3,} cells\n\Z"))
                made = mean_of_blocks(pathlib.Path(folder) / "made.png")
                self.assertGreater(len(set(made)), 0.2 * len(made), name)
                if data and not VOLUME.is_dir():
                    continue
                real = [str(VOLUME / file) for file in data]
                run = self.run_example("volumes.py", folder, name, "out.png", *real)
                self.assertEqual(run.returncode, 0, run.stderr)
                kept = SOURCE / f"Examples/Python/volumes/{name}.png"
                self.assert_kept(pathlib.Path(folder) / "out.png", kept)
            for arguments in (["shock", "out.png"], ["can"], ["fin", "out.png", "q.bin"]):
                run = self.run_example("volumes.py", folder, *arguments)
                self.assertEqual(run.returncode, 1)
                self.assertIn("reactor", run.stderr)

    def test_reliefs(self):
        """Each figure can be drawn for generated data, and for real data equals the stored one."""
        files = {
            "box": ("box", "mesh/bunny.ply"),
            "teapot": ("box", "mesh/teapot.g"),
            "methods": ("methods", "relief/mt_rainier_90m.tif"),
            "camera": ("camera", "volume/can.vtu"),
            "holes": ("holes", "mesh/bunny.ply"),
        }
        folder_of_kept = SOURCE / "Examples/Python/relief"
        self.assertEqual({path.stem for path in folder_of_kept.glob("*.png")}, set(files))
        with tempfile.TemporaryDirectory() as folder:
            for picture, (name, data) in files.items():
                self.assertIn(f"Examples/Python/relief/{picture}.png", PAGES)
                run = self.run_example("relief.py", folder, name, "made.png")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                made = mean_of_blocks(pathlib.Path(folder) / "made.png")
                self.assertGreater(len(set(made)), 0.1 * len(made), name)
                if not VOLUME.is_dir():
                    continue
                run = self.run_example("relief.py", folder, name, "out.png", str(FLOW.parent / data))
                self.assertEqual(run.returncode, 0, run.stderr)
                kept = folder_of_kept / f"{picture}.png"
                self.assert_kept(pathlib.Path(folder) / "out.png", kept)
            run = self.run_example("relief.py", folder, "ball", "out.png")
            self.assertEqual(run.returncode, 1)
            self.assertIn("holes", run.stderr)

    def test_patches_and_curves(self):
        """Each figure can be drawn for generated cells, and for real data equals the stored one."""
        figures = {
            "teapot": ("patches.py", "mesh/teapot.bpt"),
            "torus": ("patches.py", None),
            "field": ("patches.py", None),
            "can": ("patches.py", "volume/can.vtu"),
            "hair": ("curves.py", "mesh/bunny.ply"),
            "knot": ("curves.py", None),
        }
        folder_of_kept = SOURCE / "Examples/Python/patches"
        self.assertEqual({path.stem for path in folder_of_kept.glob("*.png")}, set(figures))
        with tempfile.TemporaryDirectory() as folder:
            for name, (script, data) in figures.items():
                self.assertIn(f"Examples/Python/patches/{name}.png", PAGES)
                run = self.run_example(script, folder, name, "made.png")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                made = mean_of_blocks(pathlib.Path(folder) / "made.png")
                self.assertGreater(len(set(made)), 0.1 * len(made), name)
                if data and not VOLUME.is_dir():
                    continue
                files = [str(FLOW.parent / data)] if data else []
                run = self.run_example(script, folder, name, "out.png", *files)
                self.assertEqual(run.returncode, 0, run.stderr)
                kept = folder_of_kept / f"{name}.png"
                self.assert_kept(pathlib.Path(folder) / "out.png", kept)
            for script in ("patches.py", "curves.py"):
                run = self.run_example(script, folder, "ball", "out.png")
                self.assertEqual(run.returncode, 1)
                self.assertIn("NAME is one of", run.stderr)

    def test_notebook(self):
        """The cells run, and print and draw the outputs that the notebook stores."""
        self.assertIn("Examples/Python/notebook.png", PAGES)
        notebook = json.loads((SOURCE / "Examples/Python/notebook.ipynb").read_text())
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        program = ["pictures = []"]
        printed = ""
        stored = []
        for cell in cells:
            for output in cell["outputs"]:
                printed += "".join(output.get("text", ""))
                stored += [output["data"]["image/png"]] if "data" in output else []
            tree = ast.parse("".join(cell["source"]))
            if isinstance(tree.body[-1], ast.Expr) and "data" in str(cell["outputs"]):
                shown = ast.unparse(tree.body.pop())
                program += [ast.unparse(tree), f"pictures.append(({shown})._repr_png_())"]
            else:
                program.append(ast.unparse(tree))
        program.append("for i, picture in enumerate(pictures):")
        program.append("    open(f'{i}.png', 'wb').write(picture)")
        with tempfile.TemporaryDirectory() as name:
            run = SCRIPTS.run(["-c"], name, "\n".join(program))
            self.assertEqual((run.returncode, run.stderr, run.stdout), (0, "", printed))
            self.assertEqual(len(stored), 3)
            for i, picture in enumerate(stored):
                kept = pathlib.Path(name) / "kept.png"
                kept.write_bytes(base64.b64decode(picture))
                self.assert_kept(pathlib.Path(name) / f"{i}.png", kept)

    def test_contacts(self):
        """Each figure can be drawn for generated meshes, and for real meshes equals the stored one.
        """
        meshes = [str(FLOW.parent / "mesh" / name) for name in ("bunny.ply", "teapot.g")]
        folder_of_kept = SOURCE / "Examples/Python/contact"
        kept_names = {"candidates.png", "displaced.png", "distance.png", "motion.gif"}
        self.assertEqual({path.name for path in folder_of_kept.iterdir()}, kept_names)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("candidates", "distance"):
                self.assertIn(f"Examples/Python/contact/{name}.png", PAGES)
                run = self.run_example("contact.py", folder, name, "made.png")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                made = mean_of_blocks(pathlib.Path(folder) / "made.png")
                self.assertGreater(len(set(made)), 0.3 * len(made), name)
                if not VOLUME.is_dir():
                    continue
                run = self.run_example("contact.py", folder, name, "out.png", *meshes)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                kept = folder_of_kept / f"{name}.png"
                self.assert_kept(pathlib.Path(folder) / "out.png", kept, limit_for_decimated(12))
            self.assertIn("Examples/Python/contact/displaced.png", PAGES)
            run = self.run_example("contact.py", folder, "displaced", "out.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assert_kept(pathlib.Path(folder) / "out.png", folder_of_kept / "displaced.png")
            run = self.run_example("contact.py", folder, "motion", "out.gif")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            made = GifFile(pathlib.Path(folder) / "out.gif")
            kept = GifFile(folder_of_kept / "motion.gif")
            self.assertIn("Examples/Python/contact/motion.gif", PAGES)
            self.assertEqual((len(kept.frames), kept.size), (len(made.frames), made.size))
            # The animation runs forwards and backwards: all frames except the first and the middle
            # one occur twice.
            for loop in (made, kept):
                self.assertEqual(len(set(loop.frames)), len(loop.frames) // 2 + 1)
            for arguments in (["ball", "out.png"], ["distance"], ["motion", "out.gif", "a.ply"]):
                run = self.run_example("contact.py", folder, *arguments)
                self.assertEqual(run.returncode, 1)
                self.assertIn("candidates", run.stderr)

    def test_flow_of_the_page(self):
        """The programs of flow.md draw streaks, and so does the program for VTK's mapper."""
        page = (SOURCE / "Module/Documentation/flow.md").read_text()
        pasted = [part.split("```")[0] for part in page.split("```python\n")[1:]]
        names = {}
        exec(next(text for text in pasted if "vtkArrayCalculator" in text), names)
        coarse = names["flow"]
        fine = names["mapper"]
        ported = next(text for text in pasted if "vtkSurfaceLICMapper" in text)
        exec(ported.split("# new\n")[0], names)
        flat = names["mapper"]
        self.assertIsNot(flat, fine)
        exec(ported, names)
        refined = names["mapper"]
        flat.SetInputConnection(coarse.GetOutputPort())
        self.assertEqual(flat.GetNumberOfSteps(), 40)
        shades = []
        refined.SetInputConnection(coarse.GetOutputPort())
        for mapper in (fine, flat, refined):
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer = vtkRenderer()
            renderer.AddActor(actor)
            window = relevo.vtkEGLOffscreenRenderWindow()
            window.SetSize(200, 200)
            window.AddRenderer(renderer)
            window.Render()
            self.assertEqual(mapper.GetNumberOfConvolutions(), 1)
            pixels = vtkUnsignedCharArray()
            window.GetPixelData(90, 90, 110, 110, 0, pixels, 0)
            shades.append({pixels.GetTuple3(i) for i in range(pixels.GetNumberOfTuples())})
        self.assertGreater(min(len(each) for each in shades), 50)
        counts = {
            mapper: mapper.GetNumberOfDrawnTriangles() + mapper.GetNumberOfCulledTriangles()
            for mapper in (fine, flat, refined)
        }
        self.assertEqual(counts[flat], coarse.GetOutput().GetNumberOfCells())
        self.assertEqual(counts[refined], 64 * counts[flat])
        self.assertGreater(counts[fine], counts[flat])
        # The number per coarse face is limited for all vectors.
        self.assertLessEqual(counts[fine], 64 * counts[flat])


if __name__ == "__main__":
    unittest.main(argv=["TestExamples"])
