# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on the window: position, height and value under the mouse, scale bar, help and
screenshots."""

import math
import os
import pathlib
import re
import time
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

from ViewerPictures import find, is_dark, is_surface, read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import hill, write_hill, write_mesh, write_sphere
from ViewerWindow import Display, Window, wait

DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent")
WIDTH, HEIGHT = 320, 240
MIDDLE = (WIDTH // 2, HEIGHT // 2)


def numbers(line):
    """x, y, Latitude and other values by name, several for vectors."""
    found = {}
    for name, values in re.findall(r"([A-Za-z]+)((?: -?[\d.e+-]+)+)", line.split(": ", 1)[1]):
        values = [float(value) for value in values.split()]
        found[name] = values if len(values) > 1 else values[0]
    return found


def count_light(picture):
    """Number of pixels with the colour of the help's background."""
    return sum(min(colour) > 215 for row in picture for colour in row)


class TestViewerTools(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.mesh = write_sphere(cls.folder)
        cls.display = Display()

    @classmethod
    def tearDownClass(cls):
        cls.display.stop()
        super().tearDownClass()

    def window(self, *arguments):
        """Starts with the mouse in the sky."""
        window = Window(self.display, self.folder, *arguments, f"--size={WIDTH}x{HEIGHT}")
        self.addCleanup(window.stop)
        window.move(WIDTH - 2, 2)
        return window

    def close(self, window):
        window.key("q")
        self.assertEqual(window.leave(), (0, ""))

    def under_mouse(self, window, x, y):
        """The output of c with the mouse at a pixel."""
        window.move(x, y)
        window.key("c")
        return window.expect("here: ")

    def picture(self, window):
        window.key("i")
        name = window.expect("picture: ").removeprefix("picture: ")
        return read_picture(self.folder / name)

    def test_readout_of_terrain(self):
        """The point in the centre is the requested one, and heights are the hill's, without
        exaggeration."""
        window = self.window(
            self.heights, "--center=8,5", "--zoom=1.5", "--exaggeration=1.5", "--view=200,30"
        )
        here = numbers(self.under_mouse(window, *MIDDLE))
        self.assertAlmostEqual(here["x"], 8, delta=0.3)
        self.assertAlmostEqual(here["y"], 5, delta=0.3)
        places = set()
        for x, y in (MIDDLE, (140, 180), (180, 200), (150, 160)):
            here = numbers(self.under_mouse(window, x, y))
            column, row = here["x"] + 24, here["y"] + 16
            self.assertAlmostEqual(here["column"], column, delta=0.11)
            self.assertAlmostEqual(here["row"], row, delta=0.11)
            self.assertAlmostEqual(here["height"], hill(column / 48, row / 32), delta=1.0)
            places.add((here["x"], here["y"]))
        self.assertEqual(len(places), 4)
        self.assertEqual(self.under_mouse(window, WIDTH - 2, 2), "here: nothing")
        self.close(window)

    def test_readout_during_a_drag(self):
        """Each frame of a drag shows its own values, without waiting until the mouse rests."""
        window = self.window(self.heights, "--view=180,60")

        def split(screen):
            """The words, and the rows above them."""
            return [row[:200] for row in screen[8:40]], screen[60:]

        window.move(*MIDDLE)
        wait(lambda: self.has_words(split(window.screen())[0]), "words")
        words, picture = split(self.settle(window))
        window.press()
        for i in range(1, 6):
            window.move(MIDDLE[0], MIDDLE[1] + 4 * i)
            frame = wait(
                lambda: (screen := window.screen()) and split(screen)[1] != picture and screen,
                "another frame")
            self.assertNotEqual(split(frame)[0], words)
            words, picture = split(self.settle(window))
            self.assertEqual(split(frame)[0], words)
        window.release()
        self.close(window)

    def has_words(self, rows):
        return sum(is_dark(*colour) for row in rows for colour in row) > 100

    def settle(self, window):
        """The window's pixels once they have not changed for a second."""
        last, since = window.screen(), time.monotonic()

        def rests():
            nonlocal last, since
            now = window.screen()
            if now != last:
                last, since = now, time.monotonic()
            return time.monotonic() - since > 1

        wait(rests, "a picture that rests")
        return last

    def test_large_height_map(self):
        """The window of a large raster opens before its index is complete. The terrain appears, and
        the values under the mouse are those of the file."""
        side = 4200
        row = bytes(range(10, 210)) * (side // 200)
        (self.folder / "large.pgm").write_bytes(b"P5 4200 4200 255\n" + row * side)
        window = Window(
            self.display, self.folder, "large.pgm", f"--size={WIDTH}x{HEIGHT}", "--center=50,50",
            "--view=180,90", "--zoom=9",
        )
        self.addCleanup(window.stop)
        window.move(*MIDDLE)
        here = wait(lambda: (line := self.read_mouse(window)) != "here: nothing" and line, "terrain")
        values = numbers(here)
        self.assertAlmostEqual(values["x"], 50, delta=3)
        self.assertAlmostEqual(values["y"], 50, delta=3)
        self.assertAlmostEqual(values["height"], 10 + (values["column"] - 0.5) % 200, delta=3)
        wait((self.folder / "large.pgm.relevo-index").exists, "the index")
        self.close(window)

    def read_mouse(self, window):
        window.key("c")
        return window.expect("here: ")

    def test_readout_of_mesh(self):
        """The point lies on the curved surface, with the value of the array that colours it."""
        window = self.window(self.mesh, "--array=Latitude", "--up=z", "--surface=pn")
        for x, y in (MIDDLE, (130, 100), (180, 150)):
            here = numbers(self.under_mouse(window, x, y))
            self.assertAlmostEqual(math.hypot(here["x"], here["y"], here["z"]), 0.5, delta=0.01)
            self.assertAlmostEqual(here["Latitude"], here["z"], delta=0.02)
        self.close(window)
        window = self.window(self.mesh, "--lic=Around", "--up=z")
        here = numbers(self.under_mouse(window, *MIDDLE))
        self.assertAlmostEqual(here["Around"][0], -here["y"], delta=0.05)
        self.assertAlmostEqual(here["Around"][1], here["x"], delta=0.05)
        self.close(window)

    def test_readout_of_cells(self):
        """On the surface, on cuts and inside of volumes: cell, nearest point and value."""
        size = 5  # points along an edge of a cube of 4 x 4 x 4 cells
        image = vtkImageData()
        image.SetDimensions(size, size, size)
        height = vtkDoubleArray()
        height.SetName("Height")
        for i in range(image.GetNumberOfPoints()):
            height.InsertNextValue(2.0 * image.GetPoint(i)[2])
        image.GetPointData().SetScalars(height)
        self.write_data("cells.vti", vtkXMLImageDataWriter, image)
        opaque = self.folder / "opaque.txt"
        opaque.write_text("0 1 1 1 1\n8 1 1 1 1\n")
        for options in (
            ["--array=Height"],
            ["--array=Height", "--clip=0,0,1.7,0,0.3,1"],
            ["--volume", f"--transfer={opaque}", "--unit-distance=1e-4"],
        ):
            with self.subTest(options=options):
                window = self.window("cells.vti", *options)
                for x, y in (MIDDLE, (130, 100), (180, 150)):
                    here = numbers(self.under_mouse(window, x, y))
                    place = [here[axis] for axis in "xyz"]
                    self.assertAlmostEqual(here["Height"], 2.0 * place[2], delta=0.02)
                    # Near a face, the cell may be that on the other side.
                    sides = [{min(max(int(value + d), 0), 3) for d in (-0.02, 0.02)} for value in place]
                    column, row, layer = here["cell"] % 4, here["cell"] // 4 % 4, here["cell"] // 16
                    self.assertIn(column, sides[0])
                    self.assertIn(row, sides[1])
                    self.assertIn(layer, sides[2])
                    nearest = [round(value) for value in place]
                    apart = [abs(value - near) for value, near in zip(place, nearest)]
                    if max(apart) < 0.45:
                        point = nearest[0] + size * (nearest[1] + size * nearest[2])
                        self.assertEqual(here["point"], point)
                self.close(window)

    def test_readout_of_foreign_ids(self):
        """The ids of another mesh, as in exported files, are not those of the cells."""
        sphere = vtkSphereSource()
        sphere.Update()
        mesh = sphere.GetOutput()
        ids = vtkIdTypeArray()
        ids.SetName("vtkOriginalCellIds")
        for _ in range(mesh.GetNumberOfCells()):
            ids.InsertNextValue(10**9)
        mesh.GetCellData().AddArray(ids)
        self.write_data("foreign.vtp", vtkXMLPolyDataWriter, mesh)
        window = self.window("foreign.vtp", "--surface=linear")
        here = numbers(self.under_mouse(window, *MIDDLE))
        self.assertLess(here["cell"], mesh.GetNumberOfCells())
        self.close(window)

    def test_readout_of_displaced_mesh(self):
        """On a mesh that is inside out, the value is that of the visible face, not of the closest
        one."""
        window = self.window(
            self.mesh, "--array=Latitude", "--up=z", "--height", self.heights, "--scale=1e-6",
            "--offset=-1", "--surface=linear")
        for x, y in (MIDDLE, (130, 100), (180, 150)):
            here = numbers(self.under_mouse(window, x, y))
            self.assertAlmostEqual(math.hypot(here["x"], here["y"], here["z"]), 0.5, delta=0.05)
            self.assertAlmostEqual(here["Latitude"], -here["z"], delta=0.05)
        self.close(window)

    def test_readout_of_coordinates(self):
        file = DATA / "relief" / "luxembourg_elev.tif"
        if not file.exists():
            self.skipTest("no RELEVO_TEST_DATA")
        window = self.window(file, "--center=0,0", "--zoom=8")
        here = numbers(self.under_mouse(window, *MIDDLE))
        # The raster covers 5.74167 to 6.53333 degrees east and 49.44167 to 50.19167 degrees north.
        self.assertAlmostEqual(here["longitude"], 6.1375, delta=0.002)
        self.assertAlmostEqual(here["latitude"], 49.81667, delta=0.002)
        self.close(window)

    def test_readout_in_picture(self):
        """Values appear in the corner when the mouse rests on the surface, and disappear in the
        sky."""

        def count_dark():
            corner = [row[:120] for row in window.screen()[8:40]]
            return sum(is_dark(*colour) for row in corner for colour in row)

        window = self.window(self.mesh, "--array=Latitude")
        before = count_dark()
        window.move(*MIDDLE)
        wait(lambda: count_dark() > before + 100, "words in the corner")
        window.move(WIDTH - 2, 2)
        wait(lambda: count_dark() == before, "an empty corner again")
        self.close(window)

    def test_readout_after_drag(self):
        """The readout shows what is under the mouse now, while the button is down and after it is
        released."""

        def corner():
            return [row[:200] for row in window.screen()[8:40]]

        def has_new_words(old):
            now = corner()
            return now != old and self.has_words(now)

        window = self.window(self.mesh, "--array=Latitude", "--no-legend", "--zoom=0.5")
        empty = corner()
        window.move(*MIDDLE)
        wait(lambda: has_new_words(empty), "words in the corner")
        before = corner()
        window.press()
        window.move(MIDDLE[0] + 30, MIDDLE[1] + 20)
        wait(lambda: has_new_words(before), "other words in the drag")
        self.settle(window)  # The view does not move on while the button is down.
        window.release()
        self.close(window)

    def test_scale_bar(self):
        """The scale bar is 1, 2 or 5 times a power of ten, compared with a disc of diameter 1 in
        the focal plane."""
        disc = vtkRegularPolygonSource()
        disc.SetNumberOfSides(60)
        disc.GeneratePolylineOff()
        disc.Update()
        file = write_mesh(self.folder, "disc.vtp", disc.GetOutput())
        for zoom in ("1", "0.6", "0.17"):
            window = self.window(file, "--view=180,0", "--surface=linear", f"--zoom={zoom}")
            picture = self.picture(window)
            self.close(window)
            left, _, _, _ = find([row[: WIDTH // 2] for row in picture[50:]], is_surface)
            start, end, _, _ = find([picture[16]], is_dark)
            length = (end - start) / (WIDTH - 2 * left)  # the axes cover the disc's right half
            self.assertLess(end - start, 0.21 * WIDTH)
            self.assertGreater(end - start, 0.2 * WIDTH / 2.6)
            power = 10 ** math.floor(math.log10(length) + 0.02)
            self.assertTrue(
                any(abs(length / power / digit - 1) < 0.07 for digit in (1, 2, 5)), length
            )

    def test_help(self):
        """The help appears and disappears with h."""
        window = self.window(self.mesh)
        before = self.picture(window)
        window.key("h")
        self.wait_for_help(window)
        # Nothing is reported under the help text.
        self.assertEqual(self.under_mouse(window, *MIDDLE), "here: nothing")
        window.move(WIDTH - 2, 2)
        window.key("h")
        wait(lambda: count_light(window.screen()) < 0.1 * WIDTH * HEIGHT, "no help")
        self.assertEqual(self.picture(window), before)
        self.close(window)
        usage = self.view("--help").stdout
        for words in ("In the window", "save a picture", "q, e"):
            self.assertIn(words, usage)

    def wait_for_help(self, window):
        wait(lambda: count_light(window.screen()) > 0.2 * WIDTH * HEIGHT, "the help")

    def test_pictures_without_words(self):
        """A screenshot shows neither help nor readout. Both reappear on the screen."""
        window = self.window(self.mesh, "--array=Latitude", "--no-legend")
        before = self.picture(window)
        window.move(*MIDDLE)

        def count_dark():
            return sum(is_dark(*colour) for row in window.screen()[8:40] for colour in row[:120])

        wait(lambda: count_dark() > 100, "words in the corner")
        self.assertEqual(self.picture(window), before)
        wait(lambda: count_dark() > 100, "words in the corner again")
        window.key("h")
        self.wait_for_help(window)
        self.assertEqual(self.picture(window), before)
        self.wait_for_help(window)
        self.close(window)

    def test_pictures(self):
        """Screenshots have the window's size and contents, and go to new files."""
        own = self.folder / "sphere-2.png"
        own.write_text("mine")
        for file in self.folder.glob("sphere-*.png"):
            if file != own:
                file.unlink()
        window = self.window(self.mesh)
        names = []
        for _ in range(2):
            window.key("i")
            names.append(window.expect("picture: "))
        self.assertEqual(names, ["picture: sphere-1.png", "picture: sphere-3.png"])
        self.assertEqual(own.read_text(), "mine")
        picture = read_picture(self.folder / "sphere-1.png")
        self.assertEqual((len(picture[0]), len(picture)), (WIDTH, HEIGHT))
        left, right, low, high = find(picture, is_surface)
        self.assertGreater(high - low, 0.7 * HEIGHT)
        self.close(window)

    def test_picture_that_cannot_be_written(self):
        """An error gives a warning, and the window stays open."""
        folder = self.folder / "gone"
        folder.mkdir()
        window = Window(self.display, folder, self.mesh)
        self.addCleanup(window.stop)
        folder.rmdir()
        window.key("i")
        window.key("c")
        window.expect("here: ")
        window.key("q")
        code, errors = window.leave()
        self.assertEqual(code, 0)
        self.assertRegex(errors, r"\Arelevo-view: warning: cannot write sphere-1.png: [^\n]+\n\Z")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTools"])
