# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves python.md on streamlines: relevo.streamlines(), with the pictures of relevo-view."""

import math
import os
import pathlib
import subprocess
import tempfile
import unittest
import unittest.mock
import warnings

from DrawingData import make_block, make_sphere, numpy, read_picture, relevo
from ResultData import add_array, make_cube
from relevo import _drawing
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

SIZE = (320, 200)
VIEWER = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin/relevo-view"


def make_image():
    """A cube from -4 to 4 with vectors "Turn" around the z axis, "Still", which is 0, and "Heat"."""
    image = vtkImageData()
    image.SetOrigin(-4, -4, -4)
    image.SetDimensions(9, 9, 9)
    points = [image.GetPoint(i) for i in range(image.GetNumberOfPoints())]
    add_array(image.GetPointData(), "Heat", [(x,) for x, y, z in points])
    add_array(image.GetPointData(), "Turn", [(-y, x, 0) for x, y, z in points])
    add_array(image.GetPointData(), "Still", [(0, 0, 0)] * len(points))
    return image


def average_in_cells(data):
    convert = vtkPointDataToCellData()
    convert.SetInputData(data)
    convert.Update()
    return convert.GetOutput()


def get_points(lines):
    return vtk_to_numpy(lines.GetPoints().GetData())


class TestDrawingStreamlines(unittest.TestCase):
    def test_circles(self):
        """Lines are circles around the axis, for vectors of points and of cells."""
        image = make_image()
        line = ((2.5, 0, 0), (2.5, 0, 0))
        for data in (image, average_in_cells(image)):
            drawing = relevo.streamlines(data, "Turn", seeds=1, seed_line=line)
            points = get_points(drawing.lines)
            radii = numpy.hypot(points[:, 0], points[:, 1])
            numpy.testing.assert_allclose(radii, 2.5, atol=0.06)
            numpy.testing.assert_allclose(points[:, 2], 0, atol=1e-6)
            self.assertEqual(drawing.lines.GetNumberOfLines(), 2)  # forward and backward
            angles = numpy.arctan2(points[:, 1], points[:, 0])
            self.assertGreater(numpy.ptp(angles), 6)
            self.assertEqual(drawing.mesh().GetNumberOfPoints(), len(points))
            self.assertAlmostEqual(drawing._table.GetRange()[0], 0 if data is image else math.hypot(0.5, 0.5))

    def test_defaults(self):
        """Lines begin in the middles of cells, along the first vectors, coloured by their lengths."""
        drawing = relevo.streamlines(make_image())
        self.assertEqual(drawing._vectors, "Turn")
        self.assertEqual(drawing._title, "Turn (magnitude)")
        self.assertAlmostEqual(drawing._table.GetRange()[1], math.hypot(4, 4))
        self.assertRegex(repr(drawing), r"^<relevo.streamlines: 1\d\d lines along 'Turn', Turn")
        self.assertEqual(drawing.actor.GetProperty().GetOpacity(), 0.15)
        self.assertEqual(len(drawing.actors), 2)
        starts = vtk_to_numpy(drawing.tracer.GetInputDataObject(1, 0).GetPoints().GetData())
        self.assertEqual(len(starts), 100)
        numpy.testing.assert_array_equal(starts % 1, 0.5)
        image = make_image()
        image.GetPointData().SetActiveVectors("Still")
        with self.assertWarnsRegex(UserWarning, "no seed is where 'Still' has a direction"):
            relevo.streamlines(image)

    def test_scalars(self):
        """Lines and surface have the colours of an array, which may be one of cells, or a quantity."""
        image = make_image()
        pictures = []
        for data, scalars, title in (
            (image, "Heat", "Heat"), (average_in_cells(image), "Heat", "Heat"), (image, "x of Turn", "x of Turn"),
        ):
            drawing = relevo.streamlines(data, "Turn", scalars=scalars, seeds=20)
            self.assertEqual(drawing._title, title)
            pictures.append(drawing.screenshot(size=SIZE).astype(int))
        for other in pictures[1:]:
            self.assertGreater((abs(pictures[0] - other).max(axis=2) > 20).sum(), 200)

    def test_surfaces(self):
        """On a surface, lines stay on it, and it is opaque."""
        drawing = relevo.streamlines(make_sphere(24), "V")
        radii = numpy.linalg.norm(get_points(drawing.lines), axis=1)
        self.assertTrue(0.48 < radii.min() and radii.max() < 0.51)
        self.assertEqual(drawing.actor.GetProperty().GetOpacity(), 1)

    def test_blocks(self):
        """Lines run through all blocks that have the vectors, and begin in 3D cells."""
        blocks = vtkMultiBlockDataSet()
        for i in range(2):
            image = make_image()
            image.SetOrigin(8 * i - 4, -4, -4)
            add_array(image.GetPointData(), "Push", [(1, 0, 0)] * image.GetNumberOfPoints())
            blocks.SetBlock(i, image)
        blocks.SetBlock(2, make_sphere())
        drawing = relevo.streamlines(blocks, "Push", seeds=4)
        starts = vtk_to_numpy(drawing.tracer.GetInputDataObject(1, 0).GetPoints().GetData())
        numpy.testing.assert_array_equal(starts % 1, 0.5)
        points = get_points(drawing.lines)
        self.assertLess(points[:, 0].min(), -3)
        self.assertGreater(points[:, 0].max(), 11)
        self.assertEqual(len(numpy.unique(points[:, 1:], axis=0)), 2)  # seeds at the same place of both

    def test_files(self):
        """save() writes the lines, or a picture."""
        drawing = relevo.streamlines(make_block(), "Shift", seeds=5)
        with tempfile.TemporaryDirectory() as folder:
            drawing.save(f"{folder}/lines.vtp")
            again = relevo._results.read(f"{folder}/lines.vtp")[0]
            self.assertEqual(again.GetNumberOfLines(), drawing.lines.GetNumberOfLines())
            drawing.save(f"{folder}/lines.png")
            self.assertGreater(read_picture(f"{folder}/lines.png").std(), 10)

    def test_changes(self):
        """The pipeline of VTK can be changed after the first picture."""
        drawing = relevo.streamlines(make_image(), seeds=10)
        thin = drawing.screenshot(size=SIZE).astype(int)
        drawing.tubes.SetRadius(0.3)
        self.assertGreater((abs(drawing.screenshot(size=SIZE) - thin).max(axis=2) > 20).sum(), 500)

    def test_same_as_relevo_view(self):
        if not VIEWER.exists():
            self.skipTest("built without relevo-view")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "turn.vti"
            writer = vtkXMLImageDataWriter()
            writer.SetFileName(str(path))
            writer.SetInputData(make_image())
            writer.Write()
            clip = {"clip": ((0, 0, 0), (0, 0, -1))}
            for options, arguments in (
                ({"seeds": 40}, ["--seeds=40"]),
                (
                    {"scalars": "Heat", "seed_line": ((0, 0, 0), (4, 0, 0)), "seeds": 8, "up": "z", **clip},
                    ["--array=Heat", "--seed-line=0,0,0,4,0,0", "--seeds=8", "--up=z", "--clip=0,0,0,0,0,-1"],
                ),
            ):
                own = relevo.streamlines(path, "Turn", **options).screenshot(size=SIZE).astype(int)
                output = f"{folder}/v.png"
                command = [VIEWER, path, "--streamlines=Turn", *arguments, "--size=320x200", f"--output={output}"]
                subprocess.run(command, check=True, capture_output=True)
                difference = abs(own - read_picture(output)).max(axis=2)
                self.assertLess((difference > 8).mean(), 0.002)

    def test_show(self):
        with unittest.mock.patch.object(_drawing.Drawing, "show"):
            drawing = relevo.show(make_image(), vectors="Turn", seeds=3)
        self.assertEqual(type(drawing).__name__, "Streamlines")

    def test_bad_input(self):
        image = make_image()
        for error, text, options in (
            (ValueError, "has no array 'None'; its arrays are 'Heat', 'Turn', 'Still'", {"vectors": "None"}),
            (ValueError, "the array 'Heat' has 1 components, not 3", {"vectors": "Heat"}),
            (ValueError, "seeds must be from 1 to 100000, not 0", {"seeds": 0}),
            (TypeError, "seeds must be an integer", {"seeds": 2.5}),
            (TypeError, "seed_line must be two points", {"seed_line": (1, 2, 3)}),
            (TypeError, "seed_line must be two points", {"seed_line": "line"}),
            (ValueError, "seed_line: all numbers must be finite", {"seed_line": ((0, 0, 0), (1, 0, math.nan))}),
            (TypeError, "did you mean seeds", {"seed": 3}),
            (ValueError, "has no array 'None'", {"scalars": "None"}),
        ):
            with self.assertRaisesRegex(error, text):
                relevo.streamlines(image, **options)
        with self.assertRaisesRegex(ValueError, "no array of 3 components"):
            relevo.streamlines(make_cube(names=["Heat"]))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(UserWarning, "there are no streamlines"):
                relevo.streamlines(image, seed_line=((90, 0, 0), (91, 0, 0)))


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingStreamlines"])
