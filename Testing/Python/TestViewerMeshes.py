# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on meshes: formats, surfaces, methods, heights, pictures, arrays, and errors."""

import itertools
import math
import re
import unittest

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    vtkCellArray,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkRegularPolygonSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)

from ViewerPictures import read_picture
from ViewerProgram import ViewerProgram
from ViewerScenes import make_sphere

WRITERS = {
    ".obj": vtkOBJWriter,
    ".ply": vtkPLYWriter,
    ".stl": vtkSTLWriter,
    ".vtk": vtkPolyDataWriter,
    ".vtp": vtkXMLPolyDataWriter,
}
OTHER_WRITERS = {".vtu": vtkXMLUnstructuredGridWriter}
READERS = {
    ".obj": vtkOBJReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".vtp": vtkXMLPolyDataReader,
}
SURFACES = ("linear", "pn", "phong", "st", "g1", "procedural")
METHODS = ("arkfpi", "ark", "dmr", "suapt", "tessellation", "uniform")


def read(name):
    reader = READERS[name.suffix]()
    reader.SetFileName(str(name))
    reader.Update()
    return reader.GetOutput()


class TestViewerMicroMeshes(ViewerProgram):
    """Proves dense-meshes.md: the program writes and draws micro-meshes."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write_data("sphere.vtp", vtkXMLPolyDataWriter, make_sphere())

    def test_micro_meshes(self):
        run = self.view("sphere.vtp", "--micromesh=s.rmm", "--tolerance=0.9%", "--output=a.png")
        self.assertRegex(run.stdout, r"micro-mesh: \d+ faces, error at most [\d.e-]+ from the mesh and "
                                     r"[\d.e-]+ back, 0\.\d+ % of the diagonal of the input; the mesh has \d+ faces")
        self.assertRegex(run.stdout, r"s\.rmm: \d+\.\d kB, \d+\.\d+ of the \d+\.\d kB of these triangles")
        self.assertNotIn("--isosurfaces", run.stdout)
        again = self.view("s.rmm", "--output=b.png")
        # Reading tells the same error, also relative to the input.
        self.assertEqual(again.stdout.splitlines()[0], run.stdout.splitlines()[0].split(";")[0])
        a, b = (read_picture(self.folder / name) for name in ("a.png", "b.png"))
        self.assertEqual(a, b)
        self.view("sphere.vtp", "--micromesh=t.rmm", "--tolerance=0.02")
        self.assertTrue((self.folder / "t.rmm").exists())
        few = self.statistic("triangles", "s.rmm", "--error=10")
        self.assertLess(few, self.statistic("triangles", "s.rmm", "--error=0.2"))
        self.view("s.rmm", "--export=s.ply")
        self.assertGreater(read(self.folder / "s.ply").GetNumberOfCells(), 10)

    def test_isosurfaces(self):
        """The outer surface of solid cells is encoded with a word about isosurfaces."""
        size = 24
        image = vtkImageData()
        image.SetDimensions(size, size, size)
        image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
        image.GetPointData().GetScalars().SetName("Density")
        middle = 0.5 * (size - 1)
        for k, j, i in itertools.product(range(size), repeat=3):
            distance = math.dist((i, j, k), (middle,) * 3)
            image.SetScalarComponentFromDouble(i, j, k, 0, max(0.0, 200.0 - 10.0 * distance))
        self.write_data("ct.vti", vtkXMLImageDataWriter, image)
        outer = self.view("ct.vti", "--micromesh=outer.rmm").stdout
        self.assertIn("outer surface of solid cells. For isosurfaces", outer)
        inner = self.view("ct.vti", "--micromesh=inner.rmm", "--isosurfaces=120", "--tolerance=0.5%").stdout
        self.assertNotIn("outer surface", inner)
        share = float(re.search(r"([\d.]+) % of the diagonal of the input", inner)[1])
        self.assertLessEqual(share, 0.5)
        self.view("inner.rmm", "--export=inner.ply")
        bounds = read(self.folder / "inner.ply").GetBounds()
        radius = (200.0 - 120.0) / 10.0
        for low, high in zip(bounds[::2], bounds[1::2]):
            self.assertAlmostEqual(low, middle - radius, delta=0.5)
            self.assertAlmostEqual(high, middle + radius, delta=0.5)
        self.assert_error(1, ["no isosurface at these values", "'Density' is from 0"], "ct.vti",
                          "--micromesh=none.rmm", "--isosurfaces=900")
        self.assert_error(1, ["--isosurfaces", "no solid cells"], "sphere.vtp",
                          "--micromesh=none.rmm", "--isosurfaces=1")
        self.assert_error(2, ["--isosurfaces requires --volume or --micromesh"], "ct.vti",
                          "--isosurfaces=1")

    def test_time_steps(self):
        """One file per time step, or a word about the others."""
        sets = []
        for step in range(3):
            self.write_data(f"step{step}.vtp", vtkXMLPolyDataWriter, make_sphere())
            sets.append(f'<DataSet timestep="{step}" file="step{step}.vtp"/>')
        (self.folder / "steps.pvd").write_text(
            f'<VTKFile type="Collection" version="0.1"><Collection>{"".join(sets)}</Collection></VTKFile>')
        one = self.view("steps.pvd", "--micromesh=one.rmm").stdout
        self.assertIn("This is one of 3 time steps. For all of them, use a name such as one%04d.rmm", one)
        every = self.view("steps.pvd", "--micromesh=every%02d.rmm").stdout
        self.assertEqual(len(re.findall(r"micro-mesh: \d+ faces", every)), 3)
        for step in range(3):
            self.assertEqual((self.folder / f"every{step:02d}.rmm").read_bytes(),
                             (self.folder / "one.rmm").read_bytes())
        self.assert_error(1, ["has no time steps"], "sphere.vtp", "--micromesh=every%02d.rmm")
        self.assert_error(2, ["--time cannot be combined"], "steps.pvd", "--micromesh=a%d.rmm", "--time=1")

    def test_noise(self):
        """A warning counts the sharp edges of a noisy scan, and --feature-angle ignores them."""
        noisy = vtkPolyData()
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(60)
        sphere.SetPhiResolution(60)
        sphere.Update()
        noisy.DeepCopy(sphere.GetOutput())
        for i in range(noisy.GetNumberOfPoints()):
            factor = 1.0 + 0.08 * math.sin(12345.0 * i)
            noisy.GetPoints().SetPoint(i, [factor * x for x in noisy.GetPoint(i)])
        self.write_data("noisy.vtp", vtkXMLPolyDataWriter, noisy)
        run = self.run_program("noisy.vtp", "--micromesh=kept.rmm", "--tolerance=10%")
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"warning: The coarse mesh has \d+ of \d+ triangles, because "
                                     r"\d+ edges are sharper than --feature-angle, 60 degrees")
        self.assertIn("use --feature-angle 180", run.stderr)
        faces = int(re.search(r"micro-mesh: (\d+) faces", run.stdout)[1])
        run = self.view("noisy.vtp", "--micromesh=smooth.rmm", "--tolerance=10%", "--feature-angle=180")
        self.assertLess(int(re.search(r"micro-mesh: (\d+) faces", run.stdout)[1]), 0.5 * faces)

    def test_errors(self):
        name = "sphere.vtp"
        self.assert_error(2, ["--micromesh", ".rmm"], name, "--micromesh=s.ply")
        self.assert_error(2, ["--tolerance requires --micromesh"], name, "--tolerance=1")
        for tolerance in ("0", "-1%", "%", "nan"):
            self.assert_error(2, ["--tolerance"], name, "--micromesh=u.rmm", f"--tolerance={tolerance}")
        self.assert_error(2, ["--clip cannot be combined with --micromesh"], name,
                          "--micromesh=u.rmm", "--clip=0,0,0,1,0,0")
        self.assert_error(1, ["u.rmm", "does not exist"], name, "--micromesh=none/u.rmm")
        (self.folder / "bad.rmm").write_bytes(b"no micro-mesh")
        self.assert_error(1, ["bad.rmm: it is not an .rmm file"], "bad.rmm", "--output=c.png")


class TestViewerMeshes(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sphere = make_sphere()
        cls.file = cls.write(cls.sphere, "sphere.vtp")

    @classmethod
    def write(cls, mesh, name):
        name = cls.folder / name
        writer = {**WRITERS, **OTHER_WRITERS}[name.suffix]()
        writer.SetInputData(mesh)
        writer.SetFileName(str(name))
        writer.Write()
        return name

    @classmethod
    def write_image(cls, name, value, size=16, components=1):
        """An image of value(column, row, component)."""
        image = vtkImageData()
        image.SetDimensions(size, size, 1)
        image.AllocateScalars(VTK_UNSIGNED_CHAR, components)
        for j in range(size):
            for i in range(size):
                for c in range(components):
                    image.SetScalarComponentFromDouble(i, j, 0, c, value(i, j, c))
        writer = vtkPNGWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(cls.folder / name))
        writer.Write()
        return cls.folder / name

    def export(self, *arguments, file=None, extension=".vtp"):
        name = self.folder / f"refined{extension}"
        self.view(file or self.file, "--export", name, *arguments)
        return read(name)

    def pixels(self, *arguments, file=None):
        """RGB of all pixels except the sky, which is blue."""
        self.view(file or self.file, "--output", "p.png", "--size=160x100", *arguments)
        reader = vtkPNGReader()
        reader.SetFileName(str(self.folder / "p.png"))
        reader.Update()
        image = reader.GetOutput()
        values = [
            tuple(image.GetScalarComponentAsFloat(i, j, 0, c) for c in range(3))
            for j in range(100)
            for i in range(30, 160)
        ]
        sky = [image.GetScalarComponentAsFloat(159, 0, 0, c) for c in range(3)]
        self.assertGreater(sky[2], sky[0] + 15)
        return values

    def radii(self, mesh):
        return [math.dist(mesh.GetPoint(i), (0, 0, 0)) for i in range(mesh.GetNumberOfPoints())]

    def test_formats(self):
        """Every format can be read and written, in the mesh's coordinates."""
        for extension in WRITERS:
            file = self.write(self.sphere, "in" + extension)
            mesh = self.export("--surface=linear", "--level=1", file=file)
            self.assertEqual(mesh.GetNumberOfCells(), 4 * self.sphere.GetNumberOfCells(), extension)
            for bound, expected in zip(mesh.GetBounds(), self.sphere.GetBounds()):
                self.assertAlmostEqual(bound, expected, places=5)
        for extension in READERS:
            mesh = self.export("--level=2", extension=extension)
            self.assertEqual(mesh.GetNumberOfCells(), 16 * self.sphere.GetNumberOfCells(), extension)
            self.assertAlmostEqual(max(self.radii(mesh)), 0.5, places=2)

    def test_surface_of_a_volume(self):
        """A .vtk file may contain any data set, whose surface is drawn."""
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        writer = vtkDataSetWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(self.folder / "volume.vtk"))
        writer.Write()
        mesh = self.export("--surface=linear", "--level=0", file="volume.vtk")
        self.assertEqual(mesh.GetNumberOfCells(), 6 * 4 * 2)

    def test_surfaces(self):
        """All surfaces except fur contain the sphere's points. Curved ones are closer to the
        sphere."""
        inside, outside = {}, {}
        for surface in SURFACES:
            mesh = self.export("--surface", surface, "--level=2")
            self.assertEqual(mesh.GetNumberOfCells(), 16 * self.sphere.GetNumberOfCells())
            radii = self.radii(mesh)
            inside[surface], outside[surface] = 0.5 - min(radii), max(radii) - 0.5
        for surface in ("pn", "phong", "st", "g1"):
            self.assertLess(inside[surface], 0.4 * inside["linear"], inside)
        self.assertLess(outside["linear"], 1e-5)
        self.assertGreater(outside["procedural"], 0.01)

    def test_numbers_of_surfaces(self):
        flat = min(self.radii(self.export("--surface=linear", "--level=2")))
        self.assertAlmostEqual(
            min(self.radii(self.export("--surface=phong", "--alpha=0", "--level=2"))), flat, places=6
        )
        furs = [
            max(self.radii(self.export("--surface=procedural", "--level=3", *fur)))
            for fur in (("--amplitude=0",), ("--amplitude=0.2",), ("--amplitude=0.4",))
        ]
        self.assertAlmostEqual(furs[0], 0.5, places=5)
        self.assertGreater(furs[1], 0.55)
        self.assertGreater(furs[2], furs[1] + 0.05)
        waves = [
            self.radii(self.export("--surface=procedural", "--level=3", "--frequency", n))
            for n in ("1", "3")
        ]
        self.assertNotEqual(*waves)

    def test_tags(self):
        """Without tags, the surface equals PN triangles. A sharp vertex has straight edges."""
        meshes = [self.export("--surface", surface, "--level=2") for surface in ("pn", "st")]
        self.assertEqual(*([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())] for mesh in meshes))
        tagged = vtkPolyData()
        tagged.DeepCopy(self.sphere)
        sharpness = vtkDoubleArray()
        sharpness.SetName("Sharpness")
        for i in range(tagged.GetNumberOfPoints()):
            sharpness.InsertNextValue(i == 0)  # the pole at z = 0.5
        tagged.GetPointData().AddArray(sharpness)
        sharp = self.export("--surface=st", "--level=2", file=self.write(tagged, "tagged.vtp"))
        self.assertLess(min(self.radii(sharp)), min(self.radii(meshes[0])) - 0.001)

    def test_methods(self):
        """All methods draw the same sphere with different numbers of calls."""
        calls = {}
        pictures = {}
        for method in METHODS:
            common = (self.file, "--level=2", "--method", method)
            calls[method] = self.statistic("draw calls", *common)
            pictures[method] = self.pixels("--level=2", "--method", method)
        self.assertEqual(calls["ark"], self.sphere.GetNumberOfCells())
        self.assertLess(calls["arkfpi"], 4)
        for method, pixels in pictures.items():
            differences = sum(
                max(abs(a - b) for a, b in zip(one, other)) > 40
                for one, other in zip(pixels, pictures["arkfpi"])
            )
            self.assertLess(differences, 0.01 * len(pixels), method)

    def test_heights(self):
        """A constant height map moves the sphere outwards along its normals by this height."""
        flat = self.write_image("flat.png", lambda i, j, c: 10)
        for arguments, radius in (
            (("--scale=0.01",), 0.6),
            (("--scale=0", "--offset=0.2"), 0.7),
            (("--scale=0.01", "--offset=0.2"), 0.8),
        ):
            mesh = self.export("--height", flat, "--surface=pn", "--level=2", *arguments)
            for distance in self.radii(mesh):
                self.assertAlmostEqual(distance, radius, delta=0.01)

    def test_default_relief(self):
        """Heights cover a twentieth of the diagonal, upwards from the surface, in every unit."""
        for name, low, high in (("low.png", 0, 15), ("high.png", 200, 215)):
            ramp = self.write_image(name, lambda i, j, c: low + (high - low) * j / 15)
            radii = self.radii(
                self.export("--height", ramp, "--surface=pn", "--level=2", "--up=z")
            )
            self.assertAlmostEqual(min(radii), 0.5, delta=0.005)
            self.assertAlmostEqual(max(radii), 0.5 + 0.05 * self.sphere.GetLength(), delta=0.005)

    def test_mapping(self):
        """Wrapped around, v runs from the lower to the upper pole. Projected, it follows the
        bounding box."""
        ramp = self.write_image("ramp.png", lambda i, j, c: 16 * j)
        mesh = self.export(
            "--height", ramp, "--scale=0.001", "--surface=pn", "--level=1", "--up=z"
        )
        for i in range(mesh.GetNumberOfPoints()):
            point = mesh.GetPoint(i)
            radius = math.dist(point, (0, 0, 0))
            v = 1 - math.acos(point[2] / radius) / math.pi
            expected = 0.5 + 0.001 * 16 * min(max(16 * v - 0.5, 0), 15)
            self.assertAlmostEqual(radius, expected, delta=0.02)
        disc = vtkRegularPolygonSource()
        disc.SetNumberOfSides(12)
        disc.GeneratePolylineOff()
        disc.Update()
        file = self.write(disc.GetOutput(), "disc.vtp")  # faces z
        common = ("--height", ramp, "--scale=0.001", "--surface=linear", "--level=3")
        mesh = self.export(*common, file=file)
        for i in range(mesh.GetNumberOfPoints()):
            _, y, z = mesh.GetPoint(i)
            v = y + 0.5
            self.assertAlmostEqual(abs(z), 0.001 * 16 * min(max(16 * v - 0.5, 0), 15), delta=0.001)
        around = self.export(*common, "--mapping=sphere", file=file)
        self.assertNotEqual(self.radii(mesh), self.radii(around))

    def test_picture_on_a_mesh(self):
        red = self.write_image("red.png", lambda i, j, c: 220 if c == 0 else 20, components=3)
        seen = self.pixels("--image", red)
        self.assertGreater(sum(r > 3 * g and r > 3 * b for r, g, b in seen), 1500)

    def test_arrays(self):
        """The scalars or --array are shown with a legend: Viridis from the lowest to the highest
        value."""
        plain = self.pixels("--view=205,0", "--up=z")
        coloured = self.pixels("--view=205,0", "--up=z", "--array=Latitude")
        for pixels, expected in ((plain, False), (coloured, True)):
            yellow = sum(r > 1.5 * b and g > 1.5 * b and r > 60 for r, g, b in pixels) > 50
            violet = sum(r < 70 and 2 * g < b for r, g, b in pixels) > 50
            self.assertEqual((yellow, violet), (expected, expected))
        arrays = "'Latitude' of points, 'Around' of points with 3 components"
        out = "--output=n.png", "--size=160x100"
        self.assert_error(1, ["'Longitude'", arrays], self.file, "--array=Longitude", *out)
        self.assertIn(f"arrays: {arrays}; --array", self.view(self.file, *out).stdout)
        for chosen in ("--array=Around", "--color-by=level", "--lic=Around"):
            self.assertNotIn("arrays:", self.view(self.file, chosen, *out).stdout)

    def test_title_of_magnitudes(self):
        """Vectors are coloured by length, with or without a name."""
        pictures = []
        for name, components in (("Stress", 3), ("Stress (magnitude)", 1), ("Stress", 1)):
            values = vtkDoubleArray()
            values.SetName(name)
            values.SetNumberOfComponents(components)
            for i in range(self.sphere.GetNumberOfPoints()):
                values.InsertNextTuple((i, 0, 0)[:components])
            mesh = vtkPolyData()
            mesh.ShallowCopy(self.sphere)
            mesh.GetPointData().AddArray(values)
            file = self.write(mesh, "stress.vtp")
            self.view(file, "--array", name, "--output=t.png", "--size=320x240")
            picture = read_picture(self.folder / "t.png")
            pictures.append([colour for row in picture for colour in row[:160]])
        different = [
            sum(max(abs(a - b) for a, b in zip(*pair)) > 30 for pair in zip(pictures[0], other))
            for other in pictures[1:]
        ]
        self.assertLess(different[0], 5)
        self.assertGreater(different[1], 50)

    def test_flat_faces_as_they_are(self):
        """Flat meshes are not refined, unless levels are to be shown."""
        faces = self.sphere.GetNumberOfCells()
        self.assertEqual(self.export("--surface=linear").GetNumberOfCells(), faces)
        drawn = self.statistic("drawn triangles", self.file, "--surface=linear")
        self.assertLessEqual(drawn, faces)
        for asked in ("--metric=screen-edge", "--pixels=2", "--max-level=3", "--color-by=level"):
            mesh = self.export("--surface=linear", "--size=160x100", asked)
            self.assertGreater(mesh.GetNumberOfCells(), faces, asked)

    def test_field_metric(self):
        common = (self.file, "--metric=field", "--array=Latitude", "--max-level=3")
        count = self.statistic("drawn triangles", *common)
        self.assertLess(self.sphere.GetNumberOfCells(), count)
        self.assertLess(count, 64 * self.sphere.GetNumberOfCells())
        self.assert_error(1, ["--array"], self.file, "--metric=field", "--output=n.png")

    def test_region_metric(self):
        mesh = self.export("--metric=region", "--region=0,0,0.5,0.2", "--max-level=3")
        heights = [mesh.GetPoint(i)[2] for i in range(mesh.GetNumberOfPoints())]
        self.assertGreater(sum(z > 0.3 for z in heights), 5 * sum(z < -0.3 for z in heights))

    def test_default_is_a_length_on_the_screen(self):
        """Larger pictures give more triangles, longer segments fewer."""
        curved = "drawn triangles", self.file, "--surface=pn"
        small = self.statistic(*curved)
        fine = self.statistic(*curved, "--pixels=2")
        coarse = self.statistic(*curved, "--pixels=12")
        self.assertGreater(fine, 2 * small)
        self.assertGreater(small, 2 * coarse)

    def test_feature_angle(self):
        """A cube with shared corners becomes round with PN triangles, and keeps its edges with
        --feature-angle. It is closed in both cases."""
        cube = vtkPolyData()
        points = vtkPoints()
        for i in range(8):
            points.InsertNextPoint(i & 1, i >> 1 & 1, i >> 2)
        faces = vtkCellArray()
        for corners in (
            (0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5),
        ):
            faces.InsertNextCell(4, corners)
        cube.SetPoints(points)
        cube.SetPolys(faces)
        file = self.write(cube, "cube.vtp")
        round_ = self.export("--level=3", "--surface=pn", file=file)
        sharp = self.export("--level=3", "--surface=pn", "--feature-angle=30", file=file)
        middle = max(round_.GetBounds())
        self.assertGreater(middle, 1.1)
        self.assertAlmostEqual(max(sharp.GetBounds()), 1.0, delta=1e-6)
        edges = vtkFeatureEdges()
        edges.SetInputData(round_)
        edges.FeatureEdgesOff()
        edges.ManifoldEdgesOff()
        edges.Update()
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)

    def test_default_surface(self):
        """Cells and creases keep the shape of the data. Smooth meshes are curved, and a note says
        so."""
        beam = vtkUnstructuredGrid()
        beam.SetPoints(vtkPoints())
        for k, j, i in itertools.product(range(2), range(3), range(5)):
            beam.GetPoints().InsertNextPoint(i, j, k)
        for j, i in itertools.product(range(2), range(4)):
            a = 5 * j + i
            corners = (a, a + 1, a + 6, a + 5)
            beam.InsertNextCell(VTK_HEXAHEDRON, 8, (*corners, *(c + 15 for c in corners)))
        block = vtkCubeSource()
        block.SetXLength(4)
        block.SetYLength(2)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(block.GetOutputPort())
        triangles.Update()
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(60)
        sphere.SetPhiResolution(60)
        sphere.Update()
        for data, name, is_curved in (
            (beam, "beam.vtu", False),
            (triangles.GetOutput(), "block.stl", False),
            (self.sphere, "coarse.vtp", False),
            (sphere.GetOutput(), "smooth.ply", True),
        ):
            file = self.write(data, name)
            with self.subTest(name):
                flat = self.export("--surface=linear", "--level=0", file=file)
                refined = self.export("--level=2", file=file)
                ratio = self.volume(refined) / self.volume(flat)
                if is_curved:
                    self.assertGreater(ratio, 1.002)
                    self.assertLess(ratio, 1.01)
                else:
                    self.assertAlmostEqual(ratio, 1, delta=1e-5)
                    self.assertLess(self.count_differences(file), 10)  # along edges
                said = self.view(file, "--output=p.png", "--size=160x100").stdout
                self.assertEqual("surface: curved" in said, is_curved, said)
                chosen = self.view(file, "--surface=pn", "--output=p.png", "--size=160x100")
                self.assertNotIn("surface:", chosen.stdout)

    def volume(self, mesh):
        properties = vtkMassProperties()
        properties.SetInputData(mesh)
        properties.Update()
        return properties.GetVolume()

    def count_differences(self, file):
        """Number of pixels that differ from the data's faces, which vtkPolyDataMapper draws like
        the mapper at level 0."""
        pictures = [
            self.pixels(*arguments, file=file) for arguments in ((), ("--surface=linear", "--level=0"))
        ]
        return sum(max(abs(a - b) for a, b in zip(*pair)) > 8 for pair in zip(*pictures))

    def test_bad_usage(self):
        for words, *arguments in (
            (["more than one file"], self.file),
            (["--exaggeration", "requires a height map"], "--exaggeration=2"),
            (["--resolution", "requires a height map"], "--resolution=2"),
            (["--scale", "--height"], "--scale=2"),
            (["--mapping", "--height"], "--mapping=plane"),
            (["--alpha", "phong"], "--alpha=0.5"),
            (["--alpha", "'2'"], "--surface=phong", "--alpha=2"),
            (["--amplitude", "procedural"], "--amplitude=2"),
            (["--surface", "g1", "'nurbs'"], "--surface=nurbs"),
            (["--method", "suapt", "'fast'"], "--method=fast"),
            (["--level", "'9'"], "--level=9"),
            (["--reach", "distance"], "--reach=9"),
            (["--region", "X,Y,Z,RADIUS"], "--metric=region", "--region=1,2,3"),
            (["--region", "radius"], "--metric=region", "--region=1,2,3,0"),
            (["--feature-angle", "'200'"], "--feature-angle=200"),
            (["--up", "'w'"], "--up=w"),
            (["--export", ".ply", "a.png"], "--export=a.png"),
        ):
            self.assert_error(2, words, self.file, *arguments)

    def test_bad_files(self):
        out = ("--output", self.folder / "never.png")
        for extension in WRITERS:
            self.assert_error(1, ["missing" + extension], "missing" + extension, *out)
            for name, text in (("empty", ""), ("text", "no mesh\n")):
                (self.folder / (name + extension)).write_text(text)
                self.assert_error_last(name + extension, *out)
        (self.folder / "folder.ply").mkdir()
        self.assert_error(1, ["folder.ply"], "folder.ply", *out)
        self.assert_error(1, ["missing.png"], self.file, "--height", "missing.png", *out)
        self.assert_error(1, ["missing.png"], self.file, "--image", "missing.png", *out)
        self.assert_error(1, ["text.ply"], self.file, "--image", "text.ply", *out)
        self.assert_error(1, ["nowhere"], self.file, "--export", "nowhere/a.stl")
        self.assertFalse((self.folder / "never.png").exists())

    def test_bad_meshes(self):
        out = ("--output", self.folder / "never.png")
        lost = vtkPolyData()
        lost.DeepCopy(self.sphere)
        lost.GetPoints().SetPoint(7, math.nan, 0, 0)
        self.assert_error(1, ["1 of 62", "finite"], self.write(lost, "nan.vtp"), *out)
        points = vtkPolyData()
        points.SetPoints(self.sphere.GetPoints())
        self.assert_error(1, ["polygons"], self.write(points, "points.vtp"), *out)
        (self.folder / "degenerate.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 0 0\nf 1 2 3\n")
        self.assert_error_last("degenerate.obj", *out)
        (self.folder / "cut.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
        self.assert_error_last("cut.obj", *out, words=["point 9", "there are 3"])
        self.assertFalse((self.folder / "never.png").exists())

    def assert_error_last(self, name, *arguments, words=()):
        """Exit code 1 and one line of error, possibly after warnings."""
        run = self.view(name, *arguments, code=1)
        lines = run.stderr.splitlines()
        self.assertTrue(all(line.startswith("relevo-view: warning: ") for line in lines[:-1]), lines)
        self.assertTrue(lines[-1].startswith("relevo-view: error: "), lines)
        for word in words or [name]:
            self.assertIn(word, lines[-1])


if __name__ == "__main__":
    unittest.main(argv=["TestViewerMeshes"])
