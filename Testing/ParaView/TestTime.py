# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that Adaptive Refinement follows data that change with time, animations with cached
geometry, and several views of a source."""

import os
import tempfile

from paraview import simple

import RelevoParaView as relevo
from RelevoParaView import sphere

TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetExecutive().GetOutputInformation(0)
information.Set(Pipeline.TIME_STEPS(), [0.0, 1.0, 2.0], 3)
information.Set(Pipeline.TIME_RANGE(), [0.0, 2.0], 2)
"""
TIME = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
information = self.GetExecutive().GetOutputInformation(0)
time = 0
if information.Has(Pipeline.UPDATE_TIME_STEP()):
    time = int(information.Get(Pipeline.UPDATE_TIME_STEP()))
def sphere(radius, x=0):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(x, 0, 0)
    source.SetThetaResolution(8 + time)
    source.Update()
    return source.GetOutput()
"""
SHRINKING = TIME + "output.ShallowCopy(sphere(3 - time))"
# One sphere, two spheres, and a single box.
BLOCKS = (
    TIME
    + """
output.SetNumberOfBlocks(2)
if time < 2:
    output.SetBlock(0, sphere(1))
if time == 1:
    output.SetBlock(1, sphere(0.5, 2))
if time == 2:
    box = vtkRTAnalyticSource()
    box.SetWholeExtent(0, 2, 0, 2, 0, 2)
    box.Update()
    output.SetBlock(0, box.GetOutput())
"""
)


def series(script, data_set):
    return simple.ProgrammableSource(
        Script=script, ScriptRequestInformation=TIMES, OutputDataSetType=data_set
    )


class TestTime(relevo.TestCase):
    def pair(self, source):
        """Views of Adaptive Refinement and of Surface."""
        views = relevo.view(), relevo.view()
        relevo.show(source, views[0], MaximumLevel=0, Metric="None")
        relevo.show(source, views[1], "Surface")
        return views

    def assert_alike(self, views):
        relevo.picture(views[1])
        simple.ResetCamera(views[1])
        relevo.copy_camera(views[1], views[0])
        self.assert_same_picture(*views)

    def test_blocks_that_change(self):
        """Blocks change in number, kind and shape."""
        views = self.pair(series(BLOCKS, "vtkMultiblockDataSet"))
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        for time in 0, 1, 2, 0:
            with self.subTest(time):
                scene.AnimationTime = time
                self.assert_alike(views)

    def test_data_set_that_changes(self):
        source = series(SHRINKING, "vtkPolyData")
        views = self.pair(source)
        self.assert_alike(views)
        source.OutputDataSetType = "vtkMultiblockDataSet"
        source.Script = BLOCKS
        self.assert_alike(views)
        source.OutputDataSetType = "vtkPolyData"
        source.Script = SHRINKING
        self.assert_alike(views)

    def test_cached_geometry(self):
        """A second playback gives the same pictures from the cache, with the bounds of their time.
        """
        source = series(SHRINKING, "vtkPolyData")
        view = relevo.view()
        relevo.show(source, view, MaximumLevel=0, Metric="None")
        simple.GetSettingsProxy("GeneralSettings").CacheGeometryForAnimation = 1
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        scene.PlayMode = "Snap To TimeSteps"
        relevo.picture(view)  # ParaView moves the camera in the first frame of a session
        view.CameraPosition = [0, 0, 12]
        view.CameraFocalPoint = [0, 0, 0]
        pictures = []
        scene.GetClientSideObject().AddObserver(
            "AnimationCueTickEvent", lambda *_: pictures.append(relevo.picture(view))
        )
        data = source.GetClientSideObject().GetOutputDataObject(0)
        scene.Play()
        last_execution = data.GetMTime()
        scene.Play()
        self.assertEqual(data.GetMTime(), last_execution)
        self.assertEqual(len(pictures), 6)
        self.assertGreater(relevo.differing(*pictures[:2]), 1000)
        for first, second in zip(pictures[:3], pictures[3:]):
            self.assertEqual(relevo.differing(first, second, 0), 0)


class TestViews(relevo.TestCase):
    def test_second_view(self):
        """Each view of a source has a separate recipe."""
        source = sphere()
        views = relevo.view(), relevo.view(), relevo.view()
        for view, surface in zip(views, ("None", "PN Triangles", "PN Triangles")):
            relevo.show(source, view, Metric="None", Surface=surface)
        simple.ResetCamera(views[0])
        relevo.copy_camera(views[0], views[1])
        relevo.copy_camera(views[0], views[2])
        self.assert_same_picture(views[1], views[2])
        self.assertGreater(relevo.differing(*map(relevo.picture, views[:2])), 100)

    def test_interaction(self):
        """Interactive frames are not decimated like Surface; if they take too long, levels are
        reduced."""
        source = simple.Sphere(ThetaResolution=60, PhiResolution=40)
        decimated = {}
        for representation in "Surface", "Adaptive Refinement":
            view = relevo.view()
            view.LODThreshold = 0
            view.LODResolution = 0
            shown = relevo.show(source, view, representation)
            if representation == "Adaptive Refinement":
                relevo.set_properties(shown, {"MaximumLevel": 0, "Metric": "None"})
            relevo.picture(view)
            simple.ResetCamera(view)
            still = relevo.picture(view)
            view.InteractiveRender()
            decimated[representation] = relevo.differing(relevo.drawn(view), still, 0)
        self.assertGreater(decimated["Surface"], 100)
        self.assertEqual(decimated["Adaptive Refinement"], 0)
        shown.MaximumLevel = 5
        triangles = []
        # Two frames, because the first one measures the time; then one, and two.
        for render in relevo.picture, lambda each: each.InteractiveRender(), relevo.picture:
            render(view)
            triangles.append(relevo.statistic(view, "NumberOfDrawnTriangles"))
        self.assertLess(triangles[1], triangles[0] / 4)
        self.assertEqual(triangles[2], triangles[0])

    def test_large_screenshot(self):
        """A picture larger than the window is drawn in tiles, with the levels of a window of that
        size."""
        size = [900, 600]
        pictures = []
        for view in relevo.view(), relevo.view(size):
            shown = relevo.show(sphere(), view, MaximumLevel=5, Surface="PN Triangles")
            shown.RefinementColorMode = "Level"
            relevo.picture(view)  # ParaView moves the camera in the first frame of a session
            view.CameraPosition = [0, 0, 2.5]
            view.CameraFocalPoint = [0, 0, 0]
            relevo.picture(view)
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "large.png")
                simple.SaveScreenshot(path, view, ImageResolution=size)
                pictures.append(relevo.read_png(path))
        self.assertEqual(pictures[0].shape, (600, 900, 3))
        self.assertGreater(relevo.foreground(pictures[0]), 100000)
        self.assertLess(relevo.differing(*pictures), 60)


if __name__ == "__main__":
    relevo.main()
