# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on streamlines: --streamlines, --seeds and --seed-line."""

import math
import unittest

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from ResultData import add_array
from ViewerPictures import read_colours
from ViewerProgram import ViewerProgram

SIZE = 200
SETTINGS = ("--no-legend", f"--size={SIZE}x{SIZE}", "--output=p.png")


class TestViewerStreamlines(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        """A cube from -4 to 4 with vectors "Turn" around the z axis, and "Still", which is 0."""
        super().setUpClass()
        image = vtkImageData()
        image.SetOrigin(-4, -4, -4)
        image.SetDimensions(9, 9, 9)
        points = [image.GetPoint(i) for i in range(image.GetNumberOfPoints())]
        add_array(image.GetPointData(), "Turn", [(-y, x, 0) for x, y, z in points])
        add_array(image.GetPointData(), "Still", [(0, 0, 0)] * len(points))
        add_array(image.GetPointData(), "Heat", [(x,) for x, y, z in points])
        cls.write_data("turn.vti", vtkXMLImageDataWriter, image)
        convert = vtkPointDataToCellData()
        convert.SetInputData(image)
        convert.Update()
        cls.write_data("cells.vti", vtkXMLImageDataWriter, convert.GetOutput())

    def picture(self, *arguments):
        self.view(*arguments, *SETTINGS)
        return read_colours(self.folder / "p.png")

    def test_circle(self):
        """A line from one seed is a circle around the axis, of points and of cells."""
        for name in ("turn.vti", "cells.vti"):
            arguments = (name, "--streamlines=Turn", "--view=front")
            lines = self.picture(*arguments, "--seeds=1", "--seed-line=2.4,0,0,2.6,0,0")
            none = self.run_program(
                name, "--array=Turn", "--streamlines=Turn", "--view=front", "--seeds=1", "--seed-line=90,0,0,90,0,0", *SETTINGS
            )
            self.assertEqual(none.returncode, 0)
            self.assertIn("--streamlines shows none", none.stderr)
            empty = read_colours(self.folder / "p.png")
            rows, columns = (abs(lines - empty).max(axis=2) > 40).nonzero()
            middle = SIZE / 2 - 0.5
            radii = [math.hypot(row - middle, column - middle) for row, column in zip(rows, columns)]
            self.assertGreater(len(radii), 100)
            self.assertLess(max(radii) - min(radii), 5)
            # All around.
            self.assertEqual(len({(row > middle, column > middle) for row, column in zip(rows, columns)}), 4)

    def test_options(self):
        """More seeds draw more lines, and --array colours them."""
        few, many, heat = (
            self.picture("turn.vti", "--streamlines=Turn", "--view=front", *options)
            for options in (["--seeds=7"], ["--seeds=40"], ["--seeds=40", "--array=Heat"])
        )
        self.assertGreater((abs(few - many).max(axis=2) > 20).sum(), 500)
        self.assertGreater((abs(heat - many).max(axis=2) > 20).sum(), 500)

    def test_bad_input(self):
        for words, *arguments in (
            (["no array of numbers 'None'"], "--streamlines=None"),
            (["an array with 3 components", "'Heat' has 1"], "--streamlines=Heat"),
        ):
            self.assert_error(1, words, "turn.vti", *arguments, *SETTINGS)
        for words, *arguments in (
            (["--seeds requires --streamlines"], "--seeds=3"),
            (["--seed-line", "X,Y,Z,X,Y,Z"], "--streamlines=Turn", "--seed-line=1"),
            (["--volume"], "--volume", "--streamlines=Turn"),
            (["--lic", "--streamlines"], "--lic=Turn", "--streamlines=Turn"),
            (["--streamlines needs the name"], "--streamlines="),
        ):
            self.assert_error(2, words, "turn.vti", *arguments, *SETTINGS)
        run = self.run_program("turn.vti", "--streamlines=Still", *SETTINGS)
        self.assertEqual(run.returncode, 0)
        self.assertIn("--streamlines shows none", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerStreamlines"])
