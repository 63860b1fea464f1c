# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""relevo-view: what stands for no data, and height maps and pictures larger than a texture."""

import os
import subprocess
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter, vtkTIFFWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from ViewerProgram import PROGRAM, ViewerProgram


def write(writer, name, samples):
    """An array of rows x columns (x bands), the top row first, as a file."""
    image = vtkImageData()
    image.SetDimensions(samples.shape[1], samples.shape[0], 1)
    rows = numpy.ascontiguousarray(samples[::-1]).reshape(samples.shape[0] * samples.shape[1], -1)
    array = numpy_to_vtk(rows, deep=True)
    array.SetName("Samples")
    image.GetPointData().SetScalars(array)
    writer.SetInputData(image)
    writer.SetFileName(str(name))
    writer.Write()
    return name


class TestViewerTerrain(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        rows, columns = numpy.mgrid[0:64, 0:96]
        cls.samples = 50 + rows // 8 + columns // 8
        cls.samples[20:44, 36:60] = 9
        cls.heights = write(
            vtkPNGWriter(), cls.folder / "hole.png", cls.samples.astype(numpy.uint16)
        )

    def export(self, *arguments):
        name = self.folder / "mesh.vtp"
        self.view(*arguments, "--export", name)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(name))
        reader.Update()
        return reader.GetOutput()

    def picture(self, *arguments):
        name = self.folder / "picture.png"
        self.view(*arguments, "--output", name, "--size=320x200", "--view=180,80")
        reader = vtkPNGReader()
        reader.SetFileName(str(name))
        reader.Update()
        return reader.GetOutput()

    def assert_hole(self, mesh, lowest):
        """In the middle of 96 x 64 there is nothing, and nothing is as low as what stands for it."""
        self.assertGreater(mesh.GetNumberOfCells(), 100)
        self.assertGreater(mesh.GetBounds()[4], lowest)
        for i in range(mesh.GetNumberOfPoints()):
            x, y, _ = mesh.GetPoint(i)
            self.assertFalse(-11 < x < 11 and -11 < y < 11, (x, y))

    def test_no_data_value(self):
        common = (self.heights, "--level=1", "--resolution=48")
        whole = self.export(*common)
        self.assertAlmostEqual(whole.GetBounds()[4], 9, delta=0.01)
        hole = self.export(*common, "--no-data-value", "9")
        self.assert_hole(hole, 49)
        other = self.export(*common, "--no-data-value=-9999")
        self.assertEqual(other.GetNumberOfCells(), whole.GetNumberOfCells())
        filled = self.export(*common, "--no-data-value=9.0", "--no-data=fill")
        self.assertEqual(filled.GetNumberOfCells(), whole.GetNumberOfCells())
        self.assertGreater(filled.GetBounds()[4], 49)

        # From above, the sky shows through, and the terrain is around.
        image = self.picture(self.heights, "--no-data-value", "9", "--level=1")
        for column, is_sky in ((160, True), (110, False)):
            red, _, blue = (image.GetScalarComponentAsFloat(column, 100, 0, c) for c in range(3))
            self.assertEqual(blue > red + 20, is_sky)

    def test_nan(self):
        samples = numpy.where(self.samples == 9, numpy.nan, self.samples).astype(numpy.float32)
        name = write(vtkTIFFWriter(), self.folder / "nan.tif", samples)
        self.assert_error(1, ["nan.tif", "NaN", "no data"], name, "--output", "never.png")
        mesh = self.export(name, "--level=1", "--resolution=48", "--no-data-value", "NaN")
        self.assert_hole(mesh, 49)

    def test_bad_values(self):
        for value in ("hole", "", "12m", "1e999", "1,2", "nano"):
            self.assert_error(
                2, ["--no-data-value", f"'{value}'"], self.heights, "--no-data-value", value
            )
        self.assert_error(2, ["--no-data-value", "needs"], self.heights, "--no-data-value")
        self.assert_error(
            1, ["has data"], self.flat(), "--no-data-value=7", "--output", "never.png"
        )

    def flat(self):
        return write(
            vtkPNGWriter(), self.folder / "flat.png", numpy.full((8, 8), 7, dtype=numpy.uint8)
        )

    def test_mesh(self):
        plane = vtkPlaneSource()
        plane.SetResolution(24, 24)
        name = self.folder / "plane.vtp"
        writer = vtkXMLPolyDataWriter()
        writer.SetInputConnection(plane.GetOutputPort())
        writer.SetFileName(str(name))
        writer.Write()
        self.assert_error(2, ["--no-data-value", "--height"], name, "--no-data-value=9")
        arguments = (name, "--height", self.heights, "--scale=0.01", "--level=1")
        whole = self.export(*arguments)
        hole = self.export(*arguments, "--no-data-value=9")
        self.assertLess(whole.GetBounds()[4], 0.1)
        self.assertGreater(hole.GetBounds()[4], 0.49)
        self.assertLess(hole.GetNumberOfCells(), whole.GetNumberOfCells())

    def draw(self, *arguments):
        """Draws and exports; what is said on stderr, and the mesh's bounds."""
        run = subprocess.run(
            [str(PROGRAM), *map(str, arguments), "--output=l.png", "--export=l.vtp", "--level=0"],
            cwd=self.folder,
            env={key: value for key, value in os.environ.items() if key != "DISPLAY"},
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "l.vtp"))
        reader.Update()
        return run.stderr, reader.GetOutput().GetBounds()

    def test_larger_than_a_texture(self):
        """One warning, and the place of the whole."""
        columns = numpy.arange(20000)
        samples = numpy.tile((columns // 10).astype(numpy.uint16), (250, 1))
        name = write(vtkPNGWriter(), self.folder / "large.png", samples)
        errors, bounds = self.draw(name, "--resolution=64")
        self.assertRegex(
            errors,
            r"\Arelevo-view: warning: large.png has 20000 x 250 heights, more than 16384 a side: "
            r"[^\n]*16384 x 205[^\n]*gdal_translate[^\n]*\n\Z".replace("large", str(name)[:-4]),
        )
        for bound, expected in zip(bounds, (-10000, 10000, -125, 125, 0, 1999)):
            self.assertAlmostEqual(bound, expected, delta=0.6)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTerrain"])
