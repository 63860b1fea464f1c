// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/SurfaceSampling.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double RangeOfEdge = 0.6; // of displacements, relative to the longest edge

class Sampler
{
public:
  Sampler(const MicroMesh& mesh, const TriangleTree& surface)
    : Mesh(mesh)
    , Surface(surface)
  {
  }

  // The displacement at weights of some corners. `hint` is a triangle near the sample.
  std::int16_t Sample(const MicroMesh::Face& face, const dvec3& weights, double range) const
  {
    dvec3 point(0.0);
    dvec3 direction(0.0);
    for (int c = 0; c < 3; ++c)
    {
      const auto corner = static_cast<std::size_t>(face.Corners[c]);
      point += weights[c] * this->Mesh.Points[corner];
      direction += weights[c] * dvec3(this->Mesh.Directions[corner]);
    }
    const double squared = dot(direction, direction);
    if (!(squared > 0.0))
    {
      return 0;
    }
    double t = 0.0;
    int triangle = -1;
    if (!this->Surface.Intersect(point, direction, range / std::sqrt(squared), t, triangle))
    {
      double distance2 = range * range;
      this->Surface.FindNearest(point, distance2, triangle);
      t = triangle < 0
        ? 0.0
        : dot(this->Surface.GetNearestPoint(point, triangle) - point, direction) / squared;
    }
    constexpr double most = std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(std::max(-most, std::min(most, std::round(t))));
  }

  double GetRange(const MicroMesh::Face& face, int edge = -1) const
  {
    double longest2 = 0.0;
    for (int e = 0; e < 3; ++e)
    {
      const dvec3 side = this->Mesh.Points[static_cast<std::size_t>(face.Corners[(e + 1) % 3])] -
        this->Mesh.Points[static_cast<std::size_t>(face.Corners[e])];
      longest2 = edge < 0 || e == edge ? std::max(longest2, dot(side, side)) : longest2;
    }
    return RangeOfEdge * std::sqrt(longest2);
  }

private:
  const MicroMesh& Mesh;
  const TriangleTree& Surface;
};

// The corner of the face and its edge where the samples of an edge start, for all edges.
std::vector<std::pair<int, int>> FindOwners(const MicroMesh& mesh)
{
  std::vector<std::pair<int, int>> owners(mesh.Edges.size(), { -1, 0 });
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (int e = 0; e < 3; ++e)
    {
      std::pair<int, int>& owner = owners[static_cast<std::size_t>(mesh.Faces[f].Edges[e] >> 1)];
      owner = owner.first < 0 ? std::make_pair(static_cast<int>(f), e) : owner;
    }
  }
  return owners;
}

// The place of a sample of an edge on the grid of a face with n segments.
GridPoint GetEdgePoint(const MicroMesh::Face& face, int e, int n, int place)
{
  GridPoint point{};
  const bool isReversed = (face.Edges[e] & 1) != 0;
  point[(e + 1) % 3] = isReversed ? n - place : place;
  point[e] = n - point[(e + 1) % 3];
  return point;
}

double GetDeviation2(const std::vector<dvec3>& positions, int n, const GridPoint& point, int stride)
{
  const GridCell cell = FindGridCell(point, stride);
  dvec3 interpolated(0.0);
  for (int c = 0; c < 3; ++c)
  {
    if (cell.Shares[c] > 0)
    {
      GridPoint corner = cell.Corners[c];
      for (int& number : corner)
      {
        number *= stride;
      }
      interpolated += double(cell.Shares[c]) / double(stride) *
        positions[static_cast<std::size_t>(GetGridIndex(n, corner))];
    }
  }
  const dvec3 offset = positions[static_cast<std::size_t>(GetGridIndex(n, point))] - interpolated;
  return dot(offset, offset);
}

// Whether a grid, or its edge e, deviates by at most a distance from that with a stride.
bool IsWithin(const std::vector<dvec3>& positions, int n, int stride, int e, double deviation2)
{
  bool isWithin = true;
  ForEachGridPoint(n,
    [&](const GridPoint& point)
    {
      const bool isAsked = e < 0 || point[(e + 2) % 3] == 0;
      isWithin = isWithin && (!isAsked || GetDeviation2(positions, n, point, stride) <= deviation2);
    });
  return isWithin;
}

// The lowest level of a grid, or of its edge e, that deviates from the grid by at most a distance.
int FindLevel(const std::vector<dvec3>& positions, int highest, int e, double deviation2)
{
  const int n = 1 << highest;
  int level = 0;
  while (level < highest && !IsWithin(positions, n, n >> level, e, deviation2))
  {
    ++level;
  }
  return level;
}

void CopySamples(const MicroMesh& fine, MicroMesh& coarse)
{
  for (std::size_t e = 0; e < fine.Edges.size(); ++e)
  {
    const int stride = 1 << (fine.Edges[e].Level - coarse.Edges[e].Level);
    for (int i = 1; i < 1 << coarse.Edges[e].Level; ++i)
    {
      coarse.Samples[static_cast<std::size_t>(coarse.Edges[e].First + i - 1)] =
        fine.Samples[static_cast<std::size_t>(fine.Edges[e].First + i * stride - 1)];
    }
  }
  for (std::size_t f = 0; f < fine.Faces.size(); ++f)
  {
    const int n = 1 << coarse.Faces[f].Level;
    const int stride = 1 << (fine.Faces[f].Level - coarse.Faces[f].Level);
    ForEachGridPoint(n,
      [&](const GridPoint& point)
      {
        if (GetGridEdge(point) < 0)
        {
          const GridPoint place{ { point[0] * stride, point[1] * stride, point[2] * stride } };
          const int from = fine.Faces[f].FirstInner + GetInnerIndex(n * stride, place);
          const int to = coarse.Faces[f].FirstInner + GetInnerIndex(n, point);
          coarse.Samples[static_cast<std::size_t>(to)] =
            fine.Samples[static_cast<std::size_t>(from)];
        }
      });
  }
}
}

void NumberSamples(MicroMesh& mesh)
{
  int number = 0;
  for (MicroMesh::Edge& edge : mesh.Edges)
  {
    edge.First = number;
    number += (1 << edge.Level) - 1;
  }
  for (MicroMesh::Face& face : mesh.Faces)
  {
    face.FirstInner = number;
    number += face.Level > 0 ? GetNumberOfInnerPoints(1 << face.Level) : 0;
  }
  mesh.Samples.assign(static_cast<std::size_t>(number), 0);
}

SampledParts CopyEqualSamples(
  MicroMesh& mesh, const MicroMesh& before, const std::vector<int>& matches)
{
  SampledParts sampled{ std::vector<char>(mesh.Edges.size(), 0),
    std::vector<char>(mesh.Faces.size(), 0) };
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    if (matches[f] < 0)
    {
      continue;
    }
    const MicroMesh::Face& face = mesh.Faces[f];
    const MicroMesh::Face& last = before.Faces[static_cast<std::size_t>(matches[f])];
    std::array<bool, 3> isSame{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto corner = static_cast<std::size_t>(face.Corners[c]);
      const auto lastCorner = static_cast<std::size_t>(last.Corners[c]);
      isSame[c] = mesh.Directions[corner] == before.Directions[lastCorner] &&
        mesh.Points[corner] == before.Points[lastCorner];
    }
    for (std::size_t e = 0; e < 3; ++e)
    {
      const auto index = static_cast<std::size_t>(face.Edges[e] >> 1);
      const MicroMesh::Edge& edge = mesh.Edges[index];
      const MicroMesh::Edge& lastEdge = before.Edges[static_cast<std::size_t>(last.Edges[e] >> 1)];
      if (sampled.Edges[index] != 0 || !isSame[e] || !isSame[(e + 1) % 3] ||
        edge.Level != lastEdge.Level)
      {
        continue;
      }
      const bool isReversed = ((face.Edges[e] ^ last.Edges[e]) & 1) != 0;
      const int number = (1 << edge.Level) - 1;
      for (int i = 0; i < number; ++i)
      {
        mesh.Samples[static_cast<std::size_t>(edge.First + i)] =
          before
            .Samples[static_cast<std::size_t>(lastEdge.First + (isReversed ? number - 1 - i : i))];
      }
      sampled.Edges[index] = 1;
    }
    if (isSame[0] && isSame[1] && isSame[2] && face.Level == last.Level)
    {
      const int number = face.Level > 0 ? GetNumberOfInnerPoints(1 << face.Level) : 0;
      std::copy_n(
        before.Samples.begin() + last.FirstInner, number, mesh.Samples.begin() + face.FirstInner);
      sampled.Faces[f] = 1;
    }
  }
  return sampled;
}

bool SampleSurface(MicroMesh& mesh, const SampledParts& sampled, const TriangleTree& surface,
  const std::function<bool()>& isAborted)
{
  const Sampler sampler(mesh, surface);
  std::atomic<bool> hasStopped(false);
  const std::vector<std::pair<int, int>> owners = FindOwners(mesh);
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Edges.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      hasStopped = hasStopped || isAborted();
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        const MicroMesh::Edge& edge = mesh.Edges[i];
        const MicroMesh::Face& face = mesh.Faces[static_cast<std::size_t>(owners[i].first)];
        const int e = owners[i].second;
        const int n = 1 << edge.Level;
        for (int place = 1; place < n && sampled.Edges[i] == 0 && !hasStopped; ++place)
        {
          const GridPoint point = GetEdgePoint(face, e, n, place);
          mesh.Samples[static_cast<std::size_t>(edge.First + place - 1)] = sampler.Sample(
            face, dvec3(point[0], point[1], point[2]) / double(n), sampler.GetRange(face, e));
        }
      }
    });
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      hasStopped = hasStopped || isAborted();
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        if (sampled.Faces[f] != 0)
        {
          continue;
        }
        const MicroMesh::Face& face = mesh.Faces[f];
        const int n = 1 << face.Level;
        const double range = sampler.GetRange(face);
        ForEachGridPoint(n,
          [&](const GridPoint& point)
          {
            if (GetGridEdge(point) < 0 && !hasStopped)
            {
              mesh.Samples[static_cast<std::size_t>(face.FirstInner + GetInnerIndex(n, point))] =
                sampler.Sample(face, dvec3(point[0], point[1], point[2]) / double(n), range);
            }
          });
      }
    });
  return !hasStopped;
}

std::vector<char> FindUneven(const MicroMesh& mesh, double deviation)
{
  std::vector<char> areUneven(mesh.Faces.size(), 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        const MicroMesh::Face& face = mesh.Faces[f];
        if (face.Level > 0)
        {
          const std::vector<dvec3> positions = mesh.GetPositions(face);
          areUneven[f] = IsWithin(positions, 1 << face.Level, 2, -1, deviation * deviation) ? 0 : 1;
        }
      }
    });
  return areUneven;
}

MicroMesh ReduceLevels(const MicroMesh& mesh, const std::vector<double>& deviations)
{
  MicroMesh reduced = mesh;
  std::vector<double> ofEdges(mesh.Edges.size(), std::numeric_limits<double>::infinity());
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (int reference : mesh.Faces[f].Edges)
    {
      double& ofEdge = ofEdges[static_cast<std::size_t>(reference >> 1)];
      ofEdge = std::min(ofEdge, deviations[f]);
    }
  }
  const std::vector<std::pair<int, int>> owners = FindOwners(mesh);
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        const MicroMesh::Face& face = mesh.Faces[f];
        const std::vector<dvec3> positions = mesh.GetPositions(face);
        reduced.Faces[f].Level =
          FindLevel(positions, face.Level, -1, deviations[f] * deviations[f]);
        for (int e = 0; e < 3; ++e)
        {
          const auto index = static_cast<std::size_t>(face.Edges[e] >> 1);
          if (owners[index] == std::make_pair(static_cast<int>(f), e))
          {
            reduced.Edges[index].Level = std::min(mesh.Edges[index].Level,
              FindLevel(positions, face.Level, e, ofEdges[index] * ofEdges[index]));
          }
        }
      }
    });
  for (MicroMesh::Face& face : reduced.Faces)
  {
    for (int reference : face.Edges)
    {
      face.Level =
        std::max(face.Level, reduced.Edges[static_cast<std::size_t>(reference >> 1)].Level);
    }
  }
  NumberSamples(reduced);
  CopySamples(mesh, reduced);
  return reduced;
}
}
