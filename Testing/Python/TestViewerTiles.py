# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on height maps that are drawn from tiles: colours, contour lines, memory and
flights."""

import re
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYReader

from ViewerProgram import ViewerProgram
from ViewerScenes import write_hill

GEOGRAPHIC = (
    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]'
)
HEADER = "longitude,latitude,height,heading,pitch\n"
SIZE = "--size=160x120"


class TestViewerTiles(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        (cls.folder / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

    def read(self, name):
        """Rows of red, green and blue, top row first."""
        reader = vtkPNGReader()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        image = reader.GetOutput()
        columns, rows, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)
        return pixels[::-1, :, :3].astype(int)

    def picture(self, *arguments):
        self.view(*arguments, "--output=p.png", SIZE, "--no-legend")
        return self.read("p.png")

    def grid(self, name, samples, corner=(10, 45), side=0.01):
        """A raster in degrees. Skips without GDAL."""
        rows = "\n".join(" ".join(map(str, row)) for row in samples)
        (self.folder / name).write_text(
            f"ncols {len(samples[0])}\nnrows {len(samples)}\nxllcorner {corner[0]}\n"
            f"yllcorner {corner[1]}\ncellsize {side}\nNODATA_value -9999\n{rows}\n"
        )
        (self.folder / name).with_suffix(".prj").write_text(GEOGRAPHIC)
        run = self.run_program(name, "--height-at", f"{corner[0] + side},{corner[1] + side}")
        if run.returncode != 0:
            self.skipTest("a build without GDAL")
        return name

    def test_bad_values(self):
        for option, values in (
            ("--contours", ("0", "-5", "x", "nan")),
            ("--memory", ("15", "16.5", "x", "1e9")),
            ("--range", ("1", "2,1", "1,1", "1,2,3", "a")),
            ("--palette", ("", "Relief", "jet")),
            ("--sea-level", ("", "x", "nan")),
            ("--flight", ("a.txt", "")),
        ):
            for value in values:
                self.assert_error(2, [option, f"'{value}'"], self.heights, f"{option}={value}")
        self.assert_error(2, ["cyclic, grey", "viridis or water"], self.heights, "--palette=jet")
        self.assert_error(2, ["aspect or hillshade", "'hue'"], self.heights, "--color-by=hue")

    def test_combinations(self):
        def refuses(words, *arguments):
            self.assert_error(2, words, self.heights, *arguments)

        for tiled in ("--contours=5", "--memory=64", "--color-by=slope", "--color-by=hillshade",
                      "--sea-level=0"):
            for option in ("--metric=field", "--level=2", "--resolution=8", "--no-data=fill",
                           "--stretch", "--error=0.005"):
                refuses([re.split("[= ]", tiled)[0], re.split("[=]", option)[0], "cannot be"],
                        tiled, option)
        for option in ("--palette=grey", "--range=0,1", "--light=0,45"):
            refuses([option.split("=")[0], "--color-by hillshade"], option, "--color-by=hillshade")
        for option in ("--palette=grey", "--range=0,1"):
            refuses([option.split("=")[0], "--color-by level"], option, "--color-by=level")
            refuses([option.split("=")[0], "--image"], option, "--image=a.tif")
        refuses(["--color-by height", "--image"], "--color-by=height", "--image=a.tif")
        refuses(["--sea-level", "--image"], "--sea-level=0", "--image=a.tif")
        refuses(["--sea-level", "--color-by height"], "--sea-level=0", "--color-by=slope")
        for name in ("a.png", "a%s.png", "%d/a.png", "a%d%d.png", "%%d.png", "a%12d.png"):
            refuses(["--flight requires --output", "%04d"], "--flight=a.csv", f"--output={name}")
        refuses(["--flight requires --output"], "--flight=a.csv")
        for option in ("--view=0,0", "--zoom=2", "--center=0,0", "--stats"):
            refuses([option.split("=")[0], "--flight"], "--flight=a.csv", "--output=%d.png", option)
        for option in ("--contours=5", "--memory=64", "--sea-level=0",
                       "--color-by=slope", "--color-by=height", "--flight=a.csv"):
            self.assert_error(2, [re.split("[= ]", option)[0], "height map"], "flat.obj", option)

    def test_contours(self):
        """Contour lines are black, and their number is that of the intervals."""
        def count(*arguments):
            pixels = self.picture(self.heights, "--view=180,90", *arguments)
            dark = pixels.sum(axis=2) < 60
            return dark.sum()

        self.assertEqual(count(), 0)
        many = count("--contours=5")
        self.assertGreater(many, 100)
        self.assertGreater(many, 1.5 * count("--contours=12"))
        self.assertLess(count("--contours=1000"), 0.5 * many)  # the line of height 0
        self.assert_error(2, ["--contour-labels requires --contours"], self.heights,
                          "--contour-labels")
        plain = self.picture(self.heights, "--contours=5")
        labels = self.picture(self.heights, "--contours=5", "--contour-labels")
        self.assertGreater((plain != labels).sum(), 300)

    def test_base(self):
        """The exported solid is closed: each edge of its triangles has two of them."""
        common = (self.ramp(), "--export=solid.ply", "--tolerance=1")
        run = self.view(*common, "--base=50", "--exaggeration=2")
        self.assertRegex(run.stdout, r"\Asolid.ply: \d+ triangles, at most \S+ m above or below the "
                                     r"raster\ncoordinates: metres, x east, [^\n]*\nrounding ")
        reader = vtkPLYReader()
        reader.SetFileName(str(self.folder / "solid.ply"))
        edges = vtkFeatureEdges()
        edges.SetInputConnection(reader.GetOutputPort())
        edges.FeatureEdgesOff()
        edges.ManifoldEdgesOff()
        edges.Update()
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)
        bounds = reader.GetOutput().GetBounds()
        self.assertAlmostEqual(bounds[4], 100, delta=1e-3)
        self.assertAlmostEqual(bounds[5], 2 * 490, delta=1e-3)
        self.assert_error(1, ["ramp.asc: --base is 200", "lowest height is 100"], *common, "--base=200")
        self.assert_error(1, ["--base is 7", "lowest height is 7"],
                          self.grid("flat.asc", [[7] * 20 for _ in range(20)]),
                          "--export=solid.ply", "--tolerance=1", "--base=7")
        self.view(*common, "--base=-1000", "--globe")
        self.assert_error(2, ["--base requires a height map"], "flat.obj", "--base=0")
        self.assert_error(2, ["--base cannot be combined with --resolution"], self.ramp(),
                          "--base=0", "--resolution=16")

    def test_drawn_base(self):
        """Pictures, also on the globe, show the walls and the bottom."""
        for options in ((), ("--globe",)):
            plain = self.picture(self.ramp(), "--view=30,-30", *options)
            solid = self.picture(self.ramp(), "--view=30,-30", "--base=-20000", *options)
            self.assertGreater((plain != solid).any(axis=-1).mean(), 0.05)
        self.assert_error(1, ["ramp.asc: --base is 200", "lowest height is 100"], self.ramp(),
                          "--base=200", "--output=solid.png")
        self.assert_error(1, ["--base is -1e+06", "exaggeration of 100", "centre of the globe"],
                          self.ramp(), "--globe", "--base=-1000000", "--exaggeration=100",
                          "--output=solid.png")
        bottom = self.picture(self.ramp(), "--view=30,-80", "--base=-20000")
        self.assertGreater(bottom[60, 80].min(), 50)

    def ramp(self):
        """Heights that rise to the east by 10 m per sample of 0.01 degrees."""
        return self.grid("ramp.asc", [[100 + 10 * i for i in range(40)] for _ in range(30)])

    def test_colours(self):
        name = self.ramp()
        common = (name, "--view=180,90")

        def pixel(*arguments):
            return self.picture(*common, *arguments)[60, 80]

        low = pixel("--palette=grey", "--range=1000,2000")
        high = pixel("--palette=grey", "--range=0,100")
        for color in (low, high):
            self.assertLess(color.max() - color.min(), 3)  # grey
        self.assertGreater(high[0], low[0] + 120)
        # The slope is 10 m per about 790 m.
        slope = self.picture(*common, "--color-by=slope", "--palette=grey", "--range=0,90")
        self.assertLess(slope[60, 80].max(), 60)
        steep = self.picture(*common, "--color-by=slope", "--palette=grey", "--range=0,0.3")
        self.assertGreater(steep[60, 80].min(), 150)
        # It falls to the west, at 270 of 360 degrees.
        west = pixel("--color-by=aspect", "--palette=grey", "--range=265,275")
        east = pixel("--color-by=aspect", "--palette=grey", "--range=280,281")
        north = pixel("--color-by=aspect", "--palette=grey", "--range=0,90")
        self.assertLess(east[0], west[0] - 20)
        self.assertLess(west[0], north[0] - 20)
        shade = pixel("--color-by=hillshade")
        self.assertLess(shade.max() - shade.min(), 2)
        self.assertEqual(list(pixel("--color-by=height")), list(pixel()))
        colors = {tuple(pixel(f"--palette={palette}")) for palette in
                  ("cool-warm", "cyclic", "grey", "heat", "magma", "rainbow", "relief", "viridis",
                   "water")}
        self.assertEqual(len(colors), 9)

    def test_sea_level(self):
        """The lower part of a ramp is water, the upper part has the palette."""
        def is_water(*arguments):
            pixels = self.picture(self.ramp(), "--view=180,90", *arguments)[60, 30:130]
            return pixels[:, 2] > pixels[:, 0] + 20

        self.assertFalse(is_water().any())
        share = is_water("--sea-level=250").mean()
        self.assertTrue(0.1 < share < 0.4, share)
        self.assertGreater(is_water("--sea-level=350").mean(), share + 0.2)
        self.assertTrue(is_water("--sea-level=2000").all())
        self.assertFalse(is_water("--sea-level=0").any())
        # The first colour is that of the deepest water.
        deep, shallow = (
            self.picture(self.ramp(), "--view=180,90", "--sea-level=400", f"--range={low},500")
            [60, 60] for low in (200, -5000)
        )
        self.assertGreater(shallow[1], deep[1] + 20)

    def test_ranges_of_meshes(self):
        """Palettes and ranges also colour a height map that is refined by levels."""
        pixels = self.picture(self.heights, "--level=1", "--palette=grey", "--range=1000,2000",
                              "--view=180,90")
        self.assertLess(pixels[60, 80].max(), 60)

    def test_globe(self):
        """A region of the globe looks like its map from above, and the whole earth is a disc."""
        grey = (self.mountain(), "--palette=grey", "--range=0,1000", "--light=0,90", "--zoom=3")
        globe = self.picture(*grey, "--globe", "--view=180,90", "--center=10.2E,45.295N")
        bright = numpy.argwhere(globe.min(axis=2) > 200)
        self.assertGreater(len(bright), 20)
        row, column = bright.mean(axis=0)
        self.assertAlmostEqual(row, 60, delta=4)
        self.assertAlmostEqual(column, 80, delta=4)
        earth = self.grid("earth.asc", [[100] * 72 for _ in range(36)], (-180, -90), 5)
        pixels = self.picture(earth, "--globe", "--palette=grey", "--range=0,1")
        is_sky = pixels[:, :, 2] - pixels[:, :, 0] > 15
        self.assertFalse(is_sky[60, 80])
        for row, column in ((5, 5), (5, 155), (115, 5), (115, 155), (60, 5), (60, 155)):
            self.assertTrue(is_sky[row, column])
        self.assertGreater((~is_sky).sum(), 5000)
        self.assert_error(1, ["hill.png", "coordinate system", "--globe"], self.heights, "--globe",
                          "--output=g.png")
        self.assert_error(2, ["--globe", "86.925E,27.988N"], earth, "--globe", "--center=1,2")
        self.assert_error(1, ["no height at --center 12E,45N. Give degrees"], self.ramp(), "--globe",
                          "--center=12E,45N", "--output=p.png")
        self.assert_error(2, ["--globe cannot be combined with --level"], earth, "--globe",
                          "--level=2")
        self.assert_error(2, ["--globe requires a height map"], "flat.obj", "--globe")

    def test_memory_and_error(self):
        values = {}
        for error in ("0.5", "4"):
            run = self.view(self.heights, "--stats", f"--error={error}", "--memory=16",
                            "--output=m.png", SIZE)
            lines = dict(line.split(": ") for line in run.stdout.splitlines())
            self.assertEqual(list(lines),
                             ["drawn triangles", "error", "terrain memory", "frame time"])
            self.assertLessEqual(float(lines["error"].removesuffix(" pixels")), float(error))
            self.assertLess(float(lines["terrain memory"].removesuffix(" MiB")), 16)
            values[error] = int(lines["drawn triangles"])
        self.assertGreater(values["0.5"], values["4"])

    def test_rasters_without_tiles(self):
        """A raster of one row is drawn without tiles, unless an option needs them."""
        (self.folder / "row.pgm").write_bytes(b"P5 8 1 255\n" + bytes(range(8)))
        self.view("row.pgm", "--output=p.png", SIZE)
        self.assert_error(1, ["row.pgm", "one row"], "row.pgm", "--contours=1", "--output=p.png")

    def mountain(self):
        """A mountain in the middle of the northern half of a plain, around 10.2E, 45.15N."""
        y, x = numpy.mgrid[0:40, 0:40]
        heights = 4000 * numpy.exp(-((x - 19.5) ** 2 + (y - 10) ** 2) / 12)
        return self.grid("mountain.asc", heights.round().astype(int).tolist())

    def fly(self, text, *arguments, code=0, words=()):
        (self.folder / "flight.csv").write_text(text)
        options = (self.mountain(), "--flight=flight.csv", "--output", "new/frames/%03d.png", SIZE,
                   *arguments)
        if code:
            return self.assert_error(code, words, *options)
        return self.view(*options)

    def test_flight(self):
        """The mountain is in front of a camera south of it that looks north."""
        eye = "10.2,45.15,1500"
        self.fly(
            HEADER + f"{eye},0,0\n{eye},180,0\n\n{eye},20,0\r\n {eye} , 360, 0\n"
            "10.2,45.295,30000,0,-90\n10.2,45.295,30000,90,-90\n{eye},0,80\n".format(eye=eye),
            "--palette=grey", "--range=0,1000"
        )
        names = sorted(path.name for path in (self.folder / "new" / "frames").iterdir())
        self.assertEqual(names, [f"{i:03d}.png" for i in range(7)])
        frames = [self.read(f"new/frames/{name}") for name in names]

        def mountain(frame):
            """Columns and rows of the mountain, brighter than the plain and not blue."""
            is_bright = (frame.min(axis=2) > 100) & (frame[:, :, 2] - frame[:, :, 0] < 20)
            rows, columns = numpy.nonzero(is_bright)
            return (columns.mean(), rows.mean()) if len(rows) > 20 else None

        north = mountain(frames[0])
        self.assertAlmostEqual(north[0], 80, delta=4)
        self.assertIsNone(mountain(frames[1]))
        self.assertLess(mountain(frames[2])[0], 60)  # the camera has turned to the right
        numpy.testing.assert_array_equal(frames[3], frames[0])
        # From above, in the middle; the upper side of the picture is ahead.
        for i in (4, 5):
            column, row = mountain(frames[i])
            self.assertAlmostEqual(column, 80, delta=4)
            self.assertAlmostEqual(row, 60, delta=4)
        self.assertIsNone(mountain(frames[6]))  # the sky

    def test_flight_from_above(self):
        self.fly(HEADER + "10.2,45.25,60000,0,-90\n10.2,45.25,60000,90,-90\n10.2,45.25,60000,180,-90\n",
                 "--palette=grey", "--range=0,1000")
        places = []
        for i in range(3):
            frame = self.read(f"new/frames/{i:03d}.png")
            is_bright = (frame.min(axis=2) > 100) & (frame[:, :, 2] - frame[:, :, 0] < 20)
            rows, columns = numpy.nonzero(is_bright)
            places.append((columns.mean() - 80, rows.mean() - 60))
        self.assertLess(places[0][1], -3)  # north is up
        self.assertLess(places[1][0], -3)  # east is up, north is on the left
        self.assertGreater(places[2][1], 3)

    def test_positions_outside(self):
        """Positions outside of the raster are a warning, and an error if all are far away."""
        bounds = "longitudes from 10 to 10.4 and latitudes from 45 to 45.4"
        (self.folder / "flight.csv").write_text(
            HEADER + "10.2,44.9,1500,0,0\n10.2,45.1,1500,0,0\n10.2,45.2,1500,0,0\n"
        )
        options = ("--flight=flight.csv", "--output=out-%d.png", SIZE)
        run = self.run_program(self.mountain(), *options)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(
            run.stderr, "relevo-view: warning: flight.csv: 1 of 3 positions are outside of "
            f"mountain.asc, which has {bounds}\n"
        )
        near = "10.2,44.9,1500,0,0\n"
        (self.folder / "flight.csv").write_text(HEADER + near)  # sees the mountain from outside
        self.assertIn("1 of 1", self.run_program("mountain.asc", *options).stderr)
        for row, more in (("45.1,10.2,1500,0,0\n", ". Exchange longitudes and latitudes"),
                          ("-80,45.1,1500,0,0\n", "")):
            (self.folder / "flight.csv").write_text(HEADER + 2 * row)
            self.assert_error(1, [f"all 2 positions are far outside of mountain.asc, which has "
                                  f"{bounds}{more}\n"], "mountain.asc", *options)

    def test_empty_flights(self):
        """A flight whose pictures show no terrain is an error."""
        (self.folder / "flight.csv").write_text(
            HEADER + "10.5,45.2,1500,90,0\n10.6,45.2,1500,90,0\n")  # east of it, looking east
        options = (self.mountain(), "--flight=flight.csv", "--output=out-%d.png", SIZE)
        run = self.run_program(*options)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"2 of 2 positions are outside of [^\n]*\nrelevo-view: error: "
                         r"flight.csv: none of the 2 positions sees the terrain of mountain.asc")
        (self.folder / "flight.csv").write_text(
            HEADER + "10.5,45.2,1500,270,0\n10.5,45.2,1500,90,0\n")
        run = self.run_program(*options)
        self.assertEqual(run.returncode, 0)
        self.assertTrue(run.stderr.endswith(
            "warning: flight.csv: 1 of 2 pictures show no terrain of mountain.asc\n"), run.stderr)

    def test_memory(self):
        """If the memory limits the error, a warning reports it."""
        random = numpy.random.default_rng(1).integers(0, 200, (1200, 1200))
        options = (self.grid("rough.asc", random.tolist()), "--output=m.png", "--size=1600x1200",
                   "--view=180,90", "--error=0.05")
        run = self.run_program(*options, "--memory=16")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stderr, r"\Arelevo-view: warning: rough.asc: the error is \S+ pixels, "
                         r"but --error is 0.05; a larger --memory reduces the error\n\Z")
        self.view(*options)

    def test_camera_above_ground(self):
        """On a globe as on a map, the camera does not go below the ground."""
        view = (self.mountain(), "--palette=grey", "--range=0,1000", "--zoom=4",
                "--center=10.2E,45.2N")

        for direction in ("0,-60", "180,0"):
            for frame in ((), ("--globe",)):
                pixels = self.picture(*view, f"--view={direction}", *frame)
                is_sky = pixels[:, :, 2] - pixels[:, :, 0] > 15
                self.assertTrue(is_sky[2, 2] and is_sky[2, 157])  # above the horizon
                self.assertFalse(is_sky[80:].any())

    def test_no_data(self):
        """Without any height there is nothing to draw."""
        name = self.grid("empty.asc", [[7] * 20 for _ in range(20)])
        text = (self.folder / name).read_text()
        (self.folder / name).write_text(text.replace("7 ", "-9999 ").replace("7\n", "-9999\n"))
        for option in ("--globe", "--contours=5", "--flight=flight.csv", "--color-by=slope"):
            pattern = "%d.png" if option.startswith("--flight") else "e.png"
            self.assert_error(1, ["empty.asc", "all heights are missing values"], name, option,
                              f"--output={pattern}")
        self.assert_error(1, ["empty.asc", "all 400 heights are missing"], name, "--output=e.png")
        self.assert_error(1, ["empty.asc", "all heights are missing values"], name,
                          "--export=e.vtp", "--tolerance=1")

    def test_bad_flights(self):
        row = "10.2,45.1,1500,0,0\n"
        for text, words in (
            ("", ["flight.csv"]),
            (HEADER, ["flight.csv", "no positions"]),
            ("lon,lat\n" + row, ["flight.csv, line 1", "header", "longitude,latitude,height"]),
            (row, ["flight.csv, line 1", "header"]),
            (HEADER + row + "10,45,1,2\n", ["flight.csv, line 3", "4 columns"]),
            (HEADER + "10,45,high,0,0\n", ["flight.csv, line 2, column 3 (height)", "'high'"]),
            (HEADER + row + "10,45,,0,0\n", ["line 3, column 3 (height)", "''"]),
            (HEADER + "10,91,1,0,0\n", ["line 2, column 2 (latitude)", "-90 to 90"]),
            (HEADER + "10,45,1,0,nan\n", ["line 2, column 5 (pitch)", "'nan'"]),
            (HEADER + "10,45,1,400,0\n", ["line 2, column 4 (heading)", "-360 to 360"]),
        ):
            with self.subTest(text):
                self.fly(text, code=1, words=words)
        self.assert_error(1, ["missing.csv"], self.heights, "--flight=missing.csv",
                          "--output=%d.png")
        (self.folder / "flight.csv").write_text(HEADER + row)
        self.assert_error(1, ["hill.png", "line 2", "coordinate"], self.heights,
                          "--flight=flight.csv", "--output=%d.png")
        (self.folder / "file").write_text("")
        self.assert_error(1, ["cannot create the folder"], self.mountain(), "--flight=flight.csv",
                          "--output=file/frames/%d.png")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTiles"])
