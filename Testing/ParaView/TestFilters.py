# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md on the filters and the source of the menu Relevo."""

import math
import os
import tempfile

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import RelevoParaView as relevo


# A valid triangle, and one that refers to a missing point.
MISSING_POINT = """
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
points = vtkPoints()
for place in (0, 0, 0), (1, 0, 0), (0, 1, 0):
    points.InsertNextPoint(place)
cells = vtkCellArray()
for ids in (0, 1, 2), (1, 2, {point}):
    cells.InsertNextCell(3, ids)
output = self.GetPolyDataOutput()
output.SetPoints(points)
output.SetPolys(cells)
"""
CHOICES = {
    "Metric": ("metrics", "RegionDepthTagMetric", "Region"),
    "Surface": ("surfaces", "PNTriangleSurface", "PN Triangles"),
    "Displacement": ("displacements", "HeightMapDisplacement", "Height Map"),
}


def with_vectors(source, function):
    """A source with the point vectors "Flow", up to date."""
    result = simple.Calculator(Input=source, ResultArrayName="Flow", Function=function)
    result.UpdatePipeline()
    return result


def point_values(source, name):
    return vtk_to_numpy(servermanager.Fetch(source).GetPointData().GetArray(name))


class TestFilters(relevo.TestCase):
    def assert_streaks(self, values, axis):
        """Neighbours are similar along the axis and differ across it."""
        along, across = (numpy.abs(numpy.diff(values, axis=each)).mean() for each in (axis, 1 - axis))
        self.assertLess(along, 0.5 * across)

    def test_menu(self):
        for name in (
            "AdaptiveRefinement",
            "DepthTags",
            "GeographicVectors",
            "ImageLineIntegralConvolution",
            "SurfaceLineIntegralConvolution",
            "TerrainSource",
        ):
            group = "sources" if name == "TerrainSource" else "filters"
            proxy = servermanager.ProxyManager().GetPrototypeProxy(group, name)
            self.assertTrue(proxy.GetHints().FindNestedElementByName("ShowInMenu"), name)
            self.assertTrue(proxy.GetDocumentation().GetShortHelp(), name)

    def test_arrays_of_the_input(self):
        """Filters and representations offer the same choices."""
        source = simple.Elevation(Input=simple.Sphere(Center=[5, 6, 7]))
        source.UpdatePipeline()
        shown = relevo.show(source, relevo.view())
        filters = simple.AdaptiveRefinement(Input=source), simple.DepthTags(Input=source)
        for holder in (shown, *filters):
            holder.Metric = "Variation of an Array"
            names = holder.Metric.GetProperty("ArrayName").GetAvailable()
            self.assertEqual(names, ["Elevation", "Normals"])
            self.assertEqual(holder.Metric.ArrayName, "Elevation")
            holder.Metric = "Region"
            self.assertLess(math.dist(holder.Metric.Center, [5, 6, 7]), 1e-6)
        for holder in shown, filters[0]:
            tags = holder.GetProperty("DepthTagArrayName").GetAvailable()
            self.assertEqual(tags, ["DepthTag", "Elevation"])
            holder.Surface = "Phong Tessellation"
            self.assertEqual(
                holder.Surface.GetProperty("AlphaArrayName").GetAvailable(), ["", "Elevation"]
            )
            self.assertEqual(holder.Surface.AlphaArrayName, "")

    def test_streaks_on_surfaces(self):
        """Around an axis, values are similar along circles and differ between them."""
        sphere = simple.Sphere(ThetaResolution=60, PhiResolution=60)
        flow = with_vectors(sphere, "iHat*coordsY-jHat*coordsX")
        streaks = simple.SurfaceLineIntegralConvolution(Input=flow)
        self.assertEqual(list(streaks.Vectors), ["POINTS", "Flow"])
        values = point_values(streaks, "LIC")[2:].reshape(60, 58)  # poles first, then meridians
        self.assert_streaks(values, 0)

    def test_streaks_of_images(self):
        wavelet = simple.Wavelet(WholeExtent=[0, 40, 0, 40, 0, 0])
        streaks = simple.ImageLineIntegralConvolution(Input=with_vectors(wavelet, "iHat"))
        values = point_values(streaks, "LIC").reshape(41, 41)
        self.assert_streaks(values, 1)

    def test_geographic_vectors(self):
        """North in UTM zone 33, east of 15 E."""
        north = with_vectors(simple.Plane(), "jHat+2*kHat")
        turned = simple.GeographicVectors(Input=north, CoordinateSystem="EPSG:32633")
        turned.Origin = [660000.0, 5592500.0, 0.0]
        turned.Exaggeration = 3.0
        x, y, z = point_values(turned, "Flow")[0]
        # Convergence of the meridian 2.254 degrees east at 50.46 degrees north.
        convergence = math.atan(math.tan(math.radians(2.254)) * math.sin(math.radians(50.46)))
        self.assertAlmostEqual(math.atan2(x, y), -convergence, delta=2e-4)
        self.assertAlmostEqual(z, 6.0, places=5)

    def test_refinement(self):
        """Each face gives 4^level triangles, also in blocks."""
        sphere = simple.Sphere(ThetaResolution=8, PhiResolution=6)
        blocks = simple.GroupDatasets(Input=[sphere, simple.Sphere(Center=[2, 0, 0])])
        for source in sphere, blocks:
            source.UpdatePipeline()
            faces = source.GetDataInformation().GetNumberOfCells()
            for level in 0, 2:
                mesh = simple.AdaptiveRefinement(Input=source, MaximumLevel=level)
                mesh.UpdatePipeline()
                self.assertEqual(mesh.GetDataInformation().GetNumberOfCells(), faces * 4**level)

    def test_settings_act(self):
        """Properties of the chosen proxies take effect."""
        mesh = simple.AdaptiveRefinement(Input=simple.Sphere(), Metric="Region")

        def changes(proxy, name, value):
            mesh.UpdatePipeline()
            information = mesh.GetDataInformation()
            before = information.GetBounds(), information.GetNumberOfCells()
            setattr(proxy, name, value)
            mesh.UpdatePipeline()
            information = mesh.GetDataInformation()
            return before != (information.GetBounds(), information.GetNumberOfCells())

        self.assertTrue(changes(mesh.Metric, "Radius", 0.4))
        self.assertTrue(changes(mesh.Metric, "Center", [0.5, 0, 0]))
        self.assertTrue(changes(mesh, "MaximumLevel", 4))
        self.assertTrue(changes(mesh, "Surface", "PN Triangles"))
        mesh.Displacement = "Height Map"
        self.assertTrue(changes(mesh.Displacement, "Offset", 0.5))

    def test_depth_tags(self):
        """The refinement filter without a metric uses the tags of the tag filter."""
        sphere = simple.Sphere(ThetaResolution=16, PhiResolution=12)
        deformed = simple.Transform(Input=sphere)
        deformed.Transform.Scale = [1, 1, 3]
        tags = simple.DepthTags(Input=deformed, Metric="Curvature", MaximumLevel=3)
        tags.UpdatePipeline()
        low, high = tags.PointData["DepthTag"].GetRange()
        self.assertLess(low, high)
        self.assertLessEqual(high, 3)
        counts = []
        for properties in {"Input": tags}, {"Input": deformed, "Metric": "Curvature"}:
            mesh = simple.AdaptiveRefinement(MaximumLevel=3, **properties)
            mesh.UpdatePipeline()
            counts.append(mesh.GetDataInformation().GetNumberOfCells())
        self.assertEqual(*counts)

    def test_cells_without_points(self):
        """Valid faces are tagged. Faces with missing points cannot be refined."""
        for point in 3, -1, 10**9:
            source = simple.ProgrammableSource(
                OutputDataSetType="vtkPolyData", Script=MISSING_POINT.format(point=point)
            )
            for rule in "Per Vertex", "Per Edge":
                tags = simple.DepthTags(Input=source, Metric="Region", LevelRule=rule)
                levels = servermanager.Fetch(tags).GetCellData().GetArray("EdgeLevels")
                self.assertGreater(min(levels.GetTuple3(0)), 0)
                self.assertEqual(levels.GetTuple3(1), (-1, -1, -1))
            mesh = simple.AdaptiveRefinement(Input=source)
            with relevo.messages() as told:
                mesh.UpdatePipeline()
            self.assertIn(f"cell 1 refers to point {point}, but there are 3 points", told())
            self.assertEqual(mesh.GetDataInformation().GetNumberOfCells(), 0)

    def test_no_recipe(self):
        properties = {name: CHOICES[name][:2] for name in CHOICES}
        make = relevo.define_filter("WithoutRecipe", "vtkPAdaptiveRefinementFilter", properties)
        mesh = make(Input=simple.Sphere())
        for name, (_, _, label) in CHOICES.items():
            with relevo.messages() as told:
                setattr(mesh, name, label)
            self.assertIn("There is no recipe: call SetRefinement()", told())
        with relevo.messages() as told:
            mesh.UpdatePipeline()
        self.assertIn("There is no recipe: call SetRefinement()", told())
        self.assertEqual(mesh.GetDataInformation().GetNumberOfCells(), 0)

    def test_direction_of_displacement(self):
        """A zero direction is an error, even if displacement follows the normals."""
        mesh = simple.AdaptiveRefinement(Input=simple.Sphere(), Displacement="Height Map")
        mesh.Displacement.Offset = 1.0
        with relevo.messages() as told:
            mesh.Displacement.FixedDirection = [0, 0, 0]
        self.assertIn("FixedDirection must be a finite vector that is not zero", told())
        mesh.Displacement.AlongNormals = 0
        mesh.UpdatePipeline()
        bounds = mesh.GetDataInformation().GetBounds()
        self.assertLess(bounds[1], 0.6)
        self.assertGreater(bounds[4], 0.4)

    def test_composite_metric(self):
        """A composite takes the larger level of two metrics."""
        sphere = simple.Elevation(Input=simple.Sphere(ThetaResolution=16, PhiResolution=12))
        tags = simple.DepthTags(Input=sphere, MaximumLevel=5, Metric="Variation of an Array")
        tags.Metric.ArrayName = "Elevation"
        expected = point_values(tags, "DepthTag")
        tags.Metric = "Region"
        tags.Metric.Center = [0.5, 0, 0]
        expected = numpy.maximum(expected, 0.5 * point_values(tags, "DepthTag"))
        tags.Metric = "Composite"
        tags.Metric.First = "Variation of an Array"
        tags.Metric.First.ArrayName = "Elevation"
        tags.Metric.Second = "Region"
        tags.Metric.Second.Center = [0.5, 0, 0]
        first = point_values(tags, "DepthTag")
        tags.Metric.SecondWeight = 0.5
        numpy.testing.assert_allclose(point_values(tags, "DepthTag"), expected, atol=1e-5)
        self.assertGreater(abs(first - expected).max(), 0.1)

    def test_terrain(self):
        """The source gives a coarse mesh, which the displacement lifts."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "heights.png")
            relevo.write_heights(path)
            terrain = simple.TerrainSource(FileName=path, Resolution=8)
            terrain.UpdatePipeline()
            self.assertEqual(terrain.GetDataInformation().GetNumberOfCells(), 128)
            view = relevo.view()
            shown = relevo.show(terrain, view, MaximumLevel=3, Displacement="Height Map")
            shown.Displacement.HeightMapFileName = path
            shown.Displacement.AlongNormals = 0
            simple.ResetCamera(view)
            view.Update()
            bounds = view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds()
            self.assertGreaterEqual(bounds[5], 10)
            self.assertGreater(relevo.foreground(relevo.picture(view)), 1000)


if __name__ == "__main__":
    relevo.main()
