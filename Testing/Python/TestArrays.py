# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves guide.md: relevo.arrays converts numpy arrays to heights and images, and refined meshes
and images to numpy arrays."""

import pathlib
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

import relevo
from relevo import arrays
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource


class TestArrays(unittest.TestCase):
    def test_rows_run_north_to_south(self):
        heights = numpy.array([[10.0, 20.0, 30.0], [1.0, 2.0, 3.0]])
        made = arrays.height_map(heights)
        self.assertEqual(tuple(made.GetDimensions()), (3, 2))
        self.assertEqual(tuple(made.GetRange()), (1.0, 30.0))
        for row in range(2):
            for column in range(3):
                u, v = (column + 0.5) / 3, 1.0 - (row + 0.5) / 2
                self.assertAlmostEqual(made.GetHeight(u, v), heights[row, column], places=4)

    def test_types_and_memory_layouts(self):
        for dtype in ("int16", "uint16", "float32", "float64", "uint8"):
            wide = numpy.arange(24, dtype=dtype).reshape(4, 6)
            for heights in (wide, wide[:, ::2], wide.T, numpy.asfortranarray(wide)):
                made = arrays.height_map(heights)
                self.assertEqual(tuple(made.GetRange()), (heights.min(), heights.max()))
                self.assertEqual(tuple(made.GetDimensions()), heights.shape[::-1])

    def test_shared_memory(self):
        """Arrays whose rows are contiguous are shared, in both orders of rows, and read-only."""
        wide = numpy.arange(24, dtype="float32").reshape(4, 6)
        read_only = wide.copy()
        read_only.flags.writeable = False
        for heights, shared in (
            (wide, True), (wide[::-1], True), (read_only, True), (wide[1:3], True),
            (wide[:, ::2], False), (wide.T, False), (wide.astype(">f4"), False),
        ):
            made = arrays.height_map(heights)
            image = vtk_to_numpy(made.GetImageData().GetPointData().GetScalars())
            self.assertEqual(numpy.shares_memory(image, heights), shared)
            samples = numpy.array(made.GetSamples()).reshape(heights.shape)
            numpy.testing.assert_array_equal(samples, heights[::-1])
        changed = wide.copy()
        made = arrays.height_map(changed)
        changed[0, 0] = 99
        self.assertEqual(tuple(made.GetRange()), (0.0, 23.0))
        made.GetImageData().Modified()
        self.assertTrue(made.Update())
        self.assertEqual(tuple(made.GetRange()), (1.0, 99.0))
        del changed
        made.GetImageData().Modified()
        self.assertTrue(made.Update())
        self.assertEqual(made.GetSample(0, 3), 99.0)

    def test_byte_orders_and_widths(self):
        """Number types of files (.hgt, FITS, netCDF), half precision, and types wider than double.
        """
        for dtype in ("<i2", ">i2", ">u4", "<f4", ">f4", ">f8", "<f2", ">f2", "longdouble"):
            values = numpy.array([[1, 2, 3], [258, 5, 6]], dtype=dtype)
            self.assertEqual(tuple(arrays.height_map(values).GetRange()), (1.0, 258.0), dtype)
            back = arrays.samples(arrays.image(values))
            numpy.testing.assert_array_equal(back, values.astype(float), dtype)
            vectors = arrays.image(numpy.stack([values, values], axis=2), "Vectors")
            numpy.testing.assert_array_equal(arrays.samples(vectors, "Vectors")[..., 1], values)

    def test_numbers_that_are_not_real(self):
        for dtype in ("complex64", "complex128", "bool", "timedelta64[s]", "object"):
            for make in (arrays.height_map, arrays.image):
                with self.assertRaisesRegex(ValueError, "real numbers"):
                    make(numpy.zeros((2, 2), dtype))

    def test_too_few_rows_or_columns(self):
        for shape in ((1, 800), (800, 1), (1, 1), (0, 5), (2, 0)):
            with self.assertRaisesRegex(ValueError, "at least 2 x 2, not %d x %d" % shape):
                arrays.height_map(numpy.ones(shape))
        self.assertEqual(tuple(arrays.height_map(numpy.ones((2, 2))).GetDimensions()), (2, 2))

    def test_none_and_other_objects(self):
        for function in (
            arrays.height_map, arrays.heights, arrays.image, arrays.triangles, arrays.samples
        ):
            with self.assertRaisesRegex(TypeError, "must be an? .*, not None"):
                function(None)
        with self.assertRaisesRegex(TypeError, "mesh must be a vtkPolyData, not vtkPlaneSource"):
            arrays.triangles(vtkPlaneSource())
        with self.assertRaisesRegex(TypeError, "image must be a vtkImageData, not str"):
            arrays.samples("picture.png")

    def test_all_samples(self):
        heights = numpy.array([[10.0, 20.0, 30.0], [1.0, numpy.nan, 3.0]])
        made = arrays.height_map(heights)
        self.assertEqual(made.GetNumberOfSamples(), 6)
        samples = made.GetSamples()
        self.assertEqual(samples[0:1] + samples[2:], (1.0, 3.0, 10.0, 20.0, 30.0))
        self.assertEqual(made.GetValidity(), (1, 0, 1, 1, 1, 1))
        self.assertIsNone(arrays.height_map(numpy.ones((2, 2))).GetValidity())
        self.assertIsNone(relevo.vtkHeightMap().GetSamples())

    def test_heights(self):
        """Heights can be read back as an array, of arrays and of files."""
        heights = numpy.array([[10.0, 20.0, 30.0], [1.0, numpy.nan, 3.0]])
        for source in (heights, numpy.asfortranarray(heights), heights[:, ::-1]):
            found = arrays.heights(arrays.height_map(source))
            self.assertEqual((found.dtype, found.flags.c_contiguous), (numpy.float32, True))
            numpy.testing.assert_array_equal(found, source)
        whole = numpy.arange(6, dtype="int16").reshape(3, 2)
        numpy.testing.assert_array_equal(arrays.heights(arrays.height_map(whole)), whole)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "heights.asc"
            path.write_text(
                "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -1\n4 5\n-1 7\n"
            )
            read = relevo.vtkHeightMap()
            read.SetFileName(str(path))
            numpy.testing.assert_array_equal(arrays.heights(read), [[4, 5], [numpy.nan, 7]])
            read.SetFileName(str(path) + ".none")
            with self.assertRaises(relevo.Error):
                arrays.heights(read)

    def test_no_data(self):
        heights = numpy.array([[1.0, numpy.nan], [2.0, 3.0]])
        self.assertTrue(arrays.height_map(heights).HasNoData())
        self.assertEqual(tuple(arrays.height_map(heights).GetRange()), (1.0, 3.0))
        marked = numpy.array([[1, -9999], [2, 3]], dtype="int16")
        self.assertTrue(arrays.height_map(marked, no_data=-9999).HasNoData())
        self.assertFalse(arrays.height_map(marked).HasNoData())

    def test_masked_arrays(self):
        """Array types of rasterio and netCDF4."""
        for dtype in ("int16", "uint8", ">i4", "float32", "float16", "float64"):
            values = numpy.array([[1, 99], [2, 3]], dtype=dtype)
            masked = numpy.ma.masked_equal(values, 99)
            made = arrays.height_map(masked)
            self.assertTrue(made.HasNoData(), dtype)
            self.assertEqual(tuple(made.GetRange()), (1.0, 3.0), dtype)
            self.assertEqual(tuple(arrays.height_map(masked, no_data=3).GetRange()), (1.0, 2.0))
            far = arrays.height_map(masked, no_data=-1.79e308)
            self.assertEqual(tuple(far.GetRange()), (1.0, 3.0), dtype)
            back = arrays.samples(arrays.image(masked))
            numpy.testing.assert_array_equal(back, [[1.0, numpy.nan], [2.0, 3.0]], dtype)
            unmasked = numpy.ma.masked_array(values)
            self.assertEqual(tuple(arrays.height_map(unmasked).GetRange()), (1.0, 99.0))
        with self.assertRaises(ValueError):
            arrays.height_map(numpy.ma.masked_all((3, 3)))

    def test_bad_arrays(self):
        for bad in (numpy.zeros(4), numpy.zeros((2, 2, 2)), numpy.array([["a", "b"], ["c", "d"]])):
            with self.assertRaises(ValueError):
                arrays.height_map(bad)
        with self.assertRaises(ValueError):
            arrays.height_map(numpy.full((3, 3), numpy.nan))

    def test_triangles_of_a_refined_plane(self):
        plane = vtkPlaneSource()
        displacement = relevo.vtkDisplacement()
        displacement.SetHeightMap(arrays.height_map(numpy.full((2, 2), 0.25)))
        displacement.SetDirection(0, 0, 1)
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetMaximumLevel(2)
        recipe.SetDisplacement(displacement)
        refine = relevo.vtkAdaptiveRefinementFilter()
        refine.SetInputConnection(plane.GetOutputPort())
        refine.SetRefinement(recipe)
        refine.Update()
        points, triangles = arrays.triangles(refine.GetOutput())
        self.assertEqual(triangles.shape, (2 * 4**2, 3))
        self.assertTrue((points[:, 2] == 0.25).all())
        corners = points[triangles]
        doubled = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self.assertAlmostEqual(doubled[:, 2].sum() / 2, 1.0, places=5)
        self.assertTrue((doubled[:, 2] > 0).all())

    def test_triangles_of_quads(self):
        plane = vtkPlaneSource()
        plane.Update()
        with self.assertRaises(ValueError):
            arrays.triangles(plane.GetOutput())

    def test_images(self):
        for dtype in ("uint8", "int32", "float32", "float64"):
            wide = numpy.arange(2 * 4 * 6, dtype=dtype).reshape(4, 6, 2)
            for values in (wide, wide[..., 0], wide[:, ::2], wide[..., 1].T, wide[:1], wide[:, :1]):
                image = arrays.image(values, "Some", (0.5, 2))
                self.assertEqual(image.GetDimensions(), values.shape[1::-1] + (1,))
                self.assertEqual(image.GetSpacing(), (0.5, 2, 1))
                back = arrays.samples(image, "Some")
                self.assertEqual(back.dtype, values.dtype)
                numpy.testing.assert_array_equal(back, values)
                self.assertEqual(image.GetPointData().GetScalars() is not None, values.ndim == 2)
        scalars = arrays.image(wide[..., 0])
        numpy.testing.assert_array_equal(arrays.samples(scalars), wide[..., 0])
        # Row 0 is the lowest.
        self.assertEqual(scalars.GetScalarComponentAsDouble(3, 2, 0, 0), wide[2, 3, 0])

    def test_slices(self):
        values = numpy.arange(12.0).reshape(3, 4)
        for dimensions in ((4, 3, 1), (4, 1, 3), (1, 4, 3)):
            image = arrays.image(values)
            image.SetDimensions(dimensions)
            numpy.testing.assert_array_equal(arrays.samples(image), values)

    def test_bad_images(self):
        for bad in (numpy.zeros(4), numpy.zeros((2, 2, 2, 2)), numpy.zeros((0, 3)), numpy.array([["a"]])):
            with self.assertRaises(ValueError):
                arrays.image(bad)
        image = arrays.image(numpy.zeros((2, 4, 3)))
        for name in (None, "Other"):
            with self.assertRaises(ValueError):
                arrays.samples(image, name)
        image.SetDimensions(2, 2, 2)
        with self.assertRaises(ValueError):
            arrays.samples(image, "Values")


if __name__ == "__main__":
    unittest.main(argv=["TestArrays"])
