# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on relevo-view --relief: captures in place of surfaces, folders of reliefs, and
errors."""

import unittest

from ViewerPictures import is_surface, read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import write_hill, write_sphere

SMALL = ("--size=160x120", "--no-legend")


class TestViewerRelief(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sphere = write_sphere(cls.folder)
        cls.hill = write_hill(cls.folder)

    def picture(self, *arguments):
        self.view(*arguments, *SMALL, "--output=p.png")
        return read_picture(self.folder / "p.png")

    def assert_like(self, picture, expected, share):
        """Most pixels that show the surface in the expected picture have about the same colour."""
        surface = same = 0
        for row, expected_row in zip(picture, expected):
            for pixel, other in zip(row, expected_row):
                if is_surface(*other):
                    surface += 1
                    same += max(abs(a - b) for a, b in zip(pixel, other)) < 24
        self.assertGreater(surface, 1000)
        self.assertGreater(same, share * surface)

    def test_captures(self):
        for file, ways in ((self.sphere, ("box", "sphere", "view")), (self.hill, ("view",))):
            expected = self.picture(file)
            for cameras in ways:
                self.assert_like(self.picture(file, "--relief", cameras), expected, 0.8)

    def test_methods(self):
        expected = self.picture(self.sphere)
        for method in ("automatic", "march", "refinement", "warp"):
            drawn = self.picture(self.sphere, "--relief=view", "--relief-method", method)
            self.assert_like(drawn, expected, 0.9)
        for search in ("mipmap", "linear-binary", "linear-secant", "cones"):
            drawn = self.picture(
                self.sphere, "--relief=view", "--relief-method=march", "--relief-search", search
            )
            self.assert_like(drawn, expected, 0.9)

    def test_folder(self):
        self.view(self.sphere, "--capture", "six")
        names = {path.name for path in (self.folder / "six").iterdir()}
        self.assertIn("data.csv", names)
        self.assertEqual(len([name for name in names if name.endswith(".vti")]), 6)
        self.assertEqual(self.statistic("reliefs", "six"), 6)
        drawn = self.picture("six")
        self.assertEqual(drawn, self.picture("six/data.csv"))
        self.assertNotEqual(drawn, self.picture("six", "--up=z"))
        self.assertNotEqual(drawn, self.picture("six", "--center=9,0,0"))
        self.assertGreater(sum(is_surface(*pixel) for row in drawn for pixel in row), 1000)
        self.view(self.sphere, "--relief=sphere", "--capture", "twelve", "--output=t.png", *SMALL)
        self.assertEqual(self.statistic("reliefs", "twelve", "--relief-method=march"), 12)

    def test_errors(self):
        (self.folder / "empty").mkdir(exist_ok=True)
        self.assert_error(1, ["empty", "data.csv"], "empty", "--output=o.png")
        self.assert_error(2, ["--relief", "box", "sphere", "view"], self.sphere, "--relief=ball")
        self.assert_error(2, ["--relief-method", "--relief"], self.sphere, "--relief-method=warp")
        self.assert_error(
            2, ["--relief-search", "march"], self.sphere, "--relief=box", "--relief-search=mipmap"
        )
        self.assert_error(2, ["--array", "folder"], "empty", "--array=A", "--output=o.png")
        for option in ("--light=10,20", "--exaggeration=2", "--relief=box"):
            self.assert_error(2, [option.split("=")[0], "folder"], "empty", option)
        self.assert_error(2, ["--center", "X,Y,Z"], "empty", "--center=1,2", "--output=o.png")
        self.assert_error(2, ["--capture", "folder"], self.sphere, "--capture=")
        self.assert_error(2, ["--relief", "--volume"], self.sphere, "--volume", "--relief=box")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerRelief"])
