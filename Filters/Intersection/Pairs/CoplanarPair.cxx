// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs/CoplanarPair.h"

#include "Exact/ExactPredicates.h"

#include <utility>

namespace relevo
{
namespace
{
// Two triangles in a projection where each is oriented to the left.
class PlanarPair
{
public:
  PlanarPair(const TrianglePoints& a, const TrianglePoints& b)
    : Triangles{ a, b }
  {
    const int axis = FindAxis(b[0], b[1], b[2]);
    int turns[2];
    for (int side = 0; side < 2; ++side)
    {
      const TrianglePoints& own = this->Triangles[side];
      turns[side] = Orient2D(own[0], own[1], own[2], axis);
      for (int edge = 0; edge < 3; ++edge)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          this->Sides[side][edge][corner] = turns[side] *
            Orient2D(own[edge], own[(edge + 1) % 3], this->Triangles[1 - side][corner], axis);
        }
      }
    }
    this->AreTurnedAlike = turns[0] == turns[1];
  }

  CommonPoints Intersect() const
  {
    CommonPoints common;
    if (this->AreApart())
    {
      return common;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      const TrianglePart inB = this->FindCorner(0, corner);
      if (inB != Outside)
      {
        common.Add(static_cast<TrianglePart>(corner), inB);
      }
      const TrianglePart inA = this->FindCorner(1, corner);
      if (inA != Outside)
      {
        common.Add(inA, static_cast<TrianglePart>(corner));
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        if (this->Sides[0][i][j] * this->Sides[0][i][(j + 1) % 3] < 0 &&
          this->Sides[1][j][i] * this->Sides[1][j][(i + 1) % 3] < 0)
        {
          common.Add(static_cast<TrianglePart>(3 + i), static_cast<TrianglePart>(3 + j));
        }
      }
    }
    return common.Count < 3 ? common : this->Sort(common);
  }

private:
  // Whether the other triangle is strictly outside of an edge.
  bool AreApart() const
  {
    for (const auto& edges : this->Sides)
    {
      for (const auto& sides : edges)
      {
        if (sides[0] < 0 && sides[1] < 0 && sides[2] < 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  // Returns the part of the other triangle that contains a corner.
  TrianglePart FindCorner(int side, int corner) const
  {
    const auto& edges = this->Sides[1 - side];
    return FindPart({ edges[0][corner], edges[1][corner], edges[2][corner] });
  }

  // Whether a point is on an edge: 0 to 2 of a, 3 to 5 of b.
  static bool IsOn(const CommonPoint& point, int edge)
  {
    const TrianglePart part = point.Parts[edge / 3];
    const int own = edge % 3;
    return part == own || part == (own + 1) % 3 || part == 3 + own;
  }

  // Returns -1 if the point is the start of the part of an edge of a inside of b, 1 if it is the
  // end, and 0 if undetermined.
  int GetEnd(const CommonPoint& point, int edge) const
  {
    if (IsCorner(point.Parts[0]))
    {
      return point.Parts[0] == edge ? -1 : 1;
    }
    return IsEdge(point.Parts[1]) ? this->Sides[1][point.Parts[1] - 3][edge] : 0;
  }

  // Whether p precedes q on an edge of a.
  bool IsBefore(const CommonPoint& p, const CommonPoint& q, int edge) const
  {
    const int pEnd = this->GetEnd(p, edge);
    const int qEnd = this->GetEnd(q, edge);
    if (pEnd != 0 || qEnd != 0)
    {
      return pEnd != 0 ? pEnd < 0 : qEnd > 0;
    }
    // Both are corners of b.
    const double* from = this->Triangles[0][edge];
    const double* to = this->Triangles[0][(edge + 1) % 3];
    const double* pAt = this->Triangles[1][p.Parts[1]];
    const double* qAt = this->Triangles[1][q.Parts[1]];
    int c = 0;
    while (from[c] == to[c])
    {
      ++c;
    }
    return (pAt[c] < qAt[c]) == (from[c] < to[c]);
  }

  // Sorts the corners of a polygon along its border: consecutive corners share an edge.
  CommonPoints Sort(const CommonPoints& common) const
  {
    int neighbors[6][2];
    int degrees[6] = {};
    int start[2] = { -1, -1 }; // a side with a known direction
    for (int edge = 0; edge < 6; ++edge)
    {
      int on[2];
      int count = 0;
      for (int i = 0; i < common.Count && count < 2; ++i)
      {
        if (IsOn(common.Points[i], edge))
        {
          on[count++] = i;
        }
      }
      const bool isNew = count == 2 && !(degrees[on[0]] > 0 && neighbors[on[0]][0] == on[1]) &&
        !(degrees[on[0]] > 1 && neighbors[on[0]][1] == on[1]);
      if (!isNew)
      {
        continue;
      }
      neighbors[on[0]][degrees[on[0]]++] = on[1];
      neighbors[on[1]][degrees[on[1]]++] = on[0];
      if (start[0] < 0)
      {
        const bool isForward = this->IsForward(common.Points[on[0]], common.Points[on[1]], edge);
        start[0] = isForward ? on[0] : on[1];
        start[1] = isForward ? on[1] : on[0];
      }
    }
    CommonPoints sorted;
    int last = start[0];
    int current = start[1];
    sorted.Points[sorted.Count++] = common.Points[last];
    while (current != start[0] && sorted.Count < common.Count)
    {
      sorted.Points[sorted.Count++] = common.Points[current];
      const int next =
        neighbors[current][0] == last ? neighbors[current][1] : neighbors[current][0];
      last = current;
      current = next;
    }
    return sorted;
  }

  // Whether the border of the polygon, oriented like a, leads from p to q.
  bool IsForward(const CommonPoint& p, const CommonPoint& q, int edge) const
  {
    if (edge < 3)
    {
      return this->IsBefore(p, q, edge);
    }
    // Without an edge of a, the border is that of b.
    return (p.Parts[1] == edge - 3) == this->AreTurnedAlike;
  }

  TrianglePoints Triangles[2];
  // Sides of a triangle's edges that the corners of the other are on.
  std::array<std::array<std::array<int, 3>, 3>, 2> Sides;
  bool AreTurnedAlike;
};
}

TrianglePart FindPartInPlane(const double point[3], const TrianglePoints& triangle)
{
  const int axis = FindAxis(triangle[0], triangle[1], triangle[2]);
  const int turn = Orient2D(triangle[0], triangle[1], triangle[2], axis);
  std::array<int, 3> sides;
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = turn * Orient2D(triangle[i], triangle[(i + 1) % 3], point, axis);
  }
  return FindPart(sides);
}

CommonPoints IntersectCoplanarTriangles(const TrianglePoints& a, const TrianglePoints& b)
{
  return PlanarPair(a, b).Intersect();
}
}
