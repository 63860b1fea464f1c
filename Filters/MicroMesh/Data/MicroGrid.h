// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the grid of points on a face of a micro-mesh
 *
 * At level L, a face has n = 2^L segments per edge. A grid point has three numbers i, j, k with
 * i + j + k = n, which are n times the weights of the face's corners. Edge e connects corners e and
 * (e + 1) % 3.
 */
#ifndef MicroGrid_h
#define MicroGrid_h

#include <array> // for members

namespace relevo
{
constexpr int LargestMicroLevel = 7;

using GridPoint = std::array<int, 3>;

/// The number of points of a grid with n segments per edge, and of those not on an edge.
constexpr int GetNumberOfGridPoints(int n)
{
  return (n + 1) * (n + 2) / 2;
}
constexpr int GetNumberOfInnerPoints(int n)
{
  return (n - 1) * (n - 2) / 2;
}

/// The index of a point in rows of equal k, each in the order of increasing j.
constexpr int GetGridIndex(int n, const GridPoint& point)
{
  return point[2] * (n + 1) - point[2] * (point[2] - 1) / 2 + point[1];
}
/// Does the same for the points that are not on an edge.
constexpr int GetInnerIndex(int n, const GridPoint& point)
{
  return GetGridIndex(n - 3, { { point[0] - 1, point[1] - 1, point[2] - 1 } });
}

/// Call f(point) for all points of a grid, in the order of their indices.
template <typename Function>
void ForEachGridPoint(int n, const Function& f)
{
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n - k; ++j)
    {
      f(GridPoint{ { n - j - k, j, k } });
    }
  }
}

/// Call f(a, b, c) for the indices of all triangles of a grid, with the winding of the face.
template <typename Function>
void ForEachGridTriangle(int n, const Function& f)
{
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n - k; ++j)
    {
      const int i = n - j - k;
      const int a = GetGridIndex(n, { { i, j, k } });
      const int b = GetGridIndex(n, { { i - 1, j + 1, k } });
      const int c = GetGridIndex(n, { { i - 1, j, k + 1 } });
      f(a, b, c);
      if (i > 1)
      {
        f(b, GetGridIndex(n, { { i - 2, j + 1, k + 1 } }), c);
      }
    }
  }
}

/// A triangle of a grid and the shares of its corners in a point, which sum up to `Stride`.
struct GridCell
{
  GridPoint Corners[3];
  std::array<int, 3> Shares;
  int Stride;
};

/// The triangle of a coarser grid that contains a point. An edge of the coarser grid has `stride`
/// segments of the finer one.
inline GridCell FindGridCell(const GridPoint& point, int stride)
{
  GridPoint low{};
  std::array<int, 3> rest{};
  for (int c = 0; c < 3; ++c)
  {
    low[c] = point[c] / stride;
    rest[c] = point[c] % stride;
  }
  const int sum = rest[0] + rest[1] + rest[2]; // 0, stride or 2 stride
  if (sum == 0)
  {
    return { { low, low, low }, { { stride, 0, 0 } }, stride };
  }
  GridCell cell{ { low, low, low }, {}, stride };
  const bool isTurned = sum > stride; // towards the corners
  for (int c = 0; c < 3; ++c)
  {
    for (int d = 0; d < 3; ++d)
    {
      cell.Corners[c][d] += (d == c) != isTurned ? 1 : 0;
    }
    cell.Shares[c] = isTurned ? stride - rest[c] : rest[c];
  }
  return cell;
}

/// A triangle of a grid, and the weights of its corners at a point.
struct GridPlace
{
  GridPoint Corners[3];
  std::array<double, 3> Weights;
};

/// The triangle of a grid with n segments per edge that contains a point of the face.
inline GridPlace FindGridPlace(int n, const std::array<double, 3>& weights)
{
  GridPoint low{};
  std::array<double, 3> rest{};
  int sum = 0;
  for (int c = 0; c < 2; ++c)
  {
    const double place = weights[c] * n;
    low[c] = static_cast<int>(place) < n ? static_cast<int>(place) : n - 1;
    low[c] = low[c] > n - 1 - sum ? n - 1 - sum : low[c];
    rest[c] = place - low[c];
    sum += low[c];
  }
  low[2] = n - 1 - sum; // the third coordinate of two corners
  const bool isTurned = rest[0] + rest[1] > 1.0 && low[2] > 0;
  rest[2] = 1.0 - rest[0] - rest[1];
  GridPlace result{ { low, low, low }, {} };
  for (int c = 0; c < 3; ++c)
  {
    if (isTurned) // the triangle beside it, towards the corners 0 and 1
    {
      result.Corners[c] = { { low[0] + (c == 0 ? 0 : 1), low[1] + (c == 1 ? 0 : 1),
        low[2] - (c == 2 ? 1 : 0) } };
      result.Weights[c] = c == 2 ? -rest[2] : 1.0 - rest[c];
    }
    else
    {
      ++result.Corners[c][c];
      result.Weights[c] = rest[c];
    }
  }
  return result;
}

/// The edge that a grid point is on, or -1. A corner is on both of its edges; any is returned.
constexpr int GetGridEdge(const GridPoint& point)
{
  return point[2] == 0 ? 0 : (point[0] == 0 ? 1 : (point[1] == 0 ? 2 : -1));
}
}

#endif
