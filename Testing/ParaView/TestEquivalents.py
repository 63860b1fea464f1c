# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md on replacing Warp By Scalar, Extrusion Surface, Surface LIC and Volume."""

import glob
import os
import pathlib
import re
import tempfile

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import RelevoParaView as relevo


PAGE = pathlib.Path(__file__).parents[2] / "Module" / "Documentation" / "paraview.md"
# Of all representations, or not in the panel.
INTERNAL = {"Input", "Visibility", "DummyInput", "ForceUseCache", "ForcedCacheKey"}


def read_section(title):
    """The section of the page whose title begins like this."""
    section = PAGE.read_text(encoding="utf-8").split(f"\n## {title}", 1)[1]
    return section.split("\n## ", 1)[0]


def find_unnamed(names, section):
    return sorted(name for name in names if not re.search(rf"`{name}`", section))


def settable(proxy):
    """The names of the properties of a proxy that users set."""
    iterator = proxy.NewPropertyIterator()
    names = set()
    iterator.Begin()
    while not iterator.IsAtEnd():
        if not iterator.GetProperty().GetInformationOnly():
            names.add(iterator.GetKey())
        iterator.Next()
    return names - INTERNAL


def points(source):
    return vtk_to_numpy(servermanager.Fetch(source).GetPoints().GetData())


class TestEquivalents(relevo.TestCase):
    def test_warp_by_scalar(self):
        """Points at texel centres have the same positions."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "heights.png")
            heights = numpy.random.default_rng(1).integers(0, 1000, (17, 17))
            relevo.write_png(path, heights.astype(numpy.uint16))
            image = simple.PNGSeriesReader(FileNames=[path])
            terrain = simple.TerrainSource(FileName=path, Resolution=17)
            flat = points(simple.AdaptiveRefinement(Input=terrain, MaximumLevel=1))
            numbers = {tuple(each): i for i, each in enumerate(numpy.round(2 * flat).astype(int))}
            for scale, normal in (0.01, [0, 0, 1]), (-0.02, [0, 0.6, 0.8]):
                warped = simple.WarpByScalar(Input=image, ScaleFactor=scale, Normal=normal)
                warped.Scalars = ["POINTS", "PNGImage"]
                raised = simple.AdaptiveRefinement(Input=terrain, MaximumLevel=1)
                raised.Displacement = "Height Map"
                relevo.set_properties(raised.Displacement, {
                    "HeightMapFileName": path,
                    "Scale": scale,
                    "AlongNormals": 0,
                    "FixedDirection": normal,
                })
                found = points(raised)
                for i, expected in enumerate(points(warped) - [8, 8, 0]):
                    row, column = divmod(i, 17)
                    number = numbers[2 * (column - 8), 2 * (row - 8), 0]
                    self.assertLess(abs(found[number] - expected).max(), 1e-4)

    def test_extrusion_surface(self):
        """A sphere of length 1 is displaced by 20 percent of it."""
        plugin = relevo.find_plugin("EmbossingRepresentations")
        if not plugin:
            self.skipTest("this ParaView has no Extrusion Surface")
        simple.LoadPlugin(plugin, remote=False, ns=globals())
        resolution = {"ThetaResolution": 24, "PhiResolution": 24}
        source = simple.Calculator(Input=simple.Sphere(**resolution), Function="1")
        sources = source, source, simple.Sphere(Radius=0.7, **resolution)
        names = "Extrusion Surface", "Adaptive Refinement", "Surface"
        views = [relevo.view() for _ in names]
        shown = [relevo.show(*each) for each in zip(sources, views, names)]
        relevo.set_properties(shown[0], {
            "ExtrusionInputDataArray": ["POINTS", "Result"],
            "ExtrusionNormalizeData": 0,
            "ExtrusionFactor": 20,
        })
        relevo.set_properties(shown[1], {"Metric": "None", "MaximumLevel": 0})
        shown[1].Displacement = "Height Map"
        shown[1].Displacement.Offset = 0.2
        for view in views:
            relevo.picture(view)  # ParaView moves the camera in the first frame of a session
        simple.ResetCamera(views[2])
        for view in views[1::-1]:
            relevo.copy_camera(views[2], view)
            if view is views[0] and relevo.foreground(relevo.picture(view)) == 0:
                self.skipTest("this ParaView's Extrusion Surface draws nothing")
            self.assert_same_picture(view, views[2], 100)

    def test_volume(self):
        """The page names the properties of Volume that Adaptive Volume does not have."""
        manager = servermanager.ProxyManager()
        ours = settable(manager.GetPrototypeProxy("representations", "AdaptiveVolumeRepresentation"))
        section = read_section("Coming from Volume")
        for name in "UnstructuredGridVolumeRepresentation", "UniformGridVolumeRepresentation":
            theirs = settable(manager.GetPrototypeProxy("representations", name))
            self.assertGreater(len(theirs & ours), 12)
            self.assertGreater(len(theirs - ours), 2)
            self.assertEqual(find_unnamed(theirs - ours, section), [], name)

    def test_properties_of_warp_by_scalar(self):
        names = simple.WarpByScalar(Input=simple.Wavelet()).ListProperties()
        names = [name for name in names if name not in INTERNAL]
        self.assertGreaterEqual(len(names), 5)
        self.assertEqual(find_unnamed(names, read_section("Coming from Warp By Scalar")), [])

    def test_surface_lic(self):
        """All its settings are available, except for these."""
        shown = relevo.show(simple.Sphere(), relevo.view()).SMProxy
        groups = map(shown.GetPropertyGroup, range(shown.GetNumberOfPropertyGroups()))
        names = {
            group.GetPropertyName(i)
            for group in groups
            if group.GetXMLLabel().startswith("SurfaceLIC:")
            for i in range(group.GetNumberOfProperties())
        }
        self.assertGreater(len(names), 25)
        ours = servermanager.ProxyManager().NewProxy("representations", "AdaptiveLICRepresentation")
        missing = {name for name in names if not ours.GetProperty(name)}
        self.assertEqual(missing, {"CompositeStrategy", "UseLICForLOD", "WriteLog"})


if __name__ == "__main__":
    relevo.main()
