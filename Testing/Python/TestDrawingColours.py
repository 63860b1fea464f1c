# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves python.md on colours of arrays and cuts: scalars, clip, palette, range, log, below and above,
with the pictures of relevo-view."""

import os
import pathlib
import tempfile
import unittest
import warnings

from DrawingData import make_curved_block, make_sphere, numpy, read_picture, relevo
from ForkedProgram import ForkedProgram
from ResultData import TIMES, add_array, write_series
from relevo import _legend
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

SIZE = (300, 240)
VIEWER = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin/relevo-view"
CLIP = ((4.001, 4, 4), (-1, 0, 0))


def make_block():
    """9 x 9 x 9 points with "Damage", 10^(x / 2 - 2), and the vectors "Flow"."""
    image = vtkImageData()
    image.SetDimensions(9, 9, 9)
    points = [image.GetPoint(i) for i in range(image.GetNumberOfPoints())]
    add_array(image.GetPointData(), "Damage", [(10 ** (x / 2 - 2),) for x, y, z in points])
    add_array(image.GetPointData(), "Flow", [(x - 4, y, z) for x, y, z in points])
    return image


class TestDrawingColours(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        writer = vtkXMLImageDataWriter()
        self.path = self.folder / "block.vti"
        writer.SetFileName(str(self.path))
        writer.SetInputData(make_block())
        writer.Write()

    def test_pictures_of_relevo_view(self):
        """The options have the pictures of the same options of relevo-view."""
        if not VIEWER.exists():
            self.skipTest("relevo-view was not built")
        program = ForkedProgram(VIEWER)
        self.addCleanup(program.close)
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        out_of_range = {"range": (0.1, 10), "below": "white", "above": "#ff00ff"}
        shared = ["--range=0.1,10", "--below=white", "--above=#ff00ff"]
        clip = "--clip=4.001,4,4,-1,0,0"
        for make, name, options, arguments in (
            (relevo.refined, "scalars", {"log": True, **out_of_range}, ["--log", *shared]),
            (relevo.refined, "scalars", {"clip": CLIP, "log": True}, [clip, "--log"]),
            (relevo.refined, "scalars", {"clip": CLIP, "palette": "heat"}, [clip, "--palette=heat"]),
            (relevo.patches, "scalars", {"clip": CLIP, **out_of_range}, ["--surface=patch", clip, *shared]),
            (relevo.volume, "array", {"log": True, **out_of_range}, ["--log", *shared]),
            (relevo.volume, "array", {"clip": CLIP, "palette": "cyclic"}, [clip, "--palette=cyclic"]),
        ):
            with self.subTest(make.__name__, **options):
                # An image has flat faces; relevo.patches() takes them as patches.
                if make is relevo.patches:
                    continue
                own = make(self.path, **{name: "Damage"}, **options).screenshot(size=SIZE)
                array = "--volume=Damage" if make is relevo.volume else "--array=Damage"
                size = f"--size={SIZE[0]}x{SIZE[1]}"
                run = program.run(
                    ["block.vti", array, *arguments, size, "--output=v.png"], self.folder, environment
                )
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                difference = abs(own.astype(int) - read_picture(self.folder / "v.png"))
                self.assertLess((difference.max(axis=2) > 8).mean(), 0.002)

    def test_out_of_range(self):
        """Values below and above have their colours, on surfaces, in cuts and on the legend."""
        for make, options in ((relevo.refined, {}), (relevo.refined, {"clip": CLIP}), (relevo.patches, {})):
            own = {"range": (0.1, 10), "below": (1, 1, 1), "above": "#ff0000", "lighting": False}
            drawing = make(self.path, scalars="Damage", **own, **options)
            picture = drawing.screenshot(size=SIZE, camera=(180, 0)).reshape(-1, 3)
            is_red = (picture == (255, 0, 0)).all(axis=1)
            is_white = (picture == (255, 255, 255)).all(axis=1)
            self.assertGreater(is_white.sum(), 1000)
            if not options:
                self.assertGreater(is_red.sum(), 1000)
        table = relevo.volume(self.path, "Damage", range=(0.1, 10), above="red")._table
        self.assertEqual(table.GetColor(10.01), (1, 0, 0))
        self.assertEqual(table.GetColor(0.01), table.GetColor(0.1))

    def test_log(self):
        """Each decade has the same share of the colours, and labels are powers of ten."""
        for make, name in ((relevo.refined, "scalars"), (relevo.volume, "array")):
            table = make(self.path, **{name: "Damage"}, log=True, palette="grey")._table
            for i in range(5):
                colour = [0.0] * 3
                table.GetColor(10.0 ** (i - 2), colour)
                numpy.testing.assert_allclose(colour, [0.1 + 0.22 * i] * 3, atol=2e-3)
            rows = _legend._make_rows(table, 200)
            self.assertEqual([text for _, text in rows], ["0.01", "0.1", "1", "10", "100"])
            numpy.testing.assert_allclose([place for place, _ in rows], [0, 0.25, 0.5, 0.75, 1])
        low = _legend._list_log_labels(0.03, 5e7, 5)
        self.assertEqual(low, [0.03, 10.0, 1e4, 5e7])

    def test_ranges(self):
        """A range is kept, and "all" is that of all steps, on surfaces and in volumes."""
        series = write_series(self.folder, "a.pvd")
        for make, name in (
            (relevo.refined, "scalars"), (relevo.patches, "scalars"), (relevo.volume, "array")
        ):
            for array, wanted in (("Heat", (0, TIMES[-1])), ("y of Move", (0, TIMES[-1]))):
                for time in (None, 1.0):
                    drawing = make(series, **{name: array}, range="all", time=time)
                    self.assertEqual(drawing._table.GetRange(), wanted)
            drawing = make(series, **{name: "Heat"}, range=(-1, 2.5))
            self.assertEqual(drawing._table.GetRange(), (-1, 2.5))
        drawing = relevo.lic(series, "Move", range="all", palette="grey")
        self.assertEqual(drawing._table.GetRange(), (0, TIMES[-1]))
        # Without time steps, it is the range of the data.
        drawing = relevo.refined(make_block(), scalars="Flow", range="all")
        self.assertEqual(drawing._table.GetRange()[0], 0)

    def test_quantities(self):
        drawing = relevo.refined(make_block(), scalars="x of Flow")
        self.assertEqual(drawing._table.GetRange(), (-4, 4))

    def test_cuts(self):
        """A cut of 3D cells is filled, with colours of values inside; others are hollow."""
        whole = relevo.refined(self.path, scalars="Damage", lighting=False)
        cut = relevo.refined(self.path, scalars="Damage", clip=CLIP, lighting=False)
        pictures = [own.screenshot(size=SIZE, camera=(90, 0)).astype(int) for own in (whole, cut)]
        # The face at x = 8 is yellow. The values at the cut are a hundredth, dark violet.
        red, green, blue = pictures[0][110, 160]
        self.assertGreater(min(red, green), 2 * blue)
        red, green, blue = pictures[1][110, 160]
        self.assertGreater(blue, 2 * green)
        self.assertEqual(len(cut.actors), 3)
        curved = relevo.patches(make_curved_block(), clip=((2.01, 0, 0), (-1, 0, 0)))
        self.assertEqual(len(curved.actors), 3)
        faces = curved._others[0].GetMapper()
        faces.Update()
        self.assertGreater(faces.GetInput().GetNumberOfCells(), 0)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            relevo.refined(make_sphere(), clip=((0, 0, 0), (0, 0, 1)))
        self.assertIn("no 3D cells, so the cut is hollow", str(caught[0].message))

    def test_errors(self):
        for options, error, text in (
            ({"scalars": "x of Flow", "log": True}, ValueError, r"from -4 to 4; set range=\(0.004, 4\)"),
            ({"scalars": "Damage", "log": True, "range": (0, 1)}, ValueError, "log needs a range above 0"),
            ({"scalars": "Damage", "palette": "jet"}, ValueError, "palette must be one of cool-warm"),
            ({"scalars": "Damage", "range": (2, 1)}, ValueError, "finite numbers that increase"),
            ({"scalars": "Damage", "range": "some"}, TypeError, r"range must be \(low, high\) or 'all'"),
            ({"scalars": "Damage", "below": "blurk"}, ValueError, "below must be a colour such as"),
            ({"scalars": "Damage", "above": (1, 2, 3)}, ValueError, "must be from 0 to 1"),
            ({"scalars": "Damage", "above": 3}, TypeError, "above must be a colour"),
            ({"scalars": "None"}, ValueError, "no array 'None'; its arrays are 'Damage', 'Flow'"),
            ({"palette": "grey"}, ValueError, "palette needs colours by an array"),
            ({"clip": 3}, TypeError, "clip must be a vtkPlane"),
            ({"cmap": "grey"}, TypeError, "did you mean palette"),
        ):
            with self.assertRaisesRegex(error, text):
                data = make_block()
                relevo.refined(data, **options)
        with self.assertRaisesRegex(ValueError, "palette cannot be combined with transfer"):
            relevo.volume(make_block(), transfer=[[0, 0, 0, 0, 0], [1, 1, 1, 1, 1]], palette="grey")
        with self.assertRaisesRegex(ValueError, "isolines cannot be combined with log"):
            relevo.patches(make_block(), scalars="Damage", isolines=4, log=True)


if __name__ == "__main__":
    unittest.main(argv=["TestDrawingColours"])
