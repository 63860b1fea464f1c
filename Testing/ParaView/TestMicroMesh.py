# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: Micro-Mesh and Micro-Mesh Contour encode within their tolerance, .rmm files are
written and opened, and Adaptive Refinement draws a micro-mesh like the mesh that it encodes."""

import os
import tempfile

from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkPolyData

import RelevoParaView as relevo

SIZE = (200, 150)


def dense():
    """A closed surface of 5,000 triangles with relief."""
    shape = simple.Superquadric(
        Toroidal=1, PhiRoundness=0.6, ThetaResolution=48, PhiResolution=48, Size=1
    )
    result = simple.Clean(Input=simple.Triangulate(Input=shape))
    result.UpdatePipeline()  # domains use its bounds and arrays
    return result


def fetch(source):
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def show(source, view, surface=True, **properties):
    """Shows a source in one colour, with the surface and the metric of micro-meshes."""
    shown = relevo.show(source, view, DiffuseColor=[1, 1, 1], **properties)
    if surface:
        shown.Surface = "Micro-Mesh"
        shown.Metric = "Micro-Mesh Error"
        shown.MaximumLevel = 5
        shown.LevelRule = "Per Edge"
    return shown


class TestMicroMesh(relevo.TestCase):
    def test_filter(self):
        mesh = dense()
        micro = simple.MicroMesh(Input=mesh)
        data = fetch(micro)
        sides = [high - low for low, high in zip(*[iter(fetch(mesh).GetBounds())] * 2)]
        self.assertAlmostEqual(micro.Tolerance, 0.001 * max(sides), delta=1e-6)
        self.assertLess(data.GetNumberOfPolys(), 0.5 * fetch(mesh).GetNumberOfPolys())
        error = data.GetFieldData().GetArray("MicroMeshError")
        self.assertLessEqual(max(error.GetTuple1(0), error.GetTuple1(1)), micro.Tolerance)
        self.assertFalse(data.GetCellData().HasArray("vtkOriginalCellIds"))
        micro.PassThroughCellIds = 1
        self.assertTrue(fetch(micro).GetCellData().HasArray("vtkOriginalCellIds"))
        # The filter refines it to a length.
        refined = simple.AdaptiveRefinement(Input=micro, MaximumLevel=5)
        refined.Surface = "Micro-Mesh"
        self.assertGreater(fetch(refined).GetNumberOfPolys(), data.GetNumberOfPolys())

    def test_picture(self):
        """The surface is within a pixel of the dense mesh. Only shading at silhouettes differs."""
        view, other = relevo.view(SIZE), relevo.view(SIZE)
        mesh = dense()
        micro = simple.MicroMesh(Input=mesh, Tolerance=0.002)
        show(micro, view)
        relevo.show(mesh, other, "Surface", DiffuseColor=[1, 1, 1])
        simple.ResetCamera(view)
        relevo.copy_camera(view, other)
        drawn, expected = relevo.picture(view), relevo.picture(other)
        self.assertGreater(relevo.foreground(drawn), 1500)
        self.assertLess(relevo.differing(drawn, expected, 40), 300)
        # Without the surface, the coarse faces are drawn.
        flat = relevo.view(SIZE)
        show(micro, flat, surface=False)
        relevo.copy_camera(view, flat)
        self.assertGreater(
            relevo.differing(relevo.picture(flat), expected, 40),
            relevo.differing(drawn, expected, 40),
        )

    def test_contour(self):
        wavelet = simple.Wavelet(WholeExtent=[-12, 12, -12, 12, -12, 12])
        wavelet.UpdatePipeline()
        contour = simple.MicroMeshContour(Input=wavelet, Isosurfaces=[150.0, 200.0], BlockSize=12)
        contour.Tolerance = 0.1
        self.assertEqual(contour.ContourBy[1], "RTData")
        data = fetch(contour)
        self.assertGreater(data.GetNumberOfPolys(), 100)
        error = data.GetFieldData().GetArray("MicroMeshError")
        self.assertLessEqual(max(error.GetTuple1(0), error.GetTuple1(1)), 0.1)

    def test_files(self):
        micro = simple.MicroMesh(Input=dense())
        data = fetch(micro)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.rmm")
            simple.SaveData(path, proxy=micro)
            reader = simple.OpenDataFile(path)
            self.assertEqual(reader.SMProxy.GetXMLName(), "MicroMeshReader")
            read = fetch(reader)
        self.assertIsInstance(read, vtkPolyData)
        self.assertEqual(read.GetNumberOfPoints(), data.GetNumberOfPoints())
        self.assertEqual(read.GetNumberOfPolys(), data.GetNumberOfPolys())
        names = [data.GetFieldData().GetArrayName(i) for i in range(3)]
        self.assertTrue(all(read.GetFieldData().HasArray(each) for each in names), names)

    def test_wrong_input(self):
        """Another mesh than a micro-mesh is one error, and the mesh is not drawn."""
        view = relevo.view(SIZE)
        with relevo.messages() as text:
            show(relevo.sphere(), view)
            simple.Render(view)
            self.assertIn("the mesh is not a micro-mesh", text())

    def test_no_points(self):
        """Lengths that depend on the bounds are not negative without points, and give no error."""
        empty = simple.Clip(Input=relevo.sphere(), ClipType="Plane")
        empty.ClipType.Origin = [100, 0, 0]
        empty.Invert = 0
        empty = simple.ExtractSurface(Input=empty)
        empty.UpdatePipeline()
        self.assertEqual(fetch(empty).GetNumberOfPoints(), 0)
        view = relevo.view(SIZE)
        with relevo.messages() as text:
            self.assertGreaterEqual(simple.MicroMesh(Input=empty).Tolerance, 0)
            show(empty, view)
            self.assertEqual(text(), "")


if __name__ == "__main__":
    relevo.main()
