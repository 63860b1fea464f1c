# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves intersections.md: the intersection of two triangles is exact, compared point by point with
clipping in fractions."""

import random
import sys
import unittest
from fractions import Fraction

import relevo
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def get_normal(triangle):
    return cross(subtract(triangle[1], triangle[0]), subtract(triangle[2], triangle[0]))


def clip(polygon, normal, at):
    """The part of a convex polygon, segment or point that is not beyond a plane."""
    sides = [dot(normal, subtract(point, at)) for point in polygon]
    clipped = []
    for i, point in enumerate(polygon):
        if sides[i] * sides[i - 1] < 0:
            share = sides[i] / (sides[i] - sides[i - 1])
            clipped.append(tuple(p + share * (q - p) for p, q in zip(point, polygon[i - 1])))
        if sides[i] <= 0:
            clipped.append(point)
    return clipped


def intersect(a, b):
    """Corners of the intersection of two triangles, rounded once."""
    a = [tuple(map(Fraction, point)) for point in a]
    b = [tuple(map(Fraction, point)) for point in b]
    normal = get_normal(b)
    common = clip(clip(a, normal, b[0]), tuple(-x for x in normal), b[0])
    for i in range(3):
        outwards = cross(subtract(b[i], b[i - 1]), normal)
        common = clip(common, outwards, b[i])
    return sorted(tuple(map(float, point)) for point in set(common))


def make_mesh(triangle):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    polygons = vtkCellArray()
    polygons.InsertNextCell(3)
    for point in triangle:
        polygons.InsertCellPoint(points.InsertNextPoint(point))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    return mesh


def make_filter(a, b):
    intersection = relevo.vtkSurfaceIntersectionFilter()
    intersection.SetInputData(0, make_mesh(a))
    intersection.SetInputData(1, make_mesh(b))
    return intersection


def get_points(mesh):
    return [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]


def random_whole(dice, side):
    return tuple(float(dice.randrange(side)) for _ in range(3))


def random_wild(dice):
    """Coordinates of all magnitudes, some of them equal."""
    return tuple(dice.choice((0.0, dice.uniform(-1, 1) * 2.0 ** dice.randint(-1000, 990), dice.uniform(-1, 1)))
                 for _ in range(3))


def random_near(dice):
    """Coordinates far from the origin, where rounding has most effect."""
    return tuple(1e8 + dice.randrange(5) * 2.0 ** -26 for _ in range(3))


def random_triangle(dice, make):
    while True:
        triangle = [make(dice) for _ in range(3)]
        if any(get_normal([tuple(map(Fraction, point)) for point in triangle])):
            return triangle


class TestSurfaceIntersection(unittest.TestCase):
    def check(self, a, b):
        """Returns the number of corners."""
        intersection = make_filter(a, b)
        intersection.Update()
        curves, overlaps = intersection.GetOutput(0), intersection.GetOutput(1)
        expected = intersect(a, b)
        found = sorted(get_points(overlaps if len(expected) > 2 else curves))
        self.assertEqual(found, expected, (a, b))
        kinds = (curves.GetNumberOfVerts(), curves.GetNumberOfLines(), overlaps.GetNumberOfPolys())
        self.assertEqual(kinds, tuple(int(is_kind) for is_kind in (len(expected) == 1, len(expected) == 2,
                                                                   len(expected) > 2)))
        self.assertEqual(intersection.GetOutput(2).GetCellData().GetArray("Contact").GetValue(0),
                         2 if expected else 0)
        if len(expected) > 2:
            self.check_winding(a, get_points(overlaps), overlaps.GetCell(0).GetPointIds())
        return len(expected)

    def check_winding(self, triangle, points, ids):
        """The polygon has the triangle's winding and is convex, up to rounding."""
        corners = [tuple(map(Fraction, points[ids.GetId(i)])) for i in range(ids.GetNumberOfIds())]
        normal = get_normal([tuple(map(Fraction, point)) for point in triangle])
        size = dot(normal, normal)
        for i in range(len(corners)):
            turn = cross(subtract(corners[i - 1], corners[i - 2]), subtract(corners[i], corners[i - 1]))
            self.assertGreater(dot(turn, normal) / size, -1e-12)

    def check_many(self, make, number, corners):
        dice = random.Random(1)
        counts = [0] * 7
        for _ in range(number):
            a, b = random_triangle(dice, make), random_triangle(dice, make)
            counts[self.check(a, b)] += 1
        for i in corners:
            self.assertGreater(counts[i], 0, counts)

    def test_whole(self):
        for side in (2, 3, 4, 7):
            self.check_many(lambda dice: random_whole(dice, side), 1000, (0, 1, 2))

    def test_coplanar(self):
        self.check_many(lambda dice: (float(dice.randrange(6)), float(dice.randrange(6)), 1.0), 1500, range(7))
        # In an oblique plane.
        self.check_many(lambda dice: (x := float(dice.randrange(6)), y := float(dice.randrange(6)), 2 * x - 3 * y),
                        1000, range(6))

    def test_doubles(self):
        self.check_many(lambda dice: tuple(dice.uniform(-1, 1) for _ in range(3)), 1500, (0, 2))
        self.check_many(random_near, 1000, (0, 1, 2))
        self.check_many(random_wild, 1000, (0, 2))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
