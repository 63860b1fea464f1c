// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/EdgeCollapse.h"

#include "Base/LineSimplification.h"
#include "Dense/FreeMemory.h"
#include "Distance/SegmentDistance.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace relevo
{
namespace
{
// The weight of the length of a step, so that flat regions get triangles of similar size.
constexpr double LengthWeight = 1e-3;
// Cosines between a new triangle's normal and its old normal, and the mean normals at its corners.
constexpr double LeastTurn = 0.2;
constexpr double LeastFacing = 0.25;
// Twice the area relative to the square of the longest side; 0.87 for equilateral triangles.
constexpr double LeastQuality = 0.1;
// Around vertices with worse triangles, the quality of new triangles relative to the worst.
constexpr double KeptQuality = 0.8;

int FindCorner(const DenseMesh::Triangle& triangle, int vertex)
{
  return triangle[0] == vertex ? 0 : (triangle[1] == vertex ? 1 : (triangle[2] == vertex ? 2 : -1));
}

double GetLongestSide2(const dvec3& a, const dvec3& b, const dvec3& c)
{
  return std::max({ dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c) });
}
}

EdgeCollapse::EdgeCollapse(
  const DenseMesh& mesh, const std::vector<int>& limits, double lineTolerance)
  : Mesh(mesh)
  , LineTolerance2(lineTolerance * lineTolerance)
  , AreKept(FindLineVertices(mesh, lineTolerance))
  , Triangles(mesh.Triangles)
  , Wedges(mesh.GetAllWedges())
  , AreLeft(mesh.Triangles.size(), 1)
  , NumberLeft(mesh.Triangles.size())
  , NextUses(3 * mesh.Triangles.size(), -1)
  , FirstUses(mesh.Points.size(), -1)
  , Quadrics(mesh.Points.size())
  , Normals(mesh.Points.size(), vec3(0.0f))
  , Roots(mesh.Points.size())
  , Sizes(mesh.Points.size(), 1)
  , Limits(limits)
  , Targets(mesh.Points.size(), -1)
  , Stamps(mesh.Points.size(), 0)
  , AreQueued(mesh.Points.size(), 0)
  , Marks(mesh.Points.size(), 0)
  , LineEnds(mesh.LineEnds)
{
  std::iota(this->Roots.begin(), this->Roots.end(), 0);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const dvec3 normal = mesh.GetNormal(this->Triangles[t]);
    for (int c = 0; c < 3; ++c)
    {
      const int vertex = this->Triangles[t][c];
      const auto v = static_cast<std::size_t>(vertex);
      this->AddUse(vertex, 3 * static_cast<int>(t) + c);
      this->Quadrics[v].Add(normal);
      this->Normals[v] += vec3(normal);
    }
  }
}

void EdgeCollapse::FreeMesh()
{
  FreeMemory(this->AreKept);
  FreeMemory(this->Triangles);
  FreeMemory(this->Wedges);
  FreeMemory(this->AreLeft);
  FreeMemory(this->NextUses);
  FreeMemory(this->FirstUses);
  FreeMemory(this->Quadrics);
  FreeMemory(this->Normals);
  FreeMemory(this->Limits);
  FreeMemory(this->Targets);
  FreeMemory(this->Stamps);
  FreeMemory(this->AreQueued);
  FreeMemory(this->Marks);
  this->LineEnds = LineTable();
  FreeMemory(this->Done);
  FreeMemory(this->Steps);
}

void EdgeCollapse::RemoveUse(int vertex, int use)
{
  int* place = &this->FirstUses[static_cast<std::size_t>(vertex)];
  while (*place != use)
  {
    place = &this->NextUses[static_cast<std::size_t>(*place)];
  }
  *place = this->NextUses[static_cast<std::size_t>(use)];
}

int EdgeCollapse::GetNumberOfTriangles(int root) const
{
  int number = 0;
  this->ForEachUse(root, [&](std::size_t, int) { ++number; });
  return number;
}

int EdgeCollapse::FindRoot(int vertex)
{
  auto v = static_cast<std::size_t>(vertex);
  while (this->Roots[v] != static_cast<int>(v))
  {
    this->Roots[v] = this->Roots[static_cast<std::size_t>(this->Roots[v])];
    v = static_cast<std::size_t>(this->Roots[v]);
  }
  return static_cast<int>(v);
}

unsigned char EdgeCollapse::GetLineFlags(int a, int b) const
{
  for (const LineEnd& end : this->LineEnds[static_cast<std::size_t>(a)])
  {
    if (end.Vertex == b)
    {
      return end.Flags;
    }
  }
  return 0;
}

// Marks the vertex and its neighbours with Mark.
void EdgeCollapse::FindNeighbours(int vertex, std::vector<int>& neighbours)
{
  neighbours.clear();
  ++this->Mark;
  this->Marks[static_cast<std::size_t>(vertex)] = this->Mark;
  this->ForEachUse(vertex,
    [&](std::size_t t, int)
    {
      for (int corner : this->Triangles[t])
      {
        int& mark = this->Marks[static_cast<std::size_t>(corner)];
        if (mark != this->Mark)
        {
          mark = this->Mark;
          neighbours.push_back(corner);
        }
      }
    });
}

double EdgeCollapse::GetError(int from, int to) const
{
  const auto u = static_cast<std::size_t>(from);
  const auto v = static_cast<std::size_t>(to);
  const dvec3& place = this->Mesh.Points[v];
  const dvec3 way = place - this->Mesh.Points[u];
  return std::max(0.0, this->Quadrics[u].Evaluate(way) + this->Quadrics[v].Evaluate(dvec3(0.0))) +
    LengthWeight * this->Quadrics[u].GetArea() * dot(way, way);
}

// A lower bound of the error of all steps of a vertex.
double EdgeCollapse::GetLeastError(int vertex) const
{
  double least = std::numeric_limits<double>::infinity();
  this->ForEachUse(vertex,
    [&](std::size_t t, int)
    {
      for (int corner : this->Triangles[t])
      {
        least = corner == vertex ? least : std::min(least, this->GetError(vertex, corner));
      }
    });
  return least;
}

bool EdgeCollapse::CanMove(int vertex) const
{
  const auto u = static_cast<std::size_t>(vertex);
  return !this->IsKept(vertex) && this->Sizes[u] < this->Limits[u];
}

bool EdgeCollapse::HasSize(int from, int to) const
{
  const auto u = static_cast<std::size_t>(from);
  const auto v = static_cast<std::size_t>(to);
  const int limit = std::min(this->Limits[u], this->Limits[v]);
  return this->Sizes[u] <= limit - this->Sizes[v];
}

void EdgeCollapse::Evaluate(int vertex)
{
  const auto u = static_cast<std::size_t>(vertex);
  this->Targets[u] = -1;
  this->AreQueued[u] = 0;
  if (!this->CanMove(vertex))
  {
    return;
  }
  if (this->Mesh.Kinds[u] == DenseMesh::Kind::LINE)
  {
    this->Neighbours = { this->LineEnds[u][0].Vertex, this->LineEnds[u][1].Vertex };
  }
  else
  {
    this->FindNeighbours(vertex, this->Neighbours);
  }
  this->Candidates.clear();
  for (int neighbour : this->Neighbours)
  {
    if (this->HasSize(vertex, neighbour))
    {
      this->Candidates.emplace_back(this->GetError(vertex, neighbour), neighbour);
    }
  }
  std::sort(this->Candidates.begin(), this->Candidates.end());
  for (const auto& candidate : this->Candidates)
  {
    if (this->IsLegal(vertex, candidate.second))
    {
      this->Targets[u] = candidate.second;
      this->AreQueued[u] = 1;
      this->Steps.push({ static_cast<float>(candidate.first), vertex, this->Stamps[u] });
      return;
    }
  }
}

bool EdgeCollapse::IsLegal(int from, int to)
{
  return this->HasSimpleLink(from, to) && this->KeepsLine(from, to) && this->KeepsShape(from, to) &&
    this->MapWedges(from, to);
}

// Whether the neighbours that both vertices share are only those of their common triangles, and no
// two triangles become the same.
bool EdgeCollapse::HasSimpleLink(int from, int to)
{
  this->FindNeighbours(from, this->Neighbours);
  std::size_t numberOfTriangles = 0;
  this->ForEachUse(from,
    [&](std::size_t t, int)
    { numberOfTriangles += FindCorner(this->Triangles[t], to) >= 0 ? 1 : 0; });
  const int ofFrom = this->Mark;
  const int ofTo = ++this->Mark;
  std::size_t numberOfCommon = 0;
  std::size_t numberOfOthers = 1; // the vertex that moves
  this->Marks[static_cast<std::size_t>(to)] = ofTo;
  this->Marks[static_cast<std::size_t>(from)] = ofTo;
  this->ForEachUse(to,
    [&](std::size_t t, int)
    {
      for (int corner : this->Triangles[t])
      {
        int& mark = this->Marks[static_cast<std::size_t>(corner)];
        if (mark != ofTo)
        {
          numberOfCommon += mark == ofFrom ? 1 : 0;
          ++numberOfOthers;
          mark = ofTo;
        }
      }
    });
  // The last triangles of a part, and those of a closed part of four vertices, are kept.
  return numberOfTriangles > 0 && numberOfTriangles < 3 && numberOfCommon == numberOfTriangles &&
    this->Neighbours.size() > 2 && numberOfOthers > numberOfTriangles + 1;
}

bool EdgeCollapse::KeepsShape(int from, int to) const
{
  const auto u = static_cast<std::size_t>(from);
  const auto v = static_cast<std::size_t>(to);
  const dvec3& place = this->Mesh.Points[v];
  const dvec3 merged(this->Normals[u] + this->Normals[v]);
  const double mergedLength = length(merged);
  const dvec3& place0 = this->Mesh.Points[u];
  double leastQuality = LeastQuality;
  this->ForEachUse(from,
    [&](std::size_t t, int)
    {
      const Triangle& triangle = this->Triangles[t];
      const dvec3& a = this->Mesh.Points[static_cast<std::size_t>(triangle[0])];
      const dvec3& b = this->Mesh.Points[static_cast<std::size_t>(triangle[1])];
      const dvec3& c = this->Mesh.Points[static_cast<std::size_t>(triangle[2])];
      leastQuality = std::min(
        leastQuality, KeptQuality * length(cross(b - a, c - a)) / GetLongestSide2(a, b, c));
    });
  for (int use = this->FirstUses[u]; use >= 0; use = this->NextUses[static_cast<std::size_t>(use)])
  {
    const Triangle& triangle = this->Triangles[static_cast<std::size_t>(use / 3)];
    if (FindCorner(triangle, to) >= 0)
    {
      continue;
    }
    const int corner = use % 3;
    const auto second = static_cast<std::size_t>(triangle[(corner + 1) % 3]);
    const auto third = static_cast<std::size_t>(triangle[(corner + 2) % 3]);
    const dvec3& b = this->Mesh.Points[second];
    const dvec3& c = this->Mesh.Points[third];
    const dvec3 normal = cross(b - place, c - place);
    const dvec3 old = cross(b - place0, c - place0);
    const double size = length(normal);
    if (!(size > 0.0) || size < leastQuality * GetLongestSide2(place, b, c) ||
      dot(normal, old) < LeastTurn * size * length(old) ||
      dot(normal, merged) < LeastFacing * size * mergedLength)
    {
      return false;
    }
    for (std::size_t w : { second, third })
    {
      const dvec3 facing(this->Normals[w]);
      const double cosine = dot(normal, facing) / (size * length(facing));
      const double before = dot(old, facing) / (length(old) * length(facing));
      if (cosine < LeastFacing && !(cosine >= before))
      {
        return false;
      }
    }
  }
  return true;
}

bool EdgeCollapse::KeepsLine(int from, int to) const
{
  const auto u = static_cast<std::size_t>(from);
  if (this->Mesh.Kinds[u] != DenseMesh::Kind::LINE)
  {
    return true;
  }
  const LineTable::Ends& ends = this->LineEnds[u];
  const int far = ends[0].Vertex == to ? ends[1].Vertex : ends[0].Vertex;
  // A line between these vertices exists already if the line is closed.
  return far != to && this->GetLineFlags(far, to) == 0 && this->IsLineWithin(from, far, to);
}

// Whether all vertices of the line through a vertex, from one coarse vertex to another, are within
// the tolerance of the segment between these.
bool EdgeCollapse::IsLineWithin(int vertex, int a, int b) const
{
  const dvec3& start = this->Mesh.Points[static_cast<std::size_t>(a)];
  const dvec3& end = this->Mesh.Points[static_cast<std::size_t>(b)];
  for (int side = 0; side < 2; ++side)
  {
    int before = vertex;
    int place = this->Mesh.LineEnds[static_cast<std::size_t>(vertex)][side].Vertex;
    if (side == 0 &&
      GetSegmentDistance2(this->Mesh.Points[static_cast<std::size_t>(vertex)], start, end) >
        this->LineTolerance2)
    {
      return false;
    }
    while (place != a && place != b)
    {
      const auto p = static_cast<std::size_t>(place);
      if (GetSegmentDistance2(this->Mesh.Points[p], start, end) > this->LineTolerance2)
      {
        return false;
      }
      const LineTable::Ends& ends = this->Mesh.LineEnds[p];
      const int next = ends[0].Vertex == before ? ends[1].Vertex : ends[0].Vertex;
      before = place;
      place = next;
    }
  }
  return true;
}

// Finds the points of the input for the corners that move. Fails at seams that the step would
// cross.
bool EdgeCollapse::MapWedges(int from, int to)
{
  this->WedgeMap.clear();
  if (this->Wedges.empty())
  {
    return true;
  }
  bool isUnique = true;
  const auto find = [this](int wedge)
  {
    return std::find_if(this->WedgeMap.begin(), this->WedgeMap.end(),
      [wedge](const std::pair<int, int>& known) { return known.first == wedge; });
  };
  this->ForEachUse(from,
    [&](std::size_t t, int source)
    {
      const int target = FindCorner(this->Triangles[t], to);
      if (target >= 0)
      {
        const std::pair<int, int> both(this->Wedges[t][source], this->Wedges[t][target]);
        const auto known = find(both.first);
        isUnique = isUnique && (known == this->WedgeMap.end() || known->second == both.second);
        this->WedgeMap.push_back(both);
      }
    });
  bool areKnown = true;
  this->ForEachUse(from,
    [&](std::size_t t, int source)
    { areKnown = areKnown && find(this->Wedges[t][source]) != this->WedgeMap.end(); });
  return isUnique && areKnown;
}

void EdgeCollapse::JoinLines(int from, int to)
{
  if (this->LineEnds[static_cast<std::size_t>(from)].empty())
  {
    return;
  }
  LineTable::Ends& ends = this->LineEnds.Get(static_cast<std::size_t>(from));
  const int far = ends[0].Vertex == to ? ends[1].Vertex : ends[0].Vertex;
  for (LineEnd& end : this->LineEnds.Get(static_cast<std::size_t>(far)))
  {
    end.Vertex = end.Vertex == from ? to : end.Vertex;
  }
  for (LineEnd& end : this->LineEnds.Get(static_cast<std::size_t>(to)))
  {
    end.Vertex = end.Vertex == from ? far : end.Vertex;
  }
  ends.clear();
}

void EdgeCollapse::Collapse(int from, int to)
{
  const auto u = static_cast<std::size_t>(from);
  const auto v = static_cast<std::size_t>(to);
  this->MapWedges(from, to);
  for (int use = this->FirstUses[u]; use >= 0;)
  {
    const int next = this->NextUses[static_cast<std::size_t>(use)];
    const auto index = static_cast<std::size_t>(use / 3);
    const int corner = use % 3;
    Triangle& triangle = this->Triangles[index];
    if (FindCorner(triangle, to) >= 0)
    {
      this->AreLeft[index] = 0;
      --this->NumberLeft;
      for (int other : { (corner + 1) % 3, (corner + 2) % 3 })
      {
        this->RemoveUse(triangle[other], use / 3 * 3 + other);
      }
    }
    else
    {
      triangle[corner] = to;
      this->AddUse(to, use);
      if (!this->Wedges.empty())
      {
        int& wedge = this->Wedges[index][corner];
        wedge = std::find_if(this->WedgeMap.begin(), this->WedgeMap.end(),
          [&](const std::pair<int, int>& known) {
            return known.first == wedge;
          })->second;
      }
    }
    use = next;
  }
  this->JoinLines(from, to);
  this->FirstUses[u] = -1;
  this->Quadrics[v].Add(this->Quadrics[u], this->Mesh.Points[u] - this->Mesh.Points[v]);
  this->Normals[v] += this->Normals[u];
  this->Sizes[v] += this->Sizes[u];
  this->Limits[v] = std::min(this->Limits[u], this->Limits[v]);
  this->Roots[u] = to;
  this->Done.emplace_back(from, to);
}

void EdgeCollapse::Repeat(const Moves& moves)
{
  // The steps at a vertex and at its neighbours depend on a step that is left out.
  std::vector<char> areChanged(this->Mesh.Points.size(), 0);
  for (const auto& move : moves)
  {
    char& isFrom = areChanged[static_cast<std::size_t>(move.first)];
    char& isTo = areChanged[static_cast<std::size_t>(move.second)];
    if (isFrom == 0 && isTo == 0 && this->HasSize(move.first, move.second))
    {
      this->Collapse(move.first, move.second);
      continue;
    }
    isFrom = isTo = 1;
    this->ForEachUse(move.first,
      [&](std::size_t t, int)
      {
        for (int corner : this->Triangles[t])
        {
          areChanged[static_cast<std::size_t>(corner)] = 1;
        }
      });
  }
}

bool EdgeCollapse::Run(std::size_t target, double& error, const std::function<bool(double)>& goOn)
{
  // Legal steps are found when the turn of a vertex comes.
  const auto number = static_cast<vtkIdType>(this->Mesh.Points.size());
  std::vector<float> errors(this->Mesh.Points.size(), std::numeric_limits<float>::infinity());
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto v = static_cast<int>(first); v < static_cast<int>(last); ++v)
      {
        const auto index = static_cast<std::size_t>(v);
        if (this->Roots[index] == v && this->CanMove(v))
        {
          errors[index] = static_cast<float>(this->GetLeastError(v));
        }
      }
    });
  std::vector<Step> steps;
  steps.reserve(static_cast<std::size_t>(
    std::count_if(errors.begin(), errors.end(), [&](float e) { return e <= error; })));
  this->Done.reserve(this->Mesh.Points.size());
  for (std::size_t v = 0; v < errors.size(); ++v)
  {
    if (errors[v] <= error)
    {
      steps.push_back({ errors[v], static_cast<int>(v), -1 });
      this->AreQueued[v] = 1;
    }
  }
  FreeMemory(errors);
  this->Steps = std::priority_queue<Step>(std::less<Step>(), std::move(steps));
  const std::size_t start = this->NumberLeft;
  double largest = 0.0;
  constexpr int interval = 4096; // steps between calls
  std::vector<int> ring;
  for (int i = 1; this->NumberLeft > target && !this->Steps.empty(); ++i)
  {
    if (i % interval == 0 &&
      !goOn(double(start - this->NumberLeft) / double(std::max<std::size_t>(1, start - target))))
    {
      return false;
    }
    const Step step = this->Steps.top();
    if (step.Error > error)
    {
      break;
    }
    this->Steps.pop();
    const auto u = static_cast<std::size_t>(step.Vertex);
    if (this->Roots[u] != step.Vertex)
    {
      continue;
    }
    if (this->Stamps[u] != step.Stamp)
    {
      this->Evaluate(step.Vertex);
      continue;
    }
    largest = std::max(largest, double(step.Error));
    const int to = this->Targets[u];
    this->Collapse(step.Vertex, to);
    this->FindNeighbours(to, ring);
    ring.push_back(to);
    for (int vertex : ring)
    {
      const auto v = static_cast<std::size_t>(vertex);
      ++this->Stamps[v];
      if (this->AreQueued[v] == 0)
      {
        this->AreQueued[v] = 1;
        this->Steps.push({ step.Error, vertex, -1 }); // evaluated when its turn comes
      }
    }
  }
  error = std::min(error, largest);
  return true;
}
}
