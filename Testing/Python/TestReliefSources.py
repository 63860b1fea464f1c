# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves reliefs.md from Python: reliefs of numpy arrays, renderings and height maps, and
databases."""

import pathlib
import sys
import tempfile
import unittest

import numpy

import relevo
from ErrorMessages import catch_errors
from relevo import arrays
from vtkmodules import vtkInteractionStyle, vtkRenderingOpenGL2  # noqa: F401: factories
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRendererSource, vtkRenderWindow, vtkWindowToImageFilter)


def points_of(relief):
    """Positions of all texels, shape (rows, columns, 3), by the definition of a relief."""
    depths = arrays.samples(relief, "Depth").astype(float)
    matrix = numpy.array([relief.GetFieldData().GetArray("ReliefMatrix").GetValue(i) for i in range(16)])
    rows, columns = numpy.indices(depths.shape)
    one = numpy.ones(depths.shape)
    if relief.GetFieldData().GetArray("ReliefProjection").GetValue(0):
        places = numpy.stack([columns * depths, rows * depths, depths, one], axis=-1)
    else:
        places = numpy.stack([columns, rows, depths, one], axis=-1)
    return (places @ matrix.reshape(4, 4).T)[..., :3]


class Sphere:
    """A sphere in a window without a display."""

    CENTER = numpy.array([1.0, 2.0, 3.0])
    RADIUS = 2.0

    def __init__(self, parallel):
        sphere = vtkSphereSource()
        sphere.SetCenter(*self.CENTER)
        sphere.SetRadius(self.RADIUS)
        sphere.SetThetaResolution(512)
        sphere.SetPhiResolution(256)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.9, 0.5, 0.2)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(160, 120)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(6.0, -3.0, 9.0)
        camera.SetFocalPoint(1.2, 2.1, 2.9)
        camera.SetParallelProjection(parallel)
        camera.SetParallelScale(2.5)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()

    def buffer(self, kind):
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        getattr(grab, f"SetInputBufferTypeTo{kind}")()
        grab.Update()
        return grab.GetOutput()


class TestDepthImages(unittest.TestCase):
    def test_camera(self):
        """Depths of a depth camera in millimetres, first row at the top, as its driver delivers
        them."""
        rng = numpy.random.default_rng(3)
        depths = rng.integers(500, 3000, (6, 8), dtype=numpy.uint16)
        depths[2, 3] = 0
        colors = rng.integers(0, 256, (6, 8, 3), dtype=numpy.uint8)
        picture = arrays.image(colors, "Colors")
        picture.GetPointData().SetActiveScalars("Colors")
        pose = vtkMatrix4x4()
        pose.SetElement(0, 3, 10.0)
        filter = relevo.vtkDepthImageToRelief()
        filter.SetInputData(arrays.image(depths))
        filter.SetInputData(1, picture)
        filter.SetDepthScale(0.001)
        filter.SetIntrinsics(9.0, 8.0, 3.6, 2.4)
        filter.SetPose(pose)
        filter.Update()
        relief = filter.GetOutput()
        rows, columns = numpy.indices(depths.shape)
        z = 0.001 * depths
        expected = numpy.stack([10.0 + (columns - 3.6) * z / 9.0, (rows - 2.4) * z / 8.0, z], axis=-1)
        expected[2, 3] = numpy.nan
        numpy.testing.assert_allclose(points_of(relief), expected, atol=1e-6)
        numpy.testing.assert_array_equal(arrays.samples(relief, "Color"), colors)
        self.assertEqual(arrays.samples(relief, "Normals").shape, (6, 8, 3))
        # The same picture as VTK's readers deliver it, flipped.
        filter.SetInputData(arrays.image(depths[::-1]))
        filter.BottomRowFirstOn()
        filter.Update()
        numpy.testing.assert_allclose(points_of(filter.GetOutput())[::-1], expected, atol=1e-6)

    def test_renderings(self):
        """The texels of a rendering lie on the rendered sphere, in both projections."""
        for parallel in (False, True):
            scene = Sphere(parallel)
            relief = relevo.vtkDepthImageToRelief()
            relief.SetInputData(scene.buffer("ZBuffer"))
            relief.SetInputData(1, scene.buffer("RGB"))
            relief.SetCamera(scene.renderer.GetActiveCamera())
            relief.Update()
            points = points_of(relief.GetOutput())
            seen = ~numpy.isnan(points[..., 0])
            self.assertGreater(numpy.count_nonzero(seen), 5000)
            outwards = points[seen] - Sphere.CENTER
            distances = numpy.linalg.norm(outwards, axis=1)
            # The mesh's triangles and 24-bit depths limit the accuracy.
            self.assertLess(numpy.abs(distances - Sphere.RADIUS).max(), 1e-3)
            colors = arrays.samples(relief.GetOutput(), "Color")
            self.assertGreater(colors[seen][:, 0].min(), 0)
            self.assertEqual(colors[~seen].max(), 0)
            # Normals of the smooth sphere, away from its silhouette.
            normals = arrays.samples(relief.GetOutput(), "Normals")[seen]
            cosines = numpy.sum(normals * outwards, axis=1) / distances
            self.assertGreater(numpy.median(cosines), 0.999)
            self.assertGreater(cosines.min(), 0.0)

    def test_renderer_source(self):
        scene = Sphere(False)
        source = vtkRendererSource()
        source.SetInput(scene.renderer)
        source.WholeWindowOn()
        source.DepthValuesOn()
        relief = relevo.vtkDepthImageToRelief()
        relief.SetInputConnection(source.GetOutputPort())
        relief.SetCamera(scene.renderer.GetActiveCamera())
        relief.Update()
        points = points_of(relief.GetOutput())
        seen = ~numpy.isnan(points[..., 0])
        distances = numpy.linalg.norm(points[seen] - Sphere.CENTER, axis=1)
        self.assertLess(numpy.abs(distances - Sphere.RADIUS).max(), 1e-3)
        self.assertGreater(arrays.samples(relief.GetOutput(), "Color")[seen][:, 0].min(), 0)

    def test_errors(self):
        filter = relevo.vtkDepthImageToRelief()
        errors = catch_errors(filter)
        catch_errors(filter.GetExecutive())
        filter.SetInputData(arrays.image(numpy.ones((3, 4))))
        filter.Update()
        self.assertIn("neither intrinsics nor a camera", errors[0])
        self.assertEqual(filter.GetOutput().GetNumberOfPoints(), 0)


class TestHeightMaps(unittest.TestCase):
    def test_heights(self):
        heights = numpy.add.outer(10.0 * numpy.arange(5), numpy.arange(7)) + 0.25
        heights[1, 2] = numpy.nan
        colors = numpy.arange(35 * 3, dtype=numpy.uint8).reshape(5, 7, 3)
        imagery = arrays.image(colors, "Colors")
        imagery.GetPointData().SetActiveScalars("Colors")
        filter = relevo.vtkHeightMapToRelief()
        filter.SetHeightMap(arrays.height_map(heights))
        filter.SetInputData(imagery)
        filter.SetExaggeration(2.0)
        filter.Update()
        points = points_of(filter.GetOutput())
        numpy.testing.assert_allclose(points[..., 2], 2.0 * heights[::-1], atol=1e-5)
        numpy.testing.assert_allclose(points[0, :, 0][~numpy.isnan(points[0, :, 0])], numpy.arange(7) - 3.0)
        numpy.testing.assert_array_equal(arrays.samples(filter.GetOutput(), "Color"), colors)


class TestDatabases(unittest.TestCase):
    def test_database(self):
        filter = relevo.vtkDepthImageToRelief()
        filter.SetIntrinsics(4.0, 4.0, 1.5, 1.5)
        blocks = vtkMultiBlockDataSet()
        for block in range(3):
            filter.SetInputData(arrays.image(numpy.full((4, 4), 1.0 + block)))
            filter.Update()
            blocks.SetBlock(block, filter.GetOutput().NewInstance())
            blocks.GetBlock(block).DeepCopy(filter.GetOutput())
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name, "inner", "reliefs.cdb")
            writer = relevo.vtkReliefDatabaseWriter()
            writer.SetInputData(blocks)
            writer.SetFileName(folder)
            self.assertEqual(writer.Write(), 1)
            header, *rows = (folder / "data.csv").read_text().splitlines()
            self.assertTrue(header.endswith(",FILE,FILE_image"))
            self.assertEqual(len(rows), 3)
            reader = relevo.vtkReliefDatabaseReader()
            errors = catch_errors(reader)
            self.assertTrue(reader.CanReadFile(folder))
            (folder / "relief_0001.vti").unlink()
            reader.SetFileName(folder)
            reader.Update()
            self.assertEqual(len(errors), 1)
            self.assertIn("line 3: relief_0001.vti: the file does not exist.", errors[0])
            self.assertIsNone(reader.GetOutput().GetBlock(1))
            for block in (0, 2):
                depths = arrays.samples(reader.GetOutput().GetBlock(block), "Depth")
                numpy.testing.assert_array_equal(depths, numpy.full((4, 4), 1.0 + block))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
