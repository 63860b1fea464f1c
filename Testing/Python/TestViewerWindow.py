# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves viewer.md on relevo-view's window with keys and mouse: closing it, its frames, and keys
for volumes and time steps."""

import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from ViewerProgram import ViewerProgram
from ViewerScenes import make_cube, write_cube, write_hill, write_sphere
from ViewerWindow import Display, Window

SIZE = "--size=300x200"
SLOW = ("--surface=pn", "--level=6")  # about 10^5 triangles


class TestViewerWindow(ViewerProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.heights = write_hill(cls.folder)
        cls.mesh = write_sphere(cls.folder)
        cls.volume = write_cube(cls.folder)
        cls.display = Display()

    @classmethod
    def tearDownClass(cls):
        cls.display.stop()
        super().tearDownClass()

    def window(self, *arguments):
        window = Window(self.display, self.folder, *arguments, SIZE)
        self.addCleanup(window.stop)
        return window

    def moves(self, id):
        return [word for x in range(9) for word in ("mousemove", "--window", id, 20 * x, 50)]

    def test_leaving(self):
        """However the window is closed, with the mouse inside or outside: exit code 0 and no output
        on stderr."""
        for scene in ((self.heights,), (self.mesh,), (self.mesh, "--lic=Around"), (self.volume, "--volume")):
            for way in ("q", "e", "close button"):
                with self.subTest(scene=scene, way=way):
                    window = self.window(*scene)
                    window.move(150, 100)
                    if way == "q":
                        # The mouse continues to move.
                        self.display.do("key", way, *self.moves(window.id))
                    if way == "close button":
                        window.click_close_button()
                    elif way == "e":
                        window.key(way)
                    self.assertEqual(window.leave(), (0, ""))

    def test_first_connection_lasts(self):
        """Another client stays connected, so that the X server does not reset."""
        display = Display(terminates=True)
        self.addCleanup(display.stop)
        window = Window(display, self.folder, self.mesh, SIZE)
        self.addCleanup(window.stop)
        window.key("q")
        self.assertEqual(window.leave(), (0, ""))

    def test_events_share_frames(self):
        """Most of forty turns of the wheel at once share a frame."""
        window = self.window(self.mesh, *SLOW)
        window.move(150, 100)
        frames = [window.pixels()]
        self.display.do("click", "--repeat", 40, "--delay", 0, 4, "key", "c")
        # Printed when the last turn has been drawn.
        while window.lines.empty():
            pixels = window.pixels()
            if pixels != frames[-1]:
                frames.append(pixels)
        self.assertLess(len(frames), 20)
        self.assertNotEqual(window.pixels(), frames[0])
        window.key("q")
        self.assertEqual(window.leave(), (0, ""))

    def test_stereo(self):
        """VTK's key for red and blue stereo has no effect, except that it is a view of meshes."""
        for scene in ((self.heights,), (self.mesh,)):
            window = self.window(*scene)
            window.move(298, 2)
            if scene == (self.mesh,):
                window.key("3")
                window.expect("--view left")
                window.key("c")
                window.expect("here: ")
            before = window.screen()
            window.key("3")
            window.key("c")
            self.assertEqual(window.expect("here: "), "here: nothing")
            self.assertTrue(window.screen() == before)
            window.key("q")
            self.assertEqual(window.leave(), (0, ""))

    def test_keys_of_volumes(self):
        """Each key prints the option that repeats its action."""
        window = self.window(self.volume, "--volume", "--unit-distance=2")
        for key, option, *numbers in (
            ("plus", "--unit-distance", 1.6),
            ("minus", "--unit-distance", 2),
            ("minus", "--unit-distance", 2.5),
            ("period", "--isosurfaces", 0.5),
            ("period", "--isosurfaces", 0.52),
            ("comma", "--isosurfaces", 0.5),
        ):
            window.key(key)
            words = window.expect("--").split()
            self.assertEqual(words[0], option)
            self.assertAlmostEqual(float(words[1]), numbers[0])
        cuts = []
        for key in ("m", "m", "n"):
            window.key(key)
            option, numbers = window.expect("--").split()
            self.assertEqual(option, "--clip")
            cuts.append([float(number) for number in numbers.split(",")])
        # From the camera's side, which is south and above.
        self.assertEqual(cuts[0][3:], [0, 0, -1])
        self.assertAlmostEqual(cuts[0][2], 0.98, delta=1e-4)
        self.assertAlmostEqual(cuts[1][2], 0.96, delta=1e-4)
        self.assertEqual(cuts[2], cuts[0])
        window.key("q")
        self.assertEqual(window.leave(), (0, ""))

    def test_cut_of_mesh(self):
        """The keys of cuts also fill a cut through the cells of a mesh."""
        window = self.window(self.volume)
        before = window.pixels()
        window.key("m")
        option, numbers = window.expect("--").split()
        self.assertEqual(option, "--clip")
        self.assertEqual(numbers.split(",")[3:], ["0", "0", "-1"])
        window.key("c")  # after the frame
        window.expect("here: ")
        self.assertFalse(window.pixels() == before)
        window.key("q")
        self.assertEqual(window.leave(), (0, ""))

    def test_plan_views_and_ruler(self):
        """1 to 6 look along the axes, and d measures between two points. Volumes have both, too."""
        for options in ((), ("--volume", "--unit-distance=0.01")):
            window = self.window(self.volume, *options)
            for key, name in zip("123456", ("front", "back", "left", "right", "top", "bottom")):
                window.key(key)
                self.assertEqual(window.expect("--view"), f"--view {name}")
            window.key("1")
            window.expect("--view")
            window.move(120, 100)
            window.key("d")
            self.assertIn("press d at the other end", window.expect("ruler: from"))
            before = window.pixels()
            window.move(180, 100)
            window.key("d")
            line = window.expect("--ruler")
            places = [float(number) for number in line.split()[1].split(",")]
            length = float(line.split()[-1])
            self.assertAlmostEqual(abs(places[3] - places[0]), length, delta=0.02)
            self.assertGreater(length, 0.1)
            window.key("c")  # after the frame
            window.expect("here: ")
            self.assertFalse(window.pixels() == before)
            window.move(298, 2)
            window.key("d")
            window.expect("ruler: there is nothing")
            window.key("q")
            self.assertEqual(window.leave(), (0, ""))

    def test_keys_of_time_steps(self):
        """< and > change the step. One that cannot be drawn is an error, and the old one stays."""
        entries = ""
        for time, name in enumerate(("Heat", "Heat", "Other")):
            cube = make_cube()
            array = vtkDoubleArray()
            array.SetName(name)
            for i in range(cube.GetNumberOfPoints()):
                array.InsertNextValue(time * i)
            cube.GetPointData().AddArray(array)
            self.write_data(f"{time}.vtu", vtkXMLUnstructuredGridWriter, cube)
            entries += f'<DataSet timestep="{time}" file="{time}.vtu"/>'
        (self.folder / "a.pvd").write_text(
            f'<VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>'
        )
        window = self.window("a.pvd", "--array=Heat")
        window.key("greater")
        self.assertEqual(window.expect("--"), "--time 1")
        window.key("greater")
        window.key("less")
        self.assertEqual(window.expect("--"), "--time 0")
        window.key("q")
        code, errors = window.leave()
        self.assertEqual(code, 0)
        self.assertEqual(
            errors, "relevo-view: error: a.pvd has no array 'Heat' with --time 2\n"
        )

    def test_opacity_of_other_blend_modes(self):
        window = self.window(self.volume, "--volume", "--blend=maximum")
        window.key("plus")
        self.assertEqual(window.expect("opacity"), "opacity times 1.25")
        window.key("e")
        self.assertEqual(window.leave(), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=["TestViewerWindow"])
