# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: the plugin works in clients of pvserver and in the application, and faults of
one process do not stop others.

The tests run this file as the client: pvpython TestServer.py SCENE PORT FOLDER, and on several
ranks: pvbatch TestServer.py ranks"""

import os
import re
import runpy
import shutil
import sys

import numpy
from paraview import simple, smtrace

import RelevoParaView as relevo

CAMERA = {"CameraPosition": [16, 12, 22], "CameraFocalPoint": [0, 0, 0], "CameraViewUp": [0, 1, 0]}


def make_sources():
    field = simple.Wavelet(WholeExtent=[-4, 4] * 3)
    surface = simple.Contour(Input=field, ContourBy=["POINTS", "RTData"], Isosurfaces=[180])
    return field, surface


def make_view():
    view = relevo.view((200, 150))
    view.UseFXAA = 0
    return view


def show_volume(field, view):
    shown = simple.Show(field, view)
    shown.Representation = "Adaptive Volume"
    simple.ColorBy(shown, ("POINTS", "RTData"))
    shown.RescaleTransferFunctionToDataRange(False, True)


def show_refined(surface, view):
    relevo.show(surface, view, MaximumLevel=3, Surface="PN Triangles")


def picture(view):
    simple.Render(view)  # ParaView moves the camera in the first frame of a session
    relevo.set_properties(view, CAMERA)
    return relevo.picture(view)


def draw():
    """Pictures of a refined surface and of a volume."""
    pictures = {}
    field, surface = make_sources()
    for name, show, source in ("refined", show_refined, surface), ("volume", show_volume, field):
        view = make_view()
        show(source, view)
        pictures[name] = picture(view)
        pictures[name + " is drawn by the server"] = numpy.array(
            view.GetClientSideObject().GetUseDistributedRenderingForRender()
        )
        simple.Delete(view)
    return pictures


def save_picture(path):
    view = simple.GetActiveViewOrCreate("RenderView")
    show_refined(make_sources()[1], view)
    simple.ResetCamera(view)
    simple.SaveScreenshot(path, view, ImageResolution=[200, 150])


class Client:
    """Scenes of a client."""

    def __init__(self, port, folder):
        self.folder = folder
        simple.Connect("localhost", int(port))

    def draw(self):
        numpy.savez(os.path.join(self.folder, "pictures.npz"), **draw())

    def late_plugin(self):
        """Shows data without the plugin, loads it, and shows them again. Python has the properties
        of the representation only in a new session."""
        surface = make_sources()[1]
        view = make_view()
        simple.Show(surface, view)
        simple.Render(view)
        print("the session goes on", flush=True)
        simple.Delete(view)
        for each in list(simple.GetSources().values()):
            simple.Delete(each)
        simple.LoadPlugin(os.environ["RELEVO_PLUGIN"], remote=False, ns=globals())
        view = make_view()
        simple.Show(make_sources()[1], view).Representation = "Adaptive Refinement"
        print("drawn:", relevo.foreground(picture(view)), flush=True)

    def trace(self):
        """Draws, and records a script that saves the picture of another view."""
        self.draw()
        smtrace.start_trace()
        view = simple.CreateView("RenderView")
        view.ViewSize = [200, 150]
        surface = make_sources()[1]
        shown = simple.Show(surface, view)
        with relevo.traced(shown):
            shown.Representation = "Adaptive Refinement"
            shown.MaximumLevel = 3
            shown.Surface = "PN Triangles"
            shown.Metric.ReferenceLength = 4
        simple.Render(view)
        with relevo.traced(view):
            relevo.set_properties(view, CAMERA)
        path = os.path.join(self.folder, "trace.png")
        simple.SaveScreenshot(path, view, ImageResolution=[200, 150])
        script = smtrace.stop_trace()
        with open(os.path.join(self.folder, "trace.py"), "w", encoding="utf-8") as file:
            file.write(script)


def draw_on_ranks():
    field, surface = make_sources()
    for show, source in (show_refined, surface), (show_volume, field):
        view = make_view()
        show(source, view)
        print("drawn:", relevo.foreground(picture(view)), flush=True)
        simple.Delete(view)


# A script of the application, which ends at the end of the script.
APPLICATION = f"""
import os
import sys
sys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})
try:
    import TestServer
    TestServer.save_picture("picture.png")
finally:
    os._exit(0)
"""


class TestServer(relevo.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected = draw()
        for name in "refined", "volume":
            assert relevo.foreground(cls.expected[name]) > 2000, name
        relevo.clear()

    def setUp(self):
        self.folder = self.make_folder()

    def connect(self, scene, ranks=1, client=None, **server):
        """Runs a scene of a client. Returns what the client and the server print."""
        lines = []
        with relevo.server(ranks, lines, **server) as port:
            command = ["pvpython", os.path.abspath(__file__), scene, port, self.folder]
            output = relevo.run(command, **(client or {}))
        return output, "\n".join(lines)

    def assert_picture(self, name, by_server, pixels):
        pictures = numpy.load(os.path.join(self.folder, "pictures.npz"))
        different = relevo.differing(pictures[name], self.expected[name])
        self.assertLessEqual(different, pixels, name)
        self.assertEqual(pictures[name + " is drawn by the server"], by_server, name)

    def assert_no_messages(self, *texts):
        for text in texts:
            self.assertNotRegex(text, r"(ERR|WARN)\|")

    def test_two_ranks(self):
        self.assert_no_messages(*self.connect("draw", 2))
        for name in "refined", "volume":
            self.assert_picture(name, True, 20)

    def assert_client_draws(self, *outputs):
        """The client draws surfaces. ParaView reports that volumes need the server. Returns the
        other messages."""
        found = [each for text in outputs for each in re.findall(r"(?:ERR|WARN)\|(?! (?:ERROR|Warning): In).*", text)]
        others = [each for each in found if "require remote rendering which, however" not in each]
        self.assertLess(len(others), len(found), found)
        self.assert_picture("refined", False, 0)
        return others

    def test_server_without_display(self):
        outputs = self.connect("draw", DISPLAY=None)
        if simple.GetParaViewVersion().major < 6:
            self.assertEqual(self.assert_client_draws(*outputs), [])
            return
        for name in "refined", "volume":  # later versions draw without a display
            self.assert_picture(name, True, 20)

    def test_server_with_old_opengl(self):
        """The server reports its OpenGL."""
        outputs = self.connect("draw", MESA_GL_VERSION_OVERRIDE="2.1")
        messages = self.assert_client_draws(*outputs)
        self.assertTrue(messages)
        for each in messages:
            self.assertIn("Unable to find a valid OpenGL 3.2 or later implementation", each)

    def test_client_without_plugin(self):
        """The first error names a representation of the plugin. The session goes on, and the client
        can load the plugin."""
        folder = os.environ["PV_PLUGIN_PATH"].split(os.pathsep)[0]
        without = {"PV_PLUGIN_PATH": None, "RELEVO_PLUGIN": os.path.join(folder, "Relevo.so")}
        client, _ = self.connect("late_plugin", client=without)
        errors = re.findall(r"ERR\|.*", client)
        self.assertIn("Failed to create subproxy: ", errors[0])
        self.assertRegex(client, r"Failed to create subproxy: Adaptive\w+Representation")
        goes_on, drawn = client.split("the session goes on")[1].split("drawn: ")
        self.assertNotIn("Failed to create", goes_on)
        self.assertGreater(int(drawn.split()[0]), 2000)

    def test_one_rank(self):
        """A script that is traced in the client draws the same in pvbatch."""
        self.assert_no_messages(*self.connect("trace"))
        for name in "refined", "volume":
            self.assert_picture(name, True, 0)
        path = os.path.join(self.folder, "trace.png")
        expected = relevo.read_png(path)
        self.assertGreater(relevo.foreground(expected), 2000)
        os.remove(path)
        runpy.run_path(os.path.join(self.folder, "trace.py"))
        self.assertEqual(relevo.differing(relevo.read_png(path), expected, 0), 0)

    def test_application(self):
        """The application finds the plugin by name."""
        if not shutil.which("paraview"):
            self.skipTest("there is no application")
        folder = os.environ["PV_PLUGIN_PATH"].split(os.pathsep)[0]
        script = os.path.join(self.folder, "script.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(APPLICATION)
        by_name = ["--plugin-search-paths", folder, "--plugins", "Relevo"]
        command = ["paraview", "--dr", *by_name, f"--script={script}"]
        try:
            output = relevo.run(command, cwd=self.folder, PV_PLUGIN_PATH=None)
        except AssertionError as error:
            if "no Qt platform plugin could be initialized" not in str(error):
                raise
            self.skipTest("Qt has no plugin for windows; install qt6-qpa-plugins")
        self.assert_no_messages(output)
        picture = relevo.read_png(os.path.join(self.folder, "picture.png"))
        self.assertGreater(relevo.foreground(picture), 2000)

    def test_old_opengl_on_one_rank(self):
        """The rank reports that the surface cannot be drawn, and the other draws its part."""
        old = "export MESA_GL_VERSION_OVERRIDE=3.2"
        output = relevo.run_ranks(2, os.path.abspath(__file__), "ranks", after_first=old)
        self.assertEqual(len(re.findall(r"ERR\|", output)), 1, output)
        self.assertRegex(output, r"pvbatch\.1 .*ERR\|")
        self.assertIn("Refinement needs OpenGL 3.3", output)
        refined, volume = map(int, re.findall(r"drawn: (\d+)", output))
        whole = relevo.foreground(self.expected["refined"])
        self.assertGreater(refined, whole / 4)
        self.assertLess(refined, whole)
        self.assertAlmostEqual(volume, relevo.foreground(self.expected["volume"]), delta=20)


if __name__ == "__main__":
    if len(sys.argv) == 1:
        relevo.main()
    elif sys.argv[1] == "ranks":
        draw_on_ranks()
    else:
        getattr(Client(*sys.argv[2:]), sys.argv[1])()
