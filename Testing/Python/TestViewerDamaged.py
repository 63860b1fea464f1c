# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md: a damaged file gives one line and exit code 1, whatever VTK's readers do with
it, and so do pipes, devices and folders. Names and contents cannot send commands to a terminal."""

import os
import struct
import subprocess
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

try:
    from vtkmodules.vtkIOExodus import vtkExodusIIWriter
except ImportError:
    vtkExodusIIWriter = None

from ViewerProgram import PROGRAM, ViewerProgram

EXPORT = ("--export=e.vtp", "--level=0")


def sphere():
    source = vtkSphereSource()
    source.Update()
    mesh = source.GetOutput()
    values = vtkFloatArray()
    values.SetName("Values")
    for i in range(mesh.GetNumberOfPoints()):
        values.InsertNextValue(0.1 * i)
    mesh.GetPointData().SetScalars(values)
    return mesh


def tetrahedron():
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
        points.InsertNextPoint(point)
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_TETRA, 4, (0, 1, 2, 3))
    values = vtkDoubleArray()
    values.SetName("Values")
    for i in range(4):
        values.InsertNextValue(0.123456 * i)
    grid.GetPointData().SetScalars(values)
    return grid


class TestViewerDamaged(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        os.mkfifo(cls.folder / "pipe")
        (cls.folder / "heights.pgm").write_bytes(b"P5 8 8 255\n" + bytes(range(64)))
        cls.write_data("sphere.vtp", vtkXMLPolyDataWriter, sphere())
        cls.write_data("grid.vtu", vtkXMLUnstructuredGridWriter, tetrahedron())
        (cls.folder / "waits.vrt").write_text(
            '<VRTDataset rasterXSize="8" rasterYSize="8"><VRTRasterBand dataType="Byte" band="1">'
            '<SimpleSource><SourceFilename relativeToVRT="1">pipe</SourceFilename></SimpleSource>'
            "</VRTRasterBand></VRTDataset>\n"
        )
        cls.waiting = cls.start("waits.vrt")  # see test_waiting()

    @classmethod
    def tearDownClass(cls):
        with cls.waiting:
            cls.waiting.kill()
        super().tearDownClass()

    @classmethod
    def start(cls, name):
        return subprocess.Popen(
            [str(PROGRAM), name, *EXPORT], cwd=cls.folder, stderr=subprocess.PIPE, text=True
        )

    def cut(self, name, content, sizes, *arguments):
        """Each truncated file is an error that names the file."""
        for size in sizes:
            (self.folder / name).write_bytes(content[:size])
            run = self.view(name, *arguments, *EXPORT, code=1)
            self.assertRegex(run.stderr, r"\Arelevo-view: error: [^\n]+\n\Z", (name, size))
            self.assertIn(name, run.stderr, size)

    def test_no_regular_files(self):
        """Fails at once, even for an endless device."""
        for name in ("a.tif", "a.vtp", "a.bpt", "a.ply"):
            (self.folder / name).symlink_to("pipe")
            self.assert_error(1, [name, "not a regular file"], name, *EXPORT)
            (self.folder / ("zero" + name)).symlink_to("/dev/zero")
            self.assert_error(1, [name, "not a regular file"], "zero" + name, *EXPORT)
        for name in ("pipe", "/dev/zero"):
            for arguments in (
                ("sphere.vtp", "--image=" + name),
                ("sphere.vtp", "--height=" + name),
                ("heights.pgm", "--imagery=" + name),
                ("grid.vtu", "--volume", "--transfer=" + name),
            ):
                self.assert_error(1, [name, "not a regular file"], *arguments, "--output=o.png")
        (self.folder / "reliefs").mkdir()
        (self.folder / "reliefs" / "data.csv").symlink_to("/dev/zero")
        self.assert_error(1, ["data.csv"], "reliefs", "--output=o.png")
        self.assert_error(1, ["it is a folder"], "grid.vtu", "--volume", "--transfer=reliefs",
                          "--output=o.png")

    def test_pieces(self):
        """Pieces of a .pvtu file. VTK's reader skips those that it cannot read."""
        whole = self.write_data("whole.vtu", vtkXMLUnstructuredGridWriter, tetrahedron())
        piece = self.folder / "piece.vtu"
        (self.folder / "pieces.pvtu").write_text(
            '<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">'
            '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
            '<Piece Source="whole.vtu"/><Piece Source="piece.vtu"/>'
            "</PUnstructuredGrid></VTKFile>\n"
        )
        for options in (EXPORT, ("--volume", "--output=o.png")):
            for prepare, words in (
                (piece.touch, "the file is empty"),
                (lambda: piece.write_bytes(whole[:-12]), "the file is truncated"),
                (lambda: piece.symlink_to("pipe"), "not a regular file"),
            ):
                self.assert_error(1, ["pieces.pvtu", "its piece piece.vtu", "does not exist"],
                                  "pieces.pvtu", *options)
                prepare()
                self.assert_error(1, ["pieces.pvtu", "its piece piece.vtu", words],
                                  "pieces.pvtu", *options)
                piece.unlink()
        piece.write_bytes(whole)
        self.view("pieces.pvtu", *EXPORT)

    def test_waiting(self):
        """Nobody writes into this pipe, so GDAL's reader never returns."""
        self.assertEqual(self.waiting.wait(60), 1)
        self.assertEqual(
            self.waiting.stderr.read(),
            "relevo-view: error: cannot read waits.vrt: its reader made no progress for 20 seconds; "
            "the file is damaged\n",
        )

    def test_ply(self):
        """VTK's reader crashes on most of these."""
        for name, calls in (
            ("text.ply", ["SetFileTypeToASCII"]),
            ("little.ply", ["SetFileTypeToBinary"]),
            ("big.ply", ["SetFileTypeToBinary", "SetDataByteOrderToBigEndian"]),
        ):
            content = self.write_data(name, vtkPLYWriter, sphere(), *calls)
            self.view(name, *EXPORT)
            header = content.index(b"end_header")
            self.cut(name, content, (3, header, header + 20, len(content) - 3))
            for old, new in ((b"element vertex 50", b"element vertex 99999999999"),
                             (b"element face 96", b"element face 96000"),
                             (b"element vertex 50", b"element vertex -1"),
                             (b"property float x", b"property folat x"),
                             (b"format ", b"layout ")):
                self.assertIn(old, content)
                changed = content.replace(old, new)
                (self.folder / name).write_bytes(changed)
                self.assert_error(1, ["cannot read " + name], name, *EXPORT)

    def test_stl(self):
        content = self.write_data("a.stl", vtkSTLWriter, sphere(), "SetFileTypeToBinary")
        self.cut("a.stl", content, (60, len(content) - 1))
        text = self.write_data("text.stl", vtkSTLWriter, sphere())
        self.cut("text.stl", text, (len(text) // 2,))
        # Some programs write a wrong count.
        (self.folder / "b.stl").write_bytes(content[:80] + struct.pack("<I", 0) + content[84:])
        run = subprocess.run([str(PROGRAM), "b.stl", *EXPORT], cwd=self.folder,
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"\Arelevo-view: warning: b.stl: the header declares 0 [^\n]+\n\Z")

    def test_netcdf(self):
        """The library reads zeros beyond the end of a classic file, with and without records."""
        heights = struct.pack(">16f", *range(16))
        dimension = struct.pack(">I", 1) + b"x\0\0\0" + struct.pack(">I", 4)
        second = dimension.replace(b"x", b"y")
        head = b"CDF\1" + bytes(4) + struct.pack(">II", 10, 2) + second + dimension + bytes(8)
        variable = struct.pack(">III", 11, 1, 1) + b"z\0\0\0" + struct.pack(">III", 2, 0, 1)
        variable += bytes(8) + struct.pack(">II", 5, len(heights))
        begin = len(head) + len(variable) + 4
        content = head + variable + struct.pack(">I", begin) + heights
        (self.folder / "a.nc").write_bytes(content)
        run = self.run_program("a.nc", *EXPORT)
        if "netCDF" not in run.stderr and run.returncode == 1:
            self.skipTest("GDAL reads no netCDF files")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.cut("a.nc", content, (begin - 2, begin, len(content) - 4))
        self.assert_error(1, ["cannot read a.nc: the file is truncated"], "sphere.vtp",
                          "--height=a.nc", *EXPORT)
        if not vtkExodusIIWriter:
            return
        content = self.write_data("a.ex2", vtkExodusIIWriter, tetrahedron())
        self.view("a.ex2", *EXPORT)
        self.cut("a.ex2", content, (len(content) // 4, len(content) - 20))

    def test_obj(self):
        """VTK's reader writes beyond its arrays if corners refer to missing points."""
        head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
        for corners, words in (
            ("1/1/1 2/2/1 3/3/1", "line 7 refers to texture coordinate 3, but there are 2"),
            ("1//1 2//2 3//1", "line 7 refers to normal 2, but there are 1"),
            ("1 2 4", "line 7 refers to point 4, but there are 3"),
            ("1 2 0", "line 7 refers to point 0"),
            ("-1 -2 -4", "line 7 refers to point -4, but there are 3 before it"),
            ("1/1/1/1 2 3", "line 7 has a corner with more than three indices"),
        ):
            (self.folder / "a.obj").write_text(head + f"f {corners}\n")
            self.assert_error(1, ["cannot read a.obj: " + words], "a.obj", *EXPORT)
        damaged = head.replace("vt 1", "vt\x80 1") + "f 1/1 2/2 3/1\n"
        (self.folder / "a.obj").write_bytes(damaged.encode("latin1"))
        self.assert_error(1, ["line 7 refers to texture coordinate 2"], "a.obj", *EXPORT)
        for corners in ("1 2 3", "1/1/1 2/2/1 3/2/1", "-1//-1 -2//1 -3//1\r"):
            (self.folder / "a.obj").write_text(head + f"f {corners}\n")
            self.view("a.obj", *EXPORT)

    def test_legacy(self):
        """The data of an array are truncated, which VTK's reader ignores."""
        for name, writer, data, kind in (
            ("a.vtk", vtkPolyDataWriter, sphere(), "ASCII"),
            ("b.vtk", vtkPolyDataWriter, sphere(), "Binary"),
            ("c.vtk", vtkUnstructuredGridWriter, tetrahedron(), "ASCII"),
            ("d.vtk", vtkUnstructuredGridWriter, tetrahedron(), "Binary"),
        ):
            content = self.write_data(name, writer, data, "SetFileTypeTo" + kind)
            self.view(name, *EXPORT)
            values = content.index(b"LOOKUP_TABLE default\n") + 21
            points = content.index(b"POINTS")
            self.cut(name, content, (20, points + 30, values + 5))

    def test_xml(self):
        for name, writer, data in (("a.vtp", vtkXMLPolyDataWriter, sphere()),
                                   ("a.vtu", vtkXMLUnstructuredGridWriter, tetrahedron())):
            for mode in ("Ascii", "Binary", "Appended"):
                (self.folder / name).unlink(missing_ok=True)
                content = self.write_data("x" + name, writer, data, "SetDataModeTo" + mode)
                self.view("x" + name, *EXPORT)
                self.cut("x" + name, content, (len(content) // 2, len(content) - 8))

    def test_crash(self):
        """Crashes of VTK's reader: a line with a slash, and more bytes than the data have."""
        for line in ("f 1/ 2/ 3/", "f //1 //2 //3", "f a b c", "l 1"):
            (self.folder / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + line + "\n")
            run = subprocess.run([str(PROGRAM), "a.obj", *EXPORT], cwd=self.folder,
                                 capture_output=True, text=True)
            self.assertIn(run.returncode, (0, 1), line)
            self.assertLessEqual(run.stderr.count("\n"), 1)
        (self.folder / "a.vtk").write_bytes(
            b"# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n" + bytes(36)
            + b"\nPOLYGONS 99999999999 3\nOFFSETS vtktypeint64\n" + bytes(16))
        self.assert_error(1, ["cannot read a.vtk"], "a.vtk", *EXPORT)

    def test_memory(self):
        """Requires more memory than this machine has, or than a limit allows."""
        (self.folder / "huge.vtk").write_text(
            "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 999999999999 float\n0 0 0\n")
        self.assert_error(1, ["huge.vtk"], "huge.vtk", *EXPORT)
        content = (self.folder / "grid.vtu").read_text()
        self.assertIn('NumberOfPoints="4"', content)
        (self.folder / "huge.vtu").write_text(
            content.replace('NumberOfPoints="4"', 'NumberOfPoints="400000000000"'))
        self.assert_error(1, ["huge.vtu"], "huge.vtu", *EXPORT)

    def test_terminals(self):
        """Control characters are escaped, so that a message stays one line without terminal
        commands."""
        name = "a\x1b]0;x\x07\nrelevo-view: b\x7f.ply"
        escaped = r"a\x1b]0;x\x07\nrelevo-view: b\x7f.ply"
        self.assert_error(1, [escaped], name, *EXPORT)
        (self.folder / name).write_text("no mesh\n")
        self.assert_error(1, [escaped], name, *EXPORT)
        self.assert_error(1, [escaped[:-4] + ".tif"], name[:-4] + ".tif", *EXPORT)
        self.assert_error(2, [r"unknown option '--\x1b[2J\n'"], "sphere.vtp", "--\x1b[2J\n")
        self.assert_error(2, [r"'\x1b[2J\r'"], "sphere.vtp", "--zoom=\x1b[2J\r")
        self.assert_error(1, [r"'\x1b[2J'"], "sphere.vtp", "--array=\x1b[2J", *EXPORT)
        for given, shown in (("Größe ☃".encode(), "Größe ☃".encode()),
                             (b"a\xff\x9b", rb"a\xff\x9b"),
                             ("b\u202e\u009b".encode(), rb"b\u202e\x9b")):
            run = subprocess.run([str(PROGRAM), given + b".ply", *EXPORT], cwd=self.folder,
                                 capture_output=True)
            self.assertIn(shown + b".ply", run.stderr)
        # Text of a file that VTK's readers quote.
        (self.folder / "a.vtk").write_bytes(
            b"# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n\x1b[2J 3 float\n")
        self.assert_error(1, [r"\x1b[2"], "a.vtk", *EXPORT)
        run = self.view("sphere.vtp", "--against", self.second("s\x1b[2J.vtp"))
        self.assertIn(r"s\x1b[2J.vtp", run.stdout)
        self.assertNotIn("\x1b", run.stdout)

    def second(self, name):
        self.write_data(name, vtkXMLPolyDataWriter, sphere())
        return name

    def test_end_of_options(self):
        self.second("--volume")
        self.second("-s.vtp")
        self.view(*EXPORT, "--", "-s.vtp")
        self.assert_error(2, ["unknown option '-s.vtp'"], "-s.vtp", *EXPORT)
        self.assert_error(2, ["more than one", "'--level'"], "sphere.vtp", "--", "--level", *EXPORT)
        self.assert_error(2, ["no file is given"], *EXPORT, "--")
        self.assert_error(1, ["cannot read --x.vtp"], *EXPORT, "--", "--x.vtp")

    def test_words(self):
        """Each cause has one message, which names options."""
        (self.folder / "cut.pgm").write_bytes(b"P5 8 8 255\n12345")
        run = self.view("cut.pgm", *EXPORT, code=1)
        self.assertNotIn(".gltf", run.stderr)
        self.assert_error(2, ["--array needs a value", "'--level=0'"], "sphere.vtp", "--array",
                          *EXPORT[::-1])
        self.assert_error(1, ["'--level=0'"], "sphere.vtp", "--array=--level=0", *EXPORT)
        self.assert_error(2, ["--array needs the name"], "sphere.vtp", "--array", "", *EXPORT)
        self.assert_error(2, ["--volume requires a mesh", "'a.dae'", ".vtu"], "a.dae", "--volume")
        self.assert_error(2, ["--error requires --metric height"], "heights.pgm",
                          "--error=1", "--metric=error")
        self.assert_error(2, ["--error cannot be combined with --level"], "grid.vtu", "--error=1",
                          "--level=1")
        self.assert_error(2, ["--error requires --surface patch"], "grid.vtu", "--error=1",
                          "--surface=pn")
        self.assert_error(2, ["--error requires --metric error"], "grid.vtu", "--error=1",
                          "--metric=curvature")

    def test_interrupt(self):
        """Ctrl-C ends the program, also while it reads."""
        with self.start("waits.vrt") as run:
            with self.assertRaises(subprocess.TimeoutExpired):
                run.wait(2)
            run.send_signal(2)
            self.assertEqual(run.wait(10), -2)
            self.assertEqual(run.stderr.read(), "")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerDamaged"])
