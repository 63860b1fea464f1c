# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on values at integration points: spheres, and averages of cells."""

import math
import sys
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

from vtkmodules.vtkCommonDataModel import (
    VTK_QUAD, vtkImageData, vtkQuadratureSchemeDefinition, vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersGeneral import (
    vtkDataSetTriangleFilter, vtkQuadratureSchemeDictionaryGenerator,
)
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridWriter

from ResultData import add_array
from ViewerPictures import read_colours
from ViewerProgram import ViewerProgram

SIZE = 200
SETTINGS = (f"--size={SIZE}x{SIZE}", "--no-legend", "--view=front", "--palette=grey")


def make_square():
    """A quadrilateral of side 1 with a value for each of 4 integration points, and 5 numbers."""
    points = vtkPoints()
    for corner in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)):
        points.InsertNextPoint(corner)
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_QUAD, 4, (0, 1, 2, 3))
    add_array(grid.GetCellData(), "V", [(0.0, 1.0, 2.0, 3.0)])
    add_array(grid.GetCellData(), "Five", [(0.0, 1.0, 2.0, 3.0, 4.0)])
    return grid


def make_tetrahedra():
    """Tetrahedra with tensors at 4 integration points, in VTK's field data."""
    image = vtkImageData()
    image.SetDimensions(3, 2, 2)
    numbers = [(float(i),) for i in range(image.GetNumberOfPoints())]
    add_array(image.GetPointData(), "Height", numbers)  # VTK's filter needs an array
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(image)
    scheme = vtkQuadratureSchemeDictionaryGenerator()
    scheme.SetInputConnection(divide.GetOutputPort())
    scheme.Update()
    grid = scheme.GetOutput()
    add_array(grid.GetCellData(), "Number", [(float(i),) for i in range(grid.GetNumberOfCells())])
    # The mean in cell i is a uniaxial stress i + 1.
    tensors = [
        (cell + 1.0 + delta, 0.0, 0.0, 0.0, 0.0, 0.0)
        for cell in range(grid.GetNumberOfCells())
        for delta in (-0.5, 0.5, -0.25, 0.25)
    ]
    add_array(grid.GetFieldData(), "Stress", tensors)
    key = vtkQuadratureSchemeDefinition.QUADRATURE_OFFSET_ARRAY_NAME()
    grid.GetFieldData().GetArray("Stress").GetInformation().Set(key, "QuadratureOffset")
    return grid


class TestViewerIntegrationPoints(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write_data("square.vtu", vtkXMLUnstructuredGridWriter, make_square())
        cls.write_data("solid.vtu", vtkXMLUnstructuredGridWriter, make_tetrahedra())

    def picture(self, *arguments, warns=False):
        run = self.run_program(*arguments, *SETTINGS, "--output=p.png")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(bool(run.stderr), warns, run.stderr)
        return read_colours(self.folder / "p.png")

    def find_spheres(self, picture, plain):
        """The middle and the brightness of each quarter that differs from a picture without
        spheres: lower left, lower right, upper left, upper right."""
        square = (plain != plain[0, 0]).any(axis=2)
        rows, columns = square.nonzero()
        top, left, side = rows.min(), columns.min(), columns.max() + 1 - columns.min()
        different = abs(picture - plain).max(axis=2) > 12
        spheres = []
        for row in (1, 0):
            for column in (0, 1):
                y, x = top + row * side // 2, left + column * side // 2
                part = different[y : y + side // 2, x : x + side // 2]
                if part.any():
                    inside = part.nonzero()
                    middle = [(i.mean() + 0.5 + start) / side
                              for i, start in zip(inside, (y - top, x - left))]
                    colours = picture[y : y + side // 2, x : x + side // 2][part]
                    spheres.append((middle[1], 1.0 - middle[0], float(numpy.median(colours))))
        return spheres

    def test_spheres(self):
        """Spheres are at the points of the rule, in its order, with their colours."""
        range_of_all = "--range=-1,4"
        plain = self.picture("square.vtu", "--array=mean of V", range_of_all)
        spheres = self.find_spheres(
            self.picture("square.vtu", "--integration-points=V", range_of_all), plain
        )
        self.assertEqual(len(spheres), 4)
        near, far = 0.5 - 0.5 / math.sqrt(3), 0.5 + 0.5 / math.sqrt(3)
        for sphere, place in zip(spheres, ((near, near), (far, near), (near, far), (far, far))):
            self.assertAlmostEqual(sphere[0], place[0], delta=0.04)
            self.assertAlmostEqual(sphere[1], place[1], delta=0.04)
        shades = [sphere[2] for sphere in spheres]
        self.assertEqual(shades, sorted(shades))
        self.assertGreater(min(b - a for a, b in zip(shades, shades[1:])), 10)

        # A cut removes the spheres behind it. Without 3D cells, it warns that it is hollow.
        cut = self.picture(
            "square.vtu", "--integration-points=V", range_of_all, "--clip=0.5,0,0,1,0,0", warns=True
        )
        other = self.picture(
            "square.vtu", "--array=mean of V", range_of_all, "--clip=0.5,0,0,1,0,0", warns=True
        )
        rows, columns = (abs(cut - other).max(axis=2) > 12).nonzero()
        self.assertGreater(len(rows), 20)
        self.assertGreater(columns.min(), SIZE // 2)

    def read_values(self, name, *arguments):
        self.view(*arguments, "--export=e.vtp", "--surface=linear", "--level=0")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "e.vtp"))
        reader.Update()
        data = reader.GetOutput().GetCellData()
        values = data.GetArray(name)
        numbers = data.GetArray("Number") or values
        return {numbers.GetValue(i): values.GetValue(i) for i in range(values.GetNumberOfTuples())}

    def test_averages(self):
        """Arrays at integration points are averaged in each cell, and quantities are of averages."""
        self.assertEqual(
            self.read_values("mean of V", "square.vtu", "--array=mean of V"), {1.5: 1.5}
        )
        values = self.read_values("von Mises of Stress", "solid.vtu", "--array=von Mises of Stress")
        self.assertGreater(len(values), 5)
        for cell, value in values.items():
            self.assertAlmostEqual(value, cell + 1.0)
        run = self.view("solid.vtu", "--array=xx of Stress", "--output=p.png", "--size=160x120")
        self.assertIn("colours show the averages of cells; --integration-points", run.stdout)
        run = self.view("solid.vtu", "--volume=xx of Stress", "--output=p.png", "--size=160x120")

    def test_quantities(self):
        """Quantities are computed at each point. The colours cover their values."""
        solid = ("solid.vtu", "--integration-points=von Mises of Stress")
        colours = self.picture(*solid)
        self.assertTrue((colours == self.picture(*solid, "--range=0.5,10.5")).all())
        self.assertFalse((colours == self.picture(*solid, "--range=1,10")).all())

    def test_errors(self):
        for words, *arguments in (
            (["no array 'None'"], "square.vtu", "--integration-points=None"),
            (["'Five' has no integration points", "vtkQuad"], "square.vtu",
             "--integration-points=Five"),
        ):
            self.assert_error(1, words, *arguments, "--output=n.png")
        for words, *arguments in (
            (["--array cannot be combined with --integration-points"], "--array=V"),
            (["--integration-points cannot be combined with --volume"], "--volume"),
        ):
            run = self.view(
                "square.vtu", "--integration-points=V", *arguments, "--output=n.png", code=2
            )
            for word in words:
                self.assertIn(word, run.stderr)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerIntegrationPoints"])
