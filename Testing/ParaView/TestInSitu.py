# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: in a simulation, a Catalyst script draws each step like pvbatch draws the same
data. The simulations are ParaView's, and a program that uses ParaView's implementation of Catalyst
2:

pvbatch --sym TestInSitu.py SCRIPT"""

import math
import os
import pathlib
import re
import runpy
import sys

from paraview import simple

import RelevoParaView as relevo

SCRIPT = str(pathlib.Path(__file__).parents[2] / "Examples" / "ParaView" / "catalyst.py")
STEPS = 2
EXTENT = (-8, 8) * 3


def maximum(step):
    """The formula of ParaView's simulation."""
    return 255 + 200 * math.sin(step)


def simulate(script):
    """Runs a Catalyst script like the library of ParaView for Catalyst 2 does."""
    import paraview

    paraview.options.batch = True
    paraview.options.symmetric = True
    from mpi4py.MPI import COMM_WORLD
    from paraview.modules.vtkPVInSitu import vtkInSituInitializationHelper as Catalyst
    from paraview.servermanager import ProxyManager
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

    try:
        Catalyst.Initialize(COMM_WORLD.py2f(), [])
    except TypeError:  # before ParaView 6
        Catalyst.Initialize(COMM_WORLD.py2f())
    pipelines = [["script"]]
    try:
        Catalyst.AddPipeline("script", script)
    except TypeError:  # before ParaView 5.13
        Catalyst.AddPipeline(script)
        pipelines = []
    producer = ProxyManager().NewProxy("sources", "PVTrivialProducer")
    producer.UpdateVTKObjects()
    Catalyst.SetProducer("input", producer)
    for step in range(STEPS):
        source = vtkRTAnalyticSource()
        source.SetWholeExtent(*EXTENT)
        source.SetMaximum(maximum(step))
        source.UpdatePiece(COMM_WORLD.rank, COMM_WORLD.size, 0)
        producer.GetClientSideObject().SetOutput(source.GetOutput(), step)
        producer.GetClientSideObject().SetWholeExtent(*EXTENT)
        Catalyst.MarkProducerModified("input")
        if not Catalyst.ExecutePipelines(step, step, *pipelines):
            sys.exit("the script failed")
    Catalyst.Finalize()


class TestInSitu(relevo.TestCase):
    @classmethod
    def setUpClass(cls):
        """Draws the steps in this process, from the test source that the script has without a
        simulation."""
        names = runpy.run_path(SCRIPT)
        view, source = names["view"], names["data"]
        source.WholeExtent = EXTENT
        view.ViewSize = names["png"].Writer.ImageResolution
        position = list(view.CameraPosition)
        simple.Render(view)  # ParaView moves the camera in the first frame of a session
        view.CameraPosition = position
        view.CameraFocalPoint = [0, 0, 0]
        cls.expected = []
        for step in range(STEPS):
            source.Maximum = maximum(step)
            cls.expected.append(relevo.picture(view))
        names["volume"].Visibility = 0
        cls.without_volume = relevo.picture(view)
        names["volume"].Visibility = 1
        names["refined"].Visibility = 0
        cls.without_surface = relevo.picture(view)
        relevo.clear()

    def setUp(self):
        self.folder = self.make_folder()

    def assert_steps(self, pixels, ranks, *arguments):
        """Runs a simulation and compares the pictures of its steps. Besides the announcement of
        ParaView's simulations it prints neither errors nor warnings of the plugin."""
        command = ["mpirun", "--oversubscribe", "-n", str(ranks), "pvbatch", "--sym", *arguments]
        output = relevo.run(command, cwd=self.folder)
        self.assertNotRegex(output, r"(ERR|WARN)\|.*(Relevo|Adaptive)")
        pictures = sorted(pathlib.Path(self.folder).glob("step_*.png"))
        self.assertEqual([each.name for each in pictures], ["step_000000.png", "step_000001.png"])
        for path, expected in zip(pictures, self.expected):
            different = relevo.differing(relevo.read_png(str(path)), expected)
            self.assertLessEqual(different, pixels, path.name)

    def test_expected_pictures(self):
        """Both steps differ, and both representations are visible."""
        for other in self.expected[0], self.without_volume, self.without_surface:
            self.assertGreater(relevo.differing(self.expected[1], other), 20000)

    def test_simulation(self):
        """ParaView's example of a simulation in Python."""
        size = str(EXTENT[1] - EXTENT[0] + 1)
        simulation = ["-m", "paraview.demos.wavelet_miniapp", "--size", size]
        self.assert_steps(0, 1, *simulation, "--timesteps", str(STEPS), "--script", SCRIPT)

    def test_replay(self):
        """ParaView's program that replays files to a Catalyst script, on three ranks."""
        source = simple.Wavelet(WholeExtent=EXTENT)
        for step in range(STEPS):
            source.Maximum = maximum(step)
            simple.SaveData(os.path.join(self.folder, f"data_{step}.vti"), source)
        replay = ["-m", "paraview.demos.filedriver_miniapp", "--glob", "data_*.vti"]
        self.assert_steps(60, 3, *replay, "--script", SCRIPT)

    def test_catalyst_2(self):
        """A simulation on two ranks."""
        self.assert_steps(60, 2, os.path.abspath(__file__), SCRIPT)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        simulate(sys.argv[1])
    else:
        relevo.main()
