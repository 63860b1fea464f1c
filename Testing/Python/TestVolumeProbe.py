# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves volumes.md: relevo.volume().probe() and vtkVolumeProbe return positions, cells and values
under pixels."""

import math
import unittest

from DrawingData import make_block, numpy, relevo
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell
from vtkmodules.vtkRenderingCore import vtkCamera

SIZE = (120, 90)


class TestVolumeProbe(unittest.TestCase):
    def test_values(self):
        mesh = make_block()
        volume = relevo.volume(mesh)
        data = volume.mapper.GetDataSetInput()
        array = vtk_to_numpy(data.GetPointData().GetArray(volume.mapper.GetArrayName()))
        picture = volume.screenshot(size=SIZE)
        empty = picture[0, 0]
        hits = 0
        for y in range(4, SIZE[1], 15):
            for x in range(4, SIZE[0], 15):
                point = volume.probe(x, y, size=SIZE)
                if point is None:
                    continue
                hits += 1
                # Something is drawn there.
                self.assertGreater(abs(picture[y, x].astype(int) - empty).max(), 8)
                cell = vtkGenericCell()
                data.GetCell(point.cell, cell)
                place, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
                cell.EvaluateLocation(reference(0), point.parameters, place, weights)
                self.assertLess(math.dist(place, point.position), 1e-6)
                ids = [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]
                self.assertAlmostEqual(numpy.dot(weights, array[ids]), point.value, places=6)
        self.assertGreater(hits, 3)

    def test_camera(self):
        opaque = [[0, 1, 0, 0, 1], [10, 0, 0, 1, 1]]
        volume = relevo.volume(make_block(), transfer=opaque, unit_distance=0.1)
        bounds = numpy.array(volume.actor.GetBounds()).reshape(3, 2)
        camera = vtkCamera()
        camera.SetFocalPoint(bounds.mean(axis=1))
        camera.SetPosition(*(bounds.mean(axis=1) + [0, 0, 3 * (bounds[2, 1] - bounds[2, 0])]))
        point = volume.probe(SIZE[0] / 2, 0.42 * SIZE[1], SIZE, camera)
        self.assertIsNotNone(point)
        self.assertGreater(point.position[1], bounds[1].mean())  # in the upper half
        self.assertIsNone(volume.probe(-5, 0, SIZE))

    def test_errors(self):
        with self.assertRaisesRegex(relevo.Error, "Average blending"):
            relevo.volume(make_block(), blend="average").probe(60, 45, SIZE)


if __name__ == "__main__":
    unittest.main(argv=["TestVolumeProbe"])
