# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves studio.md on saved programs, two views, the histogram and the pattern generator."""

import subprocess
import sys
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from StudioProgram import StudioProgram
from ViewerPictures import read_colours
from ViewerScenes import write_sphere

WIDTH = 560  # of the window
FONT_SIZE = 13


def similarity(a, b):
    """The mean structural similarity of greys in windows of 7 x 7, after Wang et al. 2004."""
    grey = [(p @ (0.299, 0.587, 0.114)) / 255.0 for p in (a, b)]
    windows = [numpy.lib.stride_tricks.sliding_window_view(g, (7, 7)) for g in grey]
    means = [w.mean(axis=(2, 3)) for w in windows]
    variances = [w.var(axis=(2, 3)) for w in windows]
    both = (windows[0] * windows[1]).mean(axis=(2, 3)) - means[0] * means[1]
    index = (2 * means[0] * means[1] + 1e-4) * (2 * both + 9e-4)
    index /= (means[0] ** 2 + means[1] ** 2 + 1e-4) * (variances[0] + variances[1] + 9e-4)
    return index.mean()


class TestStudioPanels(StudioProgram):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        write_sphere(cls.folder)

    def test_programs(self):
        """Saved programs draw the whole window, as the saved picture does."""
        _, errors = self.studio(
            "sphere.vtp",
            "set array Latitude",
            "set max-level 3",
            "set range -30,30",
            "set below navy",
            "set above #ff8000",
            "set compare-method suapt",
            "set session-name s.json",
            "click save-session",
            "save scene.py",
            "save source/",
            "set compare-method default",
            "save a.png",
            "set axes on",
            "set extremes on",
            "set scale-bar on",
            "set ruler 0,0,1,1,0,0",
            "save marks.py",
            "save marks.png",
        )
        self.assertEqual(errors, "")
        for name, picture in (("scene", "a"), ("marks", "marks")):
            run = subprocess.run(
                [sys.executable, name + ".py", "c.png"], cwd=self.folder, capture_output=True
            )
            self.assertEqual((run.returncode, run.stderr), (0, b""))
            self.assertEqual(
                (self.folder / "c.png").read_bytes(), (self.folder / f"{picture}.png").read_bytes()
            )
        expected = (self.folder / "a.png").read_bytes()
        self.view("--session=s.json", "--output=b.png")
        self.assertEqual((self.folder / "b.png").read_bytes(), expected)
        self.assertIn("SetMaximumLevel(3)", (self.folder / "source/source.cxx").read_text())
        self.assertTrue((self.folder / "source/CMakeLists.txt").exists())

    def test_comparison(self):
        layouts, errors = self.studio(
            "sphere.vtp",
            "set metric silhouette",
            "set wireframe on",
            "set no-legend on",
            "set compare-method arkfpi",
            "save same.png",
            "set compare-method suapt",
            "set show-difference on",
            "set difference-gain 2",
            "save views.png",
            "set difference-gain 7.5",
            "save stronger.png",
            "set compare-options max-level=1;light=20,30",
            "drag 40 200 60 210",
            "set compare-options max-level=9",
            "set view 90,10",
            "set array Latitude",
            "set compare-options default",
            "set compare-method default",
            "save alone.png",
            code=1,
        )
        self.assertIn("--max-level needs a whole number from 0 to 7", errors)
        self.assertEqual(errors.count("\n"), 2)
        same = read_colours(self.folder / "same.png")
        half = WIDTH // 2
        different = (same[:, :half] != same[:, half:]).any(axis=2)
        self.assertLess(different.mean(), 0.01)  # lines depend on the place in the window
        first = next(e for e in layouts if "figure-ssim" in e)
        self.assertEqual(first["figure-ssim"]["value"], 1)
        self.assertEqual(first["figure-different-pixels"]["value"], 0)
        views = read_colours(self.folder / "views.png")
        third = WIDTH // 3
        a, b, shown = (views[:, i * third : (i + 1) * third] for i in range(3))
        # The third view is the difference of the others, except for its place in the window.
        wrong = (shown != 255 - numpy.minimum(2 * abs(a - b), 255)).any(axis=2)
        self.assertLess(wrong.mean(), 0.02)
        self.assertGreater((a != b).any(axis=2).mean(), 0.02)
        # The gain is the factor of the differences, up to black. The views do not change.
        stronger = read_colours(self.folder / "stronger.png")
        self.assertTrue((stronger[:, : 2 * third] == views[:, : 2 * third]).all())
        shown = stronger[:, 2 * third : 3 * third]
        expected = 255 - numpy.minimum(numpy.floor(7.5 * abs(a - b) + 0.5), 255)
        self.assertLess((shown != expected).any(axis=2).mean(), 0.02)
        self.assertLess(shown.mean(), views[:, 2 * third : 3 * third].mean() - 1)
        # The figures are those of the views beside the panel.
        step = next(e for e in layouts if e["difference-gain"]["value"] == "2")
        self.assertLess(step["figure-ssim"]["value"], 0.999)
        self.assertGreater(step["figure-ssim"]["value"], 0.3)
        self.assertGreater(
            step["figure-second-triangles"]["value"], step["figure-triangles"]["value"]
        )
        options = [e for e in layouts if e["compare-options"]["value"].startswith("max")]
        self.assertLess(
            options[0]["figure-second-triangles"]["value"],
            options[0]["figure-triangles"]["value"],
        )
        self.assertFalse(layouts[0]["show-difference"]["enabled"])
        self.assertNotIn("figure-ssim", layouts[-1])
        self.assert_picture(
            "alone.png",
            *("sphere.vtp", "--metric=silhouette", "--wireframe", "--no-legend", "--view=90,10"),
            "--array=Latitude",
        )

    def test_values_beside(self):
        """Values, clicks and rulers are those of the first view. The second one has none."""
        width = (WIDTH - 25 * FONT_SIZE) // 2
        first, second = (f"{place} 210" for place in (width // 2, width + width // 2))
        layouts, errors = self.studio(
            "sphere.vtp",
            "set compare-method suapt",
            f"drag {second} {second}",
            "key d",
            "click measure",
            f"drag {second} {second}",
            f"drag {first} {first}",
            f"drag {second} {second}",
            f"drag {first.replace('210', '190')} {first.replace('210', '190')}",
            "drag 75 205 75 205",  # beside the ruler, whose lines have no values
            "set compare-method default",
            "drag 140 210 140 210",
        )
        self.assertEqual(errors, "")
        measured = next(i for i, layout in enumerate(layouts) if layout["ruler"]["value"])
        ends = [float(x) for x in layouts[measured]["ruler"]["value"].split(",")]
        self.assertGreater(abs(ends[1] - ends[4]), 0.01)  # both are in the first view
        self.assertLess(abs(ends[0] - ends[3]), 0.2 * abs(ends[1] - ends[4]) + 0.05)
        kept = next(i for i, layout in enumerate(layouts) if "probe" in layout)
        self.assertGreater(kept, measured)
        # Without the second view, its place is one of the first.
        self.assertNotEqual(layouts[-1]["probe"]["value"], layouts[kept]["probe"]["value"])

    def test_similarity(self):
        """The index is that of a picture of both views without a panel."""
        layouts, errors = self.studio(
            "sphere.vtp",
            "set compare-options wireframe;max-level=2",
            "set panels-in-pictures on",
            "save views.png",
        )
        self.assertEqual(errors, "")
        views = read_colours(self.folder / "views.png")
        width = (WIDTH - 25 * FONT_SIZE) // 2
        a, b = views[:, :width], views[:, width : 2 * width]
        self.assertAlmostEqual(layouts[-1]["figure-ssim"]["value"], similarity(a, b), delta=2e-3)

    def test_histogram(self):
        layouts, errors = self.studio(
            "sphere.vtp",
            "set metric silhouette",
            "set max-level 4",
            "click group Levels and patterns",
            "click group Levels and patterns",
        )
        self.assertEqual(errors, "")
        group = "group Levels and patterns"
        opened = next(e for e in layouts if e[group]["value"] == "on")
        levels = {k: e["value"] for k, e in opened.items() if k.startswith("figure-level-")}
        faces = {k: e["value"] for k, e in opened.items() if k.startswith("figure-faces-")}
        self.assertGreater(len(levels), 1)
        self.assertEqual(sum(levels.values()), opened["figure-triangles"]["value"])
        drawn = opened["figure-coarse-faces"]["value"] - opened["figure-culled-faces"]["value"]
        self.assertEqual(sum(faces.values()), drawn)
        self.assertLessEqual(len(faces), opened["figure-patterns"]["value"])
        # The layout has the same figures while the group is closed.
        self.assertEqual(layouts[-1][group]["value"], "off")
        for name, value in {**levels, **faces}.items():
            self.assertEqual(layouts[-1][name]["value"], value, name)

    def test_patterns(self):
        layouts, errors = self.studio(
            "sphere.vtp",
            "click group Pattern generator",
            "set pattern-levels 1,2,0",
            "set pattern-name p.vtp",
            "click save-pattern",
            "set pattern-name p.obj",
            "click save-pattern",
            "set table-name all.vtp",
            "click save-table",
            "set pattern-levels.0 7",
            "set pattern-levels 1,2",
            "set pattern-levels 1,2,8",
            "set pattern-name p.txt",
            "click save-pattern",
            code=1,
        )
        lines = errors.splitlines()
        self.assertEqual(len(lines), 4, errors)
        for line in lines[:2]:
            self.assertIn("pattern-levels needs three whole numbers from 0 to 7", line)
        self.assertIn("cannot save the pattern as p.txt", lines[2])
        chosen = next(e for e in layouts if e["pattern-levels"]["value"] == "1,2,0")
        self.assertEqual(chosen["figure-pattern-lambda"]["value"], 1)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "p.vtp"))
        reader.Update()
        mesh = reader.GetOutput()
        self.assertEqual(mesh.GetNumberOfPolys(), chosen["figure-pattern-triangles"]["value"])
        points = numpy.array([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])
        smallest = 180.0
        area = 0.0
        for i in range(mesh.GetNumberOfPolys()):
            corners = mesh.GetCell(i).GetPointIds()
            p = points[[corners.GetId(k) for k in range(3)]]
            area += numpy.cross(p[1] - p[0], p[2] - p[0])[2] / 2
            for k in range(3):
                u, v = p[k - 1] - p[k], p[k - 2] - p[k]
                cosine = u @ v / numpy.linalg.norm(u) / numpy.linalg.norm(v)
                smallest = min(smallest, numpy.degrees(numpy.arccos(cosine)))
        self.assertAlmostEqual(smallest, chosen["figure-pattern-angle"]["value"], places=3)
        self.assertAlmostEqual(area, numpy.sqrt(3) / 4, places=5)
        # The first edge, at the bottom, has 2 segments, and the second has 4.
        self.assertEqual(int((abs(points[:, 1]) < 1e-6).sum()), 3)
        right = abs(points[:, 1] - numpy.sqrt(3) * (1 - points[:, 0])) < 1e-5
        self.assertEqual(int(right.sum()), 5)
        self.assertTrue((self.folder / "p.obj").read_text().count("\nf ") > 1)
        reader.SetFileName(str(self.folder / "all.vtp"))
        reader.Update()
        levels = reader.GetOutput().GetFieldData().GetArray("MaximumLevel")
        self.assertEqual(levels.GetValue(0), 2)
        self.assertEqual(layouts[-1]["pattern-levels"]["value"], "7,2,0")


if __name__ == "__main__":
    unittest.main(argv=["TestStudioPanels"])
