# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on colours of arrays, extremes, rulers, axes and isolines of cuts: --log, --below,
--above, --range all, --extremes, --ruler, --axes, --scale-bar and plan views."""

import unittest

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLUnstructuredGridWriter

from ResultData import add_array, write_series
from ViewerPictures import read_colours
from ViewerProgram import ViewerProgram

SIZE = 200
SETTINGS = (f"--size={SIZE}x{SIZE}", "--output=p.png")
CELLS = 8
RANGE = ("--range=0.1,10", "--below=#ffffff", "--above=red")


class TestViewerColours(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        """A cube with "Damage", from 0.01 at x = 0 to 100 at x = 8, and "Bump", 9 at (8, 2, 0) and -5
        at (0, 6, 8), and otherwise from 0 to 1."""
        super().setUpClass()
        image = vtkImageData()
        image.SetDimensions(CELLS + 1, CELLS + 1, CELLS + 1)
        points = [image.GetPoint(i) for i in range(image.GetNumberOfPoints())]
        add_array(image.GetPointData(), "Damage", [(10 ** (x / 2 - 2),) for x, y, z in points])
        peaks = {(8, 2, 0): 9.0, (0, 6, 8): -5.0}
        bump = [(peaks.get((x, y, z), x / CELLS),) for x, y, z in points]
        add_array(image.GetPointData(), "Bump", bump)
        add_array(image.GetPointData(), "Side", [(x - 4,) for x, y, z in points])
        cls.write_data("cube.vti", vtkXMLImageDataWriter, image)
        append = vtkAppendFilter()
        append.AddInputData(image)
        append.Update()
        cls.write_data("cube.vtu", vtkXMLUnstructuredGridWriter, append.GetOutput())

    def picture(self, *arguments):
        """Colours from 0 to 255, of rows from the top."""
        self.view(*arguments, *SETTINGS)
        return read_colours(self.folder / "p.png")

    def test_log(self):
        """Logarithms are in proportion to x: the section and the surface have the colours of each
        decade, and those out of range beside them."""
        for options in ((), ("--clip=4,4,4.001,0,0,-1",)):
            linear = self.picture(
                "cube.vti", "--array=Side", "--view=front", "--palette=grey", "--no-legend", *options
            )
            log = self.picture(
                "cube.vti", "--array=Damage", "--log", "--view=front", "--palette=grey", "--no-legend", *options
            )
            # The same greys as those of a linear array with the same range of colours.
            self.assertLess(abs(linear - log).max(), 4)
            ends = self.picture("cube.vti", "--array=Damage", "--view=front", "--no-legend", *RANGE, *options)
            row = ends[SIZE // 2]
            red = (row[:, 0] > 2 * row[:, 1]) & (row[:, 0] > 2 * row[:, 2])
            self.assertGreater(red.sum(), 30)
            white = row.max(axis=1) - row.min(axis=1) < 3
            self.assertGreater(white.sum(), 30)

    def test_log_of_volumes(self):
        drawn = self.picture("cube.vti", "--volume=Damage", "--log", "--view=front", "--no-legend", *RANGE)
        row = drawn[SIZE // 2]
        self.assertGreater(((row[:, 0] > 200) & (row[:, 1] < 60)).sum(), 30)  # red
        self.assertGreater(((row[:, 1] > row[:, 0] + 20) & (row[:, 1] > row[:, 2] + 20)).sum(), 10)  # green

    def test_swatches(self):
        """The legend has the colours out of range above and below its bar."""
        self.view("cube.vti", "--array=Damage", "--log", *RANGE, "--size=300x200", "--output=l.png")
        column = read_colours(self.folder / "l.png")[:, 12]
        red = (column == (255, 0, 0)).all(axis=1).nonzero()[0]
        white = (column == (255, 255, 255)).all(axis=1).nonzero()[0]
        self.assertEqual(len(red), 8)
        self.assertGreaterEqual(len(white), 8)
        self.assertLess(red.max(), white.min())

    def test_range_of_all_steps(self):
        """A single picture has the colours of all steps, of surfaces and volumes."""
        write_series(self.folder, "a.pvd")
        for kind in ("--array=Heat", "--volume=Heat"):
            first = self.picture("a.pvd", kind, "--time=1", "--range=all")
            self.assertTrue((first == self.picture("a.pvd", kind, "--time=1", "--range=0,4")).all())
            self.assertFalse((first == self.picture("a.pvd", kind, "--time=1")).all())

    def test_bad_input(self):
        for words, *arguments in (
            (["--log needs values above 0", "'Side' is from -4 to 4", "--range 0.004,4"], "--array=Side", "--log"),
            (["--log needs values above 0", "'Side' is from -4 to 4"], "--volume=Side", "--log"),
        ):
            self.assert_error(1, words, "cube.vti", *arguments, *SETTINGS)
        for words, *arguments in (
            (["--log needs a --range above 0", "'0,4'"], "--array=Side", "--log", "--range=0,4"),
            (["--below needs a colour", "'blurk'"], "--array=Side", "--below=blurk"),
            (["--above needs a colour", "'#12'"], "--array=Side", "--above=#12"),
            (["--log", "--transfer"], "--volume=Side", "--log", "--transfer=t.txt"),
            (["--isolines", "--log"], "--array=Damage", "--log", "--isolines=3"),
            (["--ruler", "X,Y,Z,X,Y,Z", "'1,2'"], "--ruler=1,2"),
            (["--view"], "--view=sideways"),
        ):
            self.assert_error(2, words, "cube.vti", *arguments, *SETTINGS)
        for option in ("--log", "--range=all", "--extremes", "--axes", "--ruler=0,0,0,1,1,1"):
            self.assert_error(2, [option.split("=")[0], "mesh"], "dem.tif", option)
        run = self.run_program("cube.vti", "--color-by=level", "--extremes", *SETTINGS)
        self.assertEqual(run.returncode, 1)
        self.assertIn("--extremes requires colours by an array", run.stderr)

    def find_mark(self, *arguments):
        """The pixels that an option changes: centre, columns and rows."""
        plain = self.picture("cube.vti", "--no-legend", "--view=front", *arguments[1:])
        marked = self.picture("cube.vti", "--no-legend", "--view=front", *arguments)
        rows, columns = abs(marked - plain).max(axis=2).nonzero()
        return rows, columns

    def test_extremes(self):
        """Crosses mark the points with the largest and the smallest value."""
        for kind in ("--array=Bump", "--volume=Bump"):
            rows, columns = self.find_mark("--extremes", kind)
            # Seen from the front, (8, 2, 0) is in the lower right corner, and (0, 6, 8) in the upper
            # left one. Labels are beside them.
            self.assertGreater(len(rows), 200)
            left = columns < SIZE // 2
            self.assertTrue(left.any() and not left.all())
        # A cut that removes the largest value: another one is labelled.
        whole = self.find_mark("--extremes", "--array=Bump")
        cut = self.find_mark("--extremes", "--array=Bump", "--clip=0,3,0,0,1,0")
        self.assertNotEqual(sorted(zip(*whole)), sorted(zip(*cut)))

    def test_ruler(self):
        """A line between two points."""
        rows, columns = self.find_mark("--ruler=0,4,8,8,4,8", "--array=Bump")
        self.assertGreater(columns.max() - columns.min(), 0.6 * SIZE)
        line = self.picture("cube.vti", "--no-legend", "--view=front", "--ruler=0,4,8,8,4,8")
        dark = (line.max(axis=2) < 60).sum(axis=1)
        self.assertGreater(dark.max(), 0.6 * SIZE)

    def test_axes_and_scale(self):
        """Both are in the lower right corner. Along an axis, the others are horizontal and vertical."""
        for option in ("--axes", "--scale-bar"):
            rows, columns = self.find_mark(option)
            self.assertGreater(len(rows), 40)
            self.assertGreater(columns.min(), SIZE // 2)
            self.assertGreater(rows.min(), SIZE // 4)

    def test_plan_views(self):
        for name, angles in (
            ("front", "180,0"), ("back", "0,0"), ("left", "270,0"), ("right", "90,0"), ("top", "180,90"), ("bottom", "180,-90")
        ):
            one = self.picture("cube.vti", "--array=Bump", f"--view={name}")
            self.assertTrue((one == self.picture("cube.vti", "--array=Bump", f"--view={angles}")).all())

    def test_isolines_of_cuts(self):
        """A cut across x has vertical lines at multiples of the spacing."""
        arguments = ("cube.vtu", "--array=Side", "--clip=4,4,4.001,0,0,-1", "--view=front", "--no-legend")
        plain = self.picture(*arguments)
        lines = self.picture(*arguments, "--isolines=4")
        darker = (plain - lines).sum(axis=2)[SIZE // 2]
        columns = (darker > 60).nonzero()[0]
        # Multiples of 2 in the section: -2, 0 and 2, inside of its borders.
        groups = 1 + ((columns[1:] - columns[:-1]) > 3).sum()
        self.assertIn(groups, (3, 4, 5))


if __name__ == "__main__":
    unittest.main(argv=["TestViewerColours"])
