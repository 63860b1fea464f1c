# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves python.md: warnings and errors tell what is probably wrong with data and options, in the
caller's words, and drawings describe themselves in one line."""

import pydoc
import re
import tempfile
import unittest
import warnings

from DrawingData import (
    BOUNDS,
    make_block,
    make_curved_block,
    make_heights,
    make_sphere,
    numpy,
    relevo,
)
from relevo._messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkIOImage import vtkPNGWriter

SIZE = (64, 48)


def catch(function):
    """Return the texts of a function's warnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        function()
    return [str(own.message) for own in caught]


class TestDrawingMessages(unittest.TestCase):
    def catch_of_terrain(self, heights, **options):
        return catch(lambda: relevo.terrain(heights, **{"bounds": BOUNDS, "crs": 4326, **options}))

    def check_warning(self, texts, *words):
        self.assertEqual(len(texts), 1, texts)
        for word in words:
            self.assertIn(word, texts[0])

    def test_undeclared_no_data(self):
        """One warning names the value and the option. Declared and continuous heights have none."""
        heights = make_heights()
        hole = heights > 2000
        for value, kind in (
            (-9999, float),
            (-99999, "f4"),
            (-32768, "i2"),
            (65535, "u2"),
            (-3.4028234663852886e38, "f4"),
        ):
            data = numpy.where(hole, value, abs(heights)).astype(kind)
            with self.subTest(value):
                texts = self.catch_of_terrain(data)
                self.check_warning(texts, "the array", f"no_data={value:.9g}", f"height, {value:.9g}")
                self.assertEqual(self.catch_of_terrain(data, no_data=value), [])
                terrain = relevo.terrain(data, bounds=BOUNDS, crs=4326, no_data=value)
                self.assertTrue(numpy.isnan(terrain.elevation(86.9, 28.0)))
        steep = numpy.linspace(-9999, 9999, 64 * 96).reshape(64, 96)
        self.assertEqual(self.catch_of_terrain(steep), [])
        self.assertEqual(self.catch_of_terrain(numpy.where(hole, -9998, heights)), [])
        mask = numpy.where(hole, 65535, 0).astype("u2")
        self.assertEqual(self.catch_of_terrain(mask), [])
        with self.assertRaisesRegex(ValueError, "no_data are for arrays"):
            relevo.terrain("dem.tif", no_data=0)
        with self.assertRaisesRegex(TypeError, "no_data must be a number"):
            relevo.terrain(heights, no_data="0")

    def test_photos(self):
        noise = numpy.random.default_rng(0).integers(0, 255, (60, 80)).astype(numpy.uint8)
        self.check_warning(catch(lambda: relevo.terrain(noise)), "photo", "imagery")
        smooth = (make_heights() / 20 + 50).astype(numpy.uint8)
        self.assertEqual(catch(lambda: relevo.terrain(smooth)), [])
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkPNGWriter()
            path = folder + "/photo.png"
            writer.SetFileName(path)
            image = relevo.arrays.image(numpy.stack([smooth] * 3, axis=2))
            image.GetPointData().SetActiveScalars("Values")
            writer.SetInputData(image)
            writer.Write()
            self.check_warning(catch(lambda: relevo.terrain(path)), "three or more bands", "imagery")
        with self.assertRaisesRegex(ValueError, "not of shape .*imagery"):
            relevo.terrain(numpy.zeros((4, 5, 3)))

    def test_bounds(self):
        """The order of rasterio is an error, or a warning if the bounds are possible."""
        heights = make_heights()
        west, east, south, north = BOUNDS
        with self.assertRaisesRegex(ValueError, "they look like .west, south, east, north"):
            relevo.terrain(heights, bounds=(west, south, east, north), crs=4326)
        texts = self.catch_of_terrain(heights, bounds=(10, 47, 10.1, 47.07))
        self.check_warning(texts, "they look like (west, south, east, north)")
        self.assertEqual(self.catch_of_terrain(heights, bounds=(10, 10.1, 47, 47.07)), [])
        self.assertEqual(self.catch_of_terrain(heights, bounds=(-10, 30, 30, 70)), [])
        with self.assertRaisesRegex(ValueError, "^Cannot use the array: .*poles.* bounds"):
            relevo.terrain(heights, bounds=(-35, -34, 150, 151), crs=4326)

    def test_names(self):
        """Messages have the names of options, and of arrays instead of temporary files."""
        self.check_warning(
            catch(lambda: relevo.terrain(make_heights(), bounds=BOUNDS)),
            "the array has no coordinate system",
            "crs='EPSG:4326'",
        )
        curved = make_curved_block()
        for function, text in (
            (lambda: relevo.refined(make_sphere(), max_level=9), "max_level must be in [0, 7]"),
            (lambda: relevo.terrain(make_heights(), exaggeration=-1), "exaggeration must be at least"),
            (lambda: relevo.patches(curved, error=-1), "error must be in"),
        ):
            with self.assertRaisesRegex(ValueError, "^" + re.escape(text)):
                function()

    def test_misspelt_options(self):
        block = make_block()
        for function, text in (
            (lambda: relevo.patches(block, warp="Shift", scale=3), "did you mean factor?"),
            (lambda: relevo.volume(block, contours=[1]), "did you mean isosurfaces?"),
            (lambda: relevo.terrain(make_heights(), z_scale=3), "did you mean exaggeration?"),
            (lambda: relevo.terrain(make_heights(), Imagry="a"), "did you mean imagery?"),
            (lambda: relevo.volume(numpy.zeros((3, 4, 5))), "array of shape (3, 4, 5); put samples"),
        ):
            with self.assertRaisesRegex(TypeError, re.escape(text)):
                function()
        with self.assertRaises(AttributeError) as caught:
            relevo.patch
        self.assertEqual((caught.exception.name, caught.exception.obj), ("patch", relevo))

    def test_case(self):
        """Names of axes, surfaces, metrics and blend modes have any case."""
        drawing = relevo.refined(make_sphere(), up="Z", surface="PN", metric="Screen-Edge")
        self.assertTrue(drawing.recipe.GetSurface().IsA("vtkPNTriangleSurface"))
        self.assertEqual(drawing.recipe.GetMaximumLevel(), 7)
        self.assertEqual(relevo.volume(make_block(), blend="Maximum").mapper.GetBlendMode(), 1)
        with self.assertRaisesRegex(ValueError, "^up must be"):
            relevo.refined(make_sphere(), up=2)

    def test_single_warnings(self):
        drawing = relevo.volume(make_block(), "DistanceToCenter", isosurfaces=[1e9])
        self.check_warning(catch(lambda: drawing.screenshot(size=SIZE)), "no isosurface at 1e+09")

    def test_silenced_errors(self):
        """Errors are raised although the program has switched off VTK's messages, as vedo does."""
        self.addCleanup(vtkObject.SetGlobalWarningDisplay, vtkObject.GetGlobalWarningDisplay())
        vtkObject.GlobalWarningDisplayOff()
        with self.assertRaisesRegex(relevo.Error, "Call|call"), Messages():
            relevo.vtkTerrainPyramid().Update()
        self.assertEqual(vtkObject.GetGlobalWarningDisplay(), 0)

    def test_von_mises(self):
        """The stress is that of the tensors, of points and cells, and of symmetric parts."""
        block = make_block()
        count = block.GetNumberOfPoints()
        sheared = numpy.random.default_rng(1).normal(size=(count, 3, 3))
        full = 0.5 * (sheared + sheared.transpose(0, 2, 1))
        deviator = full - numpy.trace(full, axis1=1, axis2=2)[:, None, None] / 3 * numpy.eye(3)
        wanted = numpy.sqrt(1.5 * (deviator**2).sum(axis=(1, 2)))
        voigt = full[:, [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]

        def add(name, values):
            array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            array.SetName(name)
            block.GetPointData().AddArray(array)

        add("S", voigt)
        for name in ("von Mises", "Von-Mises of S"):
            drawing = relevo.volume(block, name)
            found = drawing.mesh().GetPointData().GetArray("von Mises of S")
            numpy.testing.assert_allclose(vtk_to_numpy(found), wanted)
            self.assertEqual(drawing._title, "von Mises of S")
        self.assertFalse(block.GetPointData().HasArray("von Mises of S"))
        add("S9", sheared.reshape(count, 9))
        drawing = relevo.patches(block, scalars="von Mises of S9")
        numpy.testing.assert_allclose(drawing._table.GetRange()[1], wanted.max(), rtol=0.5)
        self.assertLessEqual(drawing._table.GetRange()[1], wanted.max() * (1 + 1e-9))
        for name, text in (
            ("von Mises", "'S', 'S9'; choose one"),
            ("von Mises of Q", "no array 'Q'; .* are 'S', 'S9'"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                relevo.volume(block, name)
        add("von Mises", wanted)
        self.assertEqual(relevo.volume(block, "von Mises")._title, "von Mises")

    def test_descriptions(self):
        sphere = make_sphere()
        for drawing, text in (
            (relevo.terrain(make_heights()), "terrain: the array, 96 x 64 heights from "),
            (relevo.refined(sphere, max_level=2), "refined: 240 faces, up to level 2"),
            (relevo.volume(make_block(), "DistanceToCenter"), "volume: 64 cells, DistanceToCenter from"),
            (relevo.patches(make_curved_block()), "patches: "),
            (relevo.lic(sphere, "V"), "lic: 240 faces, up to level 6, V (magnitude) from "),
            (relevo.relief(make_heights()), "relief: 1 of 96 x 64 texels"),
            (relevo.intersection(sphere, make_block()), "intersection: "),
        ):
            self.assertRegex(repr(drawing), "^<relevo." + re.escape(text))
            self.assertLess(len(repr(drawing)), 100)
            self.assertNotIn("\n", repr(drawing))
        text = pydoc.render_doc(relevo)
        self.assertLess(len(text.splitlines()), 500)
        self.assertIn("no_data", text)


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingMessages"])
