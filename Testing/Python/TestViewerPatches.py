# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on curved cells, isolines and hair."""

import math
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_QUAD,
    VTK_QUADRATIC_TRIANGLE,
    vtkCellArray,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridWriter

from ViewerPictures import read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import write_sphere

# A dome over the unit square. The middle of its control net has height 1.
DOME = "1\n2 2\n" + "\n".join(
    f"{x / 2} {y / 2} {1.0 if x == y == 1 else 0.0}" for y in range(3) for x in range(3)
)
FRONT = ("--view=180,89", "--up=z", "--size=160x120", "--no-legend")


def write_grid(file, cell_type, nodes):
    """One cell; the point array Right is x."""
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    right = vtkDoubleArray()
    right.SetName("Right")
    for node in nodes:
        grid.GetPoints().InsertNextPoint(node)
        right.InsertNextValue(node[0])
    grid.GetPointData().SetScalars(right)
    cells = vtkCellArray()
    cells.InsertNextCell(len(nodes), list(range(len(nodes))))
    grid.SetCells(cell_type, cells)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(grid)
    writer.Write()


class TestViewerPatches(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "dome.bpt").write_text(DOME)
        bulge = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0.5, -0.4, 0), (0.6, 0.6, 0), (0, 0.5, 0)
        write_grid(cls.folder / "curved.vtu", VTK_QUADRATIC_TRIANGLE, bulge)
        square = (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)
        write_grid(cls.folder / "flat.vtu", VTK_QUAD, square)
        cls.sphere = write_sphere(cls.folder)

    def picture(self, *arguments):
        self.view("--output=p.png", *FRONT, *arguments)
        return read_picture(self.folder / "p.png")

    def export(self, *arguments):
        self.view("--export=e.vtp", *arguments)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "e.vtp"))
        reader.Update()
        return reader.GetOutput()

    def test_shape(self):
        """Exported points lie on the cells, whose height and border are known."""
        dome = self.export("dome.bpt", "--error=0.1")
        highest = max(dome.GetPoint(i)[2] for i in range(dome.GetNumberOfPoints()))
        self.assertAlmostEqual(highest, 0.25, 2)
        for i in range(dome.GetNumberOfPoints()):
            x, y, z = dome.GetPoint(i)
            self.assertAlmostEqual(z, 4 * x * (1 - x) * y * (1 - y), 6)
        curved = self.export("curved.vtu")
        self.assertLess(curved.GetBounds()[2], -0.35)
        flat = self.export("curved.vtu", "--surface=linear", "--level=0")
        self.assertAlmostEqual(flat.GetPointData().GetScalars().GetRange()[1], 1.0, 6)
        right = curved.GetPointData().GetArray("Right")
        for i in range(curved.GetNumberOfPoints()):
            self.assertAlmostEqual(right.GetValue(i), curved.GetPoint(i)[0], 6)

    def test_error(self):
        """Smaller errors and nearer views need more triangles. The segments requested are used."""
        counts = [self.statistic("triangles", "dome.bpt", f"--error={e}") for e in (4, 1, 0.25)]
        self.assertLess(counts[0], counts[1])
        self.assertLess(counts[1], counts[2])
        self.assertAlmostEqual(math.log(counts[2] / counts[1], 4), 1, 0)
        near = self.statistic("triangles", "dome.bpt", "--error=1", "--zoom=3")
        self.assertGreater(near, counts[1])
        powers = self.statistic("triangles", "dome.bpt", "--error=1", "--segments=powers")
        self.assertGreaterEqual(powers, counts[1])
        self.assertEqual(self.statistic("triangles", "dome.bpt", "--level=3"), 128)
        for metric in ("control-net", "curvature", "distance"):
            self.assertGreater(self.statistic("triangles", "dome.bpt", f"--metric={metric}"), 1)

    def test_lines(self):
        """Edges and isolines darken the surface in proportion to their number."""
        plain = self.picture("flat.vtu", "--surface=patch")

        def count_darker(*arguments):
            drawn = self.picture("flat.vtu", *arguments)
            pairs = (pair for rows in zip(drawn, plain) for pair in zip(*rows))
            return sum(sum(a) < sum(b) - 60 for a, b in pairs)

        self.assertEqual(count_darker("--surface=patch"), 0)
        self.assertGreater(count_darker("--patch-edges"), 100)
        few = count_darker("--isolines=4")
        self.assertGreater(few, 100)
        self.assertGreater(count_darker("--isolines=12"), 2 * few)
        self.assertEqual(self.picture("flat.vtu"), self.picture("flat.vtu", "--surface=linear"))

    def test_hair(self):
        bald = self.picture(self.sphere)
        hairy = self.picture(self.sphere, "--hair=4000")
        changed = sum(a != b for r, s in zip(bald, hairy) for a, b in zip(r, s))
        self.assertGreater(changed, 1000)
        # Everything is in view: the picture's borders show none of it.
        for drawn, empty in ((hairy, bald), (zip(*hairy), zip(*bald))):
            rows, others = list(drawn), list(empty)
            self.assertEqual((rows[0], rows[-1]), (others[0], others[-1]))
        self.assertNotEqual(self.picture("dome.bpt", "--hair=500"), self.picture("dome.bpt"))

    def test_errors(self):
        sphere = self.sphere
        self.assert_error(2, ["--isolines", "patch"], sphere, "--isolines=4", "--surface=pn")
        self.assert_error(2, ["--error", "surface patch"], sphere, "--error=1", "--surface=pn")
        for bad in ("0", "0.0009", "2e6", "nan", "few"):
            self.assert_error(2, ["--error", bad], "dome.bpt", f"--error={bad}")
        self.assert_error(2, ["--hair"], "dome.bpt", "--hair=0")
        self.assert_error(2, ["--feature-angle"], "dome.bpt", "--surface=patch", "--feature-angle=9")
        self.assert_error(1, ["unstructured grid"], sphere, "--patch-edges", "--output=o.png")
        (self.folder / "short.bpt").write_text(DOME[:-4])
        self.assert_error(1, ["short.bpt", "line"], "short.bpt", "--output=o.png")
        (self.folder / "wild.bpt").write_text("\x1b]0;x\x07" + DOME)
        self.assert_error(1, [r"wild.bpt, line 1: '\x1b]0;x\x071'"], "wild.bpt", "--output=o.png")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerPatches"])
