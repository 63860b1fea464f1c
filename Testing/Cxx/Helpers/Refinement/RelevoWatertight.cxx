// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoWatertight.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstring>
#include <set>

namespace RelevoWatertight
{
std::vector<vtkIdType> Weld(vtkPoints* points, bool value)
{
  std::map<std::array<std::uint64_t, 3>, vtkIdType> lowest;
  std::vector<vtkIdType> result;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    std::array<std::uint64_t, 3> key;
    for (int c = 0; c < 3; ++c)
    {
      const double x = value ? p[c] + 0.0 : p[c];
      std::memcpy(&key[c], &x, sizeof(x));
    }
    result.push_back(lowest.emplace(key, i).first->second);
  }
  return result;
}

void Use(EdgeUses& edges, vtkIdType a, vtkIdType b)
{
  Uses& uses = edges[{ std::min(a, b), std::max(a, b) }];
  ++(a < b ? uses.first : uses.second);
}

std::vector<std::array<vtkIdType, 3>> GetTriangles(
  vtkPolyData* mesh, const std::vector<vtkIdType>& places)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (places[a] != places[b] && places[b] != places[c] && places[a] != places[c])
    {
      triangles.push_back({ { a, b, c } });
    }
  };
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    polys->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      add(ids[0], ids[i], ids[i + 1]);
    }
  }
  auto strips = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    strips->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      i % 2 ? add(ids[i + 1], ids[i], ids[i + 2]) : add(ids[i], ids[i + 1], ids[i + 2]);
    }
  }
  return triangles;
}

int GetLevel(const std::vector<double>& tags, vtkIdType a, vtkIdType b, int maximumLevel)
{
  const double mean = tags.empty() ? maximumLevel : std::floor(0.5 * (tags[a] + tags[b]) + 0.5);
  return static_cast<int>(std::min<double>(std::max(mean, 0.0), maximumLevel));
}

namespace
{
// Compares a coarse and a fine mesh. Each step returns an error message, which is empty on success.
class Comparison
{
public:
  Comparison(vtkPolyData* coarse, vtkPolyData* fine, int maximumLevel)
    : MergedPoints(Weld(coarse->GetPoints(), true))
    , Welded(Weld(fine->GetPoints(), false))
    , CoarseTriangles(GetTriangles(coarse, this->MergedPoints))
    , MaximumLevel(maximumLevel)
  {
    if (vtkDataArray* array = coarse->GetPointData()->GetArray("DepthTag"))
    {
      this->Tags.assign(this->MergedPoints.size(), -1e300);
      for (size_t i = 0; i < this->MergedPoints.size(); ++i)
      {
        double& tag = this->Tags[this->MergedPoints[i]];
        tag = std::max(tag, array->GetComponent(i, 0));
      }
    }
  }

  // Every merged coarse point must be one point of the fine mesh.
  std::string FindCorners();
  std::string FindFineEdges(vtkPolyData* fine, bool morphing);
  // Edges that are not used once in each direction must be pieces of coarse edges with the same
  // uses.
  std::string CompareOpenEdges();
  // Nothing is missing or duplicated: Euler's V - E + F is the same before and after.
  std::string CompareEuler() const;

private:
  Uses GetFineUses(vtkIdType from, vtkIdType to);
  bool HasPath(vtkIdType from, vtkIdType next, vtkIdType to, int segments, const Uses& uses);

  std::vector<vtkIdType> MergedPoints; // by coarse point
  std::vector<vtkIdType> Welded;       // by fine point
  std::vector<std::array<vtkIdType, 3>> CoarseTriangles;
  std::vector<double> Tags; // by merged point
  int MaximumLevel;

  std::map<vtkIdType, vtkIdType> Corners; // from merged coarse point to welded fine point
  std::set<vtkIdType> IsCorner;
  EdgeUses CoarseEdges;

  EdgeUses FineEdges;
  size_t NumberOfTriangles = 0;
  std::map<vtkIdType, std::vector<vtkIdType>> Open; // the other ends of each point's open edges
};

std::string Comparison::FindCorners()
{
  for (const auto& triangle : this->CoarseTriangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType place = this->MergedPoints[triangle[i]];
      const vtkIdType point = this->Welded[triangle[i]];
      const auto known = this->Corners.emplace(place, point);
      if (known.first->second != point)
      {
        return "points " + std::to_string(place) + " and " + std::to_string(triangle[i]) +
          " lie at one place and come apart";
      }
      this->IsCorner.insert(point);
      Use(this->CoarseEdges, place, this->MergedPoints[triangle[(i + 1) % 3]]);
    }
  }
  return this->IsCorner.size() == this->Corners.size() ? "" : "two places became one";
}

std::string Comparison::FindFineEdges(vtkPolyData* fine, bool morphing)
{
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(fine->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    polys->GetCurrentCell(size, ids);
    if (size != 3)
    {
      return "a cell that is no triangle";
    }
    const vtkIdType w[3] = { this->Welded[ids[0]], this->Welded[ids[1]], this->Welded[ids[2]] };
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0])
    {
      if (morphing)
      {
        continue;
      }
      return "a triangle with two corners at one place";
    }
    ++this->NumberOfTriangles;
    for (int i = 0; i < 3; ++i)
    {
      Use(this->FineEdges, w[i], w[(i + 1) % 3]);
    }
  }
  return "";
}

Uses Comparison::GetFineUses(vtkIdType from, vtkIdType to)
{
  const Uses uses = this->FineEdges[{ std::min(from, to), std::max(from, to) }];
  return from < to ? uses : Uses(uses.second, uses.first);
}

// Whether this many open edges with these uses lead from one corner via `next` to the other.
bool Comparison::HasPath(
  vtkIdType from, vtkIdType next, vtkIdType to, int segments, const Uses& uses)
{
  vtkIdType last = from;
  vtkIdType here = next;
  int length = 1;
  bool same = this->GetFineUses(last, here) == uses;
  while (same && !this->IsCorner.count(here) && this->Open[here].size() == 2 && length < segments)
  {
    const vtkIdType onward = this->Open[here][this->Open[here][0] == last ? 1 : 0];
    last = here;
    here = onward;
    same = this->GetFineUses(last, here) == uses;
    ++length;
  }
  return same && here == to && length == segments;
}

std::string Comparison::CompareOpenEdges()
{
  const Uses inside(1, 1);
  size_t numberOfOpen = 0;
  for (const auto& edge : this->FineEdges)
  {
    if (edge.second != inside)
    {
      this->Open[edge.first.first].push_back(edge.first.second);
      this->Open[edge.first.second].push_back(edge.first.first);
      ++numberOfOpen;
    }
  }
  for (const auto& edge : this->CoarseEdges)
  {
    if (edge.second == inside)
    {
      continue;
    }
    const vtkIdType from = this->Corners[edge.first.first];
    const vtkIdType to = this->Corners[edge.first.second];
    const int segments =
      1 << GetLevel(this->Tags, edge.first.first, edge.first.second, this->MaximumLevel);
    bool found = false;
    for (vtkIdType next : this->Open[from])
    {
      found |= this->HasPath(from, next, to, segments, edge.second);
    }
    if (!found)
    {
      return "the open or shared coarse edge " + std::to_string(edge.first.first) + " " +
        std::to_string(edge.first.second) + " is not " + std::to_string(segments) + " fine edges";
    }
    numberOfOpen -= segments;
  }
  return numberOfOpen == 0 ? ""
                           : std::to_string(numberOfOpen) + " fine edges that should not be open";
}

std::string Comparison::CompareEuler() const
{
  std::set<vtkIdType> used;
  for (const auto& edge : this->FineEdges)
  {
    used.insert(edge.first.first);
    used.insert(edge.first.second);
  }
  const auto euler = [](size_t v, size_t e, size_t f)
  { return static_cast<long>(v) - static_cast<long>(e) + static_cast<long>(f); };
  const long before =
    euler(this->Corners.size(), this->CoarseEdges.size(), this->CoarseTriangles.size());
  const long after = euler(used.size(), this->FineEdges.size(), this->NumberOfTriangles);
  return before == after
    ? ""
    : "Euler characteristic " + std::to_string(after) + ", not " + std::to_string(before);
}
}

std::string FindError(vtkPolyData* coarse, vtkPolyData* fine, int maximumLevel, bool morphing)
{
  Comparison comparison(coarse, fine, maximumLevel);
  std::string error = comparison.FindCorners();
  if (error.empty())
  {
    error = comparison.FindFineEdges(fine, morphing);
  }
  if (error.empty())
  {
    error = comparison.CompareOpenEdges();
  }
  return error.empty() ? comparison.CompareEuler() : error;
}
}
