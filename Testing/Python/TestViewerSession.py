# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on sessions: the same picture to the bit, and bad sessions."""

import json
import shutil
import unittest

from ViewerProgram import ViewerProgram
from ViewerScenes import write_hill, write_sphere

SIZE = "--size=80x60"


class TestViewerSession(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.mesh = write_sphere(cls.folder)

    def picture(self, *arguments):
        self.view(*arguments, "--output=picture.png")
        return (self.folder / "picture.png").read_bytes()

    def test_same_picture(self):
        shutil.copy(self.mesh, self.folder / f"other{self.mesh.suffix}")
        for arguments in (
            [self.mesh, "--view=30,40", "--zoom=1.3", "--no-legend", "--level=3", SIZE],
            [self.heights, "--contours=2", "--palette=heat", "--view", "200,30", SIZE],
            [self.heights, "--level=1", "--wireframe", SIZE],
            [self.mesh, "--height", self.heights, "--scale=0.01", SIZE],
        ):
            with self.subTest(arguments):
                expected = self.picture(*arguments, "--save-session=s.json")
                session = json.loads((self.folder / "s.json").read_text())
                self.assertEqual(session["version"], 1)
                self.assertNotIn("/", session["file"])  # relative to the session
                self.assertEqual(session["options"]["size"], "80x60")
                self.assertNotIn("output", session["options"])
                self.assertEqual(self.picture("--session", "s.json"), expected)
                # A session of a session is the same.
                (self.folder / "sub").mkdir(exist_ok=True)
                again = self.picture("--session=s.json", "--save-session=sub/t.json")
                self.assertEqual(again, expected)
                moved = json.loads((self.folder / "sub/t.json").read_text())
                self.assertEqual(moved["file"], "../" + session["file"])
                self.assertEqual(moved["camera"], session["camera"])
                self.assertEqual(self.picture("--session=sub/t.json"), expected)
                # Options of the command line and another file have priority.
                changed = self.picture("--session=s.json", "--view=90,10")
                self.assertNotEqual(changed, expected)
                self.assertNotEqual(self.picture("--session=s.json", "--size=70x60"), expected)
        self.assertEqual(
            self.picture("--session=s.json", f"other{self.mesh.suffix}"), self.picture("--session=s.json")
        )

    def test_options_and_camera(self):
        session = {
            "version": 1, "file": str(self.mesh),
            "options": {"zoom": 2, "--no-legend": True, "size": "80x60", "level": 2.0},
        }
        (self.folder / "a.json").write_text(json.dumps(session))
        self.assertEqual(
            self.picture("--session=a.json"),
            self.picture(self.mesh, "--zoom=2", "--no-legend", "--level=2", SIZE),
        )
        session["camera"] = {
            "position": [0, 0, 90], "focal-point": [0, 0, 0], "view-up": [0, 1, 0],
            "view-angle": 20, "parallel-scale": 1, "parallel": False,
        }
        (self.folder / "a.json").write_text(json.dumps(session))
        far = self.picture("--session=a.json")
        session["camera"]["view-angle"] = 5
        (self.folder / "a.json").write_text(json.dumps(session))
        self.assertNotEqual(self.picture("--session=a.json"), far)

    def test_bad_sessions(self):
        good = {
            "version": 1, "file": self.mesh.name, "options": {"zoom": "2"},
            "camera": {
                "position": [0, 0, 9], "focal-point": [0, 0, 0], "view-up": [0, 1, 0],
                "view-angle": 30, "parallel-scale": 1, "parallel": False,
            },
        }
        text = json.dumps(good)
        camera = good["camera"]
        for session, words in (
            ({**good, "version": 2}, ["version is 2", "up to 1"]),
            ({**good, "version": "1"}, ["version must be 1"]),
            ({**good, "version": -1}, ["version must be 1"]),
            ({**good, "colour": 1}, ["unknown name 'colour'"]),
            ({"version": 1}, ["file must be the name"]),
            ({**good, "file": 5}, ["file must be the name"]),
            ({**good, "options": []}, ["options must be an object"]),
            ({**good, "options": {"zoomm": 1}}, ["unknown option '--zoomm'"]),
            ({**good, "options": {"output": "x.png"}}, ["unknown option '--output'"]),
            ({**good, "options": {"serve": True}}, ["unknown option '--serve'"]),
            ({**good, "options": {"zoom": "nan"}}, ["--zoom needs a number", "nan"]),
            ({**good, "options": {"zoom": 1e9}}, ["--zoom needs a number from 0.001 to 1e+06"]),
            ({**good, "options": {"zoom": True}}, ["--zoom needs a value"]),
            ({**good, "options": {"zoom": [1]}}, ["--zoom must be a text, a number or true"]),
            ({**good, "options": {"no-legend": "x"}}, ["--no-legend must be true"]),
            ({**good, "options": {"no-legend": False}}, ["--no-legend must be"]),
            ({**good, "options": {"pixels": 1, "metric": "distance"}}, ["--pixels"]),
            ({**good, "camera": {**camera, "position": [0, 0]}}, ["position must be three"]),
            ({**good, "camera": {**camera, "position": [0, 0, "x"]}}, ["position must be a number"]),
            ({**good, "camera": {**camera, "position": [0, 0, 0]}}, ["define no view"]),
            ({**good, "camera": {**camera, "view-up": [0, 0, 1]}}, ["define no view"]),
            ({**good, "camera": {**camera, "view-angle": 180}}, ["view-angle must be"]),
            ({**good, "camera": {**camera, "roll": 1}}, ["unknown name 'roll' in camera"]),
            ({**good, "camera": 3}, ["camera must be an object"]),
            ({**good, "file": "none.ply"}, ["none.ply"]),
            (text[:-20], ["not valid JSON"]),
            (text.replace("30", "NaN"), ["not valid JSON"]),
            (text.replace("30", "1e999"), [""]),  # JsonCpp 1.9.6 takes it as infinite
            (text + "x", ["not valid JSON"]),
            ("", ["not valid JSON"]),
            ("[1]", ["must contain an object"]),
            ("[" * 5000, ["not valid JSON"]),
            (" " * (1 << 20) + text, ["larger than 1 MiB"]),
        ):
            with self.subTest(str(session)[:200]):
                data = session if isinstance(session, str) else json.dumps(session)
                (self.folder / "bad.json").write_text(data)
                code = 1 if "none.ply" in data else 2
                place = [] if code == 1 else ["--session bad.json: "]
                if words == ["--pixels"]:
                    place = []
                self.assert_error(code, place + words, "--session=bad.json", "--output=x.png")
                self.assertFalse((self.folder / "x.png").exists())
        self.assert_error(2, ["--session none.json: the file cannot be read"], "--session=none.json")
        self.assert_error(2, ["--session", "cannot be read"], "--session", self.folder)

    def test_bad_outputs(self):
        (self.folder / "old.json").write_text("old")
        self.assert_error(2, ["--save-session needs the name of a .json file"],
                          self.mesh, "--save-session=s.txt", "--output=x.png")
        self.assert_error(1, ["none/s.json"], self.mesh, "--save-session=none/s.json",
                          "--output=x.png")
        # Bad input leaves the old file.
        self.assert_error(1, ["none.ply"], "none.ply", "--save-session=old.json",
                          "--output=x.png")
        self.assertEqual((self.folder / "old.json").read_text(), "old")


if __name__ == "__main__":
    unittest.main(argv=["TestViewerSession"])
