# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on formats: .gltf and .glb, .vtu and .off files, and formats without a reader.
"""

import base64
import json
import math
import os
import pathlib
import struct
import unittest

import vtkmodules.vtkIOGeometry
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridWriter

from ViewerProgram import ViewerProgram
from ViewerScenes import make_cube

DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent")
FLOAT, UNSIGNED_SHORT = 5126, 5123
TRIANGLES, TRIANGLE_STRIP = 4, 5
CUBE = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
# Counter-clockwise seen from outside.
CUBE_FACES = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4] + [
    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
]


class Scene:
    """Builds a glTF document step by step."""

    def __init__(self):
        self.data = b""
        self.document = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": []}],
            **{key: [] for key in ("nodes", "meshes", "materials", "accessors", "bufferViews")},
        }

    def add(self, key, value):
        self.document[key].append(value)
        return len(self.document[key]) - 1

    def add_values(self, values, target):
        """Adds an accessor for tuples of floats or for indices."""
        is_vector = isinstance(values[0], tuple)
        flat = [x for value in values for x in value] if is_vector else values
        part = struct.pack(f"<{len(flat)}{'f' if is_vector else 'H'}", *flat)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(part), "target": target}
        self.data += part + bytes(-len(part) % 4)
        accessor = {
            "bufferView": self.add("bufferViews", view),
            "componentType": FLOAT if is_vector else UNSIGNED_SHORT,
            "count": len(values),
            "type": f"VEC{len(values[0])}" if is_vector else "SCALAR",
        }
        if is_vector:
            accessor["min"] = [min(column) for column in zip(*values)]
            accessor["max"] = [max(column) for column in zip(*values)]
        return self.add("accessors", accessor)

    def primitive(self, points, indices, mode=TRIANGLES, color=None, **attributes):
        result = {
            "attributes": {"POSITION": self.add_values(points, 34962)},
            "indices": self.add_values(indices, 34963),
            "mode": mode,
        }
        for name, values in attributes.items():
            result["attributes"][name] = self.add_values(values, 34962)
        if color:
            material = {"pbrMetallicRoughness": {"baseColorFactor": color}}
            result["material"] = self.add("materials", material)
        return result

    def add_node(self, *primitives, root=True, **node):
        if primitives:
            node["mesh"] = self.add("meshes", {"primitives": list(primitives)})
        index = self.add("nodes", node)
        if root:
            self.document["scenes"][0]["nodes"].append(index)
        return index

    def write(self, path):
        document = {key: value for key, value in self.document.items() if value}
        document["buffers"] = [{"byteLength": len(self.data)}]
        if path.suffix == ".gltf":
            code = base64.b64encode(self.data).decode()
            document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + code
            path.write_text(json.dumps(document))
            return path
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        length = 12 + 8 + len(text) + 8 + len(self.data)
        path.write_bytes(
            b"glTF" + struct.pack("<II", 2, length)
            + struct.pack("<I", len(text)) + b"JSON" + text
            + struct.pack("<I", len(self.data)) + b"BIN\0" + self.data
        )
        return path


def sparse(indices, values):
    """A sparse accessor with one value: the buffer views of its index and of the value."""
    return {
        "count": 1,
        "indices": {"bufferView": indices, "componentType": UNSIGNED_SHORT},
        "values": {"bufferView": values},
    }


def volume(mesh):
    """Positive if the triangles of a closed mesh face outwards."""
    total = 0
    for i in range(mesh.GetNumberOfCells()):
        ids = mesh.GetCell(i).GetPointIds()
        a, b, c = (mesh.GetPoint(ids.GetId(k)) for k in range(3))
        total += a[0] * (b[1] * c[2] - b[2] * c[1])
        total += a[1] * (b[2] * c[0] - b[0] * c[2])
        total += a[2] * (b[0] * c[1] - b[1] * c[0])
    return total / 6


class CubeOverTime(VTKPythonAlgorithmBase):
    """A cube at the times 0.5, 1.5 and 2.5."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")

    def RequestInformation(self, request, inputs, outputs):
        information = outputs.GetInformationObject(0)
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), [0.5, 1.5, 2.5], 3)
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [0.5, 2.5], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        information = outputs.GetInformationObject(0)
        cube = vtkUnstructuredGrid.GetData(outputs)
        cube.ShallowCopy(make_cube())
        step = vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()
        time = information.Get(step) if information.Has(step) else 0.5
        cube.GetInformation().Set(cube.DATA_TIME_STEP(), time)
        return 1


class TestViewerFormats(ViewerProgram):
    def export(self, file, *arguments):
        self.view(file, "--export=e.vtp", "--surface=linear", "--level=0", *arguments)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "e.vtp"))
        reader.Update()
        return reader.GetOutput()

    def assert_bounds(self, mesh, expected):
        for one, other in zip(mesh.GetBounds(), expected):
            self.assertAlmostEqual(one, other, places=5)

    def colors(self, mesh):
        """Colours of the points, by position."""
        array = mesh.GetPointData().GetArray("Color")
        self.assertEqual(array.GetNumberOfComponents(), 3)
        return {
            tuple(round(x, 5) for x in mesh.GetPoint(i)): array.GetTuple3(i)
            for i in range(mesh.GetNumberOfPoints())
        }

    def test_transforms(self):
        """A cube in a node rotated by 90 degrees about z, inside one that is moved and scaled."""
        scene = Scene()
        half = math.sqrt(0.5)
        inner = scene.add_node(
            scene.primitive(CUBE, CUBE_FACES), rotation=[0, 0, half, half], root=False
        )
        scene.add_node(children=[inner], translation=[10, 20, 30], scale=[1, 2, 3])
        for suffix in (".gltf", ".glb"):
            mesh = self.export(scene.write(self.folder / f"cube{suffix}"))
            self.assertEqual(mesh.GetNumberOfCells(), 12)
            self.assert_bounds(mesh, (9, 10, 20, 22, 30, 33))
            self.assertAlmostEqual(volume(mesh), 6, places=4)
            self.assertIsNone(mesh.GetPointData().GetArray("Color"))

    def test_primitives_and_colours(self):
        """Colours of materials, of points, of both, and of neither. Strips become triangles."""
        scene = Scene()
        square = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
        strip = scene.primitive(square, [0, 1, 2, 3], TRIANGLE_STRIP, color=[1, 0.2159, 0, 1])
        triangle = scene.primitive(
            [(5, 0, 0), (6, 0, 0), (5, 1, 0)], [0, 1, 2], color=[1, 0.5, 0.2159, 1],
            COLOR_0=[(1.0, 1.0, 1.0), (0.0, 1.0, 1.0), (0.0, 0.0, 1.0)],
        )
        scene.add_node(strip, triangle)
        scene.add_node(scene.primitive([(8, 0, 0), (9, 0, 0), (8, 1, 0)], [0, 1, 2]))
        file = scene.write(self.folder / "colours.gltf")
        mesh = self.export(file)
        self.assertEqual(mesh.GetNumberOfCells(), 4)
        colors = self.colors(mesh)
        self.assertEqual(colors[0, 0, 0], (255, 128, 0))  # 0.2159 is 128/255 in sRGB
        self.assertEqual(colors[1, 1, 0], (255, 128, 0))
        self.assertEqual(colors[5, 0, 0], (255, 188, 128))
        self.assertEqual(colors[6, 0, 0], (0, 188, 128))
        self.assertEqual(colors[5, 1, 0], (0, 0, 128))
        self.assertEqual(colors[8, 0, 0], (255, 255, 255))
        self.view(file, "--output=p.png", "--size=64x48")

    def test_mirrored_nodes(self):
        """Mirrored triangles and strips face outwards too, as glTF requires."""
        scene = Scene()
        strip = [0, 2, 1, 3, 7, 2, 6, 0, 4, 1, 5, 7, 4, 6]  # around a cube
        for x, primitive in (
            (0, scene.primitive(CUBE, CUBE_FACES)),
            (5, scene.primitive(CUBE, strip, TRIANGLE_STRIP)),
        ):
            scene.add_node(primitive, translation=[x, 0, 0])
            scene.add_node(primitive, primitive, translation=[-x - 2, 0, 0], scale=[-1, 1, 1])
        mesh = self.export(scene.write(self.folder / "mirrored.gltf"))
        self.assertEqual(mesh.GetNumberOfCells(), 6 * 12)
        self.assertAlmostEqual(volume(mesh), 6, places=4)

    def test_bad_scenes(self):
        """Truncated files, and parts that refer to missing ones."""
        scene = Scene()
        scene.add_node(scene.primitive(CUBE, CUBE_FACES))
        good = scene.write(self.folder / "good.glb").read_bytes()
        names = []

        def write(name, content):
            names.append(name)
            (self.folder / name).write_bytes(content)

        write("cut.glb", good[: len(good) // 2])
        write("header.glb", good[:12])
        text_end = 20 + int.from_bytes(good[12:16], "little")
        write("chunks.glb", good[:text_end] + bytes(4) + good[text_end + 4 :])
        write("magic.glb", b"g\x85\x01\0" + good[4:text_end] + bytes(4) + good[text_end + 4 :])
        write("text.gltf", b"no scene\n")
        write("number.gltf", b"3\n")
        write("deep.gltf", b"[" * 2000 + b"]" * 2000)
        write("bare.gltf", b'{"asset": {"version": "2.0"}}')
        text = scene.write(self.folder / "good.gltf").read_text()
        for name, change in (
            ("lost", lambda d: d["buffers"][0].update(uri="lost.bin")),
            ("attribute", lambda d: d["meshes"][0]["primitives"][0]["attributes"].update(NORMAL=9)),
            ("indices", lambda d: d["meshes"][0]["primitives"][0].update(indices=9)),
            ("view", lambda d: d["accessors"][0].update(bufferView=9)),
            ("count", lambda d: d["accessors"][0].update(count=99)),
            ("no view", lambda d: d["accessors"][1].pop("bufferView")),
            ("buffer", lambda d: d["bufferViews"][0].update(buffer=9)),
            ("negative", lambda d: d["bufferViews"][0].update(buffer=-1)),
            ("offset", lambda d: d["bufferViews"][0].update(byteOffset=10**9)),
            ("length", lambda d: [x.update(byteLength=10**9) for x in d["bufferViews"]]),
            ("normals", lambda d: d["meshes"][0]["primitives"][0]["attributes"].update(NORMAL=1)),
            ("sparse", lambda d: d["accessors"][0].update(sparse=sparse(0, 0))),
            ("sparse view", lambda d: d["accessors"][0].update(sparse=sparse(9, 9))),
            ("points", lambda d: d["meshes"][0]["primitives"][0].update(attributes={})),
            ("node", lambda d: d["scenes"][0].update(nodes=[9])),
            ("mesh", lambda d: d["nodes"][0].update(mesh=9)),
            ("skin", lambda d: d["nodes"][0].update(skin=9)),
            ("circle", lambda d: d["nodes"][0].update(children=[0])),
            ("scene", lambda d: d.update(scene=9)),
        ):
            document = json.loads(text)
            change(document)
            write(name + ".gltf", json.dumps(document).encode())
        for name in names:
            self.assert_error(1, ["cannot read " + name], name, "--output=n.png")
        beyond = Scene()
        beyond.add_node(beyond.primitive(CUBE[:3], [0, 1, 9]))
        beyond.write(self.folder / "beyond.gltf")
        # VTK 9.6 detects this itself, but does not report what it found.
        version = vtkVersion().GetVTKMajorVersion(), vtkVersion().GetVTKMinorVersion()
        words = "point 9, but there are 3 points" if version < (9, 6) else "cannot read beyond.gltf"
        self.assert_error(1, [words], "beyond.gltf", "--output=n.png")

    def test_corners_that_do_not_exist(self):
        """Invalid references are found before the mesh is used."""
        points = ["v 0 0 0", "v 1 0 0", "v 0 1 0"]
        (self.folder / "beyond.obj").write_text("\n".join(points + ["f 1 2 3", "f 1 2 70000001\n"]))
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        for corner in CUBE:
            points.InsertNextPoint(corner)
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, (0, 1, 3, 2, 4, 5, 7, 6))
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, (0, 1, 3, 2, 4, 5, 7, 70000000))
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(str(self.folder / "beyond.vtu"))
        writer.Write()
        for name, words in (
            ("beyond.obj", "refers to point 70000001, but there are 3"),
            ("beyond.vtu", "cell 1 refers to point 70000000, but there are"),
        ):
            for more in ([], ["--metric=curvature"], ["--feature-angle=30"]):
                self.assert_error(1, [name, words], name, "--output=n.png", *more)

    def test_one_place(self):
        """A mesh whose points all coincide."""
        (self.folder / "place.obj").write_text(3 * "v 1 1 1\n" + "f 1 2 3\n")
        for more in ([], ["--metric=curvature"]):
            run = self.view("place.obj", "--output=n.png", *more, code=1)
            self.assertIn("error: place.obj: ", run.stderr)

    def test_buffers_that_are_too_short(self):
        """Buffers that are too short for their views: in a .glb file, in a data URI and in a
        separate file."""
        scene = Scene()
        scene.add_node(scene.primitive(CUBE, CUBE_FACES))
        whole = scene.data
        scene.data = whole[:-8]
        for name in ("short.glb", "short.gltf"):
            scene.write(self.folder / name)
            self.assert_error(1, ["buffer view 1 is longer than its buffer"], name, "--output=n.png")
        scene.data = whole
        document = json.loads(scene.write(self.folder / "beside.gltf").read_text())
        document["buffers"][0]["uri"] = "beside.bin"
        (self.folder / "beside.gltf").write_text(json.dumps(document))
        (self.folder / "beside.bin").write_bytes(whole)
        self.assertEqual(self.export("beside.gltf").GetNumberOfCells(), 12)
        (self.folder / "beside.bin").write_bytes(whole[:-8])
        self.assert_error(1, ["beside.bin is truncated"], "beside.gltf", "--output=n.png")

    def test_large_data_uri(self):
        """A data URI of hundreds of kilobytes."""
        size = 120
        points = [(i, j, 0.0) for j in range(size) for i in range(size)]
        corners = [j * size + i for j in range(size - 1) for i in range(size - 1)]
        faces = [id for corner in corners for id in (corner, corner + 1, corner + size)]
        scene = Scene()
        scene.add_node(scene.primitive(points, faces))
        mesh = self.export(scene.write(self.folder / "large.gltf"))
        self.assertEqual(mesh.GetNumberOfCells(), len(corners))

    def test_volume(self):
        """The surface of a .vtu file, with its point array."""
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        for corner in CUBE:
            points.InsertNextPoint(corner)
        points.InsertNextPoint(9, 9, 9)  # an unused point
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, (0, 1, 3, 2, 4, 5, 7, 6))
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(str(self.folder / "cube.vtu"))
        writer.Write()
        mesh = self.export("cube.vtu")
        self.assertEqual(mesh.GetNumberOfCells(), 12)
        self.assertAlmostEqual(volume(mesh), 1)
        (self.folder / "text.vtu").write_text("no grid\n")
        (self.folder / "cut.vtu").write_bytes((self.folder / "cube.vtu").read_bytes()[:600])
        for name in ("text.vtu", "cut.vtu", "missing.vtu"):
            self.assert_error(1, [name], name, "--output=n.png")

    def test_real_volume(self):
        file = DATA / "volume" / "can.vtu"
        if not file.exists():
            self.skipTest("no volumes in RELEVO_TEST_DATA")
        self.assertGreater(self.statistic("coarse faces", file, "--array=EQPS"), 2000)
        self.view(file, "--array=DISPL", "--output=p.png", "--size=64x48")

    def test_off(self):
        """.off files, if VTK reads them. Otherwise the error lists the supported formats."""
        (self.folder / "a.off").write_text("OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        if hasattr(vtkmodules.vtkIOGeometry, "vtkOFFReader"):
            self.assertEqual(self.export("a.off").GetNumberOfCells(), 1)
        else:
            self.assert_error(
                1, ["a.off", "VTK", ".off", ".gltf", ".ply", ".vtu"], "a.off", "--output=n.png"
            )

    def test_other_formats(self):
        """A file that no reader recognizes might be a mesh, so the error lists the mesh formats."""
        formats = [".glb", ".gltf", ".obj", ".ply", ".stl", ".vtk", ".vts, .vtu or PLOT3D files"]
        for name in ("a.dae", "a"):
            (self.folder / name).write_text("neither heights nor a mesh\n")
            self.assert_error(1, ["Cannot read " + name, *formats], name, "--output=n.png")
        # Not for other causes.
        (self.folder / "empty.dae").write_text("")
        (self.folder / "text.tif").write_text("neither heights nor a mesh\n")
        (self.folder / "cut.tif").write_bytes(b"II*\0")
        for name in ("empty.dae", "missing.dae", "text.tif", "cut.tif"):
            run = self.view(name, "--output=n.png", code=1)
            self.assertIn(name, run.stderr)
            self.assertNotIn(".gltf", run.stderr)

    def test_time_steps(self):
        """Of several time steps the first one is drawn, and a note says so."""
        try:
            from vtkmodules.vtkIOExodus import vtkExodusIIWriter
        except ImportError:
            self.skipTest("VTK has no Exodus reader")
        source = CubeOverTime()
        writer = vtkExodusIIWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(str(self.folder / "time.ex2"))
        writer.WriteAllTimeStepsOn()
        writer.Write()
        for volume in ((), ("--volume=Left",)):
            run = self.view("time.ex2", "--output=t.png", "--size=160x100", *volume)
            said = run.stdout.splitlines()
            self.assertEqual(
                said[0], "time step 1 of 3, time 0.5 of 0.5 to 2.5; --time T draws another"
            )


if __name__ == "__main__":
    unittest.main(argv=["TestViewerFormats"])
