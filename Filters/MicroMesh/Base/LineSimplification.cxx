// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/LineSimplification.h"

#include "Dense/DenseMesh.h"
#include "Distance/SegmentDistance.h"

#include <algorithm>
#include <cstddef>

namespace relevo
{
namespace
{
class LineSimplification
{
public:
  LineSimplification(const DenseMesh& mesh, double tolerance)
    : Mesh(mesh)
    , Tolerance2(tolerance * tolerance)
    , AreKept(mesh.Points.size(), 0)
    , AreDone(mesh.Points.size(), 0)
  {
  }

  std::vector<char> Run()
  {
    for (std::size_t v = 0; v < this->AreDone.size(); ++v)
    {
      if (this->Mesh.Kinds[v] == DenseMesh::Kind::LOCKED)
      {
        for (const LineEnd& end : this->Mesh.LineEnds[v])
        {
          this->Simplify(static_cast<int>(v), end.Vertex);
        }
      }
    }
    for (std::size_t v = 0; v < this->AreDone.size(); ++v) // closed lines
    {
      if (this->IsNew(static_cast<int>(v)))
      {
        this->AreDone[v] = 1;
        this->Simplify(static_cast<int>(v), this->Mesh.LineEnds[v][0].Vertex);
      }
    }
    return std::move(this->AreKept);
  }

private:
  bool IsNew(int vertex) const
  {
    const auto v = static_cast<std::size_t>(vertex);
    return this->Mesh.Kinds[v] == DenseMesh::Kind::LINE && this->AreDone[v] == 0;
  }

  // Chooses vertices of the line from a vertex through a neighbour.
  void Simplify(int start, int next)
  {
    this->Line = { start };
    for (int before = start; this->IsNew(next);)
    {
      this->AreDone[static_cast<std::size_t>(next)] = 1;
      this->Line.push_back(next);
      const LineTable::Ends& ends = this->Mesh.LineEnds[static_cast<std::size_t>(next)];
      const int after = ends[0].Vertex == before ? ends[1].Vertex : ends[0].Vertex;
      before = next;
      next = after;
    }
    this->Line.push_back(next);
    this->Orient();
    const std::size_t last = this->Line.size() - 1;
    for (std::size_t i = this->FindFarthest(0); i < last; i = this->FindFarthest(i))
    {
      this->AreKept[static_cast<std::size_t>(this->Line[i])] = 1;
    }
  }

  // Pieces of a surface choose the same vertices of a common line, because its order depends only
  // on the places of its vertices. Closed lines start at the first place.
  void Orient()
  {
    const auto isBefore = [this](int a, int b)
    {
      const dvec3 first = this->Mesh.GetPlace(a);
      const dvec3 second = this->Mesh.GetPlace(b);
      return first.x != second.x ? first.x < second.x
                                 : (first.y != second.y ? first.y < second.y : first.z < second.z);
    };
    const bool isClosed = this->Line.front() == this->Line.back();
    if (isClosed &&
      this->Mesh.Kinds[static_cast<std::size_t>(this->Line.front())] == DenseMesh::Kind::LINE)
    {
      this->Line.pop_back();
      std::rotate(this->Line.begin(),
        std::min_element(this->Line.begin(), this->Line.end(), isBefore), this->Line.end());
      this->Line.push_back(this->Line.front());
      this->AreKept[static_cast<std::size_t>(this->Line.front())] = 1;
    }
    const std::size_t last = this->Line.size() - 1;
    if (isClosed ? isBefore(this->Line[last - 1], this->Line[1])
                 : isBefore(this->Line.back(), this->Line.front()))
    {
      std::reverse(this->Line.begin(), this->Line.end());
    }
  }

  // The farthest vertex of the line for which a segment is within the tolerance.
  std::size_t FindFarthest(std::size_t first) const
  {
    const std::size_t last = this->Line.size() - 1;
    if (first == 0 && this->IsWithin(first, last))
    {
      return last;
    }
    std::size_t within = first + 1;
    std::size_t step = 1;
    while (within < last && this->IsWithin(first, std::min(last, within + step)))
    {
      within = std::min(last, within + step);
      step *= 2;
    }
    for (; step > 0; step /= 2)
    {
      within += within + step <= last && this->IsWithin(first, within + step) ? step : 0;
    }
    return within;
  }

  bool IsWithin(std::size_t first, std::size_t last) const
  {
    const dvec3& start = this->GetPoint(first);
    const dvec3& end = this->GetPoint(last);
    for (std::size_t i = first + 1; i < last; ++i)
    {
      if (GetSegmentDistance2(this->GetPoint(i), start, end) > this->Tolerance2)
      {
        return false;
      }
    }
    return true;
  }

  const dvec3& GetPoint(std::size_t i) const
  {
    return this->Mesh.Points[static_cast<std::size_t>(this->Line[i])];
  }

  const DenseMesh& Mesh;
  double Tolerance2;
  std::vector<char> AreKept;
  std::vector<char> AreDone;
  std::vector<int> Line;
};
}

std::vector<char> FindLineVertices(const DenseMesh& mesh, double tolerance)
{
  return LineSimplification(mesh, tolerance).Run();
}
}
