# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that Ctrl-C stops long work of the functions that draw, and that other threads of Python
run meanwhile. Each program runs in a process of its own, which gets real signals."""

import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

import DrawingData  # noqa: F401, skips without numpy, EGL and GDAL

# A mesh from an algorithm that interrupts itself in its step 3, and that has LAST steps.
SLOW_MESH = """
import os, signal
import relevo
from DrawingData import make_sphere
from vtkmodules.vtkFiltersProgrammable import vtkProgrammableFilter
steps = []
source = vtkProgrammableFilter()
source.SetInputData(make_sphere())
def execute():
    steps.clear()
    source.GetOutput().ShallowCopy(source.GetInput())
    for step in range(LAST):
        if source.GetAbortExecute():
            break
        steps.append(step)
        if step == 3:
            os.kill(os.getpid(), signal.SIGINT)
        source.UpdateProgress(step / LAST)
source.SetExecuteMethod(execute)
"""
MANY, FEW = "LAST = 10_000_000", "LAST = 100"


def run(program, *arguments, **options):
    return subprocess.run(
        [sys.executable, "-c", textwrap.dedent(program), *map(str, arguments)],
        cwd=pathlib.Path(__file__).parent,
        capture_output=True,
        text=True,
        timeout=300,
        **options,
    )


class TestInterrupts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check(self, program, *arguments):
        result = run(program, *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result.stdout

    def test_update(self):
        """Ctrl-C stops an algorithm, which is complete after the next update."""
        self.check(
            MANY
            + SLOW_MESH
            + """
try:
    relevo.refined(source)
except KeyboardInterrupt:
    pass
else:
    raise AssertionError("not interrupted")
assert 3 < len(steps) < LAST, len(steps)
assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
signal.signal(signal.SIGINT, signal.SIG_IGN)
LAST = 100
assert relevo.refined(source).mesh().GetNumberOfCells() > 0
assert len(steps) == LAST, len(steps)
"""
        )

    def test_algorithms_before_it(self):
        """Ctrl-C stops an algorithm that another one depends on, and makes it run again."""
        self.check(
            MANY
            + SLOW_MESH
            + """
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
last = vtkTriangleFilter()
last.SetInputConnection(source.GetOutputPort())
try:
    relevo.refined(last)
except KeyboardInterrupt:
    pass
else:
    raise AssertionError("not interrupted")
assert 3 < len(steps) < LAST, len(steps)
signal.signal(signal.SIGINT, signal.SIG_IGN)
LAST = 100
last.Update()
assert len(steps) == LAST, len(steps)
"""
        )

    def test_handlers_of_the_program(self):
        """A handler that raises nothing does not stop work. Its exceptions are raised."""
        self.check(
            FEW
            + SLOW_MESH
            + """
seen = []
signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
relevo.refined(source)
assert len(steps) == LAST and seen == [signal.SIGINT], seen
def stop(number, frame):
    raise SystemExit(0)
signal.signal(signal.SIGINT, stop)
source.Modified()
relevo.refined(source)
raise AssertionError("not stopped")
"""
        )

    def test_ignored_signals(self):
        self.check(
            FEW
            + SLOW_MESH
            + """
signal.signal(signal.SIGINT, signal.SIG_IGN)
relevo.refined(source)
assert len(steps) == LAST
"""
        )

    def test_render(self):
        """Ctrl-C while a picture is drawn is raised after it, also from observers."""
        self.check(
            """
            import os, signal
            import relevo
            from DrawingData import make_sphere
            drawing = relevo.refined(make_sphere())
            drawing.mapper.AddObserver(
                "EndEvent", lambda caller, event: os.kill(os.getpid(), signal.SIGINT)
            )
            drawing.actor.GetProperty().AddObserver("ModifiedEvent", lambda caller, event: None)
            try:
                drawing.screenshot(size=(64, 64))
            except KeyboardInterrupt:
                pass
            else:
                raise AssertionError("not interrupted")
            drawing.mapper.RemoveAllObservers()
            assert drawing.screenshot(size=(64, 64)).std() > 1
            """
        )

    def test_tiles_of_terrains(self):
        """Ctrl-C stops the loading of tiles; VTK asks for it five times per second."""
        self.check(
            """
            import os, signal, threading
            import relevo
            from DrawingData import BOUNDS, make_heights
            terrain = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
            terrain.mapper.AddObserver(
                "StartEvent", lambda caller, event: os.kill(os.getpid(), signal.SIGINT)
            )
            try:
                terrain.screenshot(size=(64, 64))
            except KeyboardInterrupt:
                pass
            else:
                raise AssertionError("not interrupted")
            """
        )

    def test_other_threads(self):
        """A reader waits for data that another thread of Python writes."""
        pipe = self.folder / "points.txt"
        os.mkfifo(pipe)
        self.check(
            """
            import sys, threading
            from relevo import _inputs
            from vtkmodules.vtkIOLegacy import vtkSimplePointsReader
            def write():
                with open(sys.argv[1], "w") as file:
                    file.write("0 0 0 1 0 0 0 1 0")
            threading.Thread(target=write, daemon=True).start()
            reader = vtkSimplePointsReader()
            reader.SetFileName(sys.argv[1])
            data = _inputs.take_data(reader)[1]
            assert data.GetNumberOfPoints() == 3
            """,
            pipe,
        )

    def test_threads_while_heights_are_read(self):
        """The heights of a displacement come from a pipe that another thread of Python fills."""
        self.check(
            """
            import os, threading
            import relevo
            from DrawingData import make_sphere
            reading, writing = os.pipe()
            os.dup2(reading, 0)
            def write():
                with open(writing, "w") as file:
                    file.write("ncols 300\\nnrows 300\\nxllcorner 0\\nyllcorner 0\\ncellsize 1\\n")
                    for row in range(300):  # more than a pipe holds
                        file.write(" ".join(f"{column % 37}.25" for column in range(300)) + "\\n")
            threading.Thread(target=write, daemon=True).start()
            heights = relevo.vtkHeightMap()
            heights.SetFileName("/vsistdin/")
            relevo.refined(make_sphere(), height=heights)
            assert tuple(heights.GetDimensions()) == (300, 300)
            assert tuple(heights.GetRange()) == (0.25, 36.25)
            """
        )

    def test_heights(self):
        """Ctrl-C while heights are read is raised, and they are complete after the next update."""
        self.check(
            """
            import os, signal
            import relevo
            from DrawingData import make_heights, make_sphere
            from relevo._raster import RasterFile
            raster = RasterFile(make_heights())
            heights = relevo.vtkHeightMap()
            heights.SetFileName(raster.name)
            heights.AddObserver(
                "ProgressEvent", lambda caller, event: os.kill(os.getpid(), signal.SIGINT)
            )
            try:
                relevo.refined(make_sphere(), height=heights)
            except KeyboardInterrupt:
                pass
            else:
                raise AssertionError("not interrupted")
            heights.RemoveAllObservers()
            assert relevo.refined(make_sphere(), height=heights).mesh().GetNumberOfCells() > 0
            """
        )

    def test_threads_while_rendering(self):
        """A frame reads its data from a pipe that another thread of Python fills."""
        pipe = self.folder / "points.txt"
        os.mkfifo(pipe)
        self.check(
            """
            import sys, threading
            import relevo
            from DrawingData import make_sphere
            from vtkmodules.vtkIOLegacy import vtkSimplePointsReader
            from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
            def write():
                with open(sys.argv[1], "w") as file:
                    file.write("0 0 0 1 0 0 0 1 0")
            reader = vtkSimplePointsReader()
            reader.SetFileName(sys.argv[1])
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(reader.GetOutputPort())
            drawing = relevo.refined(make_sphere())
            points = vtkActor()
            points.SetMapper(mapper)
            make_renderer = drawing._make_renderer
            def make_with_points(size, camera):
                renderer = make_renderer(size, camera)
                renderer.AddActor(points)
                return renderer
            drawing._make_renderer = make_with_points
            threading.Thread(target=write, daemon=True).start()
            drawing.screenshot(size=(64, 64))
            assert mapper.GetInput().GetNumberOfPoints() == 3
            """,
            pipe,
        )

    def test_work_in_other_threads(self):
        """Drawings of other threads work, and Ctrl-C is raised in the main thread."""
        self.check(
            """
            import os, signal, threading
            import relevo
            from DrawingData import make_sphere
            cells = []
            def work():
                cells.append(relevo.refined(make_sphere()).mesh().GetNumberOfCells())
                os.kill(os.getpid(), signal.SIGINT)
            thread = threading.Thread(target=work)
            try:
                thread.start()
                thread.join()
                threading.Event().wait(200)
            except KeyboardInterrupt:
                pass
            assert cells[0] > 0
            """
        )

    def test_windows(self):
        """Ctrl-C closes a window of show(), while other threads run."""
        if not os.environ.get("DISPLAY"):
            self.skipTest("no display")
        self.check(
            """
            import os, signal, threading
            import relevo
            from DrawingData import make_sphere
            drawing = relevo.refined(make_sphere())
            frames = threading.Event()
            drawing.mapper.AddObserver("EndEvent", lambda caller, event: frames.set())
            def stop():
                frames.wait()
                os.kill(os.getpid(), signal.SIGINT)
            threading.Thread(target=stop).start()
            try:
                drawing.show(size=(64, 64))
            except KeyboardInterrupt:
                pass
            else:
                raise AssertionError("not interrupted")
            """
        )


if __name__ == "__main__":
    unittest.main(argv=["TestInterrupts"])
