# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that relevo-view, for randomly damaged files of each format, gives a picture, a mesh or
one line of error.

The seed is fixed. RELEVO_TEST_FUZZ=SEED,NUMBER creates another NUMBER of files of each."""

import os
import random
import unittest

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkBMPWriter, vtkJPEGWriter, vtkPNGWriter, vtkTIFFWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

from TestViewerDamaged import sphere, tetrahedron, vtkExodusIIWriter
from TestViewerFormats import CUBE, CUBE_FACES, Scene
from ViewerProgram import ViewerProgram

SEED, NUMBER = map(int, os.environ.get("RELEVO_TEST_FUZZ", "1,4").split(","))
EXPORT = ("--export=e.vtp", "--level=0")
DRAW = ("--output=o.png", "--size=32x24")
WORDS = (b"-1", b"0", b"99999999999", b"nan", b"1e308", b"\xff\xff\xff\xff", b"<", b'"', b"\n", b"")
# Other formats have no defined end, or may have bytes after their data.
HAVE_ENDS = (".ex2", ".glb", ".gltf", ".pgm", ".ply", ".pvtu", ".vtk", ".vtp", ".vtu")


def image(components):
    data = vtkImageData()
    data.SetDimensions(16, 12, 1)
    data.AllocateScalars(VTK_UNSIGNED_CHAR, components)
    scalars = data.GetPointData().GetScalars()
    for i in range(scalars.GetNumberOfValues()):
        scalars.SetValue(i, 7 * i % 251)
    return data


def flip(content, rng):
    for _ in range(rng.choice((1, 3, 16))):
        content[rng.randrange(len(content))] ^= 1 << rng.randrange(8)


def flip_header(content, rng):
    content[rng.randrange(min(len(content), 512))] = rng.randrange(256)


def put_word(content, rng):
    place = rng.randrange(len(content))
    content[place : place + rng.randrange(8)] = rng.choice(WORDS)


def fill(content, rng):
    place, size = rng.randrange(len(content)), rng.randrange(1, 64)
    content[place : place + size] = bytes([rng.choice((0, 255))]) * len(content[place : place + size])


def shift(content, rng):
    place, size = rng.randrange(len(content)), rng.randrange(1, 200)
    if rng.random() < 0.5:
        del content[place : place + size]
    else:
        content[place:place] = content[-size:]


class TestViewerFuzz(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write_data("m.ply", vtkPLYWriter, sphere())
        cls.write_data("m.vtu", vtkXMLUnstructuredGridWriter, tetrahedron())

    def damage(self, name, *arguments, number=NUMBER):
        """Draws or exports a damaged and a truncated file."""
        path = self.folder / name
        whole = path.read_bytes()
        arguments = arguments or (name, *EXPORT)
        self.assertEqual(self.run_program(*arguments).returncode, 0)
        rng = random.Random(f"{SEED} {name} {arguments}")
        ways = (flip, flip_header, put_word, fill, shift, None)
        for i in range(number * len(ways) // 2):
            content = bytearray(whole)
            way = ways[i % len(ways)]
            if way:
                way(content, rng)
            else:
                del content[rng.randrange(len(content)) :]
            path.write_bytes(content)
            with self.subTest(name=name, i=i):
                is_short = not way and whole[len(content) :].strip()
                self.assert_survives(arguments, is_short and path.suffix in HAVE_ENDS)
        path.write_bytes(whole)

    def assert_survives(self, arguments, is_error):
        run = self.run_program(*arguments)
        self.assertIn(run.returncode, (1,) if is_error else (0, 1), run.stderr)
        error = "relevo-view: error: [^\x00-\x1f\x7f]+\n" if run.returncode else ""
        self.assertRegex(run.stderr, rf"\A(relevo-view: warning: [^\x00-\x1f\x7f]+\n)*{error}\Z")
        self.assertNotRegex(run.stderr, "the program crashed|made no progress")

    def test_polygons(self):
        for name, calls in (("t.ply", ["SetFileTypeToASCII"]), ("b.ply", ["SetFileTypeToBinary"])):
            self.write_data(name, vtkPLYWriter, sphere(), *calls)
            self.damage(name)
        for name, calls in (("t.stl", ["SetFileTypeToASCII"]), ("b.stl", ["SetFileTypeToBinary"])):
            self.write_data(name, vtkSTLWriter, sphere(), *calls)
            self.damage(name)
        self.write_data("a.obj", vtkOBJWriter, sphere())
        self.damage("a.obj", number=3 * NUMBER)
        rows = "".join(f"{i} {j} {0.1 * i * j}\n" for i in range(4) for j in range(4))
        (self.folder / "a.bpt").write_text("1\n3 3\n" + rows)
        self.damage("a.bpt")

    def test_scenes(self):
        scene = Scene()
        points = [tuple(map(float, point)) for point in CUBE]
        scene.add_node(scene.primitive(points, CUBE_FACES, color=[1, 0.5, 0, 1]))
        for name in ("a.gltf", "a.glb"):
            scene.write(self.folder / name)
            self.damage(name)

    def test_legacy(self):
        for kind in ("ASCII", "Binary"):
            for name, writer, data in (("a.vtk", vtkPolyDataWriter, sphere()),
                                       ("b.vtk", vtkUnstructuredGridWriter, tetrahedron())):
                self.write_data(name, writer, data, "SetFileTypeTo" + kind)
                self.damage(name)

    def test_xml(self):
        for name, writer, data in (("a.vtp", vtkXMLPolyDataWriter, sphere()),
                                   ("a.vtu", vtkXMLUnstructuredGridWriter, tetrahedron())):
            for mode in ("Ascii", "Binary", "Appended"):
                self.write_data(name, writer, data, "SetDataModeTo" + mode)
                self.damage(name)
        (self.folder / "a.pvtu").write_text(
            '<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">'
            '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
            '<Piece Source="m.vtu"/></PUnstructuredGrid></VTKFile>\n'
        )
        self.damage("a.pvtu")
        self.damage("m.vtu", "a.pvtu", *EXPORT)

    @unittest.skipUnless(vtkExodusIIWriter, "VTK has no Exodus reader")
    def test_exodus(self):
        self.write_data("a.ex2", vtkExodusIIWriter, tetrahedron())
        self.damage("a.ex2", number=2 * NUMBER)

    def test_rasters(self):
        (self.folder / "a.pgm").write_bytes(b"P5 16 12 255\n" + bytes(range(192)))
        self.damage("a.pgm")
        for name, writer in (("a.tif", vtkTIFFWriter), ("a.png", vtkPNGWriter)):
            self.write_data(name, writer, image(1))
            self.damage(name)
        self.damage("a.tif", "m.ply", "--height=a.tif", *EXPORT)
        rows = "\n".join(" ".join(str(i * j) for i in range(8)) for j in range(8))
        (self.folder / "a.asc").write_text(
            f"ncols 8\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 1\n{rows}\n"
        )
        if self.run_program("a.asc", *EXPORT).returncode == 0:  # needs GDAL
            self.damage("a.asc")

    def test_drawings(self):
        """Files that are only read for drawing. A frame takes a quarter of a second."""
        for name, writer in (("i.png", vtkPNGWriter), ("i.jpg", vtkJPEGWriter),
                             ("i.tif", vtkTIFFWriter), ("i.bmp", vtkBMPWriter)):
            self.write_data(name, writer, image(3))
            self.damage(name, "m.ply", "--image=" + name, "--mapping=sphere", *DRAW, number=2)
        (self.folder / "t.txt").write_text("0 0 0 1 0\n0.2 1 1 0 0.5\n0.4 1 0 0 1\n")
        self.damage("t.txt", "m.vtu", "--volume", "--transfer=t.txt", *DRAW, number=2)

    def test_reliefs(self):
        self.view("m.ply", "--capture=r.cdb", "--relief=view")
        for name in ("data.csv", "relief_0000.vti"):
            self.damage("r.cdb/" + name, "r.cdb", *DRAW, number=1)


if __name__ == "__main__":
    unittest.main(argv=["TestViewerFuzz"])
