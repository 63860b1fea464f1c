# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that drawings survive what the program around them does: data that change while they are
drawn, forks, the end of the interpreter, and modules that are imported twice."""

import os
import pathlib
import subprocess
import sys
import textwrap
import unittest

import DrawingData  # noqa: F401, skips without numpy, EGL and GDAL

# Each program begins like this.
START = """
import os, sys, threading
import numpy
import relevo
from DrawingData import BOUNDS, make_heights, make_sphere
from vtkmodules.util.numpy_support import vtk_to_numpy
"""


class TestDrawingProcesses(unittest.TestCase):
    def check(self, program, **variables):
        result = subprocess.run(
            # Python 3.12 and later warn of fork() in processes with threads.
            [sys.executable, "-W", "ignore:This process:DeprecationWarning", "-c", START + textwrap.dedent(program)],
            cwd=pathlib.Path(__file__).parent,
            env={**os.environ, **variables},
            capture_output=True,
            text=True,
            timeout=300,
        )
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)

    def test_mesh_changed_while_drawn(self):
        """Another thread moves and replaces points while pictures are drawn, and later pictures are
        those of the last points."""
        self.check(
            """
            mesh = make_sphere()
            sphere = vtk_to_numpy(mesh.GetPoints().GetData())
            first = sphere.copy()
            drawing = relevo.refined(mesh, surface="linear", max_level=1)
            before = drawing.screenshot(size=(64, 64))
            ended, moved = threading.Event(), threading.Event()
            def move():
                factor = 1.0
                while not ended.is_set():
                    factor = 2.5 - factor
                    sphere[:] = first * numpy.float32(factor)
                    mesh.Modified()
                    moved.set()
            thread = threading.Thread(target=move)
            thread.start()
            moved.wait()
            for _ in range(10):
                drawing.screenshot(size=(64, 64))
                drawing.mesh()
            ended.set()
            thread.join()
            sphere[:] = first
            drawing.mapper.GetInput().GetPoints().Modified()
            numpy.testing.assert_array_equal(drawing.screenshot(size=(64, 64)), before)
            """
        )

    def test_fork(self):
        """A child works before anything was drawn. Later it computes, and drawing is an error."""
        self.check(
            """
            def fork(work):
                sys.stdout.flush()
                child = os.fork()
                if child == 0:
                    try:
                        work()
                    except BaseException as error:
                        print(error)
                        os._exit(1)
                    os._exit(0)
                return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            drawing = relevo.refined(make_sphere(), metric="curvature", max_level=2)
            def draw():
                assert drawing.screenshot(size=(64, 64)).std() > 1
            assert fork(draw) == 0
            draw()
            terrain = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
            terrain.screenshot(size=(64, 64))
            cells = drawing.mesh().GetNumberOfCells()
            height = terrain.elevation(86.9, 28.0)
            def compute():
                assert relevo.refined(make_sphere(), metric="curvature", max_level=2)
                assert drawing.mesh().GetNumberOfCells() == cells
                assert terrain.elevation(86.9, 28.0) == height
                try:
                    draw()
                except relevo.Error as error:
                    assert "forked" in str(error) and "spawn" in str(error), error
                else:
                    raise AssertionError("no error")
            assert fork(compute) == 0
            """
        )

    def test_end_with_windows(self):
        """The interpreter ends while windows are open and tiles are loaded."""
        if not os.environ.get("DISPLAY"):
            self.skipTest("no display")
        self.check(
            """
            mesh = relevo.refined(make_sphere())._open((64, 64))
            terrain = relevo.terrain(make_heights(), bounds=BOUNDS, crs="EPSG:4326")
            window = terrain._open((64, 64))
            """
        )

    def test_two_pyvistas(self):
        """Meshes of a module that was imported again are drawn; results are of the last module."""
        self.check(
            """
            sys.path.insert(0, "StandIn")
            import pyvista as first
            mesh = first.wrap(make_sphere())
            drawing = relevo.refined(mesh)
            assert type(drawing.mesh()) is first.PolyData
            del sys.modules["pyvista"]
            second = type(drawing.mesh())  # imports it again
            assert second is sys.modules["pyvista"].PolyData and second is not first.PolyData
            assert drawing.screenshot(size=(64, 64)).std() > 1
            """
        )


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingProcesses"])
