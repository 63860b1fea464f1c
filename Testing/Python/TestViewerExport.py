# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on relevo-view --export: a terrain's arrays and location, read back by VTK, and
binary files."""

import os
import pathlib
import struct
import unittest

import relevo
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ViewerProgram import ViewerProgram

RELIEF = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent", "relief")
COLUMNS, ROWS = 24, 16


class TestViewerExport(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = cls.folder / "heights.pgm"
        samples = bytes((7 * i * j + 3 * i) % 200 for j in range(ROWS) for i in range(COLUMNS))
        cls.heights.write_bytes(b"P5 %d %d 255\n" % (COLUMNS, ROWS) + samples)

    def export(self, file, name, *arguments):
        self.view(file, "--export", name, *arguments)
        reader = (vtkSTLReader if name.endswith(".stl") else vtkXMLPolyDataReader)()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        return reader.GetOutput()

    def assert_terrain(self, mesh, file, exaggeration):
        """The mesh has the location of the source's terrain and the heights of its height map."""
        source = relevo.vtkTerrainSource()
        source.SetFileName(str(file))
        source.Update()
        data = mesh.GetFieldData()
        self.assertEqual(data.GetArray("Origin").GetTuple3(0), source.GetOrigin())
        system = data.GetAbstractArray("CoordinateSystem")
        self.assertIsInstance(system, vtkStringArray)
        self.assertEqual(system.GetValue(0), source.GetCoordinateSystem())
        heights = mesh.GetPointData().GetArray("Height")
        coordinates = mesh.GetPointData().GetTCoords()
        self.assertEqual(heights.GetNumberOfTuples(), mesh.GetNumberOfPoints())
        for i in range(mesh.GetNumberOfPoints()):
            height = heights.GetValue(i)
            self.assertAlmostEqual(
                height, source.GetHeightMap().GetHeight(*coordinates.GetTuple2(i)), places=2
            )
            self.assertAlmostEqual(mesh.GetPoint(i)[2], exaggeration * height, delta=0.05)
        return source

    def test_terrain(self):
        for exaggeration in (3, 0):
            mesh = self.export(
                self.heights, "t.vtp", f"--exaggeration={exaggeration}", "--level=2", "--resolution=6"
            )
            self.assertEqual(mesh.GetNumberOfCells(), 2 * 6 * 4 * 16)
            source = self.assert_terrain(mesh, self.heights, exaggeration)
            # Texels without georeference.
            self.assertEqual(source.GetOrigin(), (COLUMNS / 2, ROWS / 2, 0))
            self.assertGreater(mesh.GetPointData().GetArray("Height").GetRange()[1], 150)

    def test_georeferenced_terrain(self):
        file = RELIEF / "luxembourg_elev.tif"
        if not file.exists():
            self.skipTest("no relief in RELEVO_TEST_DATA")
        mesh = self.export(file, "g.vtp", "--exaggeration=2", "--level=1", "--resolution=12")
        source = self.assert_terrain(mesh, file, 2)
        if source.GetCoordinateSystem():  # needs GDAL
            self.assertIn("WGS 84", source.GetCoordinateSystem())
            longitude, latitude, _ = source.GetOrigin()
            self.assertTrue(5.7 < longitude < 6.6 and 49.4 < latitude < 50.2)

    def test_binary_stl(self):
        mesh = self.export(self.heights, "t.stl", "--level=1", "--resolution=6")
        triangles = 2 * 6 * 4 * 4
        self.assertEqual(mesh.GetNumberOfCells(), triangles)
        written = (self.folder / "t.stl").read_bytes()
        self.assertEqual(len(written), 84 + 50 * triangles)
        self.assertEqual(struct.unpack("<I", written[80:84])[0], triangles)
        same = self.export(self.heights, "t.vtp", "--level=1", "--resolution=6")
        for one, other in zip(mesh.GetBounds(), same.GetBounds()):
            self.assertAlmostEqual(one, other, places=4)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerExport"])
