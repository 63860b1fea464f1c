# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves studio.md in a window: clicks, drags and keys by xdotool, and nothing drawn while still."""

import json
import os
import pathlib
import subprocess
import sys
import time
import unittest

from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from ViewerProgram import PROGRAM as VIEWER
from ViewerProgram import ViewerProgram
from ViewerWindow import Display, wait

PROGRAM = VIEWER.with_name("relevo-studio")
if not PROGRAM.exists():
    print("skipped: relevo-studio was not built")
    sys.exit(125)


class TestStudioWindow(ViewerProgram):
    def layout(self):
        """The entries of the last frame by their names, or nothing before the first one."""
        try:
            entries = json.loads((self.folder / "layout.json").read_text())
        except (OSError, ValueError):
            return {}
        return {entry["name"]: entry for entry in entries}

    def find(self, name):
        left, top, width, height = self.layout()[name]["rectangle"]
        return int(left + width / 2), int(top + height / 2)

    def get_seconds(self, program):
        """The processor time of a program."""
        fields = pathlib.Path(f"/proc/{program.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def test_window(self):
        sphere = vtkSphereSource()
        sphere.Update()
        self.write_data("sphere.vtp", vtkXMLPolyDataWriter, sphere.GetOutput())
        display = Display("1024x1024")  # the window is 900 pixels high
        self.addCleanup(display.stop)
        program = subprocess.Popen(
            [PROGRAM, "sphere.vtp", "--size=600x900", "--layout=layout.json"],
            cwd=self.folder,
            env=display.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        wait(self.layout, "the first frame")
        window = wait(lambda: display.do("search", "--name", "^relevo-studio "), "the window")
        display.do("windowfocus", window)

        def value(name):
            return self.layout().get(name, {}).get("value")

        def move(x, y):
            display.do("mousemove", "--window", window, x, y)

        move(*self.find("wireframe"))
        display.do("click", 1)
        wait(lambda: value("wireframe") == "on", "the click")

        move(*self.find("group Light and camera"))
        display.do("click", 1)
        wait(lambda: self.layout().get("light.0", {}).get("visible"), "the group")
        left, top, width, height = self.layout()["light.0"]["rectangle"]
        move(int(left + width / 4), int(top + height / 2))
        display.do("mousedown", 1)
        for share in (0.4, 0.5, 0.6, 0.8):
            move(int(left + share * width), int(top + height / 2))
        display.do("mouseup", 1)
        wait(lambda: float(value("light.0") or 0) > 270.0, "the drag")  # from 250
        wait(lambda: (value("light") or "").endswith(",45"), "the elevation of meshes")

        # The scene takes a drag beside the panel, and then the keys.
        move(100, 300)
        display.do("mousedown", 1)
        move(140, 320)
        display.do("mouseup", 1)
        display.do("key", "ctrl+z")
        wait(lambda: value("light") == "", "undo")

        # Values follow the mouse in frames that do not draw the scene, and a click keeps them.
        repeated = value("figure-panel-frames")
        move(130, 340)
        wait(lambda: value("readout"), "the values under the mouse")
        self.assertGreater(value("figure-panel-frames"), repeated)
        display.do("click", 1)
        wait(lambda: value("probe") == value("readout"), "the values of the click")
        display.do("key", "h")
        wait(lambda: value("key-help"), "the keys")
        display.do("key", "h")
        wait(lambda: not value("key-help"), "no keys")

        # A still window draws nothing and takes less than 2 % of a processor.
        time.sleep(0.5)
        frames = value("figure-frames")
        used = self.get_seconds(program)
        time.sleep(2.0)
        self.assertEqual(value("figure-frames"), frames)
        self.assertLessEqual(self.get_seconds(program) - used, 0.04)
        display.do("key", "q")
        output, errors = program.communicate(timeout=60)
        self.assertEqual((program.returncode, errors), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=["TestStudioWindow"])
