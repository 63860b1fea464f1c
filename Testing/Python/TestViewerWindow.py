# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""relevo-view's window, with keys and a mouse: how it is left."""

import unittest

from ViewerProgram import ViewerProgram
from ViewerScenes import write_hill, write_sphere
from ViewerWindow import Display, Window

SIZE = "--size=300x200"


class TestViewerWindow(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.mesh = write_sphere(cls.folder)
        cls.display = Display()

    @classmethod
    def tearDownClass(cls):
        cls.display.stop()
        super().tearDownClass()

    def window(self, *arguments):
        return Window(self.display, self.folder, *arguments, SIZE)

    def moves(self, id):
        return [word for x in range(9) for word in ("mousemove", "--window", id, 20 * x, 50)]

    def test_leaving(self):
        """However it is left, with the mouse in it or not: exit code 0, nothing on stderr."""
        for scene in ((self.heights,), (self.mesh,), (self.mesh, "--lic=Around")):
            for way in ("q", "e", "close button"):
                with self.subTest(scene=scene, way=way):
                    window = self.window(*scene)
                    window.move(150, 100)
                    if way == "q":
                        # The mouse moves on.
                        self.display.do("key", way, *self.moves(window.id))
                    if way == "close button":
                        window.click_close_button()
                    elif way == "e":
                        window.key(way)
                    self.assertEqual(window.leave(), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=["TestViewerWindow"])
