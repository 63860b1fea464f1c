# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves terrain.md on servers and processes: a terrain of a server that fails or does not answer,
and indices that several processes make, that are interrupted, or that do not fit on the disk."""

import http.server
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

os.environ["CPL_VSIL_CURL_CACHE_SIZE"] = "65536"  # of GDAL; tiles are requested again

import relevo
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  makes render windows

PROGRAM = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin" / "relevo-pyramid"
if not PROGRAM.exists():
    print("skipped: relevo-pyramid was not built")
    sys.exit(125)

SIZE = 1500
HEADER = f"""ENVI
samples = {SIZE}
lines = {SIZE}
bands = 1
data type = 2
interleave = bsq
byte order = 0
map info = {{UTM, 1, 1, 500000, 4300000, 30, 30, 32, North, WGS-84}}
"""


class Handler(http.server.BaseHTTPRequestHandler):
    """Serves one file in every folder, or fails as the file beside it, `mode`, asks."""

    def do_HEAD(self):
        self.answer(False)

    def do_GET(self):
        self.answer(True)

    def answer(self, has_body):
        mode = (FOLDER / "mode").read_text()
        if mode == "hang":
            time.sleep(600)
        if mode.isdigit() or not self.path.endswith("/hills.tif"):
            self.send_error(int(mode) if mode.isdigit() else 404)
            return
        contents = (FOLDER / "hills.tif").read_bytes()
        first, last = 0, len(contents) - 1
        wanted = self.headers.get("Range")
        if wanted:
            begin, end = wanted.split("=")[1].split("-")
            first, last = int(begin), min(last, int(end or last))
        self.send_response(206 if wanted else 200)
        self.send_header("Content-Length", str(last - first + 1))
        self.send_header("Accept-Ranges", "bytes")
        if wanted:
            self.send_header("Content-Range", f"bytes {first}-{last}/{len(contents)}")
        self.end_headers()
        if has_body:
            body = contents[first : last + 1]
            self.wfile.write(body[: len(body) // 2] if mode == "short" else body)

    def log_message(self, *arguments):
        pass


def serve():
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        server.daemon_threads = True
        print(server.server_address[1], flush=True)
        server.serve_forever()


class Scene:
    """A terrain, and the errors of its objects."""

    def __init__(self, name, cache):
        self.pyramid = relevo.vtkTerrainPyramid()
        self.pyramid.SetFileName(name)
        self.pyramid.SetCacheDirectory(str(cache))
        self.mapper = relevo.vtkTerrainMapper()
        self.mapper.SetPyramid(self.pyramid)
        self.errors = []
        self.is_updated = False
        for source in (self.pyramid, self.mapper):
            source.AddObserver("ErrorEvent", self.note)
        self.mapper.AddObserver("UpdateEvent", self.update)
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(300, 200)
        self.window.AddRenderer(self.renderer)

    def note(self, *_):
        self.errors.append(True)

    def update(self, *_):
        self.is_updated = True

    def look(self, distance, x=0):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(x, -0.7 * distance, 900 + 0.7 * distance)
        camera.SetFocalPoint(x, 0, 900)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCameraClippingRange()

    def draw_all(self):
        """Frames until there is nothing more to load."""
        self.is_updated = True
        while self.is_updated:
            self.is_updated = False
            self.window.Render()


SCRIPT = """
import sys
import relevo
pyramid = relevo.vtkTerrainPyramid()
pyramid.SetFileName(sys.argv[1])
if len(sys.argv) > 2:
    pyramid.SetCacheDirectory(sys.argv[2])
assert pyramid.Update()
print("open", flush=True)
if sys.stdin.readline():
    print(pyramid.WaitForIndex(), pyramid.IsErrorKnown())
"""


class TestTerrainServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rows, columns = numpy.mgrid[0:SIZE, 0:SIZE]
        heights = 900 + 500 * numpy.sin(columns / 60) * numpy.cos(rows / 80) + (
            columns * 7919 + rows * 104729
        ) % 20
        heights.astype("<i2").tofile(FOLDER / "plain.dat")
        (FOLDER / "plain.hdr").write_text(HEADER)
        subprocess.run(
            [PROGRAM, FOLDER / "plain.dat", FOLDER / "hills.tif", "--no-index"], check=True
        )
        cls.set_mode("ok")
        cls.server = subprocess.Popen(
            [sys.executable, __file__, "--serve", FOLDER], stdout=subprocess.PIPE, text=True
        )
        cls.name = f"/vsicurl/http://127.0.0.1:{int(cls.server.stdout.readline())}/hills.tif"

    @classmethod
    def tearDownClass(cls):
        cls.server.kill()
        cls.server.wait()
        cls.server.stdout.close()

    @staticmethod
    def set_mode(mode):
        (FOLDER / "mode.new").write_text(mode)
        (FOLDER / "mode.new").rename(FOLDER / "mode")

    def open(self, cache, name=None):
        scene = Scene(name or self.name, FOLDER / cache)
        self.assertTrue(scene.pyramid.Update())
        self.assertTrue(scene.pyramid.WaitForIndex())
        return scene

    def test_opening(self):
        """A file that cannot be opened is one error, and the next Update() asks again."""
        for mode in ("404", "500", "503"):
            with self.subTest(mode):
                self.set_mode(mode)
                scene = Scene(self.name, FOLDER / "cache-opening")
                self.assertFalse(scene.pyramid.Update())
                self.assertEqual(len(scene.errors), 1)
                self.assertIn(self.name, scene.pyramid.GetErrorMessage())
                self.set_mode("ok")
                self.assertTrue(scene.pyramid.Update())
                self.assertTrue(scene.pyramid.WaitForIndex())
                self.assertEqual(len(scene.errors), 1)

    def test_tiles(self):
        """Tiles that a server does not deliver are drawn coarser, with one error."""
        for mode in ("404", "500", "503", "short"):
            with self.subTest(mode):
                self.set_mode("ok")
                scene = self.open("cache-tiles")
                scene.look(60000)
                scene.draw_all()
                self.assertEqual(scene.errors, [])
                self.assertTrue(scene.mapper.IsComplete())
                self.set_mode(mode)
                for i in range(4):
                    scene.look(2500, 3000 * (i - 2))
                    scene.draw_all()
                    self.assertFalse(scene.mapper.IsComplete())
                    self.assertGreater(scene.mapper.GetNumberOfDrawnTriangles(), 0)
                self.assertEqual(len(scene.errors), 1)

    def test_index(self):
        """An index without all samples is not used, and the terrain is drawn nevertheless."""
        self.set_mode("ok")
        scene = Scene(self.name, FOLDER / "cache-index")
        self.assertTrue(scene.pyramid.Update())
        self.set_mode("500")
        is_built = scene.pyramid.WaitForIndex()
        self.set_mode("ok")
        if not is_built:  # otherwise all samples had been read
            self.assertEqual(len(scene.errors), 1)
            self.assertFalse(scene.pyramid.IsErrorKnown())
            self.assertEqual(list((FOLDER / "cache-index").glob("*")), [])
        scene.look(60000)
        scene.draw_all()
        self.assertGreater(scene.mapper.GetNumberOfDrawnTriangles(), 0)

    def test_hanging(self):
        """Frames go on while a server does not answer."""
        self.set_mode("ok")
        # In another folder, because GDAL shares downloads: those that hang fail for all readers.
        name = self.name.replace("/hills.tif", "/hanging/hills.tif")
        scene = self.open("cache-hanging", name)
        scene.look(60000)
        scene.draw_all()
        self.set_mode("hang")
        for i in range(20):
            scene.look(2500, 300 * i)
            scene.window.Render()
            self.assertGreater(scene.mapper.GetNumberOfDrawnTriangles(), 0)
        self.assertEqual(scene.errors, [])
        self.assertFalse(scene.mapper.IsComplete())
        self.set_mode("ok")

    def start(self, *arguments, **settings):
        return subprocess.Popen(
            [sys.executable, "-c", SCRIPT, *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            **settings,
        )

    def copy(self, name):
        copy = FOLDER / name
        copy.write_bytes((FOLDER / "hills.tif").read_bytes())
        return copy

    def assert_indexed(self, raster):
        pyramid = relevo.vtkTerrainPyramid()
        pyramid.SetFileName(str(raster))
        self.assertTrue(pyramid.Update())
        self.assertTrue(pyramid.IsErrorKnown())  # the index is read, not made

    def files(self, raster):
        return sorted(path.name for path in FOLDER.iterdir() if raster.stem in path.name)

    def test_two_processes(self):
        """Two processes that make one index at the same time both succeed."""
        raster = self.copy("two.tif")
        with self.start(raster) as first, self.start(raster) as second:
            for process in (first, second):
                self.assertEqual(process.stdout.readline(), "open\n")
            for process in (first, second):
                process.stdin.write("\n")
                process.stdin.flush()
            for process in (first, second):
                self.assertEqual(process.stdout.read(), "True True\n")
        self.assertEqual(self.files(raster), ["two.tif", "two.tif.relevo-index"])
        self.assert_indexed(raster)

    def test_kill(self):
        """A process that is killed leaves no half index."""
        raster = self.copy("killed.tif")
        with self.start(raster) as process:
            self.assertEqual(process.stdout.readline(), "open\n")
            process.kill()
        self.assertEqual(process.returncode, -signal.SIGKILL)
        if self.files(raster) != ["killed.tif"]:  # a machine that was faster
            self.assert_indexed(raster)
        with self.start(raster) as process:
            self.assertEqual(process.communicate("\n")[0], "open\nTrue True\n")
        self.assert_indexed(raster)

    def test_full_disk(self):
        """An index that does not fit on the disk is used in memory, and there is no half file."""
        raster = self.copy("full.tif")

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))

        with self.start(raster, preexec_fn=limit) as process:
            self.assertEqual(process.communicate("\n")[0], "open\nTrue True\n")
        self.assertEqual(self.files(raster), ["full.tif"])

    def test_quit(self):
        """A process ends although a server does not answer."""
        self.set_mode("ok")
        with self.start(self.name, FOLDER / "cache-quit") as process:
            self.assertEqual(process.stdout.readline(), "open\n")
            self.set_mode("hang")
            self.assertEqual(process.communicate("", timeout=120)[0], "")
        self.assertEqual(process.returncode, 0)
        self.set_mode("ok")


if __name__ == "__main__":
    if "--serve" in sys.argv:
        FOLDER = pathlib.Path(sys.argv[2])
        serve()
    with tempfile.TemporaryDirectory() as folder:
        FOLDER = pathlib.Path(folder)
        unittest.main(argv=["TestTerrainServer"])
