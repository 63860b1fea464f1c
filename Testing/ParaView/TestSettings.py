# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that settings of the plugin take effect at once, and that undo, redo and traces restore
the picture."""

import os

from paraview import simple, smtrace

import RelevoParaView as relevo
from RelevoParaView import Undo, sphere, traced


class TestSettings(relevo.TestCase):
    def setUp(self):
        self.heights = os.path.join(self.make_folder(), "heights.png")
        relevo.write_heights(self.heights)

    def displace(self, shown):
        shown.Displacement = "Height Map"
        shown.Displacement.HeightMapFileName = self.heights
        shown.Displacement.Scale = 0.02

    def changes(self, shown):
        """Some settings of each kind: values, choices, and values of chosen proxies."""

        def sets(name, value, of=None):
            return lambda: setattr(getattr(shown, of) if of else shown, name, value)

        return {
            "MaximumLevel": sets("MaximumLevel", 2),
            "Surface": sets("Surface", "Phong Tessellation"),
            "Alpha": sets("Alpha", 0.3, "Surface"),
            "RefinementColorMode": sets("RefinementColorMode", "Level"),
            "Metric": sets("Metric", "Distance to the Camera"),
            "MaximumDistance": sets("MaximumDistance", 9.0, "Metric"),
            "Displacement": lambda: self.displace(shown),
            "Offset": sets("Offset", 0.1, "Displacement"),
            "Representation": sets("Representation", "Adaptive Refinement With Edges"),
        }

    def scene(self):
        view = relevo.view()
        source = simple.TextureMaptoSphere(Input=sphere())
        shown = relevo.show(source, view, MaximumLevel=3, Metric="None")
        relevo.picture(view)
        simple.ResetCamera(view)
        return view, shown

    def test_nothing_is_uploaded_again(self):
        """Live settings."""
        view, shown = self.scene()
        self.displace(shown)
        shown.Surface = "Phong Tessellation"
        shown.Metric = "Edge Length on Screen"
        pictures = [relevo.picture(view)]
        builds = relevo.statistic(view, "NumberOfBufferBuilds")
        for proxy, name, value in (
            (shown.Displacement, "Scale", 0.01),
            (shown.Displacement, "Offset", 0.1),
            (shown.Displacement, "FixedDirection", [0, 1, 1]),
            (shown.Surface, "Alpha", 0.3),
            (shown.Metric, "ReferenceLength", 12),
            (shown, "LevelOffset", -1),
            (shown, "MaximumLevel", 1),
        ):
            setattr(proxy, name, value)
            pictures.append(relevo.picture(view))
            self.assertEqual(relevo.statistic(view, "NumberOfBufferBuilds"), builds, name)
            if name != "FixedDirection":  # while displacement follows the normals
                self.assertGreater(relevo.differing(*pictures[-2:], 0), 20, name)

    def test_undo(self):
        undo = Undo()
        self.addCleanup(undo.end)
        view, shown = self.scene()
        pictures = [relevo.picture(view)]
        changes = self.changes(shown)
        for name, change in changes.items():
            undo.record(name, change)
            pictures.append(relevo.picture(view))
            self.assertGreater(relevo.differing(*pictures[-2:], 0), 20, name)
        for name, expected in reversed(list(zip(changes, pictures))):
            undo.step(undo.stack.Undo)
            self.assertEqual(relevo.differing(relevo.picture(view), expected, 0), 0, name)
        for name, expected in zip(changes, pictures[1:]):
            undo.step(undo.stack.Redo)
            self.assertEqual(relevo.differing(relevo.picture(view), expected, 0), 0, name)

    def test_trace(self):
        smtrace.start_trace()
        view, shown = self.scene()
        with traced(shown):
            shown.Representation = "Adaptive Refinement"
            shown.MaximumLevel = 3
            shown.Metric = "None"
        for change in self.changes(shown).values():
            with traced(shown):
                change()
        relevo.picture(view)
        script = smtrace.stop_trace()
        expected = relevo.picture(view)
        relevo.clear()
        exec(script, {"__name__": "trace"})
        view = simple.GetActiveView()
        view.ViewSize = expected.shape[1::-1]
        view.OrientationAxesVisibility = 0
        self.assertEqual(relevo.differing(relevo.picture(view), expected, 0), 0)


if __name__ == "__main__":
    relevo.main()
