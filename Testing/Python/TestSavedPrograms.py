# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that sessions, scripts and C++ sources draw the same picture, to the bit."""

import os
import pathlib
import subprocess
import sys
import unittest

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_QUADRATIC_TRIANGLE,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter, vtkXMLUnstructuredGridWriter

from ViewerProgram import ViewerProgram
from ViewerScenes import (
    make_cube,
    make_sphere,
    write_cube,
    write_hill,
    write_mesh,
    write_sphere,
)

BINARY = pathlib.Path(os.environ["RELEVO_BINARY_DIR"])
SIZE = "--size=300x220"
SCENES = (
    # A refined and displaced mesh with a legend.
    ["sphere.vtp", "--height=hill.png", "--scale=0.01", "--array=Latitude", "--range=-0.3,0.4"]
    + ["--palette=magma", "--below=white", "--metric=curvature", "--method=suapt", "--light=90,20"],
    # The inside of cells.
    ["cube.vtu", "--volume=x of Around", "--isosurfaces=0.1", "--clip=0.5,0,0,1,0.2,0"],
    # A terrain from tiles.
    ["hill.png", "--sea-level=5", "--contours=2", "--view=150,40", "--zoom=1.3"],
    # Streamlines in cells, and all marks, of which one is over the legend.
    ["cube.vtu", "--streamlines=Around", "--seeds=9", "--axes", "--scale-bar", "--extremes"]
    + ["--ruler=-1,0,0,1,1,0.5"],
)
# These need no compiler.
SCRIPTS = (
    ["cube.vtu", "--clip=0.5,0.5,0.5,1,0.2,0", "--array=Left", "--log", "--range=0.1,1"],
    ["sphere.vtp", "--lic=Around", "--lic-steps=8"],
    ["cube.vtu", "--array=Left", "--streamlines=Around", "--seed-line=0,0,0,1,1,1"],
    ["cube.vtu", "--isolines=6", "--clip=0.5,0.5,0.5,1,0.2,0", "--extremes", "--array=Around"],
    ["blocks.vtm", "--volume=Left", "--extremes"],
    ["sphere.vtp", "--image=image.png", "--mapping=sphere", "--ruler=0,0,0,1,0,1"],
    ["sphere.vtp", "--height=hill.png", "--no-data-value=0", "--no-data=fill", "--axes"],
    ["sphere.vtp", "--hair=40"],
    ["hill.png", "--level=2", "--scale-bar"],
    ["sphere.vtp", "--array=Latitude", "--relief=view"],
    ["reliefs.cdb", "--relief-method=refinement"],
    ["sphere.vtp", "--against=ball.vtp", "--contact-distance=0.05"],
    ["cells.vtu", "--against=ball.vtp"],
    ["sphere.vtp", "--color-by=level", "--level=2", "--wireframe"],
)
PROJECT = """cmake_minimum_required(VERSION 3.18)
project(Scenes LANGUAGES C CXX)
foreach (number IN ITEMS 0 1 2 3)
  add_subdirectory(source${number})
endforeach ()
"""


def write_image(folder):
    image = vtkImageData()
    image.SetDimensions(16, 8, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
    for i in range(image.GetNumberOfPoints()):
        colour = (16 * (i % 16), 32 * (i // 16), 200 - i)
        image.GetPointData().GetScalars().SetTuple(i, colour)
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(folder / "image.png"))
    writer.Write()


def write_balls(folder):
    """A sphere that intersects the other one, and a curved cell."""
    ball = make_sphere()
    for i in range(ball.GetNumberOfPoints()):
        x, y, z = ball.GetPoint(i)
        ball.GetPoints().SetPoint(i, x + 0.4, y, z + 0.1)
    write_mesh(folder, "ball.vtp", ball)
    points = vtkPoints()
    for point in ((0, 0, -1), (2, 0, -1), (0, 2, -1), (1, 0, -0.8), (1, 1, -0.8), (0, 1, -0.8)):
        points.InsertNextPoint(point[0] - 0.5, point[1] - 0.5, point[2] + 1.0)
    cells = vtkUnstructuredGrid()
    cells.SetPoints(points)
    cells.InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, list(range(6)))
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(cells)
    writer.SetFileName(str(folder / "cells.vtu"))
    writer.Write()


def write_blocks(folder):
    """Two cubes, of which one is moved."""
    cube = make_cube()
    moved = vtkUnstructuredGrid()
    moved.DeepCopy(cube)
    for i in range(moved.GetNumberOfPoints()):
        x, y, z = moved.GetPoint(i)
        moved.GetPoints().SetPoint(i, x + 1.5, y, z)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, cube)
    blocks.SetBlock(1, moved)
    writer = vtkXMLMultiBlockDataWriter()
    writer.SetInputData(blocks)
    writer.SetFileName(str(folder / "blocks.vtm"))
    writer.Write()


class TestSavedPrograms(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        write_hill(cls.folder)
        write_sphere(cls.folder)
        write_cube(cls.folder)
        write_blocks(cls.folder)
        write_balls(cls.folder)
        write_image(cls.folder)
        cls().view("sphere.vtp", "--capture=reliefs.cdb", "--relief=box")

    def run_script(self, name):
        """Runs a script from another folder. Returns the bytes of its picture."""
        picture = self.folder / "script.png"
        picture.unlink(missing_ok=True)
        run = subprocess.run(
            [sys.executable, self.folder / name, picture], cwd="/", capture_output=True, text=True
        )
        self.assertEqual((run.returncode, run.stderr), (0, ""), name)
        return picture.read_bytes()

    def draw(self, *arguments):
        self.view(*arguments, SIZE, "--output=picture.png")
        return (self.folder / "picture.png").read_bytes()

    def test_scripts(self):
        for arguments in SCRIPTS:
            with self.subTest(arguments):
                expected = self.draw(*arguments, "--save-script=scene.py")
                self.assertEqual(self.run_script("scene.py"), expected)
        script = (self.folder / "scene.py").read_text()
        # The script is a program of classes, and depends on what it says.
        self.assertIn("relevo.vtkAdaptiveRefinement()", script)
        self.assertNotIn("subprocess", script)
        changed = script.replace("SetMaximumLevel(2)", "SetMaximumLevel(1)")
        (self.folder / "scene.py").write_text(changed)
        level = [*SCRIPTS[-1], "--level=1", "--no-legend"]
        self.assertNotEqual(self.run_script("scene.py"), expected)
        self.assertNotEqual(self.draw(*level), expected)

    def test_data(self):
        """Data that readers and filters do not give are written beside the script."""
        steps = '<DataSet timestep="0" file="cube.vtu"/><DataSet timestep="3" file="cube.vtu"/>'
        (self.folder / "steps.pvd").write_text(
            f'<VTKFile type="Collection"><Collection>{steps}</Collection></VTKFile>'
        )
        expected = self.draw(
            "steps.pvd", "--time=3", "--warp=Around", "--scale=0.2", "--save-script=moved.py"
        )
        self.assertTrue((self.folder / "moved-mesh.vtp").exists())
        self.assertEqual(self.run_script("moved.py"), expected)

    def test_sources(self):
        pictures = []
        for i, scene in enumerate(SCENES):
            expected = self.draw(*scene, f"--save-session=s{i}.json", f"--save-script=s{i}.py",
                                 f"--save-source=source{i}")
            pictures.append(expected)
            self.view(f"--session=s{i}.json", "--output=session.png")
            self.assertEqual((self.folder / "session.png").read_bytes(), expected, scene)
            self.assertEqual(self.run_script(f"s{i}.py"), expected, scene)
        (self.folder / "CMakeLists.txt").write_text(PROJECT)
        flags = "-DCMAKE_CXX_FLAGS=-O0 -Wall -Wextra -Werror"
        build = self.folder / "build"
        for command in (
            ["cmake", "-S", self.folder, "-B", build, flags,
             f"-DRelevo_DIR={BINARY}/lib/cmake/Relevo"],
            ["cmake", "--build", build, "--parallel", "2"],
        ):
            run = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        for i, expected in enumerate(pictures):
            program = build / f"source{i}" / f"source{i}"
            run = subprocess.run([program, "c.png"], cwd=self.folder, capture_output=True)
            self.assertEqual((run.returncode, run.stderr), (0, b""))
            self.assertEqual((self.folder / "c.png").read_bytes(), expected, SCENES[i])

    def test_errors(self):
        picture = ("sphere.vtp", "--array=Latitude", SIZE, "--output=p.png", "--save-script=bad.py")
        words = ["a program cannot draw hill.png with this metric yet; use --metric height"]
        self.assert_error(1, words, "hill.png", *picture[2:], "--metric=silhouette")
        self.assertFalse((self.folder / "bad.py").exists())
        self.assert_error(2, ["--save-script requires --output"], "sphere.vtp",
                          "--save-script=a.py")
        self.assert_error(2, ["--save-source requires --output"], "sphere.vtp", "--save-source=a")
        self.assert_error(1, ["cannot write"], "sphere.vtp", SIZE, "--output=p.png",
                          "--save-script=missing/a.py")


if __name__ == "__main__":
    unittest.main(argv=["TestSavedPrograms"])
