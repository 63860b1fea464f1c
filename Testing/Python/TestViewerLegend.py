# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on legends: complete words, units, even labels, and no overlap with the scene.
"""

import sys
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer
import vtkmodules.vtkRenderingFreeType  # noqa: F401: draws texts

from ViewerPictures import read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import make_array, make_cube, make_sphere, write_cube, write_hill, write_mesh

STRESS = "Equivalent (von-Mises) Stress"
UTM = 'LOCAL_CS["metres",UNIT["metre",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]]'


def draw_words(words, size):
    """The opacity of a text as VTK draws it, top row first."""
    look = vtkTextProperty()
    look.SetFontSize(size)
    image = vtkImageData()
    renderer = vtkTextRenderer.GetInstance()
    renderer.RenderString(look, words, image, [0, 0], 72, renderer.FreeType)
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    opacity = pixels[::-1, :, -1] / 255.0
    rows = numpy.flatnonzero(opacity.max(axis=1))
    columns = numpy.flatnonzero(opacity.max(axis=0))
    return opacity[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]


class Picture:
    """Rows of pixels, top row first."""

    def __init__(self, name):
        self.pixels = numpy.array(read_picture(name), dtype=float)[::-1]
        dark = self.pixels.max(axis=2)
        # Text is almost black on a light background.
        ink = numpy.clip((200.0 - dark) / 150.0, 0.0, 1.0)
        self.ink = ink[:, :220].astype(numpy.float32)

    def find(self, words):
        """Left, top, right and bottom of a text that is completely visible, or None."""
        for size in (14, 12, 10):
            mask = draw_words(words, size)
            windows = numpy.lib.stride_tricks.sliding_window_view(self.ink, mask.shape)
            # Letters are dark, and the pixels around them are not.
            letters, gaps = mask > 0.75, mask < 0.05
            inside = numpy.zeros(windows.shape[:2])
            outside = numpy.zeros(windows.shape[:2])
            for j, i in numpy.argwhere(letters):
                inside += windows[:, :, j, i]
            for j, i in numpy.argwhere(gaps):
                outside += windows[:, :, j, i]
            score = inside / letters.sum() - outside / gaps.sum()
            top, left = numpy.unravel_index(score.argmax(), score.shape)
            if score[top, left] > 0.8:
                return left, top, left + mask.shape[1], top + mask.shape[0]
        return None


class TestViewerLegend(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.volume = write_cube(cls.folder)

    def picture(self, *arguments, size=(320, 240)):
        self.view(*arguments, "--output=l.png", "--size={}x{}".format(*size))
        return Picture(self.folder / "l.png")

    def write_sphere(self, name, low, high, unit=None):
        """All points have the high value, except one at the bottom."""
        sphere = make_sphere()
        count = sphere.GetNumberOfPoints()
        lowest = min(range(count), key=lambda i: sphere.GetPoint(i)[2])
        array = make_array(name, [(low if i == lowest else high,) for i in range(count)])
        if unit:
            array.GetInformation().Set(vtkDataArray.UNITS_LABEL(), unit)
        sphere.GetPointData().AddArray(array)
        return write_mesh(self.folder, "named.vtp", sphere), f"--array={name}", "--up=z"

    def assert_shows(self, picture, *words):
        boxes = [picture.find(word) for word in words]
        for word, box in zip(words, boxes):
            self.assertIsNotNone(box, word)
        return boxes

    def test_long_titles(self):
        """All words are visible, in pictures of every size, of meshes and volumes."""
        cube = make_cube()
        count = cube.GetNumberOfPoints()
        cube.GetPointData().AddArray(make_array(STRESS, [(float(i),) for i in range(count)]))
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(self.folder / "long.vtu"))
        writer.SetInputData(cube)
        writer.Write()
        mesh = self.write_sphere(STRESS, 0.0, 1.0)
        for scene in (mesh, ("long.vtu", "--volume", STRESS)):
            for size in ((320, 240), (700, 400), (300, 500)):
                with self.subTest(scene=scene, size=size):
                    picture = self.picture(*scene, size=size)
                    self.assert_shows(picture, "Equivalent", "(von-Mises)", "Stress")

    def test_title_of_one_long_word(self):
        """A long word is broken where necessary and never cut off."""
        scene = self.write_sphere("Displacementmagnitudeofthenode_at_rest", 0.0, 1.0)
        picture = self.picture(*scene)
        self.assert_shows(picture, "Displacement", "rest")

    def test_titles_of_terrains_and_levels(self):
        self.assert_shows(self.picture(self.heights), "Height", "30.0", "0.0")
        picture = self.picture(self.heights, "--color-by=level", "--max-level=3")
        self.assert_shows(picture, "Level")
        picture = self.picture(self.heights, "--color-by=pattern", "--max-level=2", size=(400, 320))
        self.assert_shows(picture, "Pattern", "(2, 2, 2)", "(0, 0, 0)")

    def test_units(self):
        """The unit in a file's array appears once, and heights are in metres."""
        self.assert_shows(self.picture(*self.write_sphere("Flux", 0.0, 1.0, "kW")), "Flux [kW]")
        picture = self.picture(*self.write_sphere("Flux [kW]", 0.0, 1.0, "kW"))
        self.assert_shows(picture, "Flux [kW]")
        self.assertIsNone(picture.find("[kW] [kW]"))
        rows = "\n".join(" ".join(str(i * j) for i in range(11)) for j in range(11))
        (self.folder / "m.asc").write_text(
            f"ncols 11\nnrows 11\nxllcorner 0\nyllcorner 0\ncellsize 10\n{rows}\n"
        )
        (self.folder / "m.prj").write_text(UTM)
        self.assert_shows(self.picture("m.asc"), "Height [m]")

    def test_sea_level(self):
        """The sea level is labelled, and labels that are too close to it are not."""
        rows = "\n".join(" ".join(str(8 * i - 40 + j % 2) for i in range(21)) for j in range(21))
        (self.folder / "sea.asc").write_text(
            f"ncols 21\nnrows 21\nxllcorner 0\nyllcorner 0\ncellsize 10\n{rows}\n"
        )
        size = (400, 320)
        picture = self.picture("sea.asc", "--sea-level=23", "--range=-40,120", size=size)
        lowest, sea, highest = self.assert_shows(picture, "-40", "23", "120")
        share = (lowest[1] - sea[1]) / (lowest[1] - highest[1])
        self.assertAlmostEqual(share, 63 / 160, delta=0.02)
        self.assertIsNone(picture.find("40.0"))

    def test_labels(self):
        """All labels have the same number of decimals and one exponent."""
        for low, high, shown, missing in (
            (0.0, 7.02e-5, ("7.02", "3.51", "0.00"), "7.02e-05"),
            (-3e8, 1.4e8, ("1.4", "-0.8", "-3.0"), "1.4e+08"),
            (-1.0, 1.0 + 1e-16, ("1.0", "0.5", "0.0", "-1.0"), "-0.00"),
            (1e-18, 5.0, ("5.00", "2.50", "0.00"), "1e-18"),
        ):
            with self.subTest(low=low, high=high):
                picture = self.picture(*self.write_sphere("Value", low, high))
                self.assert_shows(picture, "Value", *shown)
                self.assertIsNone(picture.find(missing))
                factor = {7.02e-5: "\u00d7 1e-5", 1.4e8: "\u00d7 1e8"}.get(high)
                if factor:
                    self.assert_shows(picture, factor)

    def test_nothing_is_covered(self):
        """The sphere is yellow, and the area of the text and around it is not."""
        scene = self.write_sphere(STRESS, 0.0, 1.0)
        for size in ((320, 240), (640, 480), (300, 500), (900, 300)):
            with self.subTest(size=size):
                picture = self.picture(*scene, size=size)
                yellow = picture.pixels[:, :, 1] > picture.pixels[:, :, 2] + 20.0
                bar = 36  # columns at the left, which contain yellow, too
                boxes = self.assert_shows(picture, "(von-Mises)", "1.00", "0.00")
                right = max(box[2] for box in boxes)
                bottom = max(box[3] for box in boxes)
                self.assertFalse(yellow[: bottom + 3, bar : right + 3].any())
                # The sphere is completely visible and as large as possible.
                self.assertFalse(yellow[:, -1].any() or yellow[0, bar:].any() or yellow[-1].any())
                columns = numpy.flatnonzero(yellow[:, bar:].any(axis=0))
                rows = numpy.flatnonzero(yellow[:, bar:].any(axis=1))
                self.assertGreater(
                    max(numpy.ptp(columns) / (size[0] - right - 6), numpy.ptp(rows) / size[1]), 0.85
                )

    def test_zoom_and_center_are_kept(self):
        """The requested point is in the centre, whatever the legend covers."""
        scene = self.write_sphere(STRESS, 0.0, 1.0)
        picture = self.picture(*scene, "--center=0,0,0", "--zoom=0.3", "--view=180,0")
        yellow = picture.pixels[:, 60:, 1] > picture.pixels[:, 60:, 2] + 20.0
        columns = numpy.flatnonzero(yellow.any(axis=0)) + 60
        rows = numpy.flatnonzero(yellow.any(axis=1))
        self.assertAlmostEqual(columns.mean(), 160, delta=2)
        self.assertAlmostEqual(rows.mean(), 120, delta=2)

    def test_small_pictures_have_none(self):
        arguments = (self.volume, "--volume", "--size=160x120")
        self.view(*arguments, "--output=a.png")
        self.view(*arguments, "--output=b.png", "--no-legend")
        self.assertEqual(*(read_picture(self.folder / name) for name in ("a.png", "b.png")))


if __name__ == "__main__":
    unittest.main(argv=["TestViewerLegend"])
