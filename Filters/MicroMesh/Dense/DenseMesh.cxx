// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Dense/DenseMesh.h"

#include "Dense/FreeMemory.h"
#include "Mathematics/FiniteBox.h"
#include "Mesh/SurfaceTriangles.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace relevo
{
namespace
{
// The half-edges of all triangles, sorted by the lower vertex, then the higher one. An index is 3 *
// triangle + edge.
class SortedHalfEdges
{
public:
  struct HalfEdge
  {
    int High;
    int Index;

    bool operator<(const HalfEdge& other) const
    {
      return this->High != other.High ? this->High < other.High : this->Index < other.Index;
    }
  };

  SortedHalfEdges(const std::vector<DenseMesh::Triangle>& triangles, std::size_t vertices)
    : Firsts(vertices + 1, 0)
    , Edges(3 * triangles.size())
  {
    const auto forEach = [&](const auto& f)
    {
      for (std::size_t t = 0; t < triangles.size(); ++t)
      {
        for (int e = 0; e < 3; ++e)
        {
          const auto ends = std::minmax(triangles[t][e], triangles[t][(e + 1) % 3]);
          f(static_cast<std::size_t>(ends.first), ends.second, 3 * static_cast<int>(t) + e);
        }
      }
    };
    forEach([&](std::size_t low, int, int) { ++this->Firsts[low + 1]; });
    std::partial_sum(this->Firsts.begin(), this->Firsts.end(), this->Firsts.begin());
    std::vector<std::uint32_t> next(this->Firsts.begin(), this->Firsts.end() - 1);
    forEach(
      [&](std::size_t low, int high, int index) {
        this->Edges[next[low]++] = { high, index };
      });
    vtkSMPTools::For(0, static_cast<vtkIdType>(vertices),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType v = first; v < last; ++v)
        {
          std::sort(this->Begin(v), this->Begin(v + 1));
        }
      });
  }

  // Calls f(low, high, sides) for each edge.
  template <typename Function>
  void ForEachEdge(const Function& f)
  {
    std::vector<int> sides;
    for (std::size_t v = 0; v + 1 < this->Firsts.size(); ++v)
    {
      const auto end = this->Begin(static_cast<vtkIdType>(v) + 1);
      for (auto first = this->Begin(static_cast<vtkIdType>(v)); first != end;)
      {
        const int high = first->High;
        sides.clear();
        for (; first != end && first->High == high; ++first)
        {
          sides.push_back(first->Index);
        }
        f(static_cast<int>(v), high, sides);
      }
    }
  }

private:
  std::vector<HalfEdge>::iterator Begin(vtkIdType vertex)
  {
    return this->Edges.begin() +
      static_cast<std::ptrdiff_t>(this->Firsts[static_cast<std::size_t>(vertex)]);
  }

  std::vector<std::uint32_t> Firsts; // per lower vertex
  std::vector<HalfEdge> Edges;
};

vtkIdType CountCellTriangles(vtkPolyData* input)
{
  vtkIdType number = 0;
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    number += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
  }
  return number;
}

bool DifferInCell(vtkDataArray* array, vtkIdType a, vtkIdType b)
{
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    if (array->GetComponent(a, c) != array->GetComponent(b, c))
    {
      return true;
    }
  }
  return false;
}
}

DenseMesh::DenseMesh(
  vtkPolyData* input, vtkDataArray* materials, double featureAngle, vtkDataArray* fixed)
  : InputPoints(input->GetPoints())
{
  this->ReadTriangles(input);
  this->ScalePoints(input);
  this->FindLines(materials, featureAngle);
  this->LockFans();
  if (fixed)
  {
    this->LockFixed(fixed);
  }
  FreeMemory(this->Opposite); // no longer needed
}

DenseMesh::~DenseMesh() = default;

dvec3 DenseMesh::GetPlace(int vertex) const
{
  double x[3];
  this->InputPoints->GetPoint(this->PointIds[static_cast<std::size_t>(vertex)], x);
  return { x[0], x[1], x[2] };
}

bool DenseMesh::CanStore(double coordinate) const
{
  const int type = this->InputPoints->GetDataType();
  return type == VTK_DOUBLE ||
    (type == VTK_FLOAT && double(static_cast<float>(coordinate)) == coordinate);
}

void DenseMesh::ReadTriangles(vtkPolyData* input)
{
  const SurfaceTriangles surface(input, false);
  const auto number = static_cast<vtkIdType>(surface.GetTriangles().size());
  this->NumberOfDegenerateTriangles = CountCellTriangles(input) - number;
  // Of triangles with the same corners, the first is kept.
  std::vector<int> order(static_cast<std::size_t>(number));
  std::iota(order.begin(), order.end(), 0);
  const auto sorted = [&](int t)
  {
    SurfaceTriangles::Triangle corners = surface.GetTriangles()[static_cast<std::size_t>(t)];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const auto first = sorted(a);
      const auto second = sorted(b);
      return first != second ? first < second : a < b;
    });
  std::vector<char> isDuplicate(static_cast<std::size_t>(number), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    isDuplicate[static_cast<std::size_t>(order[i])] = sorted(order[i]) == sorted(order[i - 1]);
  }
  FreeMemory(order);
  this->NumberOfDuplicates = std::count(isDuplicate.begin(), isDuplicate.end(), 1);
  this->FirstCell = number > 0 ? surface.GetCell(0) : 0;
  bool areConsecutive = true;
  for (vtkIdType t = 0; t < number; ++t)
  {
    areConsecutive = areConsecutive && surface.GetCell(t) == this->FirstCell + t;
  }
  const auto size = static_cast<std::size_t>(number - this->NumberOfDuplicates);
  areConsecutive = areConsecutive && this->NumberOfDuplicates == 0;
  const bool hasWedges = !surface.GetMergedPoints().empty();
  this->Triangles.reserve(size);
  this->Wedges.reserve(hasWedges ? size : 0);
  this->Cells.reserve(areConsecutive ? 0 : size);
  std::vector<int> vertices(static_cast<std::size_t>(surface.GetNumberOfPoints()), -1);
  for (vtkIdType t = 0; t < number; ++t)
  {
    if (isDuplicate[static_cast<std::size_t>(t)] != 0)
    {
      continue;
    }
    Triangle triangle;
    Triangle wedges;
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType point = surface.GetTriangles()[static_cast<std::size_t>(t)][c];
      int& vertex = vertices[static_cast<std::size_t>(point)];
      if (vertex < 0)
      {
        vertex = static_cast<int>(this->PointIds.size());
        this->PointIds.push_back(static_cast<int>(point));
      }
      triangle[c] = vertex;
      wedges[c] = static_cast<int>(surface.GetPoints(t)[c]);
    }
    this->Triangles.push_back(triangle);
    if (hasWedges)
    {
      this->Wedges.push_back(wedges);
    }
    if (!areConsecutive)
    {
      this->Cells.push_back(surface.GetCell(t));
    }
  }
}

void DenseMesh::ScalePoints(vtkPolyData* input)
{
  FiniteBox box;
  double x[3];
  for (int point : this->PointIds)
  {
    input->GetPoint(point, x);
    box.Add(x);
  }
  double side = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = box.GetMiddle(axis);
    side = std::max(side, box.GetSide(axis));
  }
  int exponent = 0;
  std::frexp(side, &exponent);
  this->Scale = std::ldexp(1.0, exponent);
  this->Points.reserve(this->PointIds.size());
  for (std::size_t v = 0; v < this->PointIds.size(); ++v)
  {
    this->Points.push_back(this->FromInput(this->GetPlace(static_cast<int>(v))));
  }
}

dvec3 DenseMesh::GetNormal(const Triangle& triangle) const
{
  const dvec3& origin = this->Points[static_cast<std::size_t>(triangle[0])];
  return cross(this->Points[static_cast<std::size_t>(triangle[1])] - origin,
    this->Points[static_cast<std::size_t>(triangle[2])] - origin);
}

unsigned char DenseMesh::GetFlags(
  const std::vector<int>& sides, vtkDataArray* materials, double smallestCosine) const
{
  if (sides.size() == 1)
  {
    return BORDER;
  }
  const int t[2] = { sides[0] / 3, sides[1] / 3 };
  const int e[2] = { sides[0] % 3, sides[1] % 3 };
  const Triangle& first = this->Triangles[static_cast<std::size_t>(t[0])];
  const Triangle& second = this->Triangles[static_cast<std::size_t>(t[1])];
  if (sides.size() > 2 || first[e[0]] == second[e[1]])
  {
    return UNCLEAR;
  }
  int flags = 0;
  const Triangle firstWedges = this->GetWedges(static_cast<std::size_t>(t[0]));
  const Triangle secondWedges = this->GetWedges(static_cast<std::size_t>(t[1]));
  if (firstWedges[e[0]] != secondWedges[(e[1] + 1) % 3] ||
    firstWedges[(e[0] + 1) % 3] != secondWedges[e[1]])
  {
    flags |= SEAM;
  }
  const dvec3 a = this->GetNormal(first);
  const dvec3 b = this->GetNormal(second);
  if (dot(a, b) < smallestCosine * length(a) * length(b))
  {
    flags |= SHARP;
  }
  if (materials &&
    DifferInCell(materials, this->GetCell(static_cast<std::size_t>(t[0])),
      this->GetCell(static_cast<std::size_t>(t[1]))))
  {
    flags |= MATERIAL;
  }
  return static_cast<unsigned char>(flags);
}

void DenseMesh::FindLines(vtkDataArray* materials, double featureAngle)
{
  const double smallestCosine =
    featureAngle < 180.0 ? std::cos(vtkMath::RadiansFromDegrees(featureAngle)) : -2.0;
  SortedHalfEdges halves(this->Triangles, this->Points.size());
  this->Opposite.assign(3 * this->Triangles.size(), -1);
  this->LineEnds = LineTable(this->Points.size());
  std::vector<char> areUnclear(this->Points.size(), 0);
  halves.ForEachEdge(
    [&](int low, int high, const std::vector<int>& sides)
    {
      const unsigned char flags = this->GetFlags(sides, materials, smallestCosine);
      if ((flags & (BORDER | UNCLEAR)) == 0)
      {
        this->Opposite[static_cast<std::size_t>(sides[0])] = sides[1];
        this->Opposite[static_cast<std::size_t>(sides[1])] = sides[0];
      }
      if (flags != 0)
      {
        this->LineEnds.Add(static_cast<std::size_t>(low), { high, flags });
        this->LineEnds.Add(static_cast<std::size_t>(high), { low, flags });
      }
      this->NumberOfSharpEdges += (flags & SHARP) != 0 ? 1 : 0;
      if ((flags & UNCLEAR) != 0)
      {
        ++this->NumberOfUnclearEdges;
        areUnclear[static_cast<std::size_t>(low)] = areUnclear[static_cast<std::size_t>(high)] = 1;
      }
    });
  this->FindKinds(areUnclear);
}

void DenseMesh::FindKinds(const std::vector<char>& areUnclear)
{
  this->Kinds.assign(this->Points.size(), Kind::FREE);
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    const LineTable::Ends& ends = this->LineEnds[v];
    const bool isOnLine = ends.size() == 2 && ends[0].Flags == ends[1].Flags;
    if (!ends.empty())
    {
      this->Kinds[v] = isOnLine && areUnclear[v] == 0 ? Kind::LINE : Kind::LOCKED;
    }
  }
}

void DenseMesh::LockFans()
{
  std::vector<int> numbers(this->Points.size(), 0);
  std::vector<int> corners(
    this->Points.size(), -1); // a corner per vertex, the first of an open fan
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const auto v = static_cast<std::size_t>(this->Triangles[t][c]);
      const int before = 3 * static_cast<int>(t) + (c + 2) % 3; // the half-edge that ends here
      ++numbers[v];
      if (corners[v] < 0 || this->Opposite[static_cast<std::size_t>(before)] < 0)
      {
        corners[v] = 3 * static_cast<int>(t) + c;
      }
    }
  }
  // From a corner of a triangle, the fan continues across the half-edge that starts there.
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    int number = 0;
    int corner = corners[v];
    const int start = corner;
    while (corner >= 0)
    {
      ++number;
      const int opposite = this->Opposite[static_cast<std::size_t>(corner)]; // starts at c
      corner = opposite < 0 ? -1 : opposite / 3 * 3 + (opposite % 3 + 1) % 3;
      if (corner == start)
      {
        break;
      }
    }
    if (number != numbers[v])
    {
      this->Kinds[v] = Kind::LOCKED;
    }
  }
}

void DenseMesh::LockFixed(vtkDataArray* fixed)
{
  this->AreFixed.assign(this->Points.size(), 0);
  const bool haveDirections = fixed->GetNumberOfComponents() == 4;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Triangle wedges = this->GetWedges(t);
    for (int c = 0; c < 3; ++c)
    {
      const double value = fixed->GetComponent(wedges[c], 0);
      unsigned char& mark = this->AreFixed[static_cast<std::size_t>(this->Triangles[t][c])];
      if (value != 0.0 && mark != FixedMark)
      {
        mark = value == RemovableMark ? RemovableMark : FixedMark;
        const vec3 direction = haveDirections
          ? vec3(fixed->GetComponent(wedges[c], 1), fixed->GetComponent(wedges[c], 2),
              fixed->GetComponent(wedges[c], 3))
          : vec3(0.0f);
        if (direction != vec3(0.0f))
        {
          this->FixedDirections[this->Triangles[t][c]] =
            direction / static_cast<float>(this->Scale);
        }
      }
    }
  }
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    const LineTable::Ends& ends = this->LineEnds[v];
    const bool isRemovable = this->AreFixed[v] == RemovableMark && this->Kinds[v] == Kind::LINE &&
      ends[0].Flags == BORDER && this->IsFixed(ends[0].Vertex) && this->IsFixed(ends[1].Vertex);
    if (this->AreFixed[v] != 0 && !isRemovable)
    {
      this->Kinds[v] = Kind::LOCKED;
    }
  }
}
}
