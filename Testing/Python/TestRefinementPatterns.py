# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkRefinementPatternTable promises, from Python: levels, permutations, files and errors."""

import itertools
import os
import sys
import tempfile
import unittest

import relevo
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

Table = relevo.vtkRefinementPatternTable


def collect_errors(algorithm):
    errors = []

    def collect(caller, event, message):
        errors.append(message)

    collect.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", collect)
    return errors


def segments(pattern):
    """Segments of the edges P1P2, P2P3 and P3P1, from the points on them."""
    points = [pattern.GetPoint(p) for p in range(pattern.GetNumberOfPoints())]
    return tuple(
        sum(on_edge) - 1
        for on_edge in (
            [y == 0 for x, y, z in points],
            [x + y == 1 for x, y, z in points],
            [x == 0 for x, y, z in points],
        )
    )


class TestRefinementPatterns(unittest.TestCase):
    def test_number_of_patterns_follows_the_level(self):
        table = Table()
        self.assertEqual((table.GetMaximumLevel(), table.GetNumberOfPatterns()), (5, 56))
        for level in range(8):
            table.SetMaximumLevel(level)
            expected = (level + 1) * (level + 2) * (level + 3) // 6
            self.assertEqual(table.GetNumberOfPatterns(), expected)

    def test_level_out_of_range(self):
        table = Table()
        errors = collect_errors(table)
        for level in (-1, 8):
            table.SetMaximumLevel(level)
        self.assertEqual(table.GetMaximumLevel(), 5)
        self.assertEqual(len(errors), 2)
        self.assertIn("MaximumLevel", errors[0])
        self.assertFalse(table.GetPattern(0, 6, 0, vtkPolyData()))
        self.assertIn("[0, 6, 0]", errors[2])

    def test_canonicalize_and_permutation(self):
        for levels in itertools.product(range(5), repeat=3):
            canonical = list(levels)
            swaps = Table.Canonicalize(canonical)
            self.assertEqual(canonical, sorted(levels, reverse=True))
            permutation = [0, 0, 0]
            Table.GetPermutation(swaps, permutation)
            # Edge e of the element, from corner e to the next one, is this edge of the pattern.
            edges = {frozenset((0, 1)): 0, frozenset((1, 2)): 1, frozenset((2, 0)): 2}
            for edge in range(3):
                ends = frozenset((permutation[edge], permutation[(edge + 1) % 3]))
                self.assertEqual(canonical[edges[ends]], levels[edge])
            cyclic = permutation in ([0, 1, 2], [1, 2, 0], [2, 0, 1])
            self.assertEqual(Table.IsOdd(swaps), not cyclic)

    def test_patterns(self):
        table = Table()
        pattern = vtkPolyData()
        for levels in itertools.product(range(4), repeat=3):
            self.assertTrue(table.GetPattern(*levels, pattern))
            self.assertEqual(segments(pattern), tuple(2**level for level in levels))
            weights = pattern.GetPointData().GetArray("Barycentrics")
            for p in range(pattern.GetNumberOfPoints()):
                u, v, w = weights.GetTuple3(p)
                self.assertEqual(u + v + w, 1.0)
                self.assertEqual(pattern.GetPoint(p), (v, w, 0.0))
            if len(set(levels)) == 1:
                self.assertEqual(pattern.GetNumberOfCells(), 4 ** levels[0])

    def test_conforming_by_vtk(self):
        source = relevo.vtkRefinementPatternSource()
        edges = vtkFeatureEdges()
        edges.FeatureEdgesOff()
        edges.SetInputConnection(source.GetOutputPort())
        for levels in ((5, 0, 0), (0, 3, 5), (2, 6, 4), (7, 7, 6)):
            source.SetLevels(*levels)
            edges.Update()
            border = edges.GetOutput()
            self.assertEqual(border.GetNumberOfCells(), sum(2**level for level in levels))
            outside = [
                p
                for p in map(border.GetPoint, range(border.GetNumberOfPoints()))
                if 0.0 not in (p[0], p[1], 1.0 - p[0] - p[1])
            ]
            self.assertEqual(outside, [])

    def test_count_of_triangles(self):
        table = Table()
        pattern = vtkPolyData()
        table.GetPattern(5, 0, 0, pattern)
        self.assertLess(pattern.GetNumberOfCells(), 342)  # (4^5 + 4^0 + 4^0) / 3
        table.GetPattern(5, 5, 4, pattern)
        self.assertLess(abs(pattern.GetNumberOfCells() - 768), 77)  # (2 4^5 + 4^4) / 3

    def test_files(self):
        table = Table()
        table.SetMaximumLevel(3)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("patterns.bin", "patterns.vtp", "PATTERNS.VTP"):
                path = os.path.join(folder, name)
                self.assertTrue(table.Write(path))
                read = Table()
                self.assertTrue(read.Read(path))
                self.assertEqual(read.GetMaximumLevel(), 3)
                ours, theirs = vtkPolyData(), vtkPolyData()
                table.GetPattern(1, 3, 0, ours)
                read.GetPattern(1, 3, 0, theirs)
                self.assertEqual(
                    [ours.GetPoint(p) for p in range(ours.GetNumberOfPoints())],
                    [theirs.GetPoint(p) for p in range(theirs.GetNumberOfPoints())],
                )
                self.assertEqual(ours.GetNumberOfCells(), theirs.GetNumberOfCells())
            path = os.path.join(folder, "patterns.bin")
            size = os.path.getsize(path)
            os.truncate(path, size // 2)
            errors = collect_errors(read)
            self.assertFalse(read.Read(path))
            self.assertIn("truncated", errors[0])
            self.assertEqual(read.GetMaximumLevel(), 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
