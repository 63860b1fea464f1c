# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: selections on Adaptive Refinement have the ids, blocks and processes of
Surface."""

from paraview import servermanager, simple

import RelevoParaView as relevo
from RelevoParaView import sphere

RECTANGLE = {"Rectangle": [100, 60, 200, 140]}
POLYGON = {"Polygon": [100, 60, 200, 60, 200, 140, 130, 150]}
SELECTIONS = {
    "cells": (simple.SelectSurfaceCells, RECTANGLE),
    "points": (simple.SelectSurfacePoints, RECTANGLE),
    "points in a polygon": (simple.SelectSurfacePoints, POLYGON),
    "cells in a frustum": (simple.SelectCellsThrough, RECTANGLE),
    "blocks": (simple.SelectSurfaceBlocks, RECTANGLE),
}


def selected(source):
    """The contents of a source's selection, without the number of its proxy."""
    selection = servermanager._getPyProxy(source.GetSelectionInput(0))
    names = ("IDs", "Frustum", "Blocks", "BlockSelectors")
    return [
        (each.SMProxy.GetXMLName(), name, list(getattr(each, name)))
        for each in selection.Input
        for name in names
        if hasattr(each, name)
    ]


class TestSelection(relevo.TestCase):
    def select_all(self, source, names, representation, azimuth, **properties):
        view = relevo.view()
        relevo.show(source, view, representation, **properties)
        relevo.picture(view)
        view.GetActiveCamera().Azimuth(azimuth)
        simple.ResetCamera(view)
        relevo.picture(view)
        simple.SetActiveSource(source)
        found = {}
        for name in names:
            simple.ClearSelection(source)
            select, region = SELECTIONS[name]
            select(View=view, **region)
            found[name] = selected(source)
        return found

    def compare_selections(self, source, names, level, azimuth=0):
        expected = self.select_all(source, names, "Surface", azimuth)
        refined = self.select_all(
            source,
            names,
            "Adaptive Refinement",
            azimuth,
            MaximumLevel=level,
            Metric="None",
        )
        for name, selection in expected.items():
            with self.subTest(name):
                self.assertTrue(selection and len(selection[0][2]) > 0)
                self.assertEqual(refined[name], selection)

    def test_mesh(self):
        """Selects coarse cells and points at every level."""
        self.compare_selections(sphere(), [name for name in SELECTIONS if name != "blocks"], 2)

    def test_volume(self):
        """Faces have the ids of the cells that they bound."""
        wavelet = simple.Wavelet(WholeExtent=[0, 8, 0, 8, 0, 8])
        # From the side, no points are in line with the centres of pixels.
        mesh = simple.Tetrahedralize(Input=wavelet)
        self.compare_selections(mesh, ["cells", "points"], 0, azimuth=20)

    def test_blocks(self):
        spheres = [sphere(), sphere(Center=[1.2, 0, 0])]
        for kind in "vtkMultiBlockDataSet", "vtkPartitionedDataSetCollection":
            with self.subTest(kind):
                blocks = simple.GroupDatasets(Input=spheres, OutputType=kind)
                self.compare_selections(blocks, ["cells", "blocks"], 1)


if __name__ == "__main__":
    relevo.main()
