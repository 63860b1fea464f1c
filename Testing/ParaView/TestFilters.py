# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The filters Adaptive Refinement and Depth Tags, and the source Terrain."""

import os
import tempfile

from paraview import simple

import RelevoParaView as relevo


class TestFilters(relevo.TestCase):
    def test_refinement(self):
        """4^level triangles for each face, also for blocks."""
        sphere = simple.Sphere(ThetaResolution=8, PhiResolution=6)
        blocks = simple.GroupDatasets(Input=[sphere, simple.Sphere(Center=[2, 0, 0])])
        for source in sphere, blocks:
            source.UpdatePipeline()
            faces = source.GetDataInformation().GetNumberOfCells()
            for level in 0, 2:
                mesh = simple.AdaptiveRefinement(Input=source, MaximumLevel=level)
                mesh.UpdatePipeline()
                self.assertEqual(mesh.GetDataInformation().GetNumberOfCells(), faces * 4**level)

    def test_depth_tags(self):
        """What the filter tags, refinement without a metric takes up."""
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

    def test_terrain(self):
        """A coarse mesh, which the displacement lifts."""
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
