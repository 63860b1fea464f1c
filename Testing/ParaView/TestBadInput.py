# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: invalid input is reported once, not in every frame. The rest of the scene is
drawn, and no rank hangs.

The tests run scenes in separate processes: pvbatch TestBadInput.py SCENE..."""

import os
import re
import sys
import xml.etree.ElementTree as ElementTree

from paraview import simple

import RelevoParaView as relevo
from RelevoParaView import sphere

RANK = """
from paraview.modules.vtkRemotingCore import vtkProcessModule
rank = vtkProcessModule.GetProcessModule().GetPartitionId()
"""
ARRAY_ON_RANK_0 = (
    RANK
    + """
from vtkmodules.vtkCommonCore import vtkFloatArray
values = vtkFloatArray()
values.SetName("Values")
values.SetNumberOfTuples(output.GetNumberOfPoints())
values.Fill(1)
if rank == 0:
    output.GetPointData().AddArray(values)
"""
)
NOTHING_ON_RANK_0 = RANK + "if rank == 0:\n    output.VTKObject.Initialize()\n"
SHORT_ON_RANK_0 = (
    RANK
    + """
from vtkmodules.vtkCommonCore import vtkFloatArray
values = vtkFloatArray()
values.SetName("Short")
values.SetNumberOfTuples(1)
values.Fill(1)
if rank == 0:
    output.VTKObject.GetPointData().AddArray(values)
"""
)
TAGS_ON_RANK_0 = ARRAY_ON_RANK_0.replace("Values", "Tags")
VECTORS_ON_RANK_0 = (
    RANK
    + """
from vtkmodules.vtkCommonCore import vtkFloatArray
vectors = vtkFloatArray()
vectors.SetName("Vectors")
vectors.SetNumberOfComponents(3)
vectors.SetNumberOfTuples(output.GetNumberOfPoints())
vectors.Fill(1)
if rank == 0:
    output.GetPointData().AddArray(vectors)
"""
)
NOT_A_NUMBER = """
from vtkmodules.vtkCommonCore import vtkPoints
points = vtkPoints()
points.DeepCopy(output.VTKObject.GetPoints())
points.SetPoint(3, float("nan"), 0, 0)
output.VTKObject.SetPoints(points)
"""

BLOCK = """
blocks = self.GetOutputDataObject(0)
blocks.SetBlock(0, self.GetInputDataObject(0, 0))
blocks.GetMetaData(0).Set(blocks.NAME(), "Wing")
"""
NOT_A_NUMBER_ON_RANK_1 = RANK + "if rank == 1:" + NOT_A_NUMBER.replace("\n", "\n    ")


def changed(script):
    return simple.ProgrammableFilter(Input=sphere(), Script=script, CopyArrays=1)


def show_displaced(view, source, path):
    shown = relevo.show(source, view, Displacement="Height Map")
    shown.Displacement.HeightMapFileName = path
    shown.Displacement.Scale = 0.02


def show_variation(view, source):
    shown = relevo.show(source, view, Metric="Variation of an Array")
    shown.Metric.ArrayName = "Values"


def show_streaks(view, source, vectors="Vectors"):
    shown = relevo.show(source, view, "Adaptive LIC", Metric="None", MaximumLevel=1)
    shown.SelectInputVectors = ["POINTS", vectors]


def block(source):
    return simple.ProgrammableFilter(
        Input=source, OutputDataSetType="vtkMultiblockDataSet", Script=BLOCK
    )


SCENES = {
    "good": lambda view: relevo.show(sphere(), view),
    "no file": lambda view: show_displaced(view, sphere(), "/nowhere/heights.png"),
    # A relative path: only rank 0 runs in the folder with this file.
    "file": lambda view: show_displaced(
        view, simple.TextureMaptoSphere(Input=sphere()), "heights.png"
    ),
    "no texture coordinates": lambda view: show_displaced(view, sphere(), "heights.png"),
    "no array": lambda view: show_variation(view, sphere()),
    "array on rank 0": lambda view: show_variation(view, changed(ARRAY_ON_RANK_0)),
    "short array on rank 0": lambda view: relevo.show(changed(SHORT_ON_RANK_0), view),
    "translucent": lambda view: relevo.show(changed(SHORT_ON_RANK_0), view, Opacity=0.5),
    "nothing on rank 0": lambda view: relevo.show(changed(NOTHING_ON_RANK_0), view),
    "tags on rank 0": lambda view: relevo.show(
        changed(TAGS_ON_RANK_0), view, DepthTagArrayName="Tags"
    ),
    "sharpness on rank 0": lambda view: relevo.show(
        block(changed(TAGS_ON_RANK_0.replace("Tags", "Sharpness"))), view, Surface="Scalar Tagged"
    ),
    "no vectors": lambda view: show_streaks(view, sphere(), ""),
    "unknown vectors": lambda view: show_streaks(view, sphere()),
    "vectors on rank 0": lambda view: show_streaks(view, changed(VECTORS_ON_RANK_0)),
    "not a number": lambda view: relevo.show(changed(NOT_A_NUMBER), view),
    "not a number on rank 1": lambda view: relevo.show(changed(NOT_A_NUMBER_ON_RANK_1), view),
}


def draw(name):
    """A valid sphere beside the invalid object, in two frames from different positions."""
    relevo.clear()
    view = relevo.view()
    relevo.show(simple.Sphere(Center=[1.5, 0, 0]), view, "Surface")
    relevo.picture(view)
    SCENES[name](view)
    for distance in 6.2, 6:
        view.CameraPosition = [0.7, 0, distance]
        view.CameraFocalPoint = [0.7, 0, 0]
        picture = relevo.picture(view)
    columns = picture.shape[1]
    halves = picture[:, : columns // 2], picture[:, columns // 2 :]
    print("drawn:", *map(relevo.foreground, halves), flush=True)


class TestBadInput(relevo.TestCase):
    def setUp(self):
        self.folder = self.make_folder()
        relevo.write_heights(os.path.join(self.folder, "heights.png"))

    def run_scenes(self, names, ranks=1, **environment):
        """The errors and warnings of each scene, and the pixels of the invalid object."""
        script = os.path.abspath(__file__)
        output = relevo.run_ranks(
            ranks, script, *names, after_first="cd /", cwd=self.folder, **environment
        )
        return self.read_scenes(names, output)

    def read_scenes(self, names, output):
        scenes = output.split("drawn: ")
        self.assertEqual(len(scenes), len(names) + 1, output)
        found = {}
        for name, text, after in zip(names, scenes, scenes[1:]):
            bad, good = map(int, after.split("\n")[0].split())
            self.assertGreater(good, 2000, name)
            found[name] = re.findall(r"(?:ERR|WARN)\|[^|]*?(vtk\w+ \(0x\w+\): .*)", text), bad
        return found

    def assert_told(self, found, *words):
        """Expects one message for each of `words`, in this order. Returns the pixels of the invalid
        object."""
        messages, bad = found
        self.assertEqual(len(messages), len(words), messages)
        for message, expected in zip(messages, words):
            self.assertIn(expected, message)
        return bad

    def test_one_process(self):
        words = {
            "no file": ["Cannot read /nowhere/heights.png: the file does not exist."],
            "no texture coordinates": ["needs texture coordinates"],
            "no array": ['array of numbers named "Values"', "its own error gives the reason"],
        }
        drawn = {
            "not a number": [
                "The surface has 6 faces with points that are not finite. They are left out."
            ],
            "no vectors": ["in ParaView SelectInputVectors, selects. The surface is drawn without"],
            "unknown vectors": ["in ParaView SelectInputVectors, selects. The surface is drawn"],
            "good": [],
        }
        found = self.run_scenes([*words, *drawn])
        for name, expected in words.items():
            with self.subTest(name):
                self.assertEqual(self.assert_told(found[name], *expected), 0)
        for name, expected in drawn.items():
            with self.subTest(name):
                self.assertGreater(self.assert_told(found[name], *expected), 2000)

    def test_one_of_two_processes(self):
        """The rank with the invalid array reports it, and the other one draws its part."""
        short = 'Array "Short" has too few tuples and is left out.'
        words = {
            "sharpness on rank 0": [
                'point array "Sharpness" of SharpnessArrayName is missing on rank 1 in block "Wing"'
            ],
            "file": ["Cannot read heights.png: the file does not exist."],
            "array on rank 0": ['array of numbers named "Values"', "its own error gives the reason"],
            "short array on rank 0": [short],
            "nothing on rank 0": [],
            "tags on rank 0": ['array "Tags" of DepthTagArrayName is missing on rank 1, but'],
            "vectors on rank 0": ['array "Vectors" of SelectInputVectors is missing on rank 1, but'],
            "not a number on rank 1": [
                "The surface has 3 faces with points that are not finite on rank 1."
            ],
        }
        found = self.run_scenes([*words, "translucent"], ranks=2)
        for name in words:
            with self.subTest(name):
                _, bad = found[name]
                self.assertGreater(bad, 500)
                hides_part = name in ("file", "array on rank 0", "nothing on rank 0")
                self.assertLess(bad, 2500 if hides_part else 4000)
        self.assertGreater(found["translucent"][1], 2000)
        messages = [message for told, _ in found.values() for message in told]
        # The opaque sphere has one, and ParaView delivers the translucent one twice.
        of_short = [message for message in messages if short in message]
        self.assertIn(len(of_short), (2, 3))
        parts = [part for each in words.values() for part in each if part != short]
        self.assert_messages([each for each in messages if each not in of_short], parts)

    def test_old_opengl(self):
        for told, environment in (
            (["Refinement needs OpenGL 3.3"], {"MESA_GL_VERSION_OVERRIDE": "3.2"}),
            (["without one that works (softpipe)"], {"GALLIUM_DRIVER": "softpipe"}),
            ([], {"MESA_GL_VERSION_OVERRIDE": "4.2"}),
        ):
            with self.subTest(environment):
                found = self.run_scenes(["good"], **environment)["good"]
                self.assertEqual(self.assert_told(found, *told) > 2000, not told)

    def test_server_without_plugin(self):
        command = ["pvpython", os.path.abspath(__file__), "good"]
        with relevo.server(PV_PLUGIN_PATH=None) as port:
            output = relevo.run(command, RELEVO_PORT=port)
        messages, bad = self.read_scenes(["good"], output)["good"]
        self.assertEqual(bad, 0)
        self.assertEqual(len(messages), 2)  # one of the client and one of the server
        for message in messages:
            self.assertIn("No representation was found with Name: Adaptive Refinement", message)

    def test_states_of_other_versions(self):
        """Properties that are missing in a state file have their defaults, and unknown ones are
        ignored."""
        view = relevo.view()
        relevo.show(sphere(), view, MaximumLevel=2, Metric="Curvature", Surface="PN Triangles")
        relevo.picture(view)
        simple.ResetCamera(view)
        expected = relevo.picture(view)
        path = os.path.join(self.folder, "state.pvsm")
        simple.SaveState(path)
        relevo.clear()
        state = ElementTree.parse(path)
        removed = 0
        for proxy in state.iter("Proxy"):
            properties = proxy.findall("Property")
            if not any(each.get("name") == "LevelRule" for each in properties):
                continue
            for each in properties:
                if each.get("name") in ("SegmentPolicy", "Displacement", "RefinementColorMode"):
                    proxy.remove(each)
                    removed += 1
            unknown = {"name": "Unknown", "id": proxy.get("id") + ".Unknown"}
            ElementTree.SubElement(proxy, "Property", {**unknown, "number_of_elements": "0"})
        self.assertGreaterEqual(removed, 3)
        state.write(path)
        simple.LoadState(path)
        picture = relevo.picture(simple.GetActiveView())
        self.assertEqual(relevo.differing(picture, expected, 0), 0)


if __name__ == "__main__":
    if "RELEVO_PORT" in os.environ:
        simple.Connect("localhost", int(os.environ["RELEVO_PORT"]))
    for scene in sys.argv[1:]:
        draw(scene)
    if len(sys.argv) == 1:
        relevo.main()
