# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on relevo-view --volume: arrays, transfer functions, settings, and errors."""

import math
import os
import pathlib
import unittest
from importlib.util import find_spec

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUADRATIC_HEXAHEDRON,
    VTK_TETRA,
    VTK_TRIANGLE,
    vtkCellArray,
    vtkGenericCell,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from ViewerPictures import read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import CUBES, make_array, make_cube, write_cube, write_sphere

DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent")
PIECES = """<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">
<PPointData Scalars="Left"><PDataArray type="Float64" Name="Left"/></PPointData>
<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>
<Piece Source="cube.vtu"/></PUnstructuredGrid></VTKFile>
"""
# Faces the cube with x to the left: the camera is at -z.
FRONT = ("--view=0,0", "--size=120x90", "--no-legend")


def write(folder, name, grid, writer):
    writer.SetFileName(str(folder / name))
    writer.SetInputData(grid)
    writer.Write()
    return folder / name


class TestViewerVolume(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.grid = make_cube()
        cls.file = write_cube(cls.folder)
        write(cls.folder, "cube.vtk", cls.grid, vtkUnstructuredGridWriter())
        (cls.folder / "cube.pvtu").write_text(PIECES)
        cls.sphere = write_sphere(cls.folder)

    def picture(self, *arguments, file=None):
        self.view(file or self.file, "--output=v.png", *FRONT, *arguments)
        return read_picture(self.folder / "v.png")

    def transfer(self, text):
        (self.folder / "t.txt").write_text(text)
        return "--transfer=t.txt"

    def test_transfer_and_unit_distance(self):
        """For a constant, the share of light that passes the cube is exp(-opacity * side / unit
        distance)."""
        empty = self.picture("--volume", "Flat", self.transfer("0 1 0 0 0\n9 1 0 0 0\n"))
        red = "# as it is\n0 1 0 0 0.5 # dark\n\n9\t1 0 0 0.5\n"
        for distance in (0.5, 2.0):
            drawn = self.picture(
                "--volume", "Flat", self.transfer(red), f"--unit-distance={distance}"
            )
            # The central ray follows z through one side's length or slightly more.
            passed = math.exp(-0.5 / distance)
            behind, seen = empty[45][60], drawn[45][60]
            self.assertAlmostEqual(seen[1], passed * behind[1], delta=2)
            self.assertAlmostEqual(seen[0], passed * behind[0] + 255 * (1 - passed), delta=2)
        # By default a side has as many unit distances as cells.
        drawn = self.picture("--volume", "Flat", self.transfer(red))
        passed = math.exp(-0.5 * (6 * CUBES**3) ** (1 / 3) / math.sqrt(3))
        self.assertAlmostEqual(drawn[45][60][1], passed * behind[1], delta=2)

    def test_arrays(self):
        """Active scalars, named arrays, cell data and vectors by length, before and after FILE."""
        step = self.transfer("0.499 1 0 0 0\n0.501 1 0 0 1\n")
        left = self.picture("--volume", step, "--unit-distance=0.02")
        self.assertLess(left[45][45][1], 10)
        self.assertGreater(left[45][75][1], 100)
        self.assertEqual(left, self.picture("--volume", "Left", step, "--unit-distance=0.02"))
        self.assertEqual(left, self.picture("--volume=Left", step, "--unit-distance=0.02"))
        self.view("--volume=Left", step, "--unit-distance=0.02", *FRONT, "--output=o.png", self.file)
        self.assertEqual(left, read_picture(self.folder / "o.png"))
        self.view("--volume", self.file, step, "--unit-distance=0.02", *FRONT, "--output=o.png")
        self.assertEqual(left, read_picture(self.folder / "o.png"))
        low = self.picture("--volume", "Low", step, "--unit-distance=0.02")
        self.assertLess(low[30][60][1], 10)
        self.assertGreater(low[60][60][1], 100)
        ring = self.picture("--volume", "Around", step, "--unit-distance=0.02")
        self.assertGreater(ring[45][60][1], 100)  # in the middle vectors are short
        self.assertLess(min(row[35][1] for row in ring[15:30]), 60)  # in a corner they are long

    def test_default_functions(self):
        """Every array gives a visible volume that is not completely opaque."""
        empty = self.picture("--volume", self.transfer("0 0 0 0 0\n1 0 0 0 0\n"))
        for name in ("Left", "Flat", "Around", "Spike", "Low"):
            drawn = self.picture("--volume", name)
            changes = sum(
                max(abs(a - b) for a, b in zip(drawn[j][i], empty[j][i])) > 8
                for j in range(90)
                for i in range(120)
            )
            self.assertGreater(changes, 800, name)

    def test_formats(self):
        pictures = [self.picture("--volume", file=self.folder / f"cube.{e}") for e in ("vtu", "vtk", "pvtu")]
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])
        # Without --volume, the surface is drawn.
        self.assertNotEqual(pictures[2], self.picture(file=self.folder / "cube.pvtu"))

    def write_block(self, name, heights):
        """Hexahedra over the unit square, with as many cells per side as layers."""
        grid = vtkUnstructuredGrid()
        grid.SetPoints(vtkPoints())
        size = 10
        values = []
        for z in heights:
            for j in range(size + 1):
                for i in range(size + 1):
                    grid.GetPoints().InsertNextPoint(i / size, j / size, z)
                    values.append((i / size,))
        up = (size + 1) ** 2
        for k in range(len(heights) - 1):
            for j in range(size):
                for i in range(size):
                    a = k * up + j * (size + 1) + i
                    low = (a, a + 1, a + size + 2, a + size + 1)
                    grid.InsertNextCell(VTK_HEXAHEDRON, 8, (*low, *(id + up for id in low)))
        grid.GetPointData().AddArray(make_array("X", values))
        return write(self.folder, name, grid, vtkXMLUnstructuredGridWriter())

    def test_opacity_fits_thickness(self):
        """A plate is as visible as a block, which is still translucent."""
        passed = {}
        for name, heights in (
            ("plate.vtu", (0.0, 0.025, 0.05)),
            ("sheet.vtu", (0.0, 0.005)),
            ("block.vtu", [0.1 * k for k in range(11)]),
        ):
            file = self.write_block(name, heights)
            arguments = ("--volume", "--view=180,89", "--up=z", "--no-legend", "--size=120x120")
            self.view(file, *arguments, "--output=f.png")
            nothing = self.transfer("0 0 0 0 0\n1 0 0 0 0\n")
            self.view(file, *arguments, "--output=e.png", nothing)
            seen, behind = (read_picture(self.folder / name)[60][60] for name in ("f.png", "e.png"))
            # The colour of medium values has little red.
            passed[name] = seen[0] / behind[0]
        for name, share in passed.items():
            self.assertLess(share, 0.5, name)
        self.assertGreater(passed["block.vtu"], 0.15)

    def test_statistics_and_legend(self):
        cells = self.statistic("drawn cells", self.file, "--volume")
        self.assertEqual(cells, 6 * CUBES**3)
        self.assertEqual(self.statistic("layers", self.file, "--volume"), 1)
        self.view(self.file, "--volume", "--output=l.png", "--size=300x300")
        with_legend = read_picture(self.folder / "l.png")
        self.view(self.file, "--volume", "--output=l.png", "--size=300x300", "--no-legend")
        self.assertNotEqual(with_legend, read_picture(self.folder / "l.png"))

    def test_tolerances_of_curved_cells(self):
        """Fine tolerances give the fitting picture, coarse ones another, and exact values theirs."""
        grid = vtkUnstructuredGrid()
        cell = vtkGenericCell.InstantiateCell(VTK_QUADRATIC_HEXAHEDRON)
        nodes = cell.GetParametricCoords()
        points = vtkPoints()
        positions = [nodes[3 * i : 3 * i + 3] for i in range(20)]
        for x, y, z in positions:
            points.InsertNextPoint(x + 0.8 * z * (1 - z), y, z)
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, range(20))
        grid.GetPointData().SetScalars(make_array("Bow", [((p[1] - 0.5) ** 2,) for p in positions]))
        curved = write(self.folder, "bow.vtu", grid, vtkXMLUnstructuredGridWriter())
        side = ("--view=90,0", self.transfer("0 1 0 0 1\n0.25 0 0 1 1\n"), "--unit-distance=0.25")
        pictures = {}
        for options in ((), ("--shape-tolerance=1", "--field-tolerance=1"),
                        ("--shape-tolerance=1e-4",), ("--shape-tolerance=5e-4", "--field-tolerance=0.004")):
            pictures[options] = self.picture("--volume", "Bow", *side, *options, file=curved)
        default, coarse, fine, same = pictures.values()
        self.assertEqual(default, same)

        def count(one, other):
            return sum(
                max(abs(a - b) for a, b in zip(p, q)) > 8
                for rows in zip(one, other) for p, q in zip(*rows)
            )

        self.assertLess(count(default, fine), 40)
        self.assertGreater(count(default, coarse), 200)
        for text in ("0", "1e-7", "2", "x"):
            for option in ("--shape-tolerance", "--field-tolerance"):
                self.assert_error(2, [option], curved, "--volume", f"{option}={text}", "--output=v.png")
        self.assert_error(
            2, ["--shape-tolerance requires --volume"], curved, "--shape-tolerance=0.1", "--output=v.png"
        )

    def test_methods_and_integration(self):
        """The methods compute the picture differently, but it is almost the same."""
        exact = self.picture("--volume")
        for settings in (
            ["--volume-method=ray", "--integration=exact"],
            ["--volume-method=projection"],
            ["--integration=pre"],
            ["--integration=pre2d"],
            ["--volume-method=projection", "--integration=pre"],
        ):
            drawn = self.picture("--volume", *settings)
            apart = sorted(
                max(abs(a - b) for a, b in zip(*colours))
                for rows in zip(exact, drawn)
                for colours in zip(*rows)
            )
            # Ignores the silhouette.
            most = apart[int(0.98 * len(apart))]
            self.assertLessEqual(most, 12 if "--integration=pre2d" in settings else 3, settings)
            self.assertEqual(drawn == exact, "--integration=exact" in settings, settings)

    def test_clip(self):
        """The part on the normal's side remains: x > 0.7, on the left."""
        red = self.transfer("0 1 0 0 1\n9 1 0 0 1\n")
        settings = ("--volume", "Flat", red, "--unit-distance=0.05")
        drawn = self.picture(*settings, "--clip=0.7,0,0,2,0,0")
        self.assertLess(drawn[45][35][1], 10)
        self.assertGreater(drawn[45][60][1], 100)
        turned = self.picture(*settings, "--clip", "0.7,0,0,-1,0,0")
        self.assertGreater(turned[45][35][1], 100)
        self.assertLess(turned[45][60][1], 10)

    def test_blend(self):
        """Blend modes along x, where the values, and so the reds, run from 0 to 1."""
        red = self.transfer("0 0 0 0 1\n1 1 0 0 1\n")
        for name, value in (("maximum", 1.0), ("minimum", 0.0), ("average", 0.5)):
            drawn = self.picture("--volume", red, "--blend", name, "--view=90,0")
            self.assertAlmostEqual(drawn[45][60][0], 255 * value, delta=3, msg=name)
            self.assertLess(drawn[45][60][1], 3, name)
        behind = self.picture("--volume", "Low", self.transfer("0 0 0 0 0\n1 0 0 0 0\n"))[45][60]
        faint = self.transfer("0 0.2 0 0 0.25\n9 0.2 0 0 0.25\n")
        added = self.picture("--volume", "Flat", faint, "--blend=additive", "--unit-distance=1")
        self.assertAlmostEqual(added[45][60][0], 0.75 * behind[0] + 0.05 * 255, delta=3)

    def test_isosurfaces(self):
        """Seen along x, isosurfaces are planes coloured by the transfer function, shaded or not."""
        clear = self.transfer("0 1 0 0 0\n0.249 1 0 0 0\n0.25 1 0 0 1\n0.251 1 0 0 0\n1 0 1 0 0\n")
        settings = ("--volume", clear, "--view=90,0", "--unit-distance=10")
        nothing = self.picture(*settings)
        drawn = self.picture(*settings, "--isosurfaces=0.25")
        self.assertLess(drawn[45][60][1], 60)
        self.assertGreater(drawn[45][60][0], 80)
        self.assertGreater(nothing[45][60][1], 100)
        self.assertEqual(nothing, self.picture(*settings, "--isosurfaces=0.5"))
        # Without a file and without values, isosurfaces are visible, too.
        solid = self.transfer("0 1 0 0 1\n1 1 0 0 1\n")
        alone = self.picture("--volume", solid, "--blend=isosurface", "--view=90,0")
        self.assertLess(alone[45][60][1], 60)
        default = self.picture("--volume", "--blend=isosurface", "--view=90,0")
        inside = self.picture("--volume", "--isosurfaces=0.5", "--view=90,0")
        for picture in (default, inside):
            changes = [abs(a - b) for a, b in zip(picture[45][60], nothing[45][60])]
            self.assertGreater(max(changes), 60)

    def test_bad_transfer_files(self):
        for text, *words in (
            ("0 1 0 0 1\n1 1 0 0\n", "line 2", "4 numbers", "5"),
            ("0 1 0 red 1\n", "line 1", "'red'"),
            ("# nan\n\nnan 1 0 0 1\n", "line 3", "'nan'"),
            ("0 1 0 0 1\n1 1 0 2 1\n", "line 2", "colours"),
            ("0 1 0 0 -1\n", "line 1", "opacities"),
            ("2 1 0 0 1\n# and\n2 1 0 0 0\n", "line 3", "must be greater"),
            ("# nothing\n", "value red green blue opacity"),
        ):
            option = self.transfer(text)
            self.assert_error(1, ["t.txt", *words], self.file, "--volume", option, "--output=n.png")
        self.assert_error(
            1, ["no.txt", "does not exist"], self.file, "--volume", "--transfer=no.txt", "--output=n.png"
        )
        self.assertFalse((self.folder / "n.png").exists())

    def test_bad_input(self):
        out = "--output=n.png"
        every = "'Flat', 'Left', 'Around', 'Spike', 'Low'"
        self.assert_error(1, ["'Wind'", every], self.file, "--volume", "Wind", out)
        self.assert_error(1, ["sphere.vtp", ".vtu"], self.sphere, "--volume", out)
        bare = vtkUnstructuredGrid()
        bare.CopyStructure(self.grid)
        write(self.folder, "bare.vtu", bare, vtkXMLUnstructuredGridWriter())
        self.assert_error(1, ["bare.vtu", "no array"], "bare.vtu", "--volume", out)
        bare.SetCells(VTK_TETRA, vtkCellArray())
        write(self.folder, "empty.vtu", bare, vtkXMLUnstructuredGridWriter())
        self.assert_error(1, ["empty.vtu", "no cells"], "empty.vtu", "--volume", out)
        self.assert_error(1, ["none.vtu"], "none.vtu", "--volume", out)
        self.assertFalse((self.folder / "n.png").exists())

    def test_cells_that_are_not_drawn(self):
        """A triangle beside the tetrahedra does not extend the range. Alone it is an error."""
        plain = make_cube()
        outlier = make_cube()
        outlier.InsertNextCell(VTK_TRIANGLE, 3, (0, 1, 6))
        for value, grid, name in ((0.0, plain, "plain.vtu"), (1e6, outlier, "outlier.vtu")):
            if value:
                grid.GetCellData().GetArray("Low").InsertNextValue(value)
            write(self.folder, name, grid, vtkXMLUnstructuredGridWriter())
        pictures = [self.picture("--volume=Low", file=f"{name}.vtu") for name in ("plain", "outlier")]
        for rows in zip(*pictures):
            for plain_colour, colour in zip(*rows):
                self.assertLess(max(abs(a - b) for a, b in zip(plain_colour, colour)), 10)
        flat = vtkUnstructuredGrid()
        flat.SetPoints(plain.GetPoints())
        flat.InsertNextCell(VTK_TRIANGLE, 3, (0, 1, 6))
        write(self.folder, "flat.vtu", flat, vtkXMLUnstructuredGridWriter())
        words = "flat.vtu has no 3D cells", "omit --volume"
        self.assert_error(1, words, "flat.vtu", "--volume", "--output=n.png")

    def test_bad_usage(self):
        for words, *arguments in (
            (["--transfer", "--volume"], "--transfer=t.txt"),
            (["--unit-distance", "'0'"], "--volume", "--unit-distance=0"),
            (["--unit-distance", "'nan'"], "--volume", "--unit-distance=nan"),
            (["--clip", "X,Y,Z,NX,NY,NZ", "'1,2,3'"], "--volume", "--clip=1,2,3"),
            (["--clip", "0,0,0", "normal"], "--volume", "--clip=1,2,3,0,0,0"),
            (["--blend", "isosurface", "'mean'"], "--volume", "--blend=mean"),
            (["--isosurfaces", "'a'"], "--volume", "--isosurfaces=1,a"),
            (["--isosurfaces", "number"], "--volume", "--isosurfaces="),
            (["--isosurfaces", "--blend"], "--volume", "--isosurfaces=1", "--blend=maximum"),
            (["--unit-distance", "--blend"], "--volume", "--unit-distance=1", "--blend=average"),
            (["--transfer", "file"], "--volume", "--transfer="),
            (["--volume-method", "projection", "'sort'"], "--volume", "--volume-method=sort"),
            (["--integration", "pre2d", "'fast'"], "--volume", "--integration=fast"),
            (["--integration", "--volume"], "--integration=pre"),
            (["--level", "--volume"], "--volume", "--level=2"),
            (["--array", "--volume"], "--volume", "--array=Left"),
            (["--export", "--volume"], "--volume", "--export=n.vtp"),
            (["more than one", "'Wind'"], "--volume", "Left", "Wind"),
        ):
            self.assert_error(2, words, self.file, *arguments)
        self.assert_error(2, ["--volume requires a mesh"], "heights.tif", "--volume")

    def test_real_meshes(self):
        if not DATA.exists():
            self.skipTest("no RELEVO_TEST_DATA")
        for file, name in (
            ("volume/post.vtk", "Pressure"),
            ("volume/CylinderLinear.vtk", "velocity"),
            ("volume/can.vtu", "EQPS"),
            ("flow/disk_out_ref.ex2", "Temp"),
            ("flow/office.binary.vtk", "scalars"),
        ):
            if file.endswith(".ex2") and not find_spec("vtkmodules.vtkIOExodus"):
                continue
            drawn = self.picture("--volume", name, file=DATA / file)
            colours = {colour for row in drawn[20:70] for colour in row[30:90]}
            self.assertGreater(len(colours), 200, file)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerVolume"])
