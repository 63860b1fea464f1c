// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HangingFaces.h"

#include "Boxes/BoxTree.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
// Distances of points from faces, relative to the size of the face, and to coordinates. The latter
// are rounded to floats.
constexpr double OnFace = 1e-6;
constexpr double FloatRounding = 4.0 * std::numeric_limits<float>::epsilon();
constexpr double LargestRounding = 1e-3; // of the face's size
// The largest area of a smaller face, relative to the larger one.
constexpr double LargestShare = 0.9;
constexpr size_t LongestChain = 65;
constexpr int MaximumLevel = 6;

std::uint64_t GetKey(int a, int b)
{
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  return low << 32 | static_cast<std::uint64_t>(std::max(a, b));
}
}

// A face with its geometry: three or four distinct corners.
struct HangingFaces::Surface
{
  size_t Face;
  size_t Count = 0; // of corners
  std::array<int, 4> Corners;
  std::array<dvec3, 4> Points; // of the corners
  dvec3 Inside;
  dvec3 Center = dvec3(0.0);
  dvec3 Normal; // as long as the area
  double Area;
  double Tolerance;

  dvec3 GetPoint(double u, double v) const
  {
    return this->Count == 3 ? this->Points[0] + u * (this->Points[1] - this->Points[0]) +
        v * (this->Points[2] - this->Points[0])
                            : (1.0 - v) * ((1.0 - u) * this->Points[0] + u * this->Points[1]) +
        v * ((1.0 - u) * this->Points[3] + u * this->Points[2]);
  }

  // Whether a point is on the face, by Gauss-Newton steps.
  bool Contains(const dvec3& point) const
  {
    const double size = std::sqrt(this->Area);
    double u = 0.4;
    double v = 0.4;
    for (int i = 0; i < 8; ++i)
    {
      const dvec3 here = this->GetPoint(u, v);
      const dvec3 du = this->GetPoint(u + 0.5, v) - this->GetPoint(u - 0.5, v);
      const dvec3 dv = this->GetPoint(u, v + 0.5) - this->GetPoint(u, v - 0.5);
      const dvec3 miss = point - here;
      const double a = dot(du, du);
      const double b = dot(du, dv);
      const double c = dot(dv, dv);
      const double determinant = a * c - b * b;
      if (!(determinant > 0.0))
      {
        return false;
      }
      u += (c * dot(du, miss) - b * dot(dv, miss)) / determinant;
      v += (a * dot(dv, miss) - b * dot(du, miss)) / determinant;
    }
    const double margin = this->Tolerance / size;
    const double most = this->Count == 3 ? 1.0 - u : 1.0;
    return u >= -margin && v >= -margin && u <= 1.0 + margin && v <= most + margin &&
      length(point - this->GetPoint(u, v)) <= this->Tolerance;
  }

  // Whether another face is a part of this one, with its cell on the other side.
  bool Covers(const Surface& other) const
  {
    const double side = dot(this->Normal, this->Inside - other.Center);
    const double otherSide = dot(this->Normal, other.Inside - other.Center);
    return other.Area < LargestShare * this->Area && side * otherSide < 0.0 &&
      std::all_of(other.Points.begin(), other.Points.begin() + other.Count,
        [this](const dvec3& point) { return this->Contains(point); });
  }
};

void HangingFaces::Find(const Mesh& mesh, const std::vector<size_t>& border)
{
  std::vector<Surface> surfaces;
  surfaces.reserve(border.size());
  double largest = 0.0;
  for (size_t face : border)
  {
    Surface surface;
    surface.Face = face;
    for (int corner : mesh.GetFace(face))
    {
      const auto end = surface.Corners.begin() + surface.Count;
      if (corner >= 0 && std::find(surface.Corners.begin(), end, corner) == end)
      {
        surface.Corners[surface.Count] = corner;
        surface.Points[surface.Count] = mesh.GetPoint(corner);
        surface.Center += surface.Points[surface.Count];
        ++surface.Count;
      }
    }
    const size_t count = surface.Count;
    if (count < 3)
    {
      continue;
    }
    surface.Center /= static_cast<double>(count);
    surface.Inside = mesh.GetInside(face);
    const dvec3 across = surface.Points[2] - surface.Points[0];
    surface.Normal = count == 3 ? 0.5 * cross(surface.Points[1] - surface.Points[0], across)
                                : 0.5 * cross(across, surface.Points[3] - surface.Points[1]);
    surface.Area = length(surface.Normal);
    if (!(surface.Area > 0.0) || !std::isfinite(surface.Area))
    {
      continue;
    }
    for (size_t i = 0; i < count; ++i)
    {
      const dvec3 size = abs(surface.Points[i]);
      largest = std::max({ largest, size.x, size.y, size.z });
    }
    surfaces.push_back(surface);
  }
  for (Surface& surface : surfaces)
  {
    const double size = std::sqrt(surface.Area);
    surface.Tolerance = std::min(OnFace * size + FloatRounding * largest, LargestRounding * size);
  }
  this->FindParts(surfaces);
  this->FindEdges(mesh, surfaces);
  for (Cover& cover : this->Covers)
  {
    cover.Face = surfaces[cover.Face].Face;
    for (size_t& part : cover.Parts)
    {
      part = surfaces[part].Face;
    }
  }
}

// Sets the indices of surfaces in the covers.
void HangingFaces::FindParts(const std::vector<Surface>& surfaces)
{
  std::vector<DoubleBox> boxes(surfaces.size());
  for (size_t i = 0; i < surfaces.size(); ++i)
  {
    for (size_t corner = 0; corner < surfaces[i].Count; ++corner)
    {
      const dvec3 low = surfaces[i].Points[corner] - surfaces[i].Tolerance;
      const dvec3 high = surfaces[i].Points[corner] + surfaces[i].Tolerance;
      boxes[i].Add(&low.x);
      boxes[i].Add(&high.x);
    }
  }
  DoubleBoxTree tree;
  tree.Build(boxes);
  constexpr vtkIdType none = -1;
  std::vector<vtkIdType> larger(surfaces.size(), none);
  vtkSMPTools::For(0, static_cast<vtkIdType>(surfaces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Surface& part = surfaces[i];
        DoubleBox place;
        place.Add(&part.Center.x);
        double nearest = 0.0;
        tree.Visit(
          nearest, [&](const DoubleBox& box, double) { return box.Intersects(place) ? 0.0 : 1.0; },
          [&](vtkIdType other)
          {
            const bool isSmaller =
              larger[i] == none || surfaces[other].Area < surfaces[larger[i]].Area;
            if (other != i && isSmaller && surfaces[other].Covers(part))
            {
              larger[i] = other;
            }
          });
      }
    });
  std::unordered_map<vtkIdType, size_t> known;
  for (size_t i = 0; i < surfaces.size(); ++i)
  {
    // Cells overlap if the larger face is a part, too.
    if (larger[i] == none || larger[larger[i]] != none)
    {
      continue;
    }
    const auto [cover, isNew] = known.insert({ larger[i], this->Covers.size() });
    if (isNew)
    {
      this->Covers.push_back({ static_cast<size_t>(larger[i]), {} });
    }
    this->Covers[cover->second].Parts.push_back(i);
  }
  const auto isIncomplete = [&](const Cover& cover)
  {
    double rest = surfaces[cover.Face].Area;
    double least = rest;
    for (size_t part : cover.Parts)
    {
      rest -= surfaces[part].Area;
      least = std::min(least, surfaces[part].Area);
    }
    return rest > 0.5 * least;
  };
  this->Covers.erase(
    std::remove_if(this->Covers.begin(), this->Covers.end(), isIncomplete), this->Covers.end());
}

void HangingFaces::FindEdges(const Mesh& mesh, const std::vector<Surface>& surfaces)
{
  std::vector<std::pair<double, int>> hanging;
  for (const Cover& cover : this->Covers)
  {
    const Surface& surface = surfaces[cover.Face];
    for (size_t i = 0; i < surface.Count; ++i)
    {
      const int corner = surface.Corners[i];
      const int next = surface.Corners[(i + 1) % surface.Count];
      const int low = std::min(corner, next);
      const int high = std::max(corner, next);
      const dvec3 begin = mesh.GetPoint(low);
      const dvec3 along = mesh.GetPoint(high) - begin;
      hanging.clear();
      const auto add = [&](int point)
      {
        const dvec3 from = mesh.GetPoint(point) - begin;
        const double at = dot(from, along) / dot(along, along);
        const bool isInside = point != low && point != high && at > 0.0 && at < 1.0;
        if (isInside && length(from - at * along) <= surface.Tolerance)
        {
          hanging.push_back({ at, point });
        }
      };
      for (size_t part : cover.Parts)
      {
        const auto& corners = surfaces[part].Corners;
        std::for_each(corners.begin(), corners.begin() + surfaces[part].Count, add);
      }
      Chain& chain = this->Edges[GetKey(low, high)];
      std::for_each(chain.begin(), chain.end(), add); // of the other faces of the edge
      std::sort(hanging.begin(), hanging.end());
      hanging.erase(std::unique(hanging.begin(), hanging.end()), hanging.end());
      chain.clear();
      std::transform(hanging.begin(), hanging.end(), std::back_inserter(chain),
        [](const auto& point) { return point.second; });
    }
  }
  std::vector<Chain> wholes;
  for (auto edge = this->Edges.begin(); edge != this->Edges.end();)
  {
    if (edge->second.empty())
    {
      edge = this->Edges.erase(edge);
      continue;
    }
    wholes.push_back(edge->second);
    wholes.back().insert(wholes.back().begin(), static_cast<int>(edge->first >> 32));
    wholes.back().push_back(static_cast<int>(edge->first & 0xffffffffu));
    ++edge;
  }
  for (const Chain& whole : wholes)
  {
    this->AddPieces(whole);
  }
  for (auto& edge : this->Edges)
  {
    edge.second = this->Expand(
      static_cast<int>(edge.first >> 32), static_cast<int>(edge.first & 0xffffffffu), 0);
  }
}

// Smaller cells may have longer pieces of the edge, and no other hanging face there.
void HangingFaces::AddPieces(const Chain& whole)
{
  for (size_t i = 0; i < whole.size() && whole.size() <= LongestChain; ++i)
  {
    for (size_t j = i + 2; j < whole.size(); ++j)
    {
      Chain piece(whole.begin() + i + 1, whole.begin() + j);
      if (whole[i] > whole[j])
      {
        std::reverse(piece.begin(), piece.end());
      }
      Chain& known = this->Edges[GetKey(whole[i], whole[j])];
      known = piece.size() > known.size() ? piece : known;
    }
  }
}

// Returns the points inside of an edge with those of its pieces, from a to b.
HangingFaces::Chain HangingFaces::Expand(int a, int b, int level) const
{
  Chain all;
  const Chain own = this->GetPoints(a, b);
  int from = a;
  for (size_t i = 0; i <= own.size() && !own.empty() && level < MaximumLevel; ++i)
  {
    const int to = i < own.size() ? own[i] : b;
    const Chain piece = this->Expand(from, to, level + 1);
    all.insert(all.end(), piece.begin(), piece.end());
    if (to != b)
    {
      all.push_back(to);
    }
    from = to;
  }
  return all;
}

std::vector<int> HangingFaces::GetPoints(int a, int b) const
{
  const auto found = this->Edges.find(GetKey(a, b));
  std::vector<int> points = found == this->Edges.end() ? Chain() : found->second;
  if (a > b)
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}
}
