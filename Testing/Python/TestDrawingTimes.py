# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves python.md: drawings of results with blocks and time steps, in all formats of relevo-view."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

from DrawingData import make_sphere, numpy, read_picture, relevo
from ResultData import DATA, TIMES, add_array, make_cube, write_list, write_series
from relevo import _drawing, _results
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkRectilinearGrid,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersAMR import vtkAMRGaussianPulseSource
from vtkmodules.vtkFiltersSources import vtkRandomHyperTreeGridSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkBYUWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPUnstructuredGridWriter
from vtkmodules.vtkIOXML import (
    vtkXMLHyperTreeGridWriter,
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLRectilinearGridWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUniformGridAMRWriter,
    vtkXMLUnstructuredGridWriter,
)


class CubeSource(VTKPythonAlgorithmBase):
    """An algorithm with time steps."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")

    def RequestInformation(self, request, inputs, outputs):
        keys = vtkStreamingDemandDrivenPipeline
        outputs.GetInformationObject(0).Set(keys.TIME_STEPS(), TIMES, len(TIMES))
        outputs.GetInformationObject(0).Set(keys.TIME_RANGE(), (TIMES[0], TIMES[-1]), 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        key = vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()
        information = outputs.GetInformationObject(0)
        time = information.Get(key) if information.Has(key) else TIMES[0]
        vtkUnstructuredGrid.GetData(outputs).ShallowCopy(make_cube(time))
        return 1


def get_largest(drawing):
    """The largest value on the colour bar."""
    return drawing._table.GetRange()[1]


class TestDrawingTimes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        caught = warnings.catch_warnings(record=True)
        self.warnings = caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("always")

    def write(self, name, writer, data):
        writer = writer()
        writer.SetFileName(str(self.folder / name))
        writer.SetInputData(data)
        self.assertEqual(writer.Write(), 1)
        return self.folder / name

    def write_list(self, name, entries):
        return write_list(self.folder, name, entries)

    def write_series(self, name):
        return write_series(self.folder, name)

    def test_times(self):
        """All functions draw the nearest step, of a file and of an algorithm."""
        for source in (str(self.write_series("a.pvd")), self.folder / "a.pvd", CubeSource()):
            self.assertEqual(relevo.times(source), TIMES)
            for time, found in ((1, 1.0), (2.4, 1.0), (2.6, 4.0), (0.25, 0.25)):
                self.assertEqual(get_largest(relevo.volume(source, "Heat", time=time)), found)
                drawing = relevo.patches(source, scalars="Heat", warp="Move", time=time)
                self.assertEqual(get_largest(drawing), found)
                self.assertEqual(drawing._coarse.GetBounds()[3], 1.0 + found)
                self.assertEqual(get_largest(relevo.lic(source, "Move", time=time)), found)
                mesh = relevo.refined(source, time=time).mesh()
                self.assertEqual(mesh.GetPointData().GetArray("Heat").GetRange()[1], found)
        self.assertEqual(get_largest(relevo.volume(self.folder / "a.pvd", "Heat")), TIMES[0])
        first, second = (relevo.volume(source, "Heat", time=own).mesh() for own in (1, 4))
        self.assertEqual(first.GetPointData().GetArray("Heat").GetRange()[1], 1.0)
        self.assertEqual(second.GetPointData().GetArray("Heat").GetRange()[1], 4.0)
        self.assertEqual(self.warnings, [])
        self.assertEqual(get_largest(relevo.volume(self.folder / "a.pvd", "Heat", time=9)), 4.0)
        self.assertIn("time 9 is outside of the times of", str(self.warnings.pop().message))

    def test_labels(self):
        """A label shows the time of the step, as in relevo-view, if there are several."""
        path = self.write_series("a.pvd")
        size = (320, 200)
        for make, options in (
            (relevo.refined, {"scalars": "Heat"}), (relevo.volume, {"array": "Heat"}),
            (relevo.patches, {"scalars": "Heat"}), (relevo.lic, {}), (relevo.streamlines, {}),
        ):
            first = make(path, **options)
            shown = [make(path, **options, time=time) for time in TIMES]
            self.assertEqual([own._time for own in (first, *shown)], [TIMES[0], *TIMES])
            corner = [own.screenshot(size=size)[:40, 200:] for own in (first, *shown)]
            numpy.testing.assert_array_equal(corner[0], corner[1])
            for one, other in ((1, 2), (2, 3)):
                difference = abs(corner[one].astype(int) - corner[other]).max(axis=2)
                self.assertGreater((difference > 40).sum(), 20, make.__name__)
        self.assertEqual(relevo.refined(CubeSource(), time=1)._time, 1.0)
        only = write_list(self.folder, "one.pvd", ['<DataSet timestep="3" file="a.pvd-0.vtu"/>'])
        for other in (relevo.refined(only), relevo.refined(make_cube()), relevo.refined(make_sphere())):
            self.assertIsNone(other._time)
        viewer = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin/relevo-view"
        if viewer.exists():
            command = [viewer, path, "--array=Heat", "--time=4", "--size=320x200", "--output=v.png"]
            subprocess.run(command, cwd=self.folder, check=True, capture_output=True)
            own = relevo.refined(path, scalars="Heat", time=4).screenshot(size=size)
            difference = abs(own.astype(int) - read_picture(self.folder / "v.png")).max(axis=2)
            self.assertLess((difference > 8).sum(), 5)

    def test_show(self):
        path = self.write_series("s.pvd")
        with unittest.mock.patch.object(_drawing.Drawing, "show"):
            drawing = relevo.show(path, array="Heat", time=4)
            self.assertEqual(get_largest(drawing), 4.0)
            self.assertEqual(drawing._time, 4.0)
            drawing = relevo.show(path, scalars="Heat", range="all")
            self.assertEqual(get_largest(drawing), TIMES[-1])
            with self.assertRaisesRegex(TypeError, "did you mean time"):
                relevo.show(path, timestep=4)

    def test_blocks(self):
        """Blocks are one mesh. An array that one lacks is NaN there, and does not move it."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_cube())
        blocks.SetBlock(1, make_cube(offset=2.0, names=["None"]))
        path = self.write("b.vtm", vtkXMLMultiBlockDataWriter, blocks)
        drawing = relevo.patches(path, scalars="Heat", warp="Move")
        self.assertIn("1 of 2 blocks have no array of points 'Move'", str(self.warnings.pop().message))
        self.assertEqual(drawing._coarse.GetNumberOfCells(), 24)
        self.assertEqual(drawing._coarse.GetBounds(), (0, 3, 0, 2, 0, 1))
        mesh = relevo.refined(path).mesh()
        heat = vtk_to_numpy(mesh.GetPointData().GetArray("Heat"))
        x = vtk_to_numpy(mesh.GetPoints().GetData())[:, 0]
        numpy.testing.assert_array_equal(numpy.isnan(heat), x > 1.5)
        numpy.testing.assert_array_equal(heat[x < 1.5], x[x < 1.5])
        for i, time in enumerate((1, 1)):
            self.write(f"p{i}.vtu", vtkXMLUnstructuredGridWriter, make_cube(time, 2.0 * i))
        parts = [f'<DataSet timestep="1" part="{i}" file="p{i}.vtu"/>' for i in range(2)]
        mesh = relevo.refined(self.write_list("p.pvd", parts)).mesh()
        self.assertEqual(mesh.GetBounds(), (0, 3, 0, 1, 0, 1))

    def test_grids(self):
        """Images, rectilinear, structured and parallel grids have the surface of their cells."""
        image = vtkImageData()
        image.SetDimensions(3, 4, 2)
        rectilinear = vtkRectilinearGrid()
        rectilinear.SetDimensions(3, 4, 2)
        for size, setter in zip((3, 4, 2), ("SetXCoordinates", "SetYCoordinates", "SetZCoordinates")):
            values = vtkDoubleArray()
            for x in range(size):
                values.InsertNextValue(x)
            getattr(rectilinear, setter)(values)
        structured = vtkStructuredGrid()
        structured.SetDimensions(3, 4, 2)
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
            path = self.write(name, writer, grid)
            mesh = relevo.refined(path).mesh()
            self.assertEqual(mesh.GetNumberOfPolys(), 2 * 2 * (2 * 3 + 2 * 1 + 3 * 1))
            self.assertEqual(mesh.GetBounds(), (0, 2, 0, 3, 0, 1))
            self.assertEqual(get_largest(relevo.volume(path, "Heat")), 23)
            self.assertEqual(relevo.times(path), [])
        path = self.write("g.pvtu", vtkXMLPUnstructuredGridWriter, make_cube())
        self.assertEqual(get_largest(relevo.volume(path, "Heat")), 1)

    def test_geometry_files(self):
        """.g files are of Exodus or of Movie.BYU, by their content."""
        sphere = vtkSphereSource()
        sphere.Update()
        writer = vtkBYUWriter()
        writer.SetGeometryFileName(str(self.folder / "s.g"))
        writer.SetInputData(sphere.GetOutput())
        writer.Write()
        mesh = relevo.refined(self.folder / "s.g", surface="linear", max_level=0).mesh()
        self.assertEqual(mesh.GetNumberOfPolys(), sphere.GetOutput().GetNumberOfPolys())
        if DATA.exists():
            (self.folder / "mug.g").symlink_to(DATA / "mug.e")
            self.assertEqual(len(relevo.times(self.folder / "mug.g")), 21)

    def test_results(self):
        """Results of other programs, in VTK's test data."""
        if not DATA.exists():
            self.skipTest("RELEVO_TEST_DATA is not set")
        for name, array, number, last in (
            ("mug.e", "convected", 21, 2.0),
            ("ensight/LShape.case", "displacement", 11, 1.0),
            ("ensight/blow2_bin.case", "thickness", 2, 0.1),
            ("openfoam-cavity/case.foam", "p", 6, 2.5),
        ):
            try:
                times = relevo.times(DATA / name)
            except relevo.Error as error:
                self.assertRegex(str(error), "VTK .* cannot read")  # without a module of VTK
                continue
            self.assertEqual(len(times), number)
            self.assertAlmostEqual(times[-1], last)
            first, second = (
                relevo.patches(DATA / name, scalars=array, time=time) for time in (times[0], last)
            )
            values = [
                vtk_to_numpy(own._coarse.GetPointData().GetArray(array)) for own in (first, second)
            ]
            self.assertEqual(values[0].shape, values[1].shape)
            self.assertGreater(numpy.nanmax(abs(values[1] - values[0])), 0, name)

    def test_further_formats(self):
        """Series of ParaView, AMR, hyper tree grids and PLOT3D, and those that others convert."""
        write_series(self.folder, "a.pvd")
        entries = [{"name": f"a.pvd-{i}.vtu", "time": time} for i, time in enumerate(TIMES)]
        series = self.folder / "a.vtu.series"
        series.write_text(json.dumps({"files": entries[::-1]}))
        self.assertEqual(relevo.times(series), TIMES)
        self.assertEqual(get_largest(relevo.refined(series, scalars="Heat", time=4)), 4.0)
        amr = vtkAMRGaussianPulseSource()
        amr.SetDimension(3)
        trees = vtkRandomHyperTreeGridSource()
        trees.SetDimensions(3, 3, 3)
        trees.SetSeed(5)
        for name, source, writer in (
            ("a.vth", amr, vtkXMLUniformGridAMRWriter), ("h.htg", trees, vtkXMLHyperTreeGridWriter)
        ):
            source.Update()
            path = self.write(name, writer, source.GetOutputDataObject(0))
            points = vtk_to_numpy(relevo.refined(path).mesh().GetPoints().GetData())
            self.assertGreater(len(numpy.unique(numpy.diff(numpy.unique(points[:, 0].round(4))).round(4))), 1)
        grid = numpy.mgrid[0:2, 0:3, 0:4][::-1].astype(">f4")
        for name in ("g.xyz", "gxyz.bin"):
            path = self.folder / name
            path.write_bytes(numpy.array([4, 3, 2], ">i4").tobytes() + grid.tobytes())
            self.assertEqual(relevo.refined(path).mesh().GetBounds(), (0, 3, 0, 2, 0, 1))
        with self.assertRaisesRegex(relevo.Error, "files of Gmsh; convert it.*meshio convert a.msh a.vtu"):
            (self.folder / "a.msh").write_text("$MeshFormat")
            relevo.refined(self.folder / "a.msh")
        for text, words in (
            ("{", "not JSON with a list of files"),
            ('{"files": []}', "it lists no files"),
            ('{"files": [{"time": 1}]}', "entry 1 of its files has no name"),
            ('{"files": [{"name": "a", "time": "x"}]}', "the time of a is not a number"),
            ('{"files": [{"name": "b.series"}]}', "a series cannot list another one"),
        ):
            series.write_text(text)
            with self.assertRaisesRegex(relevo.Error, words):
                relevo.times(series)

    def test_errors(self):
        series = self.write_series("e.pvd")
        one = self.write("one.vtu", vtkXMLUnstructuredGridWriter, make_cube())
        for source, options, error, text in (
            (one, {"time": 1}, ValueError, "one.vtu has no time steps"),
            (make_cube(), {"time": 1}, ValueError, "time is for files and algorithms of VTK"),
            (series, {"time": "1"}, TypeError, "time must be a number"),
            (series, {"time": [1, 2]}, TypeError, "time must be a number"),
            (series, {"warp": "None"}, ValueError, "no array 'None'; its arrays are 'Heat', 'Move'"),
            (series, {"warp": "Heat"}, ValueError, "must be an array of points with 3 components"),
        ):
            with self.assertRaisesRegex(error, text):
                relevo.patches(source, **options)
        with self.assertRaises(FileNotFoundError):
            relevo.times(self.folder / "missing.pvd")
        for source, error, text in ((3, TypeError, "path or a vtkAlgorithm"), ("a.tif", FileNotFoundError, "a.tif")):
            with self.assertRaisesRegex(error, text):
                relevo.times(source)
        for name, entries, error, text in (
            ("m.pvd", ['<DataSet file="missing.vtu"/>'], FileNotFoundError, "missing.vtu"),
            ("n.pvd", ['<DataSet timestep="0"/>'], relevo.Error, "entry 1 of its Collection names"),
            ("t.pvd", ['<DataSet timestep="x" file="one.vtu"/>'], relevo.Error, "time of one.vtu is not"),
            ("i.pvd", ['<DataSet timestep="inf" file="one.vtu"/>'], relevo.Error, "of one.vtu is not"),
            ("l.pvd", [], relevo.Error, "it lists no files"),
        ):
            with self.assertRaisesRegex(error, text):
                relevo.refined(self.write_list(name, entries))
        (self.folder / "x.pvd").write_text("<VTKFile><Other/></VTKFile>")
        with self.assertRaisesRegex(relevo.Error, "not XML with a Collection"):
            relevo.times(self.folder / "x.pvd")

    def test_damaged_files(self):
        """No reader of VTK gets a file that ends the program, or about which a library prints."""
        with tempfile.TemporaryFile() as file:
            old = os.dup(2)
            os.dup2(file.fileno(), 2)
            try:
                for extension in sorted({*_results._FORMATS} - {".foam"}):
                    for contents in (
                        b"no result\n", bytes(200), _results._HDF + bytes(100), _results._HDF, b"",
                    ):
                        path = self.folder / f"a{extension}"
                        path.write_bytes(contents)
                        with self.assertRaises((relevo.Error, ValueError), msg=path):
                            relevo.refined(path)
            finally:
                sys.stderr.flush()
                os.dup2(old, 2)
                os.close(old)
            file.seek(0)
            self.assertEqual(file.read(), b"")
        grid = make_cube()
        path = self.write("c.vtu", vtkXMLUnstructuredGridWriter, grid)
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetDataModeToAscii()
        writer.SetFileName(str(path))
        writer.SetInputData(grid)
        writer.Write()
        text = path.read_text()
        self.assertIn("0 1 2 3 4 5", text)
        path.write_text(text.replace("0 1 2 3 4 5", "0 1 99 3 4 5"))
        with self.assertRaisesRegex(relevo.Error, "cell 0 refers to point 99, but there are 8"):
            relevo.refined(path)


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingTimes"])
