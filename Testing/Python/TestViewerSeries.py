# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on further formats of results: series of ParaView, AMR, hyper tree grids and PLOT3D,
and on the message for formats that other programs convert."""

import json
import os
import pathlib
import struct
import unittest

from vtkmodules.vtkFiltersAMR import vtkAMRGaussianPulseSource
from vtkmodules.vtkFiltersSources import vtkRandomHyperTreeGridSource
from vtkmodules.vtkIOXML import (
    vtkXMLHyperTreeGridWriter,
    vtkXMLPolyDataReader,
    vtkXMLUniformGridAMRWriter,
    vtkXMLUnstructuredGridWriter,
)

from ResultData import TIMES, make_cube
from ViewerProgram import ViewerProgram

DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent") / "volume"
SIZE = "--size=240x180"


class TestViewerSeries(ViewerProgram):
    def export(self, *arguments):
        self.view(*arguments, "--export=e.vtp", "--surface=linear", "--level=0")
        return self.read_export()

    def read_export(self):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "e.vtp"))
        reader.Update()
        return reader.GetOutput()

    def write_series(self, name, entries):
        text = json.dumps({"file-series-version": "1.0", "files": entries})
        (self.folder / name).write_text(text)

    def test_series(self):
        """A .series file lists files with their times, in any order; without times, they count."""
        for i, time in enumerate(TIMES):
            self.write_data(f"c{i}.vtu", vtkXMLUnstructuredGridWriter, make_cube(time))
        entries = [{"name": f"c{i}.vtu", "time": time} for i, time in enumerate(TIMES)]
        self.write_series("a.vtu.series", entries[::-1])
        for time, wanted in ((0.25, 0.25), (3.0, 4.0)):
            mesh = self.export("a.vtu.series", "--array=Heat", f"--time={time}")
            self.assertEqual(mesh.GetPointData().GetArray("Heat").GetRange(), (0.0, wanted))
        self.write_series("b.vtu.series", [{"name": own["name"]} for own in entries])
        mesh = self.export("b.vtu.series", "--array=Heat", "--time=1")
        self.assertEqual(mesh.GetPointData().GetArray("Heat").GetRange(), (0.0, TIMES[1]))
        self.view("a.vtu.series", "--volume=Heat", "--output=v.png", SIZE)

    def test_bad_series(self):
        self.write_data("c.vtu", vtkXMLUnstructuredGridWriter, make_cube())
        for name, entries, words in (
            ("m.series", [{"name": "missing.vtu"}], "missing.vtu"),
            ("n.series", [{"time": 1}], "entry 1 of its files has no name"),
            ("t.series", [{"name": "c.vtu", "time": "x"}], "the time of c.vtu is not a number"),
            ("l.series", [], "it lists no files"),
            ("s.series", [{"name": "s.series"}], "a series cannot list another one"),
            ("f.series", [{"name": "c.txt"}], "c.txt"),
        ):
            self.write_series(name, entries)
            self.assert_error(1, [words], name, "--output=p.png", SIZE)
        (self.folder / "j.series").write_text("{")
        self.assert_error(1, ["it is not JSON with a list of files"], "j.series", "--output=p.png", SIZE)

    def test_amr(self):
        """All levels of AMR are drawn: squares of several sizes."""
        source = vtkAMRGaussianPulseSource()
        source.SetDimension(3)
        source.Update()
        writer = vtkXMLUniformGridAMRWriter()
        writer.SetFileName(str(self.folder / "a.vth"))
        writer.SetInputData(source.GetOutput())
        writer.Write()
        mesh = self.export("a.vth")
        areas = {round(mesh.GetCell(i).ComputeArea(), 6) for i in range(mesh.GetNumberOfCells())}
        self.assertGreater(len(areas), 1)
        self.view("a.vth", "--volume=Gaussian-Pulse", "--output=v.png", SIZE)

    def test_hyper_tree_grid(self):
        """The leaves are hexahedra of several sizes."""
        source = vtkRandomHyperTreeGridSource()
        source.SetDimensions(3, 3, 3)
        source.SetMaxDepth(3)
        source.SetSeed(5)
        source.Update()
        writer = vtkXMLHyperTreeGridWriter()
        writer.SetFileName(str(self.folder / "h.htg"))
        writer.SetInputData(source.GetOutput())
        writer.Write()
        mesh = self.export("h.htg")
        areas = {round(mesh.GetCell(i).ComputeArea(), 6) for i in range(mesh.GetNumberOfCells())}
        self.assertGreater(len(areas), 1)
        bounds = source.GetOutput().GetBounds()
        for one, other in zip(mesh.GetBounds(), bounds):
            self.assertAlmostEqual(one, other, places=5)
        self.view("h.htg", "--volume=Depth", "--output=v.png", SIZE)

    def test_plot3d(self):
        """Binary grids are recognized by their length, in both byte orders, with their solution."""
        dimensions = (4, 3, 2)
        places = [
            (x, y, z) for z in range(2) for y in range(3) for x in range(4)
        ]
        for order in "<>":
            for name in ("g.xyz", "g.x", "gxyz.bin"):
                with self.subTest(order=order, name=name):
                    numbers = [place[axis] for axis in range(3) for place in places]
                    grid = struct.pack(f"{order}3i72f", *dimensions, *numbers)
                    (self.folder / name).write_bytes(grid)
                    mesh = self.export(name)
                    self.assertEqual(mesh.GetBounds(), (0, 3, 0, 2, 0, 1))
                    self.assertEqual(mesh.GetNumberOfCells(), 4 * (3 * 2 + 3 * 1 + 2 * 1))  # triangles
        values = [1.0 + place[0] for place in places] + 96 * [1.0]
        solution = struct.pack(">3i4f120f", *dimensions, 0, 0, 0, 0, *values)
        (self.folder / "gq.bin").write_bytes(solution)
        mesh = self.export("gxyz.bin", "--array=Density")
        self.assertEqual(mesh.GetPointData().GetArray("Density").GetRange(), (1.0, 4.0))
        # One byte more: no grid, so a height map, which it is not either.
        (self.folder / "h.bin").write_bytes(grid + b"0")
        self.assert_error(1, ["h.bin"], "h.bin", "--output=p.png", SIZE)

    def test_real_plot3d(self):
        if not DATA.exists():
            self.skipTest("no RELEVO_TEST_DATA")
        for name in ("bluntfinxyz.bin", "postxyz.bin"):
            # Some of their cells have coincident corners, with a warning.
            run = self.run_program(DATA / name, "--array=Pressure", "--export=e.vtp", "--level=0")
            self.assertEqual(run.returncode, 0)
            low, high = self.read_export().GetPointData().GetArray("Pressure").GetRange()
            self.assertLess(low, high)

    def test_converted_formats(self):
        for name, program in (("a.msh", "Gmsh"), ("a.mesh", "MEDIT"), ("a.med", "MED")):
            (self.folder / name).write_text("MeshVersionFormatted 1\n")
            words = [f"no reader for files of {program}", f"meshio convert {name} a.vtu"]
            self.assert_error(1, words, name, "--output=p.png", SIZE)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerSeries"])
