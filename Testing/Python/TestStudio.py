# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves studio.md without a display: scripts, pictures as of relevo-view, figures, keys, errors."""

import json
import re
import subprocess
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from StudioProgram import PROGRAM, StudioProgram

VOLUME_NODES = "0 0 0 1 0;3 0 1 0 0.5;6 1 0 0 1"


def make_grid(time=1.0):
    """Hexahedra with displacements, stresses and values of cells."""
    image = vtkImageData()
    image.SetDimensions(7, 5, 4)
    moves = vtkDoubleArray()
    moves.SetName("Move")
    moves.SetNumberOfComponents(3)
    stress = vtkDoubleArray()
    stress.SetName("Stress")
    stress.SetNumberOfComponents(6)
    height = vtkDoubleArray()
    height.SetName("Height")
    for i in range(image.GetNumberOfPoints()):
        x, y, z = image.GetPoint(i)
        moves.InsertNextTuple((0.0, 0.0, time * x * x / 30.0))
        stress.InsertNextTuple((x, y, z, x * y / 4.0, 0.5, 0.0))
        height.InsertNextValue(x)
    image.GetPointData().AddArray(moves)
    image.GetPointData().AddArray(stress)
    image.GetPointData().SetScalars(height)
    points = vtkDoubleArray()
    points.SetName("AtPoints")
    points.SetNumberOfComponents(8)
    for i in range(image.GetNumberOfCells()):
        points.InsertNextTuple([i + k / 8.0 for k in range(8)])
    image.GetCellData().AddArray(points)
    append = vtkAppendFilter()
    append.AddInputData(image)
    append.Update()
    return append.GetOutput()


class TestStudio(StudioProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write_data("beam.vtu", vtkXMLUnstructuredGridWriter, make_grid())
        for step in range(3):
            cls.write_data(
                f"s{step}.vtu", vtkXMLUnstructuredGridWriter, make_grid(time=float(step))
            )
        sets = "".join(f'<DataSet timestep="{s}" file="s{s}.vtu"/>' for s in range(3))
        (cls.folder / "steps.pvd").write_text(
            f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>'
        )

    def test_results(self):
        layouts, errors = self.studio(
            "beam.vtu",
            "save a.png",
            "set array von Mises of Stress",
            "set palette magma",
            "save b.png",
            "set clip 3,0,0,1,0,0",
            "set range 1,5",
            "save c.png",
            "set warp Move",
            "set scale 2",
            "save d.png",
            "click undo",
            "click undo",
            "save e.png",
            "click redo",
            "click redo",
            "set palette default",
            "set clip 2,0,0,1,0,0",
            "set method ark",
            "set metric distance",
            "set max-level 2",
            "set light 100,20",
            "save f.png",
            "set clip default",
            "set wireframe on",
            "click view-top",
            "save g.png",
            "save mesh.vtp",
            "set range default",
            "set array default",
            "set integration-points AtPoints",
            "set clip 3,0,0,1,0,0",
            "set clip 2.5,0,0,1,0,0",
            "save h.png",
        )
        self.assertEqual(errors, "")
        mises = ("beam.vtu", "--array", "von Mises of Stress")
        clip = (*mises, "--palette=magma", "--clip=3,0,0,1,0,0", "--range=1,5")
        self.assert_picture("a.png", "beam.vtu")
        self.assert_picture("b.png", *mises, "--palette=magma")
        self.assert_picture("c.png", *clip)
        self.assert_picture("d.png", *clip, "--warp=Move", "--scale=2")
        self.assert_picture("e.png", *clip)
        bent = (*mises, "--range=1,5", "--warp=Move", "--scale=2", "--method=ark")
        levels = ("--metric=distance", "--max-level=2", "--light=100,20")
        self.assert_picture("f.png", *bent, *levels, "--clip=2,0,0,1,0,0")
        self.assert_picture("g.png", *bent, *levels, "--wireframe", "--view=180,90")
        points = ("--integration-points=AtPoints", "--clip=2.5,0,0,1,0,0", "--warp=Move", "--scale=2")
        self.assert_picture("h.png", "beam.vtu", *points, "--method=ark", *levels, "--wireframe",
            "--view=180,90")
        self.assertTrue((self.folder / "mesh.vtp").exists())
        names = next(e for e in reversed(layouts) if e["array"]["value"])
        self.assertEqual(names["array"]["value"], "von Mises of Stress")
        self.assertFalse(names["isosurfaces"]["enabled"])
        self.assertIn("requires --volume", names["isosurfaces"]["reason"])
        self.assertIn("no time steps", names["time"]["reason"])
        frames = [layout["figure-frames"]["value"] for layout in layouts]
        self.assertEqual(frames, sorted(set(frames)))

    def test_uniforms(self):
        """Dragging a plane, a light, the length of segments or the ends of the colours builds no
        buffers and shaders."""
        first = ("set clip 3,0,0,1,0,0", "set metric screen-edge", "set range 1,5", "wait")
        last = self.studio("beam.vtu", *first)[0][-1]


        def drag(name):
            left, top, width, height = last[name]["rectangle"]
            middle = top + height / 2
            return f"drag {left + width / 2} {middle} {left + width * 0.8} {middle}"

        dragged, errors = self.studio(
            "beam.vtu",
            *first,
            drag("clip-position"),
            drag("range.0"),
            drag("range.1"),
            "set palette magma",
            "set below white",
            "set pixels 10",
            "set light 90,10",
            "set zoom 2",
            "set view front",
        )
        self.assertEqual(errors, "")
        # The scene is beside the panel.
        panel = dragged[-1]["undo"]["rectangle"]
        self.assertGreater(panel[0], 200)
        for figure in ("figure-buffer-builds", "figure-shader-builds"):
            self.assertEqual(dragged[-1][figure]["value"], last[figure]["value"], figure)
            self.assertGreater(last[figure]["value"], 0)
        # Each position of the slider is drawn.
        values = [layout["clip-position"]["value"] for layout in dragged]
        self.assertGreaterEqual(len(dict.fromkeys(values)), 7)
        self.assertGreater(float(values[-1]), 4.0)
        self.assertNotEqual(dragged[-1]["range"]["value"], "1,5")

    def describe(self, layout, name):
        """The numbers of a text of values, by their names."""
        words = layout[name]["value"].split()
        return {word: float(number) for word, number in zip(words, words[1:]) if word.isalpha()
                and re.fullmatch(r"-?[0-9.e+-]+", number)}

    def test_probe(self):
        """The values under the mouse follow it on surfaces, cuts and isosurfaces, in frames that do
        not draw the scene. A click keeps them."""
        opaque = "0 1 1 1 1;6 1 1 1 1"
        for lines in (
            (),
            ("set clip 0,0,1.6,0,0.2,1",),
            ("set volume Height", f"set transfer {opaque}", "set unit-distance 1e-4"),
            ("set volume Height", "set blend isosurface", "set isosurfaces 2.5", "set view left"),
        ):
            with self.subTest(lines=lines):
                layouts, errors = self.studio(
                    "beam.vtu", *lines, "drag 110 200 110 200", "drag 130 215 130 215",
                    "drag 2 2 2 2", "click forget-probe",
                )
                self.assertEqual(errors, "")
                shown = [layout for layout in layouts if "readout" in layout]
                self.assertGreaterEqual(len({e["readout"]["value"] for e in shown}), 2)
                for layout in shown:
                    values = self.describe(layout, "readout")
                    self.assertAlmostEqual(values["Height"], values["x"], delta=0.02)
                    self.assertIn("cell", values)
                    self.assertIn("point", values)
                    if "set blend isosurface" in lines:
                        self.assertAlmostEqual(values["Height"], 2.5, delta=0.02)
                kept = [layout for layout in layouts if "probe" in layout]
                self.assertEqual(kept[-1]["probe"]["value"], shown[-1]["readout"]["value"])
                self.assertNotIn("readout", layouts[-1])
                self.assertNotIn("probe", layouts[-1])
                self.assertFalse(layouts[-1]["forget-probe"]["enabled"])
                self.assertGreaterEqual(layouts[-1]["figure-panel-frames"]["value"], 3)

    def test_keys_of_viewer(self):
        """The keys of relevo-view set the options of the controls."""
        layouts, errors = self.studio(
            "steps.pvd", "key >", "key w", "key m", "key m", "key 5", "save a.png", "key s", "key n",
            "key h", "key i", "key h", "key r",
        )
        self.assertEqual(errors, "")
        wire = next(e for e in layouts if e["clip"]["value"] and e["view"]["value"])
        self.assertEqual(wire["wireframe"]["value"], "on")
        self.assertEqual(wire["time"]["value"], "1")
        self.assertEqual(wire["view"]["value"], "top")
        self.assert_picture(
            "a.png", "steps.pvd", "--time=1", "--wireframe", f"--clip={wire['clip']['value']}",
            "--view=top",
        )
        self.assertEqual(layouts[-1]["wireframe"]["value"], "")
        self.assertNotEqual(layouts[-1]["clip"]["value"], wire["clip"]["value"])
        helped = [layout for layout in layouts if "key-help" in layout]
        self.assertIn("wireframe", helped[0]["key-help"]["value"])
        self.assertNotIn("key-help", layouts[-1])
        self.assertTrue((self.folder / "steps-1.png").exists())
        (self.folder / "steps-1.png").unlink()

    def test_controls_by_keys(self):
        """Keys alone open all groups and reach all controls that are available."""
        rows = 80  # at least as many as there are
        closed = 12  # groups above the open one of figures, from the bottom up
        open_groups = ["key space", "key Up", "key Up"] + ["key space", "key Up"] * closed
        layouts, errors = self.studio(
            "beam.vtu",
            "key Tab",
            *["key Down"] * rows,
            *open_groups,
            *["key Up"] * 20,
            *["key Down"] * rows,
            *["key Right", "key Right", "key Up"] * rows,
        )
        self.assertEqual(errors, "")
        reached = {name for layout in layouts for name, e in layout.items() if e.get("focused")}
        entries = layouts[-1]
        groups = [name for name in entries if name.startswith("group ")]
        self.assertGreater(len(groups), 14)
        for name in groups:
            self.assertEqual(entries[name]["value"], "on", name)
        for name, entry in entries.items():
            if entry["kind"] not in ("figure", "words") and entry["enabled"]:
                parts = {other for other in reached if re.match(re.escape(name) + "[.-]", other)}
                # Both sides of a part in the middle of a row are reached.
                beside = [f"{name[:-1]}{int(name[-1]) + i}" for i in (-1, 1) if name[-2] == "."]
                is_between = bool(beside) and reached.issuperset(beside)
                self.assertTrue(name in reached or parts or is_between, name)

    def test_ruler(self):
        layouts, errors = self.studio(
            "beam.vtu", "drag 110 200 110 200", "key d", "drag 130 215 130 215", "key d",
            "set axes on", "set scale-bar on", "set extremes on", "save a.png", "set ruler default",
            "set axes default", "set scale-bar default", "set extremes default", "save b.png",
            "click measure", "drag 110 200 110 200", "drag 130 215 130 215",
        )
        self.assertEqual(errors, "")
        rulers = [layout["ruler"]["value"] for layout in layouts]
        ends = next(filter(None, rulers))
        self.assertEqual(ends.count(","), 5)
        self.assertEqual(rulers[-1], ends)
        self.assert_picture(
            "a.png", "beam.vtu", f"--ruler={ends}", "--axes", "--scale-bar", "--extremes")
        self.assert_picture("b.png", "beam.vtu")

    def test_session(self):
        """A session of the panel is one of relevo-view, and opens with its file and camera."""
        layouts, errors = self.studio(
            "beam.vtu", "set array Stress", "set wireframe on", "set range 1,5", "drag 20 200 70 230",
            "set session-name mine.json", "click save-session", "save a.png", "set range default",
            "set session-name none.json", "save c.png",
        )
        self.assertEqual(errors, "")
        self.view("--session=mine.json", "--output=expected.png")
        expected = (self.folder / "expected.png").read_bytes()
        self.assertEqual((self.folder / "a.png").read_bytes(), expected)
        layouts, errors = self.studio(
            "steps.pvd", "set session-name mine.json", "click open-session", "save b.png",
            "set session-name none.json", "click open-session", "save c.png", "click undo",
            "save d.png", code=1,
        )
        self.assertIn("line 5: --session none.json: the file cannot be read", errors)
        self.assertEqual(errors.count("\n"), 2)
        self.assertEqual((self.folder / "b.png").read_bytes(), expected)
        self.assertEqual((self.folder / "c.png").read_bytes(), expected)
        self.assert_picture("d.png", "steps.pvd")

    def test_options(self):
        """Each option of relevo-view is a control, or does not change a running scene."""
        options = set(re.findall(r"^  --([a-z-]+)", self.view("--help").stdout, re.MULTILINE))
        options |= {"above", "seed-line"}
        layouts, errors = self.studio("beam.vtu", "set log on", code=1)
        self.assertIn("needs values above 0", errors)
        others = {
            "against", "capture", "contact-distance", "export", "flight", "height-at", "help",
            "micromesh", "output", "relief", "serve", "session", "size", "stats", "tolerance",
            "version",
        }
        self.assertEqual(options - set(layouts[-1]), others)
        for name in options - others:
            entry = layouts[-1][name]
            self.assertTrue(entry["enabled"] or entry["reason"], name)

    def test_volume(self):
        (self.folder / "nodes.txt").write_text(VOLUME_NODES.replace(";", "\n") + "\n")
        layouts, errors = self.studio(
            "beam.vtu",
            "set array Stress",
            "set volume Height",
            "save a.png",
            "set transfer nodes.txt",
            "set unit-distance 2",
            "save b.png",
            "set clip 1,0,0,1,0,0",
            "set isosurfaces 2.5",
            "save c.png",
            f"set transfer {VOLUME_NODES}",
            "click transfer-next",
            "click transfer-add",
            "set array Height",
            "save d.png",
            "click undo",
        )
        self.assertEqual(errors, "")
        volume = ("beam.vtu", "--volume=Height")
        nodes = (*volume, f"--transfer={VOLUME_NODES}", "--unit-distance=2")
        self.assert_picture("a.png", *volume)
        self.assert_picture("b.png", *nodes)
        self.assert_picture("d.png", "beam.vtu", "--array=Height", "--clip=1,0,0,1,0,0")
        self.assert_picture("c.png", *nodes, "--clip=1,0,0,1,0,0", "--isosurfaces=2.5")
        self.assertEqual(layouts[-1]["transfer"]["value"].count(";"), 3)
        # One frame for each line that needs one; saved pictures are two frames more.
        self.assertEqual(len(layouts), 12)

    def test_time(self):
        layouts, errors = self.studio(
            "steps.pvd",
            "set warp Move",
            "click step-forward",
            "save a.png",
            "set time 2",
            "save b.png",
            "set time 0",
            "click play",
            "wait",
        )
        self.assertEqual(errors, "")
        self.assert_picture("a.png", "steps.pvd", "--warp=Move", "--time=1")
        self.assert_picture("b.png", "steps.pvd", "--warp=Move", "--time=2")
        self.assertEqual(layouts[-1]["time"]["value"], "2")

    def test_directions(self):
        """The panel shows the light and the view in use, and parts of controls can be set."""
        layouts, errors = self.studio(
            "beam.vtu",
            "click group Light and camera",
            "drag 20 200 70 200",
            "set view default",
            "set light.1 30",
            "set clip-direction -y",
            "set clip-position 1",
            "save a.png",
            "click group Figures",
        )
        self.assertEqual(errors, "")

        def find(number, name):
            return [float(layouts[number][f"{name}.{i}"]["value"]) for i in range(2)]

        moved = next(i for i, e in enumerate(layouts) if e["view"]["value"])
        self.assertEqual(find(moved - 1, "light"), [250.0, 45.0])
        self.assertEqual(find(moved - 1, "view"), [205.0, 20.0])
        last = max(i for i, e in enumerate(layouts) if e["view"]["value"])
        # VTK's trackball turns by 200 degrees for the width of the window, about a tilted axis.
        turn = 200.0 * 50 / 560
        self.assertAlmostEqual(find(last, "view")[0], 205.0 + turn, delta=2.0)
        self.assertEqual(find(-1, "view"), [205.0, 20.0])
        self.assertEqual(layouts[-1]["clip-direction"]["value"], "-y")
        self.assertEqual(layouts[-1]["clip-position"]["value"], "1")
        self.assertEqual(layouts[-1]["group Figures"]["value"], "off")
        self.assert_picture("a.png", "beam.vtu", "--light=250,30", "--clip=3,1,1.5,0,-1,0")

    def test_keys(self):
        """The arrows reach each control that applies."""
        groups = ["Volume", "Surface", "Level of detail", "Light and camera", "Compare", "Save"]
        groups.append("Pattern generator")
        opened = [f"click group {name}" for name in groups]
        layouts, errors = self.studio(
            "beam.vtu", *opened, "click panels-in-pictures", *["key Up"] * 130
        )
        self.assertEqual(errors, "")
        wanted = {
            name
            for name, entry in layouts[-1].items()
            if entry["kind"] in ("choice", "flag", "number", "integer", "button", "text", "color")
            and entry.get("enabled")
            and any(entry["rectangle"])  # its group is open
            and not name.endswith(".default")
        }
        reached = {
            name for layout in layouts for name, e in layout.items() if e.get("focused")
        }
        # Buttons in a row are reached by Right.
        rows = ("redo", "step-", "play", "loop", "view-", "reset-view", "keys", "save-", "open-",
                "forget-probe", "clip-position")
        parts = {name for name in wanted if name[-2:] in (".0", ".1", ".2")}
        whole = {name[:-2] for name in parts}
        missing = {
            name
            for name in wanted - reached - whole
            if not name.startswith(rows) and not name.endswith((".1", ".2"))
        }
        self.assertEqual(missing, set())

    def test_flags(self):
        """The studio knows which options of relevo-view have no value."""
        usage = self.view("--help").stdout
        flags = re.findall(r"^  (--[a-z-]+)  ", usage, re.MULTILINE)
        self.assertIn("--wireframe", flags)
        run = subprocess.run(
            [PROGRAM, *sorted(set(flags) - {"--help", "--version"}), "--version"],
            capture_output=True,
            text=True,
        )
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertTrue(run.stdout.startswith("relevo-studio "))

    def test_report(self):
        run = subprocess.run([PROGRAM, "--report"], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        report = json.loads(run.stdout)
        self.assertRegex(report["opengl"]["version"], r"^[34]\.")
        self.assertGreaterEqual(report["opengl"]["texture size"], 1024)
        computes = "GL_ARB_compute_shader" in report["opengl"]["extensions"]
        self.assertEqual(report["opengl"]["compute shaders"], computes)
        self.assertRegex(report["imgui"], r"^1\.")

    def test_errors(self):
        layouts, errors = self.studio(
            "beam.vtu",
            "# a comment",
            "set nothing 3",
            "set range nan,1",
            "set max-level 8",
            "set exaggeration 2",
            "set array Missing",
            "set undo on",
            "click nothing",
            "save picture.gif",
            "key hyper+x",
            "key Foo",
            "set palett magma",
            "set clip-position 1",
            "set group Data",
            "set warp Move",
            "set scale 1e99",
            "set warp default",
            "save still.png",
            code=1,
        )
        expected = (
            (2, "unknown control 'nothing'"),
            (3, "--range needs"),
            (4, "--max-level needs a whole number from 0 to 7"),
            (5, "'exaggeration' is not available: --exaggeration requires a height map"),
            (6, "no array of numbers 'Missing'"),
            (7, "'undo' is a button"),
            (8, "unknown control 'nothing'"),
            (9, "picture.gif: its name must end with .png"),
            (10, "unknown key 'hyper+x'"),
            (11, "unknown key 'Foo'; keys are characters and BackSpace, "),
            (12, "unknown control 'palett'; similar: palette"),
            (13, "'clip-position' is not available: set clip-direction first"),
            (14, "unknown control 'group'"),
            (16, "--scale 1e+99 moves points too far away; use a smaller factor"),
        )
        lines = errors.splitlines()
        self.assertEqual(len(lines), len(expected) + 1, errors)
        for line, (number, words) in zip(lines, expected):
            self.assertIn(f"relevo-studio: error: script.txt, line {number}: ", line)
            self.assertIn(words, line)
        self.assert_picture("still.png", "beam.vtu")
        self.assertEqual(layouts[-1]["array"]["value"], "")
        for text, words in (
            ("jump 3", "line 1: unknown command 'jump'"),
            ("wait\ndrag 1 2 x 4", "line 2: 'x' is not a number of pixels"),
            ("set palette", "line 1: the command is 'set NAME VALUE'"),
        ):
            _, errors = self.studio("beam.vtu", text, code=1)
            self.assertIn(words, errors)
            self.assertEqual(errors.count("\n"), 1)
        for arguments, words in (
            (["beam.vtu", "--frobnicate"], "unknown option '--frobnicate'"),
            (["beam.vtu", "--palette"], "--palette needs a value"),
            (["script.txt", "--script=script.txt"], "relevo-studio reads meshes from "),
        ):
            run = subprocess.run(
                [PROGRAM, *arguments], cwd=self.folder, capture_output=True, text=True
            )
            self.assertIn(run.returncode, (1, 2))
            self.assertIn(words, run.stderr)


if __name__ == "__main__":
    unittest.main(argv=["TestStudio"])
