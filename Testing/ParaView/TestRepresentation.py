# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: the representation Adaptive Refinement equals Surface, and the filter's mesh.
"""

import os
import re
import tempfile

import numpy
from paraview import servermanager, simple, smstate

import RelevoParaView as relevo
from RelevoParaView import sphere

OWN = "vtk(Adaptive|Terrain|Relief)"  # classes of the plugin's representations


def data_sets():
    """Sources of all types of data that the plugin's representations are offered for."""
    wavelet = simple.Wavelet(WholeExtent=[0, 6, 0, 5, 0, 4])
    return {
        "image": wavelet,
        "unstructured": simple.Tetrahedralize(Input=wavelet),
        "structured": simple.Transform(Input=wavelet),
        "polygons": sphere(),
        "blocks": simple.GroupDatasets(Input=[sphere(), sphere(Center=[1, 0, 0])]),
        "refined grids": simple.AMRGaussianPulseSource(),
        "trees": simple.HyperTreeGridRandom(),
    }


def parts(shown):
    """The representations that the types of a representation stand for."""
    composite = shown.GetClientSideObject()
    active, result = composite.GetActiveRepresentationKey(), {}
    for each in *shown.GetProperty("Representation").Available, active:
        composite.SetActiveRepresentation(each)
        result[composite.GetActiveRepresentation()] = True
    return list(result)


class TestRepresentation(relevo.TestCase):
    def test_every_data_set(self):
        """With a curved surface; at level 0 it equals Surface exactly."""
        for name, source in data_sets().items():
            with self.subTest(name):
                self.compare(source, MaximumLevel=0, Metric="None")

    def test_looks(self):
        looks = {
            "colour": lambda r: setattr(r, "DiffuseColor", [0.2, 0.6, 0.9]),
            "opacity": lambda r: setattr(r, "Opacity", 0.4),
            "transform": lambda r: setattr(r, "Orientation", [20, 30, 40]),
            "backface": lambda r: setattr(r, "BackfaceRepresentation", "Cull Frontface"),
            "specular": lambda r: setattr(r, "Specular", 0.7),
        }
        for name, prepare in looks.items():
            with self.subTest(name):
                self.compare(sphere(), prepare=prepare, MaximumLevel=0, Metric="None")

    def test_colours(self):
        """Colours by point and cell arrays."""
        points = simple.Elevation(Input=sphere())
        cells = simple.PointDatatoCellData(Input=points)
        for source, association in (points, "POINTS"), (cells, "CELLS"):
            with self.subTest(association):
                self.compare(
                    source,
                    prepare=lambda r: simple.ColorBy(r, (association, "Elevation")),
                    MaximumLevel=0,
                    Metric="None",
                )

    def test_the_filter_is_its_twin(self):
        for surface in "PN Triangles", "Phong Tessellation", "G1":
            mesh = simple.AdaptiveRefinement(Input=sphere(), MaximumLevel=3, Surface=surface)
            with self.subTest(surface):
                self.compare(
                    sphere(), 20, mesh, MaximumLevel=3, Metric="None", Surface=surface
                )

    def test_bounds_of_what_is_displaced(self):
        """Resetting a view includes the largest displacement."""
        view = relevo.view()
        shown = relevo.show(sphere(), view, Metric="None", Displacement="Height Map")
        shown.Displacement.Offset = 2.0
        simple.ResetCamera(view)
        view.Update()
        bounds = view.GetClientSideObject().GetRenderer().ComputeVisiblePropBounds()
        self.assertLess(bounds[0], -2.3)
        self.assertGreater(bounds[1], 2.3)
        picture = relevo.picture(view)
        border = [picture[0], picture[-1], picture[:, 0], picture[:, -1]]
        self.assertTrue(all((line == picture[0, 0]).all() for line in border))
        self.assertGreater(relevo.foreground(picture), 5000)

    def test_settings_act_live(self):
        view = relevo.view()
        shown = relevo.show(sphere(), view, MaximumLevel=4, Metric="None")
        simple.ResetCamera(view)
        pictures = [relevo.picture(view)]
        for name, value in (
            ("Surface", "PN Triangles"),
            ("RefinementColorMode", "Pattern"),
            ("Metric", "Silhouette"),
            ("MaximumLevel", 3),
            ("LevelOffset", -1.0),
            ("TargetNumberOfTriangles", 400),
        ):
            setattr(shown, name, value)
            pictures.append(relevo.picture(view))
            self.assertGreater(relevo.differing(*pictures[-2:], 0), 20, name)

    def test_blocks(self):
        """Visibility, colour and opacity of blocks."""
        left = sphere(registrationName="Left")
        right = sphere(registrationName="Right", Center=[1.2, 0, 0])
        blocks = simple.GroupDatasets(Input=[left, right])

        def hide(representation):
            representation.BlockSelectors = ["/Root/Left"]

        def colour(representation):
            representation.BlockColors = ["/Root/Right", "1", "0", "0"]

        def fade(representation):
            representation.BlockOpacities = ["/Root/Right", "0.3"]

        for prepare in hide, colour, fade:
            with self.subTest(prepare.__name__):
                self.compare(blocks, prepare=prepare, MaximumLevel=0, Metric="None")

    def test_selection(self):
        """A rectangle selects cells with the same ids as in Surface."""
        found = []
        for representation in "Surface", "Adaptive Refinement":
            view = relevo.view()
            source = sphere()
            relevo.show(source, view, representation)
            simple.ResetCamera(view)
            simple.Render(view)
            simple.SetActiveSource(source)
            simple.SelectSurfaceCells(Rectangle=[100, 60, 200, 140], View=view)
            selection = servermanager._getPyProxy(source.GetSelectionInput(0))
            found.append(list(selection.Input[0].IDs))
        self.assertGreater(len(found[0]), 5)
        self.assertEqual(*found)

    def test_streaks(self):
        """Adaptive LIC shows streaks, with the settings of Surface LIC and of the recipe."""
        flow = simple.Calculator(Input=sphere(), ResultArrayName="Flow")
        flow.Function = "iHat*coordsY-jHat*coordsX+kHat"
        view = relevo.view()
        shown = relevo.show(flow, view)
        simple.ResetCamera(view)
        smooth = relevo.picture(view)
        shown.SelectInputVectors = ["POINTS", "Flow"]
        shown.Representation = "Adaptive LIC"
        pictures = [smooth, relevo.picture(view)]
        self.assertGreater(relevo.differing(*pictures), relevo.foreground(smooth) / 2)
        noise = os.path.join(self.make_folder(), "noise.png")
        relevo.write_png(noise, numpy.random.default_rng(1).integers(0, 255, (64, 64), numpy.uint8))
        for name, value in (
            ("NumberOfSteps", 10),
            ("NoiseFileName", noise),
            ("OrientedLIC", 1),
            ("Surface", "PN Triangles"),
            ("MaximumLevel", 1),
        ):
            setattr(shown, name, value)
            pictures.append(relevo.picture(view))
            self.assertGreater(relevo.differing(*pictures[-2:]), 20, name)

    def test_panel(self):
        """The proxy has the settings of streaks for Surface LIC and for Adaptive LIC."""
        proxy = relevo.show(sphere(), relevo.view()).SMProxy
        groups = {}  # the last entry of a property is used
        for group in map(proxy.GetPropertyGroup, range(proxy.GetNumberOfPropertyGroups())):
            for i in range(group.GetNumberOfProperties()):
                groups[group.GetPropertyName(i)] = group

        def values(element):
            for each in map(element.GetNestedElement, range(element.GetNumberOfNestedElements())):
                yield from [each.GetAttribute("value")] if each.GetAttribute("value") else values(each)

        for names, expected in (
            (("MaximumLevel", "Metric", "Method"), {"Adaptive Refinement", "Adaptive LIC"}),
            (("OrientedLIC", "Phase"), {"Adaptive LIC"}),
            (
                ("SelectInputVectors", "StepSize", "LICIntensity", "MaskColor", "NoiseType"),
                {"Adaptive LIC", "Surface LIC"},
            ),
        ):
            for name in names:
                self.assertLessEqual(expected, set(values(groups[name].GetHints())), name)

    def test_one_error_for_a_bad_height_map(self):
        view = relevo.view()
        shown = relevo.show(sphere(), view, MaximumLevel=1, Displacement="Height Map")
        errors = []
        displacement = shown.Displacement.SMProxy.GetClientSideObject()
        displacement.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
        shown.Displacement.HeightMapFileName = __file__
        for _ in range(2):
            simple.Render(view)
        self.assertEqual(len(errors), 1)

    def test_inactive(self):
        """Of the representations of the data, the plugin's run only if chosen, and print nothing."""
        sources = data_sets()
        table = simple.Histogram(Input=sources["image"])
        sources["table in blocks"] = simple.GroupDatasets(Input=[sphere(), table])
        for name, source in sources.items():
            view, ran = relevo.view((60, 40)), set()
            with self.subTest(name), relevo.messages() as told:
                shown = simple.Show(source, view)
                for part in parts(shown):
                    note = lambda caller, _: ran.add(caller.GetClassName())
                    part.AddObserver("UpdateDataEvent", note)
                for each in "Outline", "Surface":
                    shown.Representation = each
                    shown.Opacity = 0.9
                    simple.Render(view)
                    shown.UpdatePipelineInformation()  # a change of a file name does this
                    shown.UpdatePipeline()
                self.assertNotRegex(told(), OWN)  # ParaView's own report errors for trees
                self.assertTrue(ran)
                self.assertEqual([each for each in ran if re.match(OWN, each)], [])
            simple.Delete(view)

    def test_state_files(self):
        view = relevo.view()
        shown = relevo.show(sphere(), view, MaximumLevel=3, Metric="Composite", Surface="PN Triangles")
        shown.RefinementColorMode = "Level"
        shown.Metric.First = "Silhouette"
        shown.Metric.Second = "Curvature"
        shown.Metric.Second.Quantiles = [0.1, 0.8]
        shown.Metric.SecondWeight = 0.7
        simple.ResetCamera(view)
        expected = relevo.picture(view)
        script = smstate.get_state()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "state.pvsm")
            simple.SaveState(path)
            loads = (lambda: simple.LoadState(path)), (lambda: exec(script, {"__name__": "state"}))
            for load in loads:
                relevo.clear()
                load()
                view = simple.GetActiveViewOrCreate("RenderView")
                self.assertEqual(relevo.differing(relevo.picture(view), expected, 0), 0)


if __name__ == "__main__":
    relevo.main()
