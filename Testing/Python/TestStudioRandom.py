# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that relevo-studio survives random actions: no crash, no error of OpenGL, no growth of
memory, and a scene that a session brings back to the bit.

A run has a file and a seed. It repeats a block of random actions in one process, and opens the
first session after each block. RELEVO_FUZZ_RUNS=N makes N runs of 1000 actions, and
RELEVO_FUZZ_FIRST the first seed. RELEVO_TEST_DATA adds files. RELEVO_FUZZ_VERBOSE=1 prints each run
and its script.
"""

import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import unittest

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from StudioProgram import PROGRAM, SIZE, StudioProgram
from TestStudio import make_grid
from ViewerScenes import write_cube, write_hill, write_sphere

RUNS = int(os.environ.get("RELEVO_FUZZ_RUNS", "0"))
FIRST = int(os.environ.get("RELEVO_FUZZ_FIRST", "1"))
VERBOSE = os.environ.get("RELEVO_FUZZ_VERBOSE")
BLOCKS = 5 if RUNS else 2  # of a run
ACTIONS = 1000 // BLOCKS if RUNS else 25  # of a block
DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent")
FILES = ("result/mug.e", "result/ensight/LShape.case", "result/ensight/blow2_bin.case",
         "result/openfoam-cavity/case.foam", "result/TriQuadraticHexahedron.vtu",
         "result/Disc_BiQuadraticQuads_0_0.vtu", "mesh/teapot.bpt", "relief/rmnp-dem.tif",
         "volume/CylinderQuadratic.vtk", "flow/SurfaceVectors.vtk")
WIDTH, HEIGHT = 560, 420
PANEL = WIDTH - 325  # where the panel starts
GROWTH = 24 << 20  # bytes, after the first blocks
KEYS = ["BackSpace", "Delete", "Down", "End", "Escape", "Home", "Insert", "Left", "Next", "Prior",
        "Return", "Right", "Tab", "Up", "space", "ctrl+z", "ctrl+y", "shift+Tab", *"0123456789",
        *"abcdfhimnoprsw<>+-.,?"]
ODD = ["", "nan", "inf", "-inf", "1e308", "-1", "0", "1e-308", "abc", "1,2", "1,2,3", "1,2,3,4,5,6",
       "0,0,0,0,0,0", "default", "on", "off", "%s%n", "\x7f", "é", "9" * 40, "all", "1;2", "x=1"]
TEXTS = {
    "height": ["hill.png", "missing.png", "sphere.vtp"],
    "image": ["hill.png", "missing.jpg"],
    "no-data-value": ["0", "30"],
    "region": ["0,0,1", "0,0,0,1", "2,2,1,0.5"],
    "seed-line": ["0,0,0,1,1,1", "0,0,0,0,0,0"],
    "ruler": ["0,0,0,1,1,1", "-1,5,2,0,0,0"],
    "center": ["0,0", "0,0,0", "1,2,1"],
    "imagery-bands": ["1,1,1", "1"],
    "transfer": ["0 0 0 1 0;1 1 0 0 1", "0 0 0 1 0; 0 1 0 0 1", "missing.txt", "1 2", "nodes.txt"],
    "isosurfaces": ["0.5", "0.1,0.2,0.3", "1e9"],
    "compare-options": ["max-level=1", "wireframe;array=Height", "surface=phong;level=2", "x=1",
                        "volume", "max-level=9"],
    "below": ["red", "#123456", "#12"],
    "above": ["white", "no"],
    "pattern-levels": ["1,2,3", "5,0,5", "7,7,7"],
}
# Names that buttons write: they must not be those of inputs.
NAMES = {
    "picture-name": ["p.png", "missing/p.png", "p.gif"],
    "mesh-name": ["m.vtp", "m.obj", "m.x"],
    "session-name": ["s.json", "missing.json", "hill.png"],
    "script-name": ["s.py", "missing/s.py"],
    "source-name": ["source/"],
    "pattern-name": ["pattern.vtp", "pattern.x"],
    "table-name": ["table.vtp"],
}
# Finer meshes only take more time and memory.
LIMITS = {"level": 3, "max-level": 3, "hair": 300, "resolution": 64, "budget": 20000, "zoom": 5,
          "seeds": 50, "lic-steps": 30}
START = ("set session-name first.json", "click save-session", "save first.png")
RESET = ("key Escape", "set compare-method default", "set compare-options default",
         "set show-difference default", "set difference-gain default",
         "set panels-in-pictures default", "set loop default", "set session-name first.json")


class ScriptWriter:
    """Random lines for the controls of a scene."""

    def __init__(self, seed, controls, choices):
        self.rng = random.Random(seed)
        self.controls = [c for c in controls if c["kind"] not in ("figure", "words", "item")]
        self.enabled = [c for c in self.controls if c["enabled"]]
        self.choices = choices

    def pick(self, *kinds):
        """A control of other kinds than these. Most of them are available at first."""
        controls = self.enabled if self.rng.random() < 0.6 else self.controls
        return self.rng.choice([c for c in controls if c["kind"] not in kinds])

    def number(self, entry):
        low, high = entry.get("range") or (-1.0, 1.0)
        high = min(high, LIMITS.get(entry["name"].split(".")[0], high))
        share = self.rng.random()
        value = low + (high - low) * share**3
        return str(round(value)) if entry["kind"] == "integer" else f"{value:.6g}"

    def value(self, entry):
        name, rng = entry["name"], self.rng
        if name in NAMES:
            return rng.choice(NAMES[name])
        if rng.random() < 0.08:
            return rng.choice(ODD) or "default"
        if rng.random() < 0.15:
            return "default"
        if name in TEXTS and rng.random() < 0.9:
            return rng.choice(TEXTS[name])
        if name in self.choices:
            return rng.choice(self.choices[name])
        if entry["kind"] == "flag":
            return rng.choice(("on", "off"))
        if entry["kind"] == "plane":
            place = [f"{rng.uniform(-1, 6):.3g}" for _ in range(3)]
            return ",".join(place + rng.choice((["1", "0", "0"], ["0", "-1", "0.2"])))
        if entry["kind"] == "step":
            return str(rng.choice((0, 1, 2, 0.5, 1.3)))
        count = 1 if name[-2:-1] == "." else rng.choice((1, 1, 2, 3))
        return ",".join(sorted(self.number(entry) for _ in range(count)))

    def pixel(self):
        left, right = self.rng.choice(((0, PANEL), (0, PANEL), (PANEL, WIDTH), (-20, WIDTH + 20)))
        return self.rng.randint(left, right), self.rng.randint(-5, HEIGHT + 5)

    def drag(self):
        x, y = self.pixel()
        dx, dy = self.rng.choice(((0, 0), (1, 0), (30, -20), (-60, 40), (80, 0)))
        return f"drag {x} {y} {x + dx} {y + dy}"

    def line(self):
        rng = self.rng
        what = rng.random()
        if what < 0.4:
            entry = self.pick("button", "group")
            return f"set {entry['name']} {self.value(entry)}"
        if what < 0.6:
            return f"click {self.pick()['name']}"
        if what < 0.75:
            return self.drag()
        if what < 0.9:
            return f"key {rng.choice(KEYS)}"
        if what < 0.97:
            return f"click {rng.choice(('undo', 'undo', 'redo'))}"
        if what < 0.98:
            return "wait"
        return "save " + rng.choice(("r.png", "r.json", "r.py", "source/", "r.vtp", "r.gif"))

    def block(self, number):
        first = [
            f"set {name} {self.rng.choice(self.choices[name])}"
            for name in ("array", "warp", "volume")
            if name in self.choices and self.rng.random() < 0.6
        ]
        return [*first, *(self.line() for _ in range(number - len(first)))]


def resident_size(process):
    with open(f"/proc/{process.pid}/statm", encoding="ascii") as numbers:
        return int(numbers.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def limit_files():
    """A write of more than this fails, as on a full disk."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (64 << 20, 64 << 20))


class TestStudioRandom(StudioProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        write_hill(cls.folder)
        write_sphere(cls.folder)
        write_cube(cls.folder)
        for step in range(3):
            cls.write_data(f"s{step}.vtu", vtkXMLUnstructuredGridWriter, make_grid(float(step)))
        sets = "".join(f'<DataSet timestep="{s}" file="s{s}.vtu"/>' for s in range(3))
        (cls.folder / "steps.pvd").write_text(
            f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>'
        )
        (cls.folder / "nodes.txt").write_text("0 0 0 1 0\n3 0 1 0 0.5\n6 1 0 0 1\n")
        cls.files = ["steps.pvd", "sphere.vtp", "cube.vtu", "hill.png"]
        if RUNS:
            cls.view(cls(), "sphere.vtp", "--capture=reliefs.cdb", "--relief=view")
            cls.files += ["reliefs.cdb", *(DATA / f for f in FILES if (DATA / f).exists())]

    def ask(self, file):
        """The controls of a file, and the choices of each."""
        layouts, _ = self.studio(file)
        controls = list(layouts[-1].values())
        asked = [c["name"] for c in controls if c["kind"] == "choice" and c.get("enabled")]
        lines = [line for name in asked for line in (f"click {name}", "key Escape")]
        layouts, _ = self.studio(file, *lines)
        choices = {}
        for layout in layouts:
            for name, entry in layout.items():
                if entry["kind"] == "item":
                    control, choice = name.split("=", 1)
                    choices.setdefault(control, {})[choice] = None
        return controls, {name: list(items) for name, items in choices.items()}

    def run_script(self, file, lines):
        """Runs a script. Returns its messages and the memory at the end of each block."""
        (self.folder / "random.txt").write_text("\n".join(lines) + "\n")
        log = self.folder / "opengl.txt"
        log.unlink(missing_ok=True)
        environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
        environment.update(MESA_DEBUG="1", MESA_LOG_FILE=str(log))
        errors = self.folder / "errors.txt"
        sizes = []
        with errors.open("w") as stderr, subprocess.Popen(
            [PROGRAM, file, SIZE, "--script", "random.txt", "--layout", "/dev/stdout"],
            cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=stderr, text=True,
            preexec_fn=limit_files, restore_signals=False, errors="replace",
        ) as process:
            for line in process.stdout:
                # The end of a block names the picture.
                found = re.search(r'"value" : "end-(\d+)\.png"', line)
                if found and int(found[1]) == len(sizes):
                    sizes.append(resident_size(process))
        self.assertIn(process.returncode, (0, 1), errors.read_text()[-2000:])
        self.assertFalse(log.exists() and log.read_text(), "errors of OpenGL")
        return errors.read_text(errors="replace"), sizes

    def survive(self, file, seed):
        for name in ("s.json", "r.json"):
            (self.folder / name).unlink(missing_ok=True)
        shutil.rmtree(self.folder / "source", ignore_errors=True)
        controls, choices = self.ask(file)
        block = ScriptWriter(f"{file} {seed}", controls, choices).block(ACTIONS)
        lines = list(START)
        for number in range(BLOCKS):
            if number == BLOCKS - 1:
                # The state after random actions is one of relevo-view, too.
                lines += [*block, *RESET[:-1], "save state.json", "save state.png"]
            else:
                lines += block
            lines += [*RESET, "click open-session", f"set picture-name end-{number}.png",
                      f"save end-{number}.png"]
        if VERBOSE:
            print(f"{file} {seed}\n" + "\n".join(lines), flush=True)
        messages, sizes = self.run_script(file, lines)
        for message in messages.splitlines():
            self.assertRegex(message, r"\Arelevo-studio: (error|warning): [^\x00-\x1f\x7f]*\w\W{0,2}\Z")
        self.assertEqual(len(sizes), BLOCKS)
        first = (self.folder / "first.png").read_bytes()
        for number in range(BLOCKS):
            self.assertEqual((self.folder / f"end-{number}.png").read_bytes(), first, number)
        self.view("--session=state.json", "--output=again.png")
        self.assertEqual(
            (self.folder / "again.png").read_bytes(), (self.folder / "state.png").read_bytes()
        )
        if BLOCKS > 2:
            growth = sizes[-1] - sizes[BLOCKS // 2]
            if VERBOSE:
                print(file, seed, [size >> 20 for size in sizes], flush=True)
            self.assertLess(growth, GROWTH)

    def test_actions(self):
        for run in range(max(RUNS, 1)):
            seed = FIRST + run
            file = str(self.files[seed % len(self.files)])
            with self.subTest(file=file, seed=seed):
                self.survive(file, seed)

    def test_detection(self):
        """Errors of OpenGL are found."""
        program = (
            "import ctypes, relevo\n"
            "import vtkmodules.vtkRenderingOpenGL2\n"
            "window = relevo.vtkEGLOffscreenRenderWindow()\n"
            "window.Render()\n"
            "window.MakeCurrent()\n"
            "print(window.ReportCapabilities())\n"
            "ctypes.CDLL('libGL.so.1').glEnable(0xdead)\n"
        )
        log = self.folder / "detected.txt"
        environment = {**os.environ, "MESA_DEBUG": "1", "MESA_LOG_FILE": str(log)}
        run = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True,
                             text=True)
        if run.returncode != 0 or "Mesa" not in run.stdout:
            self.skipTest("the driver is not Mesa, or there is no EGL")
        self.assertIn("GL_INVALID_ENUM", log.read_text())


if __name__ == "__main__":
    unittest.main(argv=["TestStudioRandom"])
