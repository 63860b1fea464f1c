# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on terrain: missing data, and height maps and pictures larger than a texture."""

import math
import os
import re
import struct
import subprocess
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter, vtkTIFFWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from ViewerProgram import PROGRAM, ViewerProgram

GEOGRAPHIC = (
    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]'
)


def write(writer, name, samples):
    """Writes an array of rows x columns (x bands), top row first."""
    image = vtkImageData()
    image.SetDimensions(samples.shape[1], samples.shape[0], 1)
    rows = numpy.ascontiguousarray(samples[::-1]).reshape(samples.shape[0] * samples.shape[1], -1)
    array = numpy_to_vtk(rows, deep=True)
    array.SetName("Samples")
    image.GetPointData().SetScalars(array)
    writer.SetInputData(image)
    writer.SetFileName(str(name))
    writer.Write()
    return name


class TestViewerTerrain(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        rows, columns = numpy.mgrid[0:64, 0:96]
        cls.samples = 50 + rows // 8 + columns // 8
        cls.samples[20:44, 36:60] = 9
        cls.heights = write(
            vtkPNGWriter(), cls.folder / "hole.png", cls.samples.astype(numpy.uint16)
        )

    def test_height_at(self):
        """viewer.md: --height-at prints the height at a longitude and latitude."""
        name = self.folder / "degrees.asc"
        rows = [" ".join(str(100 * row + column) for column in range(5)) for row in range(4)]
        name.write_text(
            "ncols 5\nnrows 4\nxllcorner 10\nyllcorner 40\ncellsize 1\nNODATA_value 302\n"
            + "\n".join(rows)
            + "\n"
        )
        (self.folder / "degrees.prj").write_text(GEOGRAPHIC)
        for place, height in (
            ("10.5,43.5", 0.0),
            ("11,43", 50.5),
            ("14.5E,42.5N", 104.0),
            ("40.5N,13.5E", 303.0),
            ("370.5,43.5", None),
        ):
            with self.subTest(place):
                if height is None:
                    self.assert_error(2, ["--height-at"], name, "--height-at", place)
                else:
                    run = self.view(name, "--height-at", place)
                    self.assertAlmostEqual(float(run.stdout), height, places=6)
        self.assert_error(1, ["no height", "no data"], name, "--height-at=12.5,40.5")
        self.assert_error(1, ["no height"], name, "--height-at=-20,40.5")
        self.assert_error(2, ["LON,LAT"], name, "--height-at", "north")
        self.assert_error(2, ["--height-at"], name, "--height-at=11,43", "--no-legend")
        self.assert_error(1, ["coordinate system"], self.heights, "--height-at=11,43")

    def export(self, *arguments):
        name = self.folder / "mesh.vtp"
        self.view(*arguments, "--export", name)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(name))
        reader.Update()
        return reader.GetOutput()

    def picture(self, *arguments):
        name = self.folder / "picture.png"
        self.view(*arguments, "--output", name, "--size=320x200", "--view=180,80")
        reader = vtkPNGReader()
        reader.SetFileName(str(name))
        reader.Update()
        return reader.GetOutput()

    def assert_hole(self, mesh, lowest):
        """The middle of the 96 x 64 heights has a hole, and no point is as low as the missing-data
        marker."""
        self.assertGreater(mesh.GetNumberOfCells(), 100)
        self.assertGreater(mesh.GetBounds()[4], lowest)
        for i in range(mesh.GetNumberOfPoints()):
            x, y, _ = mesh.GetPoint(i)
            self.assertFalse(-11 < x < 11 and -11 < y < 11, (x, y))

    def test_no_data_value(self):
        common = (self.heights, "--level=1", "--resolution=48")
        whole = self.export(*common)
        self.assertAlmostEqual(whole.GetBounds()[4], 9, delta=0.01)
        hole = self.export(*common, "--no-data-value", "9")
        self.assert_hole(hole, 49)
        other = self.export(*common, "--no-data-value=-9999")
        self.assertEqual(other.GetNumberOfCells(), whole.GetNumberOfCells())
        filled = self.export(*common, "--no-data-value=9.0", "--no-data=fill")
        self.assertEqual(filled.GetNumberOfCells(), whole.GetNumberOfCells())
        self.assertGreater(filled.GetBounds()[4], 49)

        # From above, the sky is visible through the hole, and terrain around it.
        image = self.picture(self.heights, "--no-data-value", "9", "--level=1")
        for column, is_sky in ((160, True), (110, False)):
            red, _, blue = (image.GetScalarComponentAsFloat(column, 100, 0, c) for c in range(3))
            self.assertEqual(blue > red + 20, is_sky)

    def test_nan(self):
        samples = numpy.where(self.samples == 9, numpy.nan, self.samples).astype(numpy.float32)
        name = write(vtkTIFFWriter(), self.folder / "nan.tif", samples)
        self.assert_error(1, ["nan.tif", "NaN", "--no-data-value"], name, "--level=1",
                          "--export", "never.vtp")
        # Tiles have no data there.
        image = self.picture(name)
        red, _, blue = (image.GetScalarComponentAsFloat(160, 100, 0, c) for c in range(3))
        self.assertGreater(blue, red + 20)
        mesh = self.export(name, "--level=1", "--resolution=48", "--no-data-value", "NaN")
        self.assert_hole(mesh, 49)

    def test_bad_values(self):
        for value in ("hole", "", "12m", "1e999", "1,2", "nano"):
            self.assert_error(
                2, ["--no-data-value", f"'{value}'"], self.heights, "--no-data-value", value
            )
        self.assert_error(2, ["--no-data-value", "needs"], self.heights, "--no-data-value")
        self.assert_error(
            1, ["are missing values"], self.flat(), "--no-data-value=7", "--output", "never.png"
        )

    def flat(self):
        return write(
            vtkPNGWriter(), self.folder / "flat.png", numpy.full((8, 8), 7, dtype=numpy.uint8)
        )

    def test_mesh(self):
        plane = vtkPlaneSource()
        plane.SetResolution(24, 24)
        name = self.folder / "plane.vtp"
        writer = vtkXMLPolyDataWriter()
        writer.SetInputConnection(plane.GetOutputPort())
        writer.SetFileName(str(name))
        writer.Write()
        self.assert_error(2, ["--no-data-value", "--height"], name, "--no-data-value=9")
        arguments = (name, "--height", self.heights, "--scale=0.01", "--level=1")
        whole = self.export(*arguments)
        hole = self.export(*arguments, "--no-data-value=9")
        self.assertLess(whole.GetBounds()[4], 0.1)
        self.assertGreater(hole.GetBounds()[4], 0.49)
        self.assertLess(hole.GetNumberOfCells(), whole.GetNumberOfCells())

    def draw(self, *arguments):
        """Draws and exports. Returns the output on stderr and the mesh's bounds."""
        run = subprocess.run(
            [str(PROGRAM), *map(str, arguments), "--output=l.png", "--export=l.vtp", "--level=0"],
            cwd=self.folder,
            env={key: value for key, value in os.environ.items() if key != "DISPLAY"},
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "l.vtp"))
        reader.Update()
        return run.stderr, reader.GetOutput().GetBounds()

    def ramp(self, highest, sides=(40, 30)):
        """Texels without georeference, from 0 in the west to the highest value in the east."""
        columns = numpy.linspace(0, highest, sides[0]).astype(numpy.uint16)
        samples = numpy.tile(columns, (sides[1], 1))
        return write(vtkPNGWriter(), self.folder / f"ramp{highest}.png", samples)

    def test_heights_of_another_unit(self):
        """Heights larger than the width, without a coordinate system: an exaggeration is chosen and
        reported."""
        name = self.ramp(65535)
        run = self.view(name, "--export=r.vtp", "--level=0")
        self.assertRegex(
            run.stdout, r"\A[^\n]*--exaggeration 0.00012 [^\n]*georeference[^\n]*1 m wide[^\n]*\n\Z"
        )
        mesh = self.export(name, "--level=0")
        self.assertAlmostEqual(mesh.GetBounds()[5], 0.00012 * 65535, delta=0.01)
        # A requested exaggeration is used unless the terrain becomes a needle.
        run = self.view(name, "--export=r.vtp", "--level=0", "--exaggeration=0.01")
        self.assertEqual(run.stdout, "")
        words = ["--exaggeration 1 ", "100 times", "--no-data-value"]
        self.assert_error(1, words, name, "--output=never.png", "--exaggeration=1")
        # A terrain as high as it is wide is acceptable.
        self.assertEqual(self.view(self.ramp(38), "--export=r.vtp", "--level=0").stdout, "")

    def test_map_view(self):
        """Seen from straight above, the azimuth points upwards: at 180, north is at the top."""
        name = self.ramp(10)
        colours = {}
        for view in ("180,90", "180,89.5", "0,90", "90,90"):
            self.view(
                name, "--output=m.png", "--size=160x120", f"--view={view}", "--no-legend", "--level=1"
            )
            reader = vtkPNGReader()
            reader.SetFileName(str(self.folder / "m.png"))
            reader.Update()
            pixels = reader.GetOutput()
            colours[view] = [
                [pixels.GetScalarComponentAsFloat(x, y, 0, c) for c in range(3)]
                for x, y in ((25, 60), (135, 60), (80, 20), (80, 100))
            ]
        west, east, south, north = colours["180,90"]
        self.assertGreater(east[0], west[0] + 30)
        numpy.testing.assert_allclose(south, north, atol=15)
        numpy.testing.assert_allclose(colours["180,90"], colours["180,89.5"], atol=12)
        numpy.testing.assert_allclose(colours["0,90"][:2], [east, west], atol=15)
        bottom, top = colours["90,90"][2:]
        self.assertGreater(bottom[0], top[0] + 30)  # the east is redder than the west
        self.assert_error(2, ["--view", "-90 to 90"], name, "--view=0,91", "--output=never.png")

    def test_small_budget(self):
        """A budget below the number of coarse triangles is an error."""
        run = self.run_program(
            self.ramp(10), "--budget=500", "--resolution=20", "--output=b.png", "--size=80x60",
            "--metric=distance",
        )
        self.assertEqual(run.returncode, 0)
        self.assertRegex(
            run.stderr,
            r"\A[^\n]*--budget 500 is less than the 600 coarse triangles[^\n]*--resolution 18[^\n]*\n\Z",
        )
        self.view(
            self.ramp(10), "--budget=600", "--resolution=20", "--output=b.png", "--size=80x60",
            "--metric=distance",
        )

    def test_options_in_messages(self):
        """Messages name the viewer's options, not the library's setters."""
        samples = numpy.where(self.samples == 9, numpy.nan, self.samples).astype(numpy.float32)
        name = write(vtkTIFFWriter(), self.folder / "nan2.tif", samples)
        self.assert_error(1, ["with --no-data-value"], name, "--level=1", "--export",
                          "never.vtp")
        samples = numpy.where(self.samples == 9, -3.4e38, self.samples).astype(numpy.float32)
        name = write(vtkTIFFWriter(), self.folder / "lowest.tif", samples)
        self.assert_error(1, ["-3.4e+38", "--no-data-value"], name, "--output", "never.png")

    def grid(self, name, corner, side, samples):
        """Writes an ASCII grid, which has a georeference but no coordinate system. Needs GDAL."""
        rows = "\n".join(" ".join(map(str, row)) for row in samples)
        path = self.folder / name
        path.write_text(
            f"ncols {len(samples[0])}\nnrows {len(samples)}\nxllcorner {corner[0]}\n"
            f"yllcorner {corner[1]}\ncellsize {side}\nNODATA_value -9999\n{rows}\n"
        )
        if self.run_program(path, "--export=g.vtp", "--level=0").returncode != 0:
            self.skipTest("a build without GDAL")
        return path

    def declare(self, name, system):
        self.folder.joinpath(name).with_suffix(".prj").write_text(system)

    def test_around_the_pole(self):
        """For all longitudes, triangles have area, and the border is a parallel."""
        samples = [[10] * 360 for _ in range(4)]
        name = self.grid("pole.asc", (-180, 86), 1, samples)
        self.declare("pole.asc", GEOGRAPHIC)
        mesh = self.export(name, "--level=0", "--resolution=64")
        self.assertEqual(mesh.GetNumberOfCells(), 2 * 64 * 4 - 64)  # the pole is a corner
        areas = vtkCellSizeFilter()
        areas.SetInputData(mesh)
        areas.Update()
        area = areas.GetOutput().GetCellData().GetArray("Area")
        self.assertGreater(area.GetRange()[0], 1e6)
        # The area of the cap north of 86 degrees, on a plane that touches at 88 degrees.
        total = sum(area.GetValue(i) for i in range(area.GetNumberOfTuples()))
        radius = 6399593.6  # radius of curvature at the pole
        cap = math.pi * (radius * math.sin(math.radians(4))) ** 2
        self.assertAlmostEqual(total / cap, 1, delta=0.01)

    def test_doubtful_coordinates(self):
        """Degrees without a coordinate system, and projections that lengthen distances, give a
        warning."""
        degrees = self.grid("degrees.asc", (10, 50), 0.01, [[1, 2, 3], [2, 3, 4]])
        run = self.run_program(degrees, "--export=d.vtp", "--level=0")
        self.assertRegex(run.stderr, r"\A[^\n]*degrees[^\n]*gdal_translate -a_srs EPSG:4326[^\n]*\n\Z")
        self.assertIn("--exaggeration", run.stdout)
        for corner, rows in (((0, -90), 18), ((-180, -95), 19)):  # samples may be at the poles
            globe = self.grid("globe.asc", corner, 10, [[1] * 36] * rows)
            run = self.run_program(globe, "--export=d.vtp", "--level=0")
            self.assertRegex(run.stderr, r"\A[^\n]*degrees[^\n]*-a_srs EPSG:4326[^\n]*\n\Z")
        self.declare("degrees.asc", GEOGRAPHIC)
        self.view(degrees, "--export=d.vtp", "--level=0")
        metres = self.grid("metres.asc", (10, 50), 1, [[1, 2, 3], [2, 3, 4]])
        self.view(metres, "--export=d.vtp", "--level=0")
        mercator = (
            f'PROJCS["Mercator",{GEOGRAPHIC},PROJECTION["Mercator_1SP"],'
            'PARAMETER["central_meridian",0],PARAMETER["scale_factor",1],'
            'PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1]]'
        )
        # At 60 degrees north; at 16 degrees, lengths are 4 % too long.
        for north, factor in ((8362700, "2"), (1790000, None)):
            name = self.grid(f"{north}.asc", (0, north), 100, [[1, 2, 3], [2, 3, 4]])
            self.declare(f"{north}.asc", mercator)
            run = self.run_program(name, "--export=d.vtp", "--level=0")
            if factor:
                self.assertIn(f"by {factor}, ", run.stderr)
                self.assertIn("gdalwarp -t_srs", run.stderr)
            else:
                self.assertEqual(run.stderr, "")

    def test_rasters_in_containers(self):
        """GDAL names the directories of a TIFF file."""
        self.grid("any.asc", (10, 50), 1, [[1, 2, 3], [2, 3, 4]])  # skips without GDAL
        samples = numpy.tile(numpy.arange(12, dtype=numpy.uint8), (8, 1))
        name = write(vtkTIFFWriter(), self.folder / "in.tif", samples)
        whole = self.export(name, "--level=0")
        part = self.export(f"GTIFF_DIR:1:{name}", "--level=0")
        self.assertEqual(part.GetBounds(), whole.GetBounds())
        for missing in ("GTIFF_DIR:1:no.tif", 'NETCDF:"no.nc":a'):
            self.assert_error(
                1, [missing, "does not exist"], missing, "--output=never.png"
            )
        os.mkfifo(self.folder / "pipe.tif")
        pipe = f"GTIFF_DIR:1:{self.folder / 'pipe.tif'}"
        self.assert_error(1, ["not a regular file"], pipe, "--output=never.png")

    def test_container(self):
        """For a file with several variables, the error lists them."""
        name = self.netcdf("two.nc", ("first", "second"))
        run = self.run_program(name, "--export=c.vtp", "--level=0")
        if "container" not in run.stderr:
            self.skipTest("GDAL reads no netCDF files")
        self.assertIn("it contains 2 rasters", run.stderr)
        names = re.findall(r'NETCDF:"[^"]*":\w+', run.stderr)
        self.assertEqual([text.split(":")[-1] for text in names], ["first", "second"])
        for text in (*names, "NETCDF:two.nc:second"):
            self.view(text, "--export=c.vtp", "--level=0")

    def netcdf(self, name, variables):
        """A classic netCDF file with variables of 4 x 5 bytes."""
        word = struct.Struct(">I").pack

        def text(value):
            data = value.encode()
            return word(len(data)) + data + bytes(-len(data) % 4)

        def head(begins):
            dimensions = word(10) + word(2) + text("y") + word(4) + text("x") + word(5)
            entries = b"".join(
                text(variable) + word(2) + word(0) + word(1) + bytes(8) + word(1) + word(20)
                + word(begin)
                for variable, begin in zip(variables, begins)
            )
            return b"CDF\1" + bytes(4) + dimensions + bytes(8) + word(11) + word(
                len(variables)) + entries

        size = len(head([0] * len(variables)))
        begins = [size + 20 * i for i in range(len(variables))]
        path = self.folder / name
        path.write_bytes(head(begins) + bytes(range(20)) * len(variables))
        return path

    def test_center_of_a_texel(self):
        """The height of a sample without neighbours, with rounded coordinates of its centre."""
        samples = numpy.full((9, 9), -9999)
        samples[2, 3] = 500
        samples[5:, :] = 400
        name = self.grid("texel.asc", (10, 50), 1 / 120, samples)
        self.declare("texel.asc", GEOGRAPHIC)
        longitude, latitude = 10 + 3.5 / 120, 50 + 6.5 / 120
        for digits in (4, 5, 6, 9):
            place = f"{longitude:.{digits}f}E,{latitude:.{digits}f}N"
            self.view(name, "--center", place, "--output=t.png", "--size=80x60")
        away = f"{longitude + 0.3 / 120}E,{latitude}N"
        self.assert_error(1, ["has no height"], name, "--center", away, "--output=never.png")

    def test_larger_than_a_texture(self):
        """A reduced raster gives one warning and keeps the location of the whole."""
        columns = numpy.arange(20000)
        samples = numpy.tile((columns // 10).astype(numpy.uint16), (250, 1))
        name = write(vtkPNGWriter(), self.folder / "large.png", samples)
        errors, bounds = self.draw(name, "--resolution=64")
        self.assertRegex(
            errors,
            r"\Arelevo-view: warning: large.png has 20000 x 250 heights, but the limit is 16384 per side: "
            r"[^\n]*16384 x 205[^\n]*gdal_translate[^\n]*\n\Z".replace("large", str(name)[:-4]),
        )
        for bound, expected in zip(bounds, (-10000, 10000, -125, 125, 0, 1999)):
            self.assertAlmostEqual(bound, expected, delta=0.6)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTerrain"])
