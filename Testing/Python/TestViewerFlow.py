# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on relevo-view --lic: streaks along point and cell vectors, settings, and
errors."""

import math
import os
import pathlib
import unittest
from importlib.util import find_spec

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from ViewerProgram import ViewerProgram

FLOW = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent", "flow")
CELLS = 8
# Faces the plane so that the picture's centre lies in it. Only the streaks are visible.
FRONT = ("--view=180,0", "--size=200x150")
GREY = (*FRONT, "--lic-intensity=1")


def make_array(name, values):
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(values[0]))
    for value in values:
        array.InsertNextTuple(value)
    return array


class TestViewerFlow(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        """A plane with vectors along x and y as point and cell data, and a vortex."""
        super().setUpClass()
        plane = vtkPolyData()
        plane.SetPoints(vtkPoints())
        plane.SetPolys(vtkCellArray())
        for j in range(CELLS + 1):
            for i in range(CELLS + 1):
                plane.GetPoints().InsertNextPoint(i / CELLS - 0.5, j / CELLS - 0.5, 0)
        for j in range(CELLS):
            for i in range(CELLS):
                a = j * (CELLS + 1) + i
                b = a + CELLS + 1
                plane.GetPolys().InsertNextCell(3, (a, a + 1, b + 1))
                plane.GetPolys().InsertNextCell(3, (a, b + 1, b))
        points = [plane.GetPoint(i) for i in range(plane.GetNumberOfPoints())]
        of_points = plane.GetPointData()
        of_points.AddArray(make_array("East", [(2, 0, 0)] * len(points)))
        of_points.AddArray(make_array("Flat", [(0, 3)] * len(points)))
        of_points.AddArray(make_array("Vortex", [(-y, x, 0) for x, y, _ in points]))
        of_points.AddArray(make_array("Marked", [
            (2, 0, 0) if x < 0.1 else (-1e9, -1e9, -1e9) for x, _, _ in points]))
        of_points.AddArray(make_array("Faint", [
            (2, 0, 0) if x < 0.1 else (0, 3e-19, 0) for x, _, _ in points]))
        of_points.AddArray(make_array("Height", [(x,) for x, _, _ in points]))
        plane.GetCellData().AddArray(make_array("North", [(0, 1, 0)] * 2 * CELLS**2))
        of_points.SetNormals(make_array("Normals", [(0, 0, 1)] * len(points)))
        writer = vtkXMLPolyDataWriter()
        cls.file = cls.folder / "plane.vtp"
        writer.SetFileName(str(cls.file))
        writer.SetInputData(plane)
        writer.Write()

    def pixels(self, *arguments, file=None, part=(60, 140, 35, 115)):
        """The green component of a part of the picture, row by row."""
        self.view(file or self.file, "--output=flow.png", *arguments)
        reader = vtkPNGReader()
        reader.SetFileName(str(self.folder / "flow.png"))
        reader.Update()
        image = reader.GetOutput()
        left, right, low, high = part
        return [
            [image.GetScalarComponentAsFloat(i, j, 0, 1) for i in range(left, right)]
            for j in range(low, high)
        ]

    def spread(self, rows):
        """Mean and standard deviation."""
        values = [value for row in rows for value in row]
        mean = sum(values) / len(values)
        return mean, math.sqrt(sum((value - mean) ** 2 for value in values) / len(values))

    def likeness(self, rows, dx, dy):
        """The correlation of the pixels with those shifted by dx and dy."""
        mean, deviation = self.spread(rows)
        products = [
            (rows[j][i] - mean) * (rows[j + dy][i + dx] - mean)
            for j in range(len(rows) - dy)
            for i in range(len(rows[0]) - dx)
        ]
        return sum(products) / len(products) / deviation**2

    def test_directions(self):
        """Pixels along the vectors are similar, others are not, for point data, cell data and two
        components."""
        for name, along, across in (
            ("East", (4, 0), (0, 4)),
            ("North", (0, 4), (4, 0)),
            ("Flat", (0, 4), (4, 0)),
        ):
            rows = self.pixels(*GREY, "--lic", name)
            self.assertGreater(self.spread(rows)[1], 10, name)
            self.assertGreater(self.likeness(rows, *along), 0.6, name)
            self.assertLess(self.likeness(rows, *across), 0.3, name)

    def test_steps(self):
        """More or longer steps give longer streaks."""
        likeness = [
            self.likeness(self.pixels(*GREY, "--lic=East", *settings), 10, 0)
            for settings in (("--lic-steps=3",), ("--lic-steps=20",), ("--lic-steps=3", "--lic-step-size=5"))
        ]
        self.assertGreater(likeness[1], likeness[0] + 0.2)
        self.assertGreater(likeness[2], likeness[0] + 0.1)

    def test_phase(self):
        still, loop, half = (
            self.pixels(*GREY, "--lic=East", f"--lic-phase={phase}") for phase in (0, 1, 0.5)
        )
        self.assertEqual(still, loop)
        self.assertNotEqual(still, half)

    def test_contrast(self):
        deviations = [
            self.spread(self.pixels(*GREY, "--lic=East", f"--lic-contrast={contrast}"))[1]
            for contrast in ("off", "lic", "color", "both")
        ]
        self.assertGreater(deviations[1], 1.1 * deviations[0])
        self.assertGreater(deviations[2], 1.1 * deviations[0])
        self.assertGreater(deviations[3], 1.1 * deviations[0])

    def test_colours(self):
        """Colours follow the vectors' lengths unless another array is named; both colour modes
        work."""
        plain = self.spread(self.pixels(*FRONT, "--array=East"))
        none = self.spread(self.pixels(*FRONT, "--lic=East", "--lic-intensity=0"))
        self.assertAlmostEqual(none[0], plain[0], delta=1)
        self.assertAlmostEqual(none[1], plain[1], delta=1)
        half = self.spread(self.pixels(*FRONT, "--lic=East", "--lic-intensity=0.5"))
        full = self.spread(self.pixels(*FRONT, "--lic=East", "--lic-intensity=1"))
        self.assertGreater(full[1], 1.5 * half[1])
        height = self.pixels(*FRONT, "--lic=East", "--lic-mode=multiply", "--array=Height")
        vortex = self.pixels(*FRONT, "--lic=Vortex", "--lic-mode=multiply")
        for rows, left_is_dark in ((height, True), (vortex, False)):
            left = self.spread([row[:20] for row in rows])[0]
            middle = self.spread([row[30:50] for row in rows[30:50]])[0]
            self.assertEqual(left < middle, left_is_dark)

    def test_no_data(self):
        """Missing and very short vectors give neither streaks nor noise."""
        for name in ("Marked", "Faint"):
            rows = self.pixels(*GREY, "--lic", name)
            self.assertGreater(self.spread([row[:30] for row in rows])[1], 10, name)
            marked = self.pixels(*GREY, "--lic", name, part=(128, 140, 35, 115))
            self.assertLess(self.spread(marked)[1], 3, name)

    def test_levels_follow_the_field(self):
        count = {
            name: self.statistic("drawn triangles", self.file, "--lic", name, "--max-level=5", *settings)
            for name, *settings in (("East",), ("Vortex",), ("North",))
        }
        self.assertGreater(count["Vortex"], 2 * count["East"])
        self.assertEqual(count["East"], count["North"])
        fine = self.statistic("drawn triangles", self.file, "--lic=East", "--pixels=3")
        self.assertGreater(fine, 2 * count["East"])
        for metric in ("curvature", "screen-edge", "field"):
            self.view(self.file, "--lic=North", "--metric", metric, "--output=m.png", "--size=60x40")

    def test_bad_arrays(self):
        out = "--output=never.png"
        every = ["'East', 'Flat', 'Vortex', 'Marked', 'Faint', 'North'"]
        self.assert_error(1, ["'Wind'", *every], self.file, "--lic=Wind", out)
        self.assert_error(1, ["'Height'", "1 component", *every], self.file, "--lic", "Height", out)
        (self.folder / "bare.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assert_error(1, ["'Wind'", "no arrays of 2 or 3 components"], "bare.obj", "--lic=Wind", out)
        self.assertFalse((self.folder / "never.png").exists())

    def test_bad_usage(self):
        for words, *arguments in (
            (["--lic-steps", "'0'"], "--lic=East", "--lic-steps=0"),
            (["--lic-steps", "'2.5'"], "--lic=East", "--lic-steps=2.5"),
            (["--lic-step-size", "'0'"], "--lic=East", "--lic-step-size=0"),
            (["--lic-step-size", "'nan'"], "--lic=East", "--lic-step-size=nan"),
            (["--lic-intensity", "'1.5'"], "--lic=East", "--lic-intensity=1.5"),
            (["--lic-intensity", "blend"], "--lic=East", "--lic-mode=multiply", "--lic-intensity=1"),
            (["--lic-phase", "'a'"], "--lic=East", "--lic-phase=a"),
            (["--lic-contrast", "both", "'on'"], "--lic=East", "--lic-contrast=on"),
            (["--lic-mode", "multiply", "'add'"], "--lic=East", "--lic-mode=add"),
            (["--lic-steps", "--lic"], "--lic-steps=5"),
            (["--lic", "array"], "--lic="),
        ):
            self.assert_error(2, words, self.file, *arguments)
        self.assert_error(2, ["--lic requires a mesh"], "heights.tif", "--lic=East")

    def test_real_meshes(self):
        if not FLOW.exists():
            self.skipTest("no flow in RELEVO_TEST_DATA")
        for file, name in (
            ("SurfaceVectors.vtk", "V"),
            ("disk_out_ref_surface.vtp", "V"),
            ("disk_out_ref.ex2", "V"),
            ("office.binary.vtk", "vectors"),
        ):
            if file.endswith(".ex2") and not find_spec("vtkmodules.vtkIOExodus"):
                continue
            rows = self.pixels(*FRONT, "--lic", name, file=FLOW / file, part=(0, 200, 0, 150))
            self.assertGreater(self.spread(rows)[1], 5, file)
        self.assert_error(1, ["'V'"], FLOW / "SurfaceVectors.vtk", "--lic=Temp", "--output=n.png")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerFlow"])
