// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/GlobeFaces.h"

#include "Bisection/FaceHeights.h"
#include "Lattice/BlockErrors.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <iterator>
#include <utility>

namespace relevo
{
namespace
{
constexpr int GlobeSegments = TerrainFace::Segments;

// Apex coordinates are below 2^31 in units of the finest lattice, and steps have 16 combinations.
// The apex belongs to one level only: in units of a pattern, its column or its row is odd.
std::uint64_t GetFaceKey(const TerrainFace& face)
{
  const int level = face.Level - BlockErrors::FinestLevel;
  const auto getUnits = [&](int axis)
  { return static_cast<std::uint64_t>((face.Apex[axis] / GlobeSegments) << level); };
  const auto direction = static_cast<std::uint64_t>(3 * (face.Step1[1] + 1) + face.Step1[0] + 1);
  std::uint64_t key = face.IsPositive() ? 1u : 0u;
  key = key << 4 | direction;
  key = key << 28 | getUnits(0);
  return key << 28 | getUnits(1);
}

void LocateFace(const GlobeShape& shape, const TerrainFace& face, GlobeFaces::Vertices& vertices)
{
  std::array<double, GlobeFaces::VerticesPerFace> columns;
  std::array<double, GlobeFaces::VerticesPerFace> rows;
  for (int b = 0; b <= GlobeSegments; ++b)
  {
    for (int a = 0; a + b <= GlobeSegments; ++a)
    {
      const std::array<double, 2> sample = face.GetSample(a, b);
      columns[GlobeFaces::GetIndex(a, b)] = sample[0];
      rows[GlobeFaces::GetIndex(a, b)] = sample[1];
    }
  }
  shape.Locate(columns.size(), columns.data(), rows.data(), vertices.data());
}
}

void GlobeFaces::Update(const GlobeShape& shape, const std::vector<TerrainFace>& faces)
{
  ++this->Updates;
  this->Current.clear();
  std::vector<std::pair<const TerrainFace*, Vertices*>> missing;
  for (const TerrainFace& face : faces)
  {
    Entry& entry = this->Entries[GetFaceKey(face)];
    if (!entry.Data)
    {
      entry.Data = std::make_unique<Vertices>();
      missing.emplace_back(&face, entry.Data.get());
    }
    entry.LastUse = this->Updates;
    this->Current.push_back(entry.Data.get());
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(missing.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        LocateFace(shape, *missing[i].first, *missing[i].second);
      }
    });
  this->Computed += missing.size();
  if (this->Entries.size() > SpareFaces + faces.size() + faces.size() / 4)
  {
    for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
    {
      entry = entry->second.LastUse < this->Updates ? this->Entries.erase(entry) : std::next(entry);
    }
  }
}

std::array<double, 3> GlobeFaces::GetWorld(const TerrainFace& face, const Vertices& vertices,
  const TerrainPlacement& placement, int a, int b)
{
  const FaceHeights heights(face);
  const auto locate = [&](int i, int j, float height)
  {
    return vertices[GetIndex(i, j)].ToWorld(placement.HeightScale * height, placement.Exaggeration);
  };
  FaceHeights::AddedVertex added;
  if (!heights.FindAdded(a, b, added))
  {
    return locate(a, b, heights.GetHeight(a, b));
  }
  const int i = a % 2;
  const int j = b % 2;
  std::array<double, 3> world = locate(a, b, added.Target);
  const std::array<double, 3> before = locate(a - i, b - j, added.Sources[0]);
  const std::array<double, 3> after = locate(a + i, b + j, added.Sources[1]);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double source = 0.5 * (before[axis] + after[axis]);
    world[axis] = source + face.Morph * (world[axis] - source);
  }
  return world;
}

std::size_t GlobeFaces::GetMemorySize() const
{
  return this->Entries.size() * (sizeof(Vertices) + sizeof(std::pair<std::uint64_t, Entry>));
}

void GlobeFaces::Clear()
{
  this->Entries.clear();
  this->Current.clear();
}
}
