# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that the Python programs in README.md and in the pages of Module/Documentation run
off-screen.

A block after the line <!-- continues --> continues the previous block of its page. Each program
runs separately, in a folder with my-dem.tif and my-mesh.ply. The programs of a tutorial share a
folder. Those under "Example data" run first, and the pictures of the page are those that the
programs draw."""

import atexit
import os
import pathlib
import re
import sys
import tempfile
import unittest

import relevo
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkTIFFWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

from ForkedScripts import ForkedScripts
from ViewerPictures import largest_difference

SOURCE = pathlib.Path(os.environ["RELEVO_SOURCE_DIR"])
if not hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
    print("skipped: built without rendering, or without EGL")
    sys.exit(125)
# PyVista has no window without a display in all versions of VTK.
sys.path.insert(0, str(pathlib.Path(__file__).parent / "StandIn"))
SCRIPTS = ForkedScripts()
atexit.register(SCRIPTS.close)


def read_programs(page):
    """Pairs of a line number and a text: the longest chains of blocks that continue each other."""
    text = page.read_text()
    programs = []
    for match in re.finditer(r"(<!-- continues -->\n)?```python\n(.*?)```", text, re.S):
        line = text.count("\n", 0, match.start(2)) + 1
        if match[1]:
            first, program = programs.pop()
            programs.append((first, program + "\n" + match[2]))
        else:
            programs.append((line, match[2]))
    return programs


def write_inputs(folder):
    image = vtkImageData()
    image.SetDimensions(40, 30, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    for j in range(30):
        for i in range(40):
            image.SetScalarComponentFromDouble(i, j, 0, 0, i * j // 12)
    writer = vtkTIFFWriter()
    writer.SetFileName(str(folder / "my-dem.tif"))
    writer.SetInputData(image)
    writer.Write()
    sphere = vtkSphereSource()
    writer = vtkPLYWriter()
    writer.SetFileName(str(folder / "my-mesh.ply"))
    writer.SetInputConnection(sphere.GetOutputPort())
    writer.Write()


class TestPagePrograms(unittest.TestCase):
    def check_program(self, page, line, program, folder):
        with self.subTest(page=page.name, line=line):
            run = SCRIPTS.run(["-c"], folder, program)
            # VTK writes its errors to standard error and continues.
            self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)

    def test_programs(self):
        pages = [SOURCE / "README.md", *sorted((SOURCE / "Module/Documentation").glob("*.md"))]
        count = 0
        for page in pages:
            if page.name.startswith("tutorial-"):
                continue
            for line, program in read_programs(page):
                with tempfile.TemporaryDirectory() as folder:
                    write_inputs(pathlib.Path(folder))
                    self.check_program(page, line, program, folder)
                count += 1
        self.assertGreater(count, 6)

    def test_tutorials(self):
        pages = sorted((SOURCE / "Module/Documentation").glob("tutorial-*.md"))
        self.assertEqual(len(pages), 4)
        for page in pages:
            text = page.read_text()
            programs = read_programs(page)
            data = text.count("\n", 0, text.find("## Example data"))
            programs.sort(key=lambda program: (program[0] < data, program[0]))
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                write_inputs(folder)
                for line, program in programs:
                    self.check_program(page, line, program, folder)
                pictures = re.findall(r"\]\((tutorial-[\w-]+\.png)\)", text)
                self.assertGreater(len(pictures), 2)
                for picture in pictures:
                    with self.subTest(picture=picture):
                        difference = largest_difference(folder / picture, page.parent / picture)
                        self.assertLess(difference, 15)

    def test_long_program(self):
        """The last program of python.md is the example terrain.py, which draws a terrain."""
        *_, (_, program) = read_programs(SOURCE / "Module/Documentation/python.md")
        example = (SOURCE / "Examples/Python/terrain.py").read_text().splitlines()
        names = {'"my-dem.tif"': "heightmap", '"my-dem.png"': "picture"}
        for line in program.splitlines():
            for name, variable in names.items():
                line = line.replace(name, variable)
            self.assertIn(line, example)
        self.check_picture(program, (800, 500))

    def test_first_program(self):
        """The first program of README.md draws a terrain."""
        (_, program), *_ = read_programs(SOURCE / "README.md")
        self.assertEqual(len(program.replace("\n\n", "\n").strip().splitlines()), 4)
        self.check_picture(program, (1280, 800))

    def check_picture(self, program, size):
        with tempfile.TemporaryDirectory() as folder:
            write_inputs(pathlib.Path(folder))
            self.assertEqual(SCRIPTS.run(["-c"], folder, program).returncode, 0)
            reader = vtkPNGReader()
            reader.SetFileName(str(pathlib.Path(folder) / "my-dem.png"))
            reader.Update()
            picture = reader.GetOutput()
            self.assertEqual(picture.GetDimensions(), (*size, 1))
            shades = {
                picture.GetScalarComponentAsFloat(i, j, 0, 0)
                for j in range(0, size[1], 10)
                for i in range(0, size[0], 10)
            }
            self.assertGreater(len(shades), 10)


if __name__ == "__main__":
    unittest.main(argv=["TestPagePrograms"])
