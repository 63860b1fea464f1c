# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md for close views of terrain: the camera stays above the ground, and nothing is
clipped.

Pictures are compared with rays through the bilinear heights. Rays and camera are computed here from
heights and options. If the camera would be in the ground, the test checks a property of every view
from above a height field: below ground there is ground."""

import itertools
import math
import sys
import unittest

try:
    import numpy
except ImportError:
    print("skipped: there is no numpy")
    sys.exit(125)

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ViewerPictures import read_picture
from ViewerProgram import ViewerProgram

SIZE = (80, 60)
COLUMNS, ROWS = 96, 64
FILLED = 0.94  # share of the picture without a legend
ANGLE = math.radians(30)
DARK = 40  # brighter than the underside when lit from above


def make_heights():
    """Hills and valleys, a ridge and a cliff, in whole numbers."""
    x, y = numpy.meshgrid(numpy.arange(COLUMNS) / COLUMNS, numpy.arange(ROWS) / COLUMNS)
    heights = 60 + 40 * numpy.sin(9 * x + 4 * y) * numpy.cos(11 * y) + 15 * numpy.sin(40 * x)
    heights += 60 * numpy.exp(-(((x - 0.3) / 0.04) ** 2)) + 40 * (x > 0.75)
    return numpy.round(heights).astype(int)


HEIGHTS = make_heights()


def interpolate(x, y):
    """Bilinear heights at the terrain's x and y; NaN outside."""
    u = numpy.clip(x + COLUMNS / 2 - 0.5, 0, COLUMNS - 1)
    v = numpy.clip(y + ROWS / 2 - 0.5, 0, ROWS - 1)
    i = numpy.minimum(u.astype(int), COLUMNS - 2)
    j = numpy.minimum(v.astype(int), ROWS - 2)
    s, t = u - i, v - j
    low = (1 - s) * HEIGHTS[j, i] + s * HEIGHTS[j, i + 1]
    high = (1 - s) * HEIGHTS[j + 1, i] + s * HEIGHTS[j + 1, i + 1]
    inside = (numpy.abs(x) <= COLUMNS / 2) & (numpy.abs(y) <= ROWS / 2)
    return numpy.where(inside, (1 - t) * low + t * high, numpy.nan)


def get_axes(azimuth, elevation):
    """The directions to the camera, to the right and upwards."""
    a, e = math.radians(azimuth), math.radians(elevation)
    back = numpy.array(
        [math.sin(a) * math.cos(e), math.cos(a) * math.cos(e), math.sin(e)]
    )
    right = numpy.cross(-back, (0, 0, 1))
    right /= numpy.linalg.norm(right)
    return back, right, numpy.cross(right, -back)


def get_distance(points, axes):
    """Distance from the camera that shows all points to the centre of their bounding box."""
    back, right, up = axes
    tangents = FILLED * math.tan(ANGLE / 2) * numpy.array([SIZE[0] / SIZE[1], 1])
    depths = points @ -back
    nearest = math.inf
    for axis, tangent in zip((right, up), tangents):
        across = points @ axis
        most = numpy.max(across - tangent * depths) + numpy.max(-across - tangent * depths)
        nearest = min(nearest, -most / 2 / tangent)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return centre @ -back - nearest


def cast(position, axes, scale, nearest):
    """Whether the rays through the pixels' centres hit the ground, lowest row first."""
    back, right, up = axes
    x, y = (
        (2 * (numpy.arange(n) + 0.5) / n - 1) * math.tan(ANGLE / 2) * n / SIZE[1] for n in SIZE
    )
    rays = x[None, :, None] * right + y[:, None, None] * up - back
    met = numpy.zeros(rays.shape[:2], bool)
    before = numpy.full(met.shape, numpy.nan)  # height above the ground, NaN outside
    for depth in numpy.geomspace(nearest, 400, 600):
        point = position + depth * rays
        above = point[..., 2] - scale * interpolate(point[..., 0], point[..., 1])
        met |= above * before < 0
        before = above
    return met


def is_sky(red, green, blue):
    return blue > red + 10 and blue > 150


class TestViewerCloseViews(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        image = vtkImageData()
        image.SetDimensions(COLUMNS, ROWS, 1)
        image.AllocateScalars(VTK_UNSIGNED_SHORT, 1)
        for j in range(ROWS):
            for i in range(COLUMNS):
                image.SetScalarComponentFromDouble(i, j, 0, 0, HEIGHTS[j, i])
        cls.file = cls.folder / "rough.png"
        writer = vtkPNGWriter()
        writer.SetFileName(str(cls.file))
        writer.SetInputData(image)
        writer.Write()

    def picture(self, *arguments):
        """True where there is ground, and the share of it that is dark."""
        self.view(
            self.file, "--output=p.png", "--size={}x{}".format(*SIZE), "--no-legend",
            "--light=0,90", *arguments
        )
        picture = numpy.array(read_picture(self.folder / "p.png"))
        sky = numpy.array([[is_sky(*colour) for colour in row] for row in picture])
        return ~sky, numpy.mean(picture.max(axis=2)[~sky] < DARK)

    def get_points(self, scale):
        self.view(self.file, "--export=e.vtp", "--level=0", f"--exaggeration={scale}")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "e.vtp"))
        reader.Update()
        mesh = reader.GetOutput()
        return numpy.array([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])

    def test_views(self):
        scale = 0.3
        points = self.get_points(scale)
        clear = 0
        views = itertools.product(((190, 20), (20, 5), (190, 50)), (8, 60, 400, 3000))
        for number, ((azimuth, elevation), zoom) in enumerate(views):
            x, y = ((7 * number) % 60 - 30) + 0.4, ((11 * number) % 40 - 20) + 0.3
            with self.subTest(view=(azimuth, elevation), zoom=zoom, at=(x, y)):
                ground, dark = self.picture(
                    f"--exaggeration={scale}", f"--zoom={zoom}", f"--center={x},{y}",
                    f"--view={azimuth},{elevation}",
                )
                axes = get_axes(azimuth, elevation)
                distance = get_distance(points, axes) / zoom
                height = scale * interpolate(numpy.array(x), numpy.array(y))
                position = numpy.array([x, y, height]) + distance * axes[0]
                below = scale * interpolate(position[0], position[1])
                if not math.isnan(below):  # from outside the terrain, its underside may be visible
                    self.assertLess(dark, 0.03)
                    self.assert_no_gaps(ground)
                if not position[2] < below + 0.02 * distance:
                    clear += 1
                    self.assert_same(ground, cast(position, axes, scale, 0.01 * distance))
        self.assertGreater(clear, 4)
        self.assertLess(clear, 12)

    def assert_no_gaps(self, ground):
        """Below ground there is ground."""
        for column in ground.T:
            first = numpy.flatnonzero(column)
            self.assertTrue(first.size == 0 or column[: first[-1]].all())

    def assert_same(self, ground, expected):
        """Ignores one pixel along silhouettes."""
        near = expected.copy()
        sure = expected.copy()
        for axis in (0, 1):
            for step in (-1, 1):
                near |= numpy.roll(expected, step, axis)
                sure &= numpy.roll(expected, step, axis)
        wrong = (ground & ~near) | (~ground & sure)
        self.assertLess(wrong.sum(), 0.005 * wrong.size)

    def test_coarse_terrain(self):
        """The camera stays above the drawn surface, which is flatter than the heights."""
        for arguments in (("--level=0", "--resolution=6"), ("--level=2", "--resolution=3")):
            for zoom in (20, 200):
                for at in ("-20,3", "25,12"):
                    with self.subTest(arguments, zoom=zoom, at=at):
                        ground, dark = self.picture(
                            *arguments, "--exaggeration=0.3", f"--zoom={zoom}", f"--center={at}",
                            "--view=190,15",
                        )
                        self.assert_no_gaps(ground)
                        self.assertLess(dark, 0.03)

    def test_exaggeration(self):
        """Nothing of a needle is visible; the message gives the possible range."""
        for value in ("1e9", "-1e9"):
            self.assert_error(
                1, ["rough.png", f"--exaggeration {float(value):.3g}", "as high as"], self.file,
                f"--exaggeration={value}", "--output=n.png",
            )
        ground, _ = self.picture("--exaggeration=40")
        self.assertGreater(ground.sum(), 20)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerCloseViews"])
