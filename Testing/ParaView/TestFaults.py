# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: a representation reports a fault of one rank once, with the array or the block.
All ranks draw what they can, and none hangs.

The test runs the scenes in two processes: pvbatch TestFaults.py SCENE..."""

import os
import re
import subprocess
import sys
import tempfile

from paraview import simple

import RelevoParaView as relevo
import TestVolumeRanks as pieces

# OpenGL has no setting that limits the size of textures, so this library replaces a function of it.
LIMITED_TEXTURES = """
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
void glGetIntegerv(unsigned int name, int* value)
{
  const char* most = getenv("RELEVO_TEST_TEXELS");
  void (*next)(unsigned int, int*) = dlsym(RTLD_NEXT, "glGetIntegerv");
  next(name, value);
  if (name == 0x8c2b && most) // GL_MAX_TEXTURE_BUFFER_SIZE
  {
    *value = atoi(most);
  }
}
"""
FEW_TEXELS = """
import os
if rank == 1:
    os.environ["RELEVO_TEST_TEXELS"] = "500"
"""
BLOCKS = """
blocks = self.GetOutputDataObject(0)
for i in range(2):
    block = piece.NewInstance()
    block.DeepCopy(piece)
    for k in range(block.GetNumberOfPoints()):
        x, y, z = block.GetPoints().GetPoint(k)
        block.GetPoints().SetPoint(k, x + 10 * i, y, z)
    blocks.SetBlock(i, block)
    blocks.GetMetaData(i).Set(blocks.NAME(), ("Wing", "Tail")[i])
if rank == 1:
    data = blocks.GetBlock(1).GetPointData()
"""
TEXT = """
    from vtkmodules.vtkCommonCore import vtkStringArray
    texts = vtkStringArray()
    texts.SetName("RTData")
    texts.SetNumberOfValues(piece.GetNumberOfPoints())
    data.AddArray(texts)
"""
PAIRS = """
    pairs = numpy_to_vtk(numpy.ones((piece.GetNumberOfPoints(), 2)), deep=1)
    pairs.SetName("RTData")
    data.AddArray(pairs)
"""
NOT_FINITE = """
if rank == 1:
    piece.GetPoints().SetPoint(0, float("nan"), 0, 0)
"""
NO_VALUE = """
    piece = blocks.GetBlock(1)
    piece.GetPointData().GetArray("RTData").SetComponent(0, 0, float("nan"))
"""


def make_blocks(fault):
    text = pieces.script().replace("output.VTKObject.ShallowCopy(piece)", BLOCKS + fault)
    return simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=text)


def show_all(source, view):
    """Shows a source as Adaptive Volume, Adaptive Patches and Adaptive Refinement."""
    pieces.show(source, view)
    for representation in "Adaptive Patches", "Adaptive Refinement":
        copy = simple.Transform(Input=source)
        copy.Transform.Translate = [10, 0, 0]
        relevo.show(copy, view, representation)


def show_volume(source, view):
    pieces.show(source, view)


LARGE = "the mesh is larger than the buffer textures of this OpenGL, of at most 500 texels; use more"
# How to make and show the data, and the message of each representation. The limit of textures stays
# for later scenes.
SCENES = {
    "points": (
        lambda: pieces.deal(fault=NOT_FINITE),
        show_all,
        {
            "Volume": "has no volume, or points that are not finite; it is left out.",
            "Patch": "Rank 1: Cell 0 (vtkTetra, type 10) is left out: point 0 is not finite.",
            "Refinement": "points that are not finite on rank 1. They are left out.",
        },
    ),
    "text in a block": (
        lambda: make_blocks(TEXT),
        show_volume,
        {"Volume": 'Rank 1: Block 2 ("Tail") has no array "RTData"; it is left out.'},
    ),
    "pairs in a block": (
        lambda: make_blocks(PAIRS),
        show_volume,
        {
            "Volume": 'Rank 1: The input has an array "RTData" in Block 2 ("Tail") with 2 components, '
            'but with 1 in Block 1 ("Wing").'
        },
    ),
    "no value in a block": (
        lambda: make_blocks(NO_VALUE),
        show_volume,
        {
            "Volume": 'Rank 1: 1 of 2510 cells has values of the array "RTData" that are not finite, '
            'in Block 2 ("Tail"); it is transparent.'
        },
    ),
    "textures": (
        lambda: pieces.deal(fault=FEW_TEXELS),
        show_all,
        {
            "Volume": "Rank 1: The mesh cannot be drawn: " + LARGE,
            "Patch": "Rank 1: Cannot draw the input: " + LARGE,
            "Refinement": "Rank 1: Cannot draw the input: " + LARGE,
        },
    ),
}
if simple.GetParaViewVersion().major >= 6:
    del SCENES["textures"]  # its VTK looks up OpenGL's functions itself, so none can be replaced


def draw(name):
    relevo.clear()
    view = relevo.view((200, 150))
    make, show, _ = SCENES[name]
    show(make(), view)
    for height in 11, 12:
        view.CameraPosition = [20, -28, height]
        view.CameraFocalPoint = [5, 0, 0]
        view.CameraViewUp = [0, 0, 1]
        picture = relevo.picture(view)
    print("visible:", relevo.foreground(picture), flush=True)


class TestFaults(relevo.TestCase):
    def run_scenes(self):
        """The output of each scene, whose rank 1 has another library."""
        with tempfile.TemporaryDirectory() as folder:
            library = os.path.join(folder, "textures.so")
            compiler = ["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", library, "-ldl"]
            subprocess.run(compiler, input=LIMITED_TEXTURES, text=True, check=True)
            script = os.path.abspath(__file__)
            preload = f"export LD_PRELOAD={library}${{LD_PRELOAD:+:$LD_PRELOAD}}"
            return relevo.run_ranks(2, script, *SCENES, after_first=preload, LP_NUM_THREADS="0")

    def test_one_of_two_ranks(self):
        output = self.run_scenes()
        parts = output.split("visible: ")
        self.assertEqual(len(parts), len(SCENES) + 1, output)
        for name, after in zip(SCENES, parts[1:]):
            with self.subTest(name):
                self.assertGreater(int(after.split()[0]), 1000)
        said = r"(?:ERR|WARN)\|.*?vtkAdaptive(\w+?)Representation \(0x\w+\): (.*)"
        found = re.findall(said, output)
        for representation in "Volume", "Patch", "Refinement":
            expected = [words.get(representation) for _, _, words in SCENES.values()]
            messages = [message for each, message in found if each == representation]
            self.assert_messages(messages, filter(None, expected))


if __name__ == "__main__":
    for each in sys.argv[1:]:
        draw(each)
    if len(sys.argv) == 1:
        relevo.main()
