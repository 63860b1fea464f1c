# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on relevo-view --against: output and picture of two intersecting meshes, and
errors."""

import math
import re
import unittest

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_QUAD, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from ViewerPictures import read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import write_hill, write_mesh


def write_box(folder, name, low, high):
    source = vtkCubeSource()
    source.SetBounds(low, high, low, high, low, high)
    source.Update()
    write_mesh(folder, name, source.GetOutput())


def write_bore(folder):
    """A tube of 8 quadratic cells around the y axis, from -1 to 1."""
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    for y in (-1, 0, 1):
        for i in range(16):
            angle = math.pi * i / 8
            grid.GetPoints().InsertNextPoint(math.cos(angle), y, math.sin(angle))
    for i in range(0, 16, 2):
        middle, end = i + 1, (i + 2) % 16
        nodes = (i, end, end + 32, i + 32, middle, end + 16, middle + 32, i + 16)
        grid.InsertNextCell(VTK_QUADRATIC_QUAD, 8, nodes)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(folder / "bore.vtu"))
    writer.SetInputData(grid)
    writer.Write()


def write_pin(folder, name, radius):
    source = vtkCylinderSource()
    source.SetRadius(radius)
    source.SetResolution(128)
    source.Update()
    write_mesh(folder, name, source.GetOutput())


def is_red(red, green, blue):
    return red > 60 and green < 0.4 * red and blue < 0.4 * red


def is_orange(red, green, blue):
    return red > 100 and 0.4 * red < green < 0.75 * red and blue < 0.4 * red


def count(picture, is_shown):
    return sum(is_shown(*colour) for row in picture for colour in row)


class TestViewerContact(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        write_box(cls.folder, "a.vtp", 0, 2)
        write_box(cls.folder, "b.vtp", 1, 3)
        write_box(cls.folder, "c.vtp", 2.5, 3)
        write_box(cls.folder, "d.vtp", 0.5, 2)

    def found(self, *arguments):
        """The printed numbers by name."""
        lines = self.view(*arguments).stdout.splitlines()
        return {
            line.split(":")[0]: tuple(map(float, re.findall(r"\d[\d.e+-]*", line)))
            for line in lines
        }

    def test_curves(self):
        """One closed curve, a hexagon with edges of length 1."""
        found = self.found("a.vtp", "--against", "b.vtp")
        self.assertEqual(set(found), {"cut faces", "curves", "overlap area"})
        self.assertEqual(found["curves"], (1, 6))
        self.assertEqual(found["overlap area"], (0,))
        self.assertEqual(found["cut faces"], (3, 3))

    def test_overlap(self):
        """Three faces of the smaller box lie in faces of the other."""
        found = self.found("a.vtp", "--against=d.vtp")
        self.assertAlmostEqual(found["overlap area"][0], 3 * 1.5**2)

    def test_distance(self):
        found = self.found("a.vtp", "--against=c.vtp", "--contact-distance=1")
        self.assertEqual(found["curves"], (0, 0))
        self.assertEqual(found["near faces"], (3, 3))
        self.assertAlmostEqual(found["least distance"][0], 0.5 * 3**0.5, places=5)
        found = self.found("a.vtp", "--against=c.vtp", "--contact-distance=0.5")
        self.assertEqual(found["near faces"], (0, 0))
        found = self.found("a.vtp", "--against=b.vtp", "--contact-distance=0")
        self.assertEqual((found["least distance"], found["faces inside"]), ((0,), (0, 0)))

    def test_curved_cells(self):
        """A bore of radius 1 has 8 quadratic cells whose chords are 0.924 from the axis. A pin of
        0.99 does not touch it; both ends of a pin of 1.02 intersect it all around. Messages name
        files."""
        write_bore(self.folder)
        for radius in (0.99, 1.02):
            write_pin(self.folder, "pin.vtp", radius)
            with self.subTest(radius):
                picture = "--output=p.png", "--size=160x100"
                found = self.found("bore.vtu", "--against=pin.vtp", *picture)
                self.assertAlmostEqual(found["curved cells"][-1], 1e-4 * 12**0.5)
                red = count(read_picture(self.folder / "p.png"), is_red)
                if radius < 1:
                    self.assertEqual(found["cut faces"], (0, 0))
                    self.assertEqual((found["curves"], red), ((0, 0), 0))
                else:
                    self.assertEqual(found["cut faces"][0], 8)
                    self.assertEqual(found["curves"][0], 2)
                    # Parabolas through points of a circle deviate by up to 0.0008.
                    self.assertAlmostEqual(found["curves"][1], 4 * math.pi, delta=0.01)
                    self.assertGreater(red, 100)
        write_pin(self.folder, "pin.vtp", 0.99)
        run = self.run_program("bore.vtu", "--against=pin.vtp", "--contact-distance=0.1")
        self.assertRegex(run.stderr, r"\Arelevo-view: warning: No cell is classified as inside[^\n]*: bore.vtu\.\n\Z")
        self.assertIn("near faces: 8 of bore.vtu", run.stdout)
        least = float(run.stdout.split()[-1])
        self.assertGreater(least, 0.0088)
        self.assertLess(least, 0.0105)

    def test_picture(self):
        picture = "--output=p.png", "--size=160x100", "--view=45,35"
        self.view("a.vtp", "--against=b.vtp", *picture)
        cut = read_picture(self.folder / "p.png")
        self.assertGreater(count(cut, is_red), 300)
        self.assertEqual(count(cut, is_orange), 0)
        self.view("a.vtp", "--against=c.vtp", "--contact-distance=1", *picture)
        near = read_picture(self.folder / "p.png")
        self.assertEqual(count(near, is_red), 0)
        self.assertGreater(count(near, is_orange), 300)

    def test_errors(self):
        write_hill(self.folder)
        self.assert_error(2, ["--against", "mesh", "b.tif"], "a.vtp", "--against=b.tif")
        self.assert_error(2, ["--against requires a mesh"], "hill.png", "--against=a.vtp")
        self.assert_error(2, ["--contact-distance", "--against"], "a.vtp", "--contact-distance=1")
        for bad in ("-1", "nan", "near"):
            self.assert_error(
                2, ["--contact-distance", bad], "a.vtp", "--against=b.vtp", f"--contact-distance={bad}"
            )
        for option in ("--surface=pn", "--stats", "--export=e.ply", "--relief=box", "--volume"):
            self.assert_error(
                2, [option.split("=")[0], "--against"], "a.vtp", "--against=b.vtp", option
            )
        self.assert_error(1, ["none.ply"], "a.vtp", "--against=none.ply")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerContact"])
