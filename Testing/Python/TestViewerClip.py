# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on cuts through meshes: --clip fills them, with values and edges of cells."""

import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUADRATIC_HEXAHEDRON,
    vtkGenericCell,
    vtkImageData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)

from ResultData import CORNERS
from ViewerPictures import read_colours
from ViewerProgram import ViewerProgram

CELLS = 4
SIZE = 200
SETTINGS = ("--no-legend", f"--size={SIZE}x{SIZE}", "--output=p.png")


class TestViewerClip(ViewerProgram):
    def picture(self, *arguments):
        """Rows from the top, of colours from 0 to 255."""
        self.view(*arguments, *SETTINGS)
        return read_colours(self.folder / "p.png")

    def write_cube(self):
        """A cube of 4 x 4 x 4 cells. "Middle" is 1 half-way along x and 0 at both ends."""
        image = vtkImageData()
        image.SetDimensions(CELLS + 1, CELLS + 1, CELLS + 1)
        array = vtkDoubleArray()
        array.SetName("Middle")
        for i in range(image.GetNumberOfPoints()):
            array.InsertNextValue(1.0 - abs(image.GetPoint(i)[0] - 0.5 * CELLS) / (0.5 * CELLS))
        image.GetPointData().AddArray(array)
        self.write_data("cube.vti", vtkXMLImageDataWriter, image)

    def test_values(self):
        """The section has the value inside of the mesh; each cell has a border."""
        self.write_cube()
        arguments = ("cube.vti", "--array=Middle", "--view=90,0")
        whole = self.picture(*arguments)
        cut = self.picture(*arguments, "--clip=1.9999,0,0,-1,0,0")
        # The middles of the cells of a front face, between the edges.
        cells = [(SIZE * (2 * i + 1) // 8, SIZE * (2 * j + 1) // 8) for i in (1, 2) for j in (1, 2)]
        for row, column in cells:
            red, green, blue = whole[row, column]
            self.assertLess(green, blue)  # violet
            red, green, blue = cut[row, column]
            self.assertGreater(min(red, green), 2 * blue)  # yellow
        # The edges between them.
        middle = cut[SIZE // 4 : 3 * SIZE // 4, SIZE * 3 // 8].sum(axis=1)
        self.assertLess(middle.min(), 0.8 * middle.max())
        # The other half is hollow from this side, so that its back is visible.
        turned = self.picture(*arguments, "--clip=1.9999,0,0,1,0,0")
        self.assertFalse((turned == cut).all())

    def test_curved_cells(self):
        """The section of a bent cell has its outline: an arch, not a roof."""
        cell = vtkGenericCell.InstantiateCell(VTK_QUADRATIC_HEXAHEDRON)
        nodes = cell.GetParametricCoords()
        points = vtkPoints()
        for i in range(20):
            x, y, z = nodes[3 * i : 3 * i + 3]
            points.InsertNextPoint(x, y + 3.2 * x * (1.0 - x), z)
        grid = vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, range(20))
        self.write_data("arch.vtu", vtkXMLUnstructuredGridWriter, grid)
        arguments = ("arch.vtu", "--view=180,0", "--zoom=0.8")
        whole = self.picture(*arguments)
        cut = self.picture(*arguments, "--clip=0,0,0.99,0,0,-1")
        # Both outlines are the same except for the perspective.
        background = whole[0, 0]
        inside = [abs(p - background).sum(axis=2) > 60 for p in (whole, cut)]
        areas = [mask.sum() for mask in inside]
        self.assertGreater(areas[1], 0.97 * areas[0])
        self.assertLess(areas[1], 1.005 * areas[0])

    def test_discontinuous_values(self):
        """Cells that do not share points keep their values, on the surface and in a cut."""
        points, grid = vtkPoints(), vtkUnstructuredGrid()
        values = vtkDoubleArray()
        values.SetName("Value")
        for cell in range(2):
            for x, y, z in CORNERS:
                points.InsertNextPoint(x + cell, y, z)
                values.InsertNextValue(cell)
        grid.SetPoints(points)
        for cell in range(2):
            grid.InsertNextCell(VTK_HEXAHEDRON, 8, range(8 * cell, 8 * cell + 8))
        grid.GetPointData().AddArray(values)
        self.write_data("jump.vtu", vtkXMLUnstructuredGridWriter, grid)
        for options in ((), ("--clip=0,0,0.5,0,0,-1",)):
            drawn = self.picture("jump.vtu", "--array=Value", "--palette=grey", "--view=front", *options)
            left, right = (drawn[SIZE // 2, SIZE // 2 + side] for side in (-4, 4))
            # Each half has one colour, with a jump between them.
            self.assertLess(left.max(), 60)
            self.assertGreater(right.min(), 150)

    def test_hollow(self):
        sphere = vtkSphereSource()
        sphere.Update()
        self.write_data("sphere.vtp", vtkXMLPolyDataWriter, sphere.GetOutput())
        run = self.run_program("sphere.vtp", "--clip=0,0,0,0,1,0", *SETTINGS)
        self.assertEqual(run.returncode, 0)
        self.assertIn("sphere.vtp has no 3D cells, so the cut is hollow", run.stderr)

    def test_nothing_left(self):
        self.write_cube()
        for options in (["--array=Middle"], ["--volume=Middle"]):
            run = self.run_program("cube.vti", "--clip=0,9,0,0,1,0", *options, *SETTINGS)
            self.assertEqual(run.returncode, 0)
            self.assertIn("--clip 0,9,0,0,1,0 leaves nothing", run.stderr)

    def test_bad_usage(self):
        self.write_cube()
        for words, *arguments in (
            (["--clip", "X,Y,Z,NX,NY,NZ", "'1,2,3'"], "--clip=1,2,3"),
            (["--clip", "normal"], "--clip=1,2,3,0,0,0"),
            (["--clip", "--export"], "--clip=0,0,0,1,0,0", "--export=e.vtp"),
            (["--clip", "--height"], "--clip=0,0,0,1,0,0", "--height=h.png"),
            (["--clip", "--relief"], "--clip=0,0,0,1,0,0", "--relief=box", "--output=p.png"),
        ):
            self.assert_error(2, words, "cube.vti", *arguments)
        self.assert_error(2, ["--clip", "mesh"], "dem.tif", "--clip=0,0,0,1,0,0")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerClip"])
