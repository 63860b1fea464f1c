// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Quantities/GaussPoints.h"

#include <cmath>

namespace relevo
{
namespace
{
using GaussPointList = std::vector<std::array<double, 3>>;

// On a line from 0 to 1.
std::vector<double> FindLinePoints(int number)
{
  const double two = 0.5 / std::sqrt(3.0);
  const double three = 0.5 * std::sqrt(0.6);
  switch (number)
  {
    case 1:
      return { 0.5 };
    case 2:
      return { 0.5 - two, 0.5 + two };
    case 3:
      return { 0.5 - three, 0.5, 0.5 + three };
    default:
      return {};
  }
}

GaussPointList FindTrianglePoints(int number)
{
  const double third = 1.0 / 3.0;
  const double sixth = 1.0 / 6.0;
  return number == 1 ? GaussPointList{ { third, third, 0.0 } }
    : number == 3    ? GaussPointList{ { sixth, sixth, 0.0 }, { 4.0 * sixth, sixth, 0.0 },
        { sixth, 4.0 * sixth, 0.0 } }
                     : GaussPointList{};
}

GaussPointList FindTetrahedronPoints(int number)
{
  const double a = (5.0 - std::sqrt(5.0)) / 20.0;
  const double b = 1.0 - 3.0 * a;
  return number == 1 ? GaussPointList{ { 0.25, 0.25, 0.25 } }
    : number == 4    ? GaussPointList{ { a, a, a }, { b, a, a }, { a, b, a }, { a, a, b } }
                     : GaussPointList{};
}

GaussPointList FindWedgePoints(int number)
{
  GaussPointList points;
  const bool hasOne = number < 3; // in each triangle
  for (double z : FindLinePoints(hasOne ? number : number == 6 ? 2 : number == 9 ? 3 : 0))
  {
    for (const auto& point : FindTrianglePoints(hasOne ? 1 : 3))
    {
      points.push_back({ point[0], point[1], z });
    }
  }
  return points;
}

// In the first directions of a square or a cube.
GaussPointList FindBoxPoints(int dimension, int number)
{
  for (int side = 1; side <= 3; ++side)
  {
    const int sides[3] = { side, dimension > 1 ? side : 1, dimension > 2 ? side : 1 };
    if (sides[0] * sides[1] * sides[2] != number)
    {
      continue;
    }
    GaussPointList points;
    const std::vector<double> places = FindLinePoints(side);
    for (int i = 0; i < number; ++i)
    {
      const int j = i / side;
      points.push_back({ places[i % side], dimension > 1 ? places[j % side] : 0.0,
        dimension > 2 ? places[j / side] : 0.0 });
    }
    return points;
  }
  return {};
}
}

std::vector<std::array<double, 3>> FindGaussPoints(CellTopology shape, int number)
{
  switch (shape)
  {
    case CellTopology::Curve:
      return FindBoxPoints(1, number);
    case CellTopology::Quadrilateral:
      return FindBoxPoints(2, number);
    case CellTopology::Hexahedron:
      return FindBoxPoints(3, number);
    case CellTopology::Triangle:
      return FindTrianglePoints(number);
    case CellTopology::Tetrahedron:
      return FindTetrahedronPoints(number);
    case CellTopology::Wedge:
      return FindWedgePoints(number);
    case CellTopology::Pyramid:
      return number == 1 ? GaussPointList{ { 0.5, 0.5, 0.25 } } : GaussPointList{};
    default:
      return {};
  }
}
}
