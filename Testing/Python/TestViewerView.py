# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on camera, lights and legend: what is visible, and where."""

import math
import subprocess
import unittest

import relevo
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter

from ViewerPictures import find, is_surface, read_picture
from ViewerProgram import PROGRAM, ViewerProgram
from ViewerScenes import make_sphere, write_hill, write_mesh, write_sphere

WIDTH, HEIGHT = 160, 120
SIZE = f"--size={WIDTH}x{HEIGHT}"
ELLIPSOID = 'DATUM["WGS_1984",SPHEROID["WGS_1984",6378137,298.257223563]]'
GEOGRAPHIC = f'GEOGCS["WGS84",{ELLIPSOID},PRIMEM["Greenwich",0],UNIT["Degree",0.0174532925199433]]'
UTM = (f'PROJCS["UTM33N",{GEOGRAPHIC},PROJECTION["Transverse_Mercator"],'
       'PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],'
       'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],'
       'PARAMETER["false_northing",0],UNIT["Meter",1]]')
TOP = (48 * 0.65 - 24, 32 * 0.65 - 16)  # top of the hill


class TestViewerView(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.mesh = write_sphere(cls.folder)

    def picture(self, *arguments, size=SIZE):
        """Rows of (red, green, blue), lowest first."""
        self.view(*arguments, size, "--output=view.png")
        return read_picture(self.folder / "view.png")

    def brightness(self, picture, columns, rows):
        values = [sum(picture[j][i]) for j in rows for i in columns]
        return sum(values) / len(values)

    def assert_fits(self, picture):
        """The scene is as large as possible and centred."""
        left, right, low, high = find(picture, is_surface)
        self.assertAlmostEqual(left + right, WIDTH - 1, delta=4)
        self.assertAlmostEqual(low + high, HEIGHT - 1, delta=4)
        self.assertGreater(max((right - left) / WIDTH, (high - low) / HEIGHT), 0.88)

    def write_dot(self, x, y):
        """A white picture of the hill's size with a red dot at a point of the terrain."""
        image = vtkImageData()
        image.SetDimensions(240, 160, 1)
        image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
        for j in range(160):
            for i in range(240):
                distance = math.hypot((i + 0.5) / 5 - 24 - x, (j + 0.5) / 5 - 16 - y)
                for c in range(3):
                    image.SetScalarComponentFromDouble(
                        i, j, 0, c, 255 if c == 0 or distance > 0.8 else 0
                    )
        writer = vtkPNGWriter()
        writer.SetFileName(str(self.folder / "dot.png"))
        writer.SetInputData(image)
        writer.Write()
        return self.folder / "dot.png"

    def test_center_of_terrain(self):
        """The requested point is in the centre, also on a slope, and zoom brings it closer."""
        x, y = 3.0, -2.0

        def is_dot(r, g, b):
            return r > 2 * g and r > 2 * b

        common = (self.heights, "--image", self.write_dot(x, y), "--max-level=3")
        widths = {}
        for zoom in (1, 4):
            picture = self.picture(*common, f"--center={x},{y}", f"--zoom={zoom}")
            left, right, low, high = find(picture, is_dot)
            self.assertAlmostEqual(0.5 * (left + right), 0.5 * (WIDTH - 1), delta=1.5)
            self.assertAlmostEqual(0.5 * (low + high), 0.5 * (HEIGHT - 1), delta=1.5)
            widths[zoom] = right - left + 1
        self.assertAlmostEqual(widths[4] / widths[1], 4, delta=1)
        # With a height, another part of the picture is in the centre.
        high_up = self.picture(*common, f"--center={x},{y},30")
        _, _, low, high = find(high_up, is_dot)
        self.assertLess(high, 0.4 * HEIGHT)

    def test_center_of_mesh(self):
        """The pole of a sphere seen from the side: half of the picture is sky."""
        picture = self.picture(self.mesh, "--up=z", "--view=0,0", "--center=0,0,0.5", "--zoom=1.5")
        _, _, low, high = find(picture, is_surface)
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, 0.5 * HEIGHT, delta=3)

    def test_zoom(self):
        """Zoom magnifies the centre without entering the surface."""
        whole = find(self.picture(self.mesh, "--view=0,0"), is_surface)
        half = find(self.picture(self.mesh, "--view=0,0", "--zoom=0.5"), is_surface)
        self.assertAlmostEqual((whole[1] - whole[0]) / (half[1] - half[0]), 2, delta=0.3)
        for zoom in ("4", "20"):
            picture = self.picture(self.mesh, "--view=0,0", f"--zoom={zoom}")
            self.assertEqual(find(picture, is_surface), (0, WIDTH - 1, 0, HEIGHT - 1))

    def test_light(self):
        """The side that faces the light is brighter, for every side."""
        left, right = range(40, 70), range(90, 120)
        rows = range(40, 80)
        for scene, light, lit, dark in (
            ((self.mesh, "--up=z", "--view=180,0"), "270,10", left, right),
            ((self.mesh, "--up=z", "--view=180,0"), "90,10", right, left),
            ((self.heights, "--view=180,60"), "270,20", left, right),
            ((self.heights, "--view=180,60"), "90,20", right, left),
        ):
            if scene[0] == self.heights:
                scene = (*scene, "--center={},{}".format(*TOP), "--zoom=1.5", "--no-legend")
            picture = self.picture(*scene, f"--light={light}")
            self.assertGreater(
                self.brightness(picture, lit, rows), 1.2 * self.brightness(picture, dark, rows)
            )

    def test_unused_points_of_mesh(self):
        """Unused points affect neither the view nor anything else."""
        sphere = make_sphere()
        more = vtkPolyData()
        more.DeepCopy(sphere)
        points = more.GetPoints()
        for point in ((40, 30, 20), (math.nan, 0, 0)):
            points.InsertNextPoint(point)
            more.GetPointData().GetArray("Latitude").InsertNextValue(1000)
            more.GetPointData().GetArray("Around").InsertNextTuple((1000, 0, 0))
        file = write_mesh(self.folder, "more.vtp", more)
        self.assert_fits(self.picture(file, "--up=z"))
        ramp = self.folder / "ramp.png"
        self.write_ramp(ramp)
        for arguments in (
            ("--height", ramp, "--mapping=plane", "--array=Latitude"),
            ("--surface=procedural", "--metric=distance", "--color-by=level"),
            ("--metric=field", "--array=Latitude", "--color-by=level"),
            ("--lic=Around", "--metric=region"),
        ):
            with self.subTest(arguments):
                self.assertEqual(
                    self.picture(file, "--up=z", *arguments),
                    self.picture(self.mesh, "--up=z", *arguments),
                )

    def write_ramp(self, name):
        image = vtkImageData()
        image.SetDimensions(16, 16, 1)
        image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
        for j in range(16):
            for i in range(16):
                image.SetScalarComponentFromDouble(i, j, 0, 0, 8 * j + i)
        writer = vtkPNGWriter()
        writer.SetFileName(str(name))
        writer.SetInputData(image)
        writer.Write()

    def test_height_legend(self):
        """A terrain coloured by height has a legend from green to white; others have none."""

        def bar(*arguments):
            """The left part of a picture with room for a legend."""
            picture = self.picture(self.heights, *arguments, size="--size=300x300")
            return [colour for row in picture for colour in row[5:9]]

        def count(pixels, colour):
            return sum(
                all(abs(a - 255 * b) < 12 for a, b in zip(pixel, colour)) for pixel in pixels
            )

        green, white = (0.27, 0.47, 0.29), (0.97, 0.97, 0.97)
        shown = bar()
        self.assertGreater(count(shown, green), 0)
        self.assertGreater(count(shown, white), 0)
        for arguments in (("--no-legend",), ("--image", self.write_dot(0, 0))):
            beside = bar(*arguments)
            self.assertEqual(count(beside, green) + count(beside, white), 0)

    def test_bad_usage(self):
        for file, words, argument in (
            (self.heights, ["--center", "X,Y or X,Y,Z", "'1'"], "--center=1"),
            (self.heights, ["--center", "'1,2,3,4'"], "--center=1,2,3,4"),
            (self.heights, ["--center", "number", "'x'"], "--center=1,x"),
            (self.mesh, ["--center", "X,Y,Z", "'1,2'"], "--center=1,2"),
            (self.mesh, ["--zoom", "from 0.001 to 1e+06", "'0'"], "--zoom=0"),
            (self.mesh, ["--zoom", "'-2'"], "--zoom=-2"),
            (self.mesh, ["--zoom", "'nan'"], "--zoom=nan"),
            (self.mesh, ["--zoom", "from 0.001 to 1e+06", "'1e30'"], "--zoom=1e30"),
            (self.mesh, ["degrees", "height map"], "--center=1E,2N"),
            (self.heights, ["longitude", "'361'"], "--center=361E,2N"),
            (self.heights, ["86.925E,27.988N", "'1E,2'"], "--center=1E,2"),
            (self.heights, ["86.925E,27.988N", "'1E,2W'"], "--center=1E,2W"),
            (self.heights, ["86.925E,27.988N", "'1E,2N,3'"], "--center=1E,2N,3"),
            (self.mesh, ["--light", "AZIMUTH,ELEVATION", "'10'"], "--light=10"),
            (self.mesh, ["--light", "elevation", "'91'"], "--light=10,91"),
        ):
            self.assert_error(2, words, file, argument)

    def test_center_without_terrain(self):
        self.assert_error(
            1, ["hill.png", "--center 80,5", "-24 to 24"], self.heights, "--center=80,5", "--output=n.png"
        )

    def write_grid(self, name, corner, size, system):
        """A hill of 11 x 11 heights in a coordinate system."""
        rows = [" ".join(str(99 - i * i - j * j) for i in range(-5, 6)) for j in range(-5, 6)]
        (self.folder / f"{name}.asc").write_text(
            f"ncols 11\nnrows 11\nxllcorner {corner[0]}\nyllcorner {corner[1]}\ncellsize {size}\n"
            + "\n".join(rows) + "\n")
        (self.folder / f"{name}.prj").write_text(system)
        return f"{name}.asc"

    def test_center_in_degrees(self):
        degrees = self.write_grid("degrees", (86.9, 27.9), 0.001, GEOGRAPHIC)
        pyramid = relevo.vtkTerrainPyramid()
        pyramid.SetFileName(str(self.folder / degrees))
        mapper = relevo.vtkTerrainMapper()
        mapper.SetPyramid(pyramid)
        if not pyramid.Update():
            self.skipTest("a build without GDAL")
        place = [0.0, 0.0, 0.0]
        self.assertTrue(mapper.GeographicToWorld((86.902, 27.904, 0), place))
        x, y, _ = place
        expected = self.picture(degrees, f"--center={x!r},{y!r}", "--zoom=4")
        for center in ("86.902E,27.904N", "27.904n,86.902e", "-86.902W,-27.904S"):
            self.assertEqual(self.picture(degrees, f"--center={center}", "--zoom=4"), expected)
        # In metres they are close to the centre: a warning shows both forms.
        run = subprocess.run(
            [str(PROGRAM), degrees, "--center=86.902,27.904", SIZE, "--output=view.png"],
            cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"\Arelevo-view: warning: --center 86.902,27.904 is taken as metres "
                                     r"[^\n]*for degrees, use --center 86.902E,27.904N\n\Z")
        for center in ("86.902E,28.904N", "86.902W,27.904N", "9999,9999"):
            self.assert_error(1, [degrees, "no height at --center " + center, "27.988N"], degrees,
                              f"--center={center}", "--output=n.png")
        # On the central meridian, from the equator: the scale is 0.9996.
        utm = self.write_grid("utm", (499450, -550), 100, UTM)
        expected = self.picture(utm, "--center=0,0", "--zoom=3")
        self.assertEqual(self.picture(utm, "--center=15E,0N", "--zoom=3"), expected)
        run = self.run_program(utm, "--center=15,0.001", SIZE, "--output=view.png")
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"\A[^\n]*for degrees, use --center 15E,0.001N\n\Z")
        self.assert_error(1, ["no coordinate system"], self.heights, "--center=1E,2N", "--output=n.png")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerView"])
