# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on exported height maps: all formats within their tolerance, their coordinates,
pictures and messages. The files are read by VTK, and .glb files also byte by byte."""

import json
import math
import re
import struct
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ViewerProgram import ViewerProgram

GEOGRAPHIC = (
    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]'
)
PROJECTED = (
    f'PROJCS["WGS 84 / UTM zone 33N",{GEOGRAPHIC},PROJECTION["Transverse_Mercator"],'
    'PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],'
    'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],'
    'PARAMETER["false_northing",0],UNIT["metre",1]]'
)
COLUMNS, ROWS = 60, 45
AXIS, FLATTENING = 6378137.0, 1 / 298.257223563
SQUARE = FLATTENING * (2 - FLATTENING)  # of the eccentricity
READERS = {
    ".vtp": vtkXMLPolyDataReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader, ".obj": vtkOBJReader
}


class TestViewerTerrainMesh(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        x, y = numpy.meshgrid(numpy.arange(COLUMNS), numpy.arange(ROWS))
        # Floats represent them exactly.
        heights = 600 * numpy.sin(0.15 * x) * numpy.cos(0.11 * y) + 40 * numpy.sin(1.3 * x + y)
        cls.heights = numpy.round(8 * heights) / 8

    def setUp(self):
        if self.run_program(self.degrees(), "--height-at=12.1,47.1").returncode != 0:
            self.skipTest("a build without GDAL")

    def raster(self, name, corner, side, system, heights=None):
        heights = self.heights if heights is None else heights
        rows = "\n".join(" ".join(map(str, row)) for row in heights)
        (self.folder / name).write_text(
            f"ncols {heights.shape[1]}\nnrows {heights.shape[0]}\nxllcorner {corner[0]}\n"
            f"yllcorner {corner[1]}\ncellsize {side}\nNODATA_value -9999\n{rows}\n"
        )
        (self.folder / name).with_suffix(".prj").write_text(system)
        return name

    def degrees(self):
        return self.raster("degrees.asc", (12, 47), 0.01, GEOGRAPHIC)

    def metres(self):
        return self.raster("metres.asc", (500000, 5000000), 30, PROJECTED)

    def export(self, file, name, *arguments):
        """Positions, triangles and the lines of the output. .glb files are read byte by byte."""
        lines = self.view(file, "--export", name, *arguments).stdout.splitlines()
        if name.endswith(".glb"):
            return (*self.read_glb(name), lines)
        reader = READERS[name[-4:]]()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        self.mesh = reader.GetOutput()
        points = vtk_to_numpy(self.mesh.GetPoints().GetData()).astype(float)
        triangles = vtk_to_numpy(self.mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        return points, triangles, lines

    def read_glb(self, name):
        data = (self.folder / name).read_bytes()
        magic, version, length, size, kind = struct.unpack("<4sIII4s", data[:20])
        self.assertEqual((magic, version, length, kind), (b"glTF", 2, len(data), b"JSON"))
        self.gltf = json.loads(data[20:20 + size])
        count, kind = struct.unpack("<I4s", data[20 + size:28 + size])
        self.assertEqual(kind, b"BIN\0")
        self.binary = data[28 + size:]
        self.assertEqual((size % 4, count % 4, count), (0, 0, len(self.binary)))

        def read(number):
            accessor = self.gltf["accessors"][number]
            view = self.gltf["bufferViews"][accessor["bufferView"]]
            components = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
            kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
            values = numpy.frombuffer(
                self.binary, kind, accessor["count"] * components, view["byteOffset"]
            ).reshape(-1, components)
            if "min" in accessor:
                self.assertEqual(list(values.min(axis=0)), accessor["min"])
                self.assertEqual(list(values.max(axis=0)), accessor["max"])
            return values

        primitive = self.gltf["meshes"][0]["primitives"][0]
        self.attributes = {name: read(i) for name, i in primitive["attributes"].items()}
        normals = self.attributes["NORMAL"]
        numpy.testing.assert_allclose(numpy.linalg.norm(normals, axis=1), 1, atol=1e-5)
        self.assertEqual(primitive["mode"], 4)
        # From the file's axes, in double precision, to z up.
        matrix = numpy.array(self.gltf["nodes"][0]["matrix"]).reshape(4, 4).T
        points = self.attributes["POSITION"].astype(float) @ matrix[:3, :3].T + matrix[:3, 3]
        points = numpy.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)
        return points, read(primitive["indices"]).reshape(-1, 3)

    def interpolate(self, columns, rows):
        columns = numpy.clip(columns, 0, COLUMNS - 1)
        rows = numpy.clip(rows, 0, ROWS - 1)
        i = numpy.minimum(columns.astype(int), COLUMNS - 2)
        j = numpy.minimum(rows.astype(int), ROWS - 2)
        u, v = columns - i, rows - j
        h = self.heights
        return ((h[j, i] * (1 - u) + h[j, i + 1] * u) * (1 - v)
                + (h[j + 1, i] * (1 - u) + h[j + 1, i + 1] * u) * v)

    def from_map(self, points, lengths):
        """Columns, rows and heights of points of the map frame."""
        return (points[:, 0] / lengths[0] + (COLUMNS - 1) / 2,
                -points[:, 1] / lengths[1] + (ROWS - 1) / 2, points[:, 2])

    def from_globe(self, points):
        """The same for the raster in degrees on the ellipsoid."""
        x, y, z = points.T
        across = numpy.hypot(x, y)
        latitude = numpy.arctan2(z, across * (1 - SQUARE))
        for _ in range(8):
            radius = AXIS / numpy.sqrt(1 - SQUARE * numpy.sin(latitude) ** 2)
            height = (across * numpy.cos(latitude) + z * numpy.sin(latitude)
                      - AXIS**2 / radius)
            latitude = numpy.arctan2(z, across * (1 - SQUARE * radius / (radius + height)))
        longitude = numpy.degrees(numpy.arctan2(y, x))
        return ((longitude - 12) / 0.01 - 0.5,
                (47 + 0.01 * ROWS - numpy.degrees(latitude)) / 0.01 - 0.5, height)

    @staticmethod
    def degree_lengths():
        latitude = math.radians(47 + 0.005 * ROWS)
        w = math.sqrt(1 - SQUARE * math.sin(latitude) ** 2)
        return (0.01 * math.radians(AXIS) / w * math.cos(latitude),
                0.01 * math.radians(AXIS) * (1 - SQUARE) / w**3)

    def assert_tolerance(self, points, triangles, to_samples, tolerance, rounding=1e-6):
        """Vertices lie on the surface, except those at clipped borders; others are near it."""
        columns, rows, heights = to_samples(points)
        self.assertAlmostEqual(columns.min(), 0, delta=1e-3)
        self.assertAlmostEqual(columns.max(), COLUMNS - 1, delta=1e-3)
        self.assertAlmostEqual(rows.min(), 0, delta=1e-3)
        self.assertAlmostEqual(rows.max(), ROWS - 1, delta=1e-3)
        inside = (columns < COLUMNS - 1.001) & (rows < ROWS - 1.001)
        distances = abs(heights - self.interpolate(columns, rows))
        self.assertLess(distances[inside].max(), rounding)
        random = numpy.random.default_rng(2)
        worst = 0
        for i in range(5):
            if i < 3:
                weights = random.dirichlet((1, 1, 1), len(triangles))
            else:
                weights = numpy.tile((0.5, 0.5, 0) if i == 3 else (1 / 3,) * 3, (len(triangles), 1))
            places = (points[triangles] * weights[:, :, None]).sum(axis=1)
            columns, rows, heights = to_samples(places)
            worst = max(worst, abs(heights - self.interpolate(columns, rows)).max())
        self.assertLessEqual(worst, tolerance + 1e-9)
        self.assertGreater(worst, 0.2 * tolerance)

    def test_formats(self):
        """All formats are within the tolerance, in metres around the centre."""
        for file, lengths, name in (
            (self.degrees(), self.degree_lengths(), "WGS 84"),
            (self.metres(), (30, 30), "WGS 84 / UTM zone 33N"),
        ):
            counts = set()
            for extension in (".vtp", ".ply", ".stl", ".obj", ".glb"):
                with self.subTest(file + extension):
                    points, triangles, lines = self.export(file, "m" + extension, "--tolerance=5")
                    is_double = extension == ".vtp"
                    self.assert_tolerance(
                        points, triangles, lambda p: self.from_map(p, lengths), 5,
                        1e-6 if is_double else 0.01
                    )
                    found = re.fullmatch(
                        rf"m{extension}: (\d+) triangles, at most ([0-9.]+) m above or below the "
                        "raster", lines[0])
                    self.assertEqual(int(found[1]), len(triangles))
                    self.assertLessEqual(float(found[2]), 5)
                    self.assertRegex(
                        lines[1], rf"coordinates: metres, x east, .* in {re.escape(name)}")
                    self.assertEqual(len(lines), 2 if is_double else 3)
                    counts.add(len(triangles))
            self.assertLess(max(counts), 1.1 * min(counts))
        self.assertIn("(0, 0) is at 500900, 5000675", lines[1])

    def test_arrays(self):
        points, _, _ = self.export(self.metres(), "m.vtp", "--tolerance=5", "--exaggeration=2")
        heights = vtk_to_numpy(self.mesh.GetPointData().GetArray("Height"))
        numpy.testing.assert_allclose(points[:, 2], 2 * heights)
        coordinates = vtk_to_numpy(self.mesh.GetPointData().GetTCoords())
        numpy.testing.assert_allclose(coordinates[:, 0], points[:, 0] / 1800 + 0.5, atol=1e-6)
        field = self.mesh.GetFieldData()
        self.assertEqual(field.GetArray("Origin").GetTuple3(0), (500900, 5000675, 0))
        self.assertIn("UTM zone 33N", field.GetAbstractArray("CoordinateSystem").GetValue(0))

    def test_comments(self):
        for extension, count in ((".ply", 400), (".obj", 400)):
            self.export(self.metres(), "m" + extension, "--tolerance=50")
            head = (self.folder / f"m{extension}").read_bytes()[:count]
            self.assertIn(b"(0, 0) is at 500900, 5000675 in WGS 84 / UTM zone 33N", head)
        self.export(self.metres(), "m.glb", "--tolerance=50")
        self.assertIn("500900, 5000675", str(self.gltf["nodes"][0]["extras"]))

    def test_globe(self):
        """Geocentric meshes are within the tolerance, too. Floats are around their middle."""
        file = self.degrees()
        points, triangles, lines = self.export(file, "g.vtp", "--globe", "--tolerance=8")
        self.assert_tolerance(points, triangles, self.from_globe, 8)
        self.assertIn("centre of the ellipsoid of WGS 84", lines[1])
        for extension in (".stl", ".obj", ".glb"):
            points, triangles, lines = self.export(
                file, "g" + extension, "--globe", "--tolerance=8")
            origin = [float(number) for number in lines[1].split(" is at ")[1].split(", ")]
            if extension != ".glb":  # has the origin in its matrix
                self.assertLess(abs(points).max(), 1e5)
                points = points + origin
            self.assert_tolerance(points, triangles, self.from_globe, 8, 0.01)

    def test_picture(self):
        """.glb and .obj files have the picture, also in their texture coordinates."""
        pixels = vtkImageData()
        pixels.SetDimensions(60, 45, 1)
        pixels.AllocateScalars(3, 3)
        for y in range(45):
            for x in range(60):
                for band, value in enumerate((4 * x, 5 * y, 90)):
                    pixels.SetScalarComponentFromDouble(x, y, 0, band, value)
        self.write_data("photo.png", vtkPNGWriter, pixels)
        # A world file: the centre of the upper left pixel.
        (self.folder / "photo.pgw").write_text("30\n0\n0\n-30\n500015\n5001335\n")
        options = ("--image=photo.png", "--tolerance=20")
        _, _, lines = self.export(self.metres(), "p.glb", *options)
        self.assertIn("picture: 60 x 45 pixels", lines)
        image = self.gltf["images"][0]
        self.assertEqual(image["mimeType"], "image/png")
        view = self.gltf["bufferViews"][image["bufferView"]]
        data = self.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
        (self.folder / "embedded.png").write_bytes(data)
        material = self.gltf["materials"][0]["pbrMetallicRoughness"]
        self.assertEqual(material["baseColorTexture"]["index"], 0)
        # v points down.
        places, coordinates = self.attributes["POSITION"], self.attributes["TEXCOORD_0"]
        numpy.testing.assert_allclose(coordinates[:, 0], places[:, 0] / 1800 + 0.5, atol=1e-5)
        numpy.testing.assert_allclose(coordinates[:, 1], 0.5 - places[:, 1] / 1350, atol=1e-5)
        for name in ("p.stl", "p.vtp"):
            run = self.run_program(self.metres(), f"--export={name}", *options)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(run.stderr, f"relevo-view: warning: {name} is written without the picture "
                                         "of --image; .glb and .obj files contain it\n")
        self.export(self.metres(), "p q.obj", *options)
        text = (self.folder / "p q.obj").read_text()
        self.assertIn("mtllib p q.mtl\nusemtl terrain\n", text)
        self.assertRegex(text, r"\nf \d+/\d+ \d+/\d+ \d+/\d+\n")
        self.assertIn("map_Kd p q-imagery.png\n", (self.folder / "p q.mtl").read_text())
        for name in ("embedded.png", "p q-imagery.png"):
            reader = vtkPNGReader()
            reader.SetFileName(str(self.folder / name))
            reader.Update()
            for x, y in ((3, 2), (50, 40)):
                color = [reader.GetOutput().GetScalarComponentAsDouble(x, y, 0, c) for c in range(3)]
                numpy.testing.assert_allclose(color, (4 * x, 5 * y, 90), atol=4)
        self.assertFalse([path for path in self.folder.iterdir() if "temporary" in path.name])

    def test_view(self):
        """Without a tolerance, the mesh is that of the view."""
        file = self.metres()
        whole, _, lines = self.export(file, "v.vtp", "--size=400x300", "--error=2")
        self.assertRegex(lines[0], r"in this view at most \S+ pixels above or below the raster")
        self.assertLessEqual(float(lines[0].split("at most ")[1].split()[0]), 2)
        part, _, _ = self.export(file, "v.vtp", "--size=400x300", "--error=2", "--zoom=30")
        self.assertLess(numpy.ptp(part[:, 0]), 0.8 * numpy.ptp(whole[:, 0]))
        globe, _, lines = self.export(file, "v.vtp", "--size=400x300", "--globe")
        self.assertGreater(numpy.linalg.norm(globe, axis=1).min(), 6.3e6)
        fine, _, _ = self.export(file, "v.vtp", "--size=400x300", "--error=0.2")
        self.assertGreater(len(fine), len(whole))

    def test_precision(self):
        """Coordinates that floats round by more than a tenth of the tolerance are a warning."""
        heights = numpy.zeros((36, 72))
        heights[10:20, 10:20] = 4000
        file = self.raster("earth.asc", (-180, -90), 5, GEOGRAPHIC, heights)
        run = self.run_program(file, "--export=e.stl", "--tolerance=2")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stderr, r"warning: floats round the coordinates in e.stl by up to \S+ m")
        self.view(file, "--export=e.vtp", "--tolerance=2")

    def test_errors(self):
        file = self.metres()

        def refuses(code, words, *arguments):
            self.assert_error(code, words, file, *arguments)

        for tolerance in ("0", "-2", "x"):
            refuses(2, ["--tolerance", f"'{tolerance}'"], "--export=a.vtp",
                    f"--tolerance={tolerance}")
        refuses(2, [".glb, .obj, .ply, .stl or .vtp", "a.fbx"], "--export=a.fbx", "--tolerance=1")
        for option in ("--max-level=3", "--resolution=9", "--no-data=fill", "--no-data-value=3"):
            refuses(2, ["--tolerance cannot be combined with", option.split("=")[0]],
                    "--export=a.vtp", "--tolerance=1", option)
        refuses(1, ["nowhere"], "--export=nowhere/a.glb", "--tolerance=1")
        (self.folder / "taken.mtl").mkdir(exist_ok=True)
        (self.folder / "any.png").write_bytes(b"no picture")
        refuses(1, ["taken.mtl"], "--export=taken.obj", "--tolerance=1", "--image=any.png")
        refuses(1, ["too many triangles for --tolerance 1e-09", "larger --tolerance"],
                "--export=a.vtp", "--tolerance=1e-9")
        refuses(1, ["any.png"], "--export=a.glb", "--tolerance=9", "--image=any.png")
        self.assertFalse((self.folder / "a.glb").exists())


if __name__ == "__main__":
    unittest.main(argv=["TestViewerTerrainMesh"])
