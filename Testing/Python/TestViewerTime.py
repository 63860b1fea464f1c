# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on results: formats with blocks and time steps, --time, --warp and --range."""

import unittest

from vtkmodules.vtkCommonCore import (
    vtkDoubleArray,
    vtkFloatArray,
    vtkIntArray,
    vtkPoints,
    vtkStringArray,
)
from vtkmodules.vtkCommonDataModel import (
    VTK_QUADRATIC_HEXAHEDRON,
    vtkGenericCell,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkRectilinearGrid,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLRectilinearGridWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUnstructuredGridWriter,
)
from vtkmodules.vtkImagingCore import vtkImageDifference

from ResultData import (
    CORNERS,
    DATA,
    TIMES,
    add_array,
    make_cube,
    write_list,
    write_series,
)
from ViewerProgram import ViewerProgram

SIZE = "--size=240x180"


class TestViewerTime(ViewerProgram):
    def write_series(self, name):
        write_series(self.folder, name)

    def export(self, *arguments):
        self.view(*arguments, "--export=e.vtp", "--surface=linear", "--level=0")
        return self.read_mesh("e.vtp")

    def read_mesh(self, name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        return reader.GetOutput()

    def read(self, name):
        reader = vtkPNGReader()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        return reader.GetOutput()

    def difference(self, one, other):
        compare = vtkImageDifference()
        compare.SetInputData(self.read(one))
        compare.SetImageData(self.read(other))
        compare.SetThreshold(0)
        compare.AllowShiftOff()
        compare.Update()
        return compare.GetThresholdedError()

    def test_time(self):
        """--time reads the nearest step."""
        self.write_series("a.pvd")
        for options, index in (
            ([], 0), (["--time=1"], 1), (["--time=2.4"], 1), (["--time=2.6"], 2), (["--time=4"], 2)
        ):
            mesh = self.export("a.pvd", "--array=Heat", *options)
            self.assertEqual(mesh.GetPointData().GetArray("Heat").GetRange(), (0.0, TIMES[index]))
        run = self.view("a.pvd", "--output=t.png", SIZE)
        self.assertIn("time step 1 of 3, time 0.25 of 0.25 to 4; --time T", run.stdout)
        run = self.run_program("a.pvd", "--time=5", "--output=t.png", SIZE)
        self.assertIn("warning: --time 5 is outside of the file's times", run.stderr)

    def test_frames(self):
        """There is a picture for each step, with the same colours."""
        self.write_series("b.pvd")
        for kind in (["--array=Heat"], ["--volume=Heat"]):
            self.view("b.pvd", "--output=frames/%02d.png", "--no-legend", SIZE, *kind)
            names = sorted(path.name for path in (self.folder / "frames").iterdir())
            self.assertEqual(names, ["00.png", "01.png", "02.png"])
            self.assertGreater(self.difference("frames/00.png", "frames/02.png"), 1000)
        self.view("b.pvd", "--output=frames/%02d.png", "--no-legend", SIZE, "--array=Heat")
        for i, time in enumerate(TIMES):
            options = ["--array=Heat", "--range=0,4", f"--time={time}", "--output=one.png"]
            self.view("b.pvd", "--no-legend", SIZE, *options)
            self.assertEqual(self.difference(f"frames/{i:02}.png", "one.png"), 0)

    def test_quantities(self):
        """Names such as "x of Move" stand for numbers that are computed from an array."""
        grid = make_cube()
        tensor = (3.0, 1.0, -2.0, 0.0, 0.0, 0.0)
        add_array(grid.GetPointData(), "Stress", [tensor] * 8)
        self.write_data("s.vtu", vtkXMLUnstructuredGridWriter, grid)
        for name, values in (
            ("von Mises of Stress", (19**0.5, 19**0.5)),
            ("tresca of Stress", (5.0, 5.0)),
            ("y of Move", (0.0, 1.0)),
        ):
            mesh = self.export("s.vtu", "--array", name)
            found = mesh.GetPointData().GetArray(name.replace("tresca", "Tresca")).GetRange()
            for value, wanted in zip(found, values):
                self.assertAlmostEqual(value, wanted)
        self.view("s.vtu", "--volume=y of Move", "--output=t.png", SIZE)
        note = "colours show the magnitude of the tensor 'Stress', which is not the von Mises stress"
        run = self.view("s.vtu", "--array=Stress", "--output=t.png", SIZE)
        self.assertIn(note, run.stdout)
        run = self.view("s.vtu", "--array=von Mises of Stress", "--output=t.png", SIZE)
        self.assertNotIn("magnitude", run.stdout)
        words = ("'von Mises of Move' needs an array with 6 or 9 components", "'Stress'")
        self.assert_error(1, words, "s.vtu", "--array=von Mises of Move", "--output=t.png")

    def test_palette(self):
        """--palette also colours arrays of meshes and volumes: black to white, without other hues."""
        self.write_series("p.pvd")
        for options in (["--array=Heat"], ["--volume=Heat", "--unit-distance=0.01"]):
            hues = {}
            for palette in ("viridis", "grey"):
                self.view(
                    "p.pvd", *options, f"--palette={palette}", "--no-legend", "--output=t.png", SIZE
                )
                reader = vtkPNGReader()
                reader.SetFileName(str(self.folder / "t.png"))
                reader.Update()
                middle = [reader.GetOutput().GetScalarComponentAsDouble(100, 90, 0, c) for c in range(3)]
                hues[palette] = max(middle) - min(middle)
            self.assertLess(hues["grey"], 12)
            self.assertGreater(hues["viridis"], 40)
        for name in ("one", "two"):
            size = {"one": "0,9", "two": "0,0.1"}[name]
            self.view("p.pvd", "--volume=Heat", f"--range={size}", f"--output={name}.png", SIZE)
        self.assertGreater(self.difference("one.png", "two.png"), 100)
        words = ("--palette requires colours by an array", "p.pvd has none")
        self.assert_error(1, words, "p.pvd", "--palette=grey", "--output=t.png")

    def test_warp(self):
        """--warp moves points by the factor times the array, also nodes of curved cells."""
        self.write_series("c.pvd")
        mesh = self.export("c.pvd", "--warp=Move", "--scale=0.5", "--time=4")
        for i in range(mesh.GetNumberOfPoints()):
            x, y, z = mesh.GetPoint(i)
            self.assertIn((x, y - 2.0 * x, z), CORNERS)
        run = self.view("c.pvd", "--warp=Move", "--scale=0.001", "--output=t.png", SIZE)
        self.assertIn("--scale 0.3 makes that 5 %", run.stdout)
        cell = vtkGenericCell.InstantiateCell(VTK_QUADRATIC_HEXAHEDRON)
        nodes = cell.GetParametricCoords()
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        for i in range(20):
            points.InsertNextPoint(nodes[3 * i : 3 * i + 3])
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, range(20))
        # x moves by z (1 - z), so that vertical edges become parabolas.
        moves = [(points.GetPoint(i)[2] * (1 - points.GetPoint(i)[2]), 0, 0) for i in range(20)]
        add_array(grid.GetPointData(), "Bend", moves)
        self.write_data("q.vtu", vtkXMLUnstructuredGridWriter, grid)
        self.view("q.vtu", "--warp=Bend", "--level=4", "--export=e.vtp")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "e.vtp"))
        reader.Update()
        mesh = reader.GetOutput()
        self.assertGreater(mesh.GetNumberOfPoints(), 500)
        bent = 0
        for i in range(mesh.GetNumberOfPoints()):
            x, y, z = mesh.GetPoint(i)
            base = x - z * (1 - z)
            self.assertTrue(-1e-6 < base < 1 + 1e-6)
            bent += abs(base) < 1e-6 and z not in (0.0, 1.0)
        self.assertGreater(bent, 100)

    def test_blocks(self):
        """Blocks are one mesh. An array that one lacks is NaN there."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_cube())
        blocks.SetBlock(1, make_cube(offset=2.0, names=["Move"]))
        self.write_data("d.vtm", vtkXMLMultiBlockDataWriter, blocks)
        mesh = self.export("d.vtm", "--array=Heat")
        self.assertEqual(mesh.GetNumberOfPolys(), 24)
        values = mesh.GetPointData().GetArray("Heat")
        for i in range(mesh.GetNumberOfPoints()):
            x, value = mesh.GetPoint(i)[0], values.GetValue(i)
            self.assertTrue(value != value if x > 1.5 else value == x, (x, value))
        mesh = self.export("d.vtm", "--warp=Move")
        self.assertEqual(mesh.GetBounds(), (0, 3, 0, 2, 0, 1))
        only = vtkMultiBlockDataSet()
        bare = make_cube(offset=2.0)
        bare.GetPointData().RemoveArray("Move")
        only.SetBlock(0, make_cube())
        only.SetBlock(1, bare)
        self.write_data("w.vtm", vtkXMLMultiBlockDataWriter, only)
        run = self.run_program("w.vtm", "--warp=Move", "--output=t.png", SIZE)
        self.assertIn("warning: 1 of 2 blocks have no array of points 'Move'", run.stderr)

    def write_blocks(self, name, *arrays):
        """Writes cubes side by side, each with an array "Load", and the second named "wing"."""
        blocks = vtkMultiBlockDataSet()
        for i, array in enumerate(arrays):
            cube = make_cube(offset=2.0 * i)
            array.SetName("Load")
            cube.GetPointData().AddArray(array)
            blocks.SetBlock(i, cube)
        blocks.GetMetaData(1).Set(blocks.NAME(), "wing")
        self.write_data(name, vtkXMLMultiBlockDataWriter, blocks)

    def fill(self, array, components=1):
        """Eight tuples of 0, 1, 2 and so on."""
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(8)
        for i in range(8 * components):
            array.SetValue(i, str(i // components) if array.IsA("vtkStringArray") else i // components)
        return array

    def test_blocks_that_differ(self):
        """The first block decides on an array. In blocks where it has another number of components,
        or is text, it is NaN, with a warning. Other types of numbers are kept."""
        pair, number, text = vtkDoubleArray, vtkIntArray, vtkStringArray
        double = "the array of points 'Load' has no values in block 2 'wing': it has 2 components there, "
        for arrays, warning, without in (
            ([(pair, 1), (pair, 2)], double + "but 1 component in block 1\n", {1}),
            ([(pair, 1), (pair, 2), (pair, 3)], "block 1, and 1 more block differs\n", {1, 2}),
            (
                [(pair, 1), (text, 1)],
                "in block 2 'wing': it is text there, but has 1 component in block 1\n",
                {1},
            ),
            ([(number, 1), (pair, 1), (vtkFloatArray, 1)], None, set()),
        ):
            with self.subTest(warning):
                self.write_blocks("b.vtm", *(self.fill(kind(), size) for kind, size in arrays))
                for more in [], ["--warp=Move"]:
                    flat = "--surface=linear", "--level=0"
                    run = self.run_program("b.vtm", "--array=Load", "--export=b.vtp", *flat, *more)
                    self.assertEqual(run.stderr.count("warning: "), 0 if warning is None else 1)
                    self.assertIn(warning or "", run.stderr)
                    mesh = self.read_mesh("b.vtp")
                    values = mesh.GetPointData().GetArray("Load")
                    for i in range(mesh.GetNumberOfPoints()):
                        block, value = int(mesh.GetPoint(i)[0] // 2), values.GetValue(i)
                        self.assertEqual(value != value, block in without, (block, value))

    def test_grids(self):
        """Images, rectilinear and structured grids have the surface of their cells."""
        image = vtkImageData()
        image.SetDimensions(3, 4, 2)
        rectilinear = vtkRectilinearGrid()
        rectilinear.SetDimensions(3, 4, 2)
        structured = vtkStructuredGrid()
        structured.SetDimensions(3, 4, 2)
        for i, setter in enumerate(("SetXCoordinates", "SetYCoordinates", "SetZCoordinates")):
            values = vtkDoubleArray()
            for x in range((3, 4, 2)[i]):
                values.InsertNextValue(x)
            getattr(rectilinear, setter)(values)
        points = vtkPoints()
        for i in range(24):
            points.InsertNextPoint(i % 3, i // 3 % 4, i // 12)
        structured.SetPoints(points)
        for name, writer, grid in (
            ("g.vti", vtkXMLImageDataWriter, image),
            ("g.vtr", vtkXMLRectilinearGridWriter, rectilinear),
            ("g.vts", vtkXMLStructuredGridWriter, structured),
        ):
            add_array(grid.GetPointData(), "Heat", [(i,) for i in range(24)])
            self.write_data(name, writer, grid)
            mesh = self.export(name)
            self.assertEqual(mesh.GetNumberOfPolys(), 2 * 2 * (2 * 3 + 2 * 1 + 3 * 1))
            self.assertEqual(mesh.GetBounds(), (0, 2, 0, 3, 0, 1))
            self.view(name, "--volume=Heat", "--output=v.png", SIZE)

    def test_results(self):
        """Results of other programs, in VTK's test data."""
        if not DATA.exists():
            self.skipTest("RELEVO_TEST_DATA is not set")
        for name, array, times, options in (
            ("mug.e", "convected", 21, []),
            ("ensight/LShape.case", "displacement", 11, ["--warp=displacement"]),
            ("ensight/blow2_bin.case", "thickness", 2, []),
            ("openfoam-cavity/case.foam", "p", 6, []),
        ):
            file = DATA / name
            run = self.run_program(file, "--output=r.png", f"--array={array}", SIZE, *options)
            if "cannot read" in run.stderr and "files; relevo-view reads" in run.stderr:
                continue # without a module of VTK
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(f"time step 1 of {times}, time 0", run.stdout)
        mesh = self.export("/".join((str(DATA), "mug.e")), "--time=2", "--array=convected")
        self.assertEqual(mesh.GetPointData().GetArray("convected").GetRange()[0], 0.0)

    def test_errors(self):
        self.write_series("e.pvd")
        cube = make_cube()
        self.write_data("one.vtu", vtkXMLUnstructuredGridWriter, cube)
        picture = ["--output=x.png"]
        self.assert_error(1, ["one.vtu has no time steps"], "one.vtu", "--time=1", *picture)
        self.assert_error(1, ["one.vtu has no time steps"], "one.vtu", "--output=%d.png")
        (self.folder / "heights.pgm").write_bytes(b"P5 2 2 255\n1234")
        self.assert_error(2, ["--output %d.png requires --flight"], "heights.pgm", "--output=%d.png")
        self.assert_error(2, ["--time cannot be combined"], "e.pvd", "--time=1", "--output=%d.png")
        self.assert_error(1, ["no array of points 'None'"], "e.pvd", "--warp=None", *picture)
        self.assert_error(1, ["3 components", "'Heat' has 1"], "e.pvd", "--warp=Heat", *picture)
        self.assert_error(2, ["--scale requires --height or --warp"], "e.pvd", "--scale=2", *picture)
        self.assert_error(2, ["--warp needs the name"], "e.pvd", "--warp=", *picture)
        bare = make_cube(names=["Move"])
        bare.GetPointData().RemoveArray("Move")
        self.write_data("bare.vtu", vtkXMLUnstructuredGridWriter, bare)
        self.assert_error(1, ["--range requires colours"], "bare.vtu", "--range=0,1", *picture)
        # An array that vanishes between time steps.
        write_list(self.folder, "v.pvd", ['<DataSet timestep="0" file="one.vtu"/>',
                                  '<DataSet timestep="1" file="bare.vtu"/>'])
        self.assert_error(
            1, ["no array 'Heat' with --time 1"], "v.pvd", "--array=Heat", "--output=f%d.png"
        )
        for name, entries, words in (
            ("m.pvd", ['<DataSet timestep="0" file="missing.vtu"/>'], "cannot read missing.vtu"),
            ("n.pvd", ['<DataSet timestep="0"/>'], "entry 1 of its Collection names no file"),
            ("t.pvd", ['<DataSet timestep="x" file="one.vtu"/>'], "the time of one.vtu is not a"),
            ("l.pvd", [], "it lists no files"),
        ):
            write_list(self.folder, name, entries)
            self.assert_error(1, [words], name, *picture)
        (self.folder / "x.pvd").write_text("<VTKFile><Other/></VTKFile>")
        self.assert_error(1, ["not XML with a Collection"], "x.pvd", *picture)
        (self.folder / "y.pvd").write_text("no XML")
        self.assert_error(1, ["cannot read y.pvd"], "y.pvd", *picture)
        for name in ("a.case", "a.cgns", "a.e", "a.foam", "a.vti", "a.vtkhdf", "a.vtm", "a.g"):
            (self.folder / name).write_bytes(b"this is no result\n")
            self.view(name, *picture, code=1)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTime"])
