// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ReliefPatterns.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Buffers/ReliefTiles.h"
#include "Patterns/RefinementPattern.h"
#include "View/ReliefView.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr double NearEnough = 0.25;

// Return the lowest level whose triangles deviate at most by this distance.
unsigned char FindLevel(const ReliefTiles& tiles, vtkIdType tile, double allowed)
{
  const float* deviations = tiles.GetDeviations().data() + tile * ReliefTiles::HighestLevel;
  const float* found = std::find_if(deviations, deviations + ReliefTiles::HighestLevel,
    [=](float deviation) { return deviation <= allowed; });
  return static_cast<unsigned char>(found - deviations);
}

std::vector<unsigned char> FindLevels(const ReliefTiles& tiles, const ReliefView& view)
{
  std::vector<unsigned char> levels(tiles.GetNumberOfTiles());
  vtkSMPTools::For(0, tiles.GetNumberOfTiles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType tile = begin; tile < end; ++tile)
      {
        const vec4& place = tiles.GetPlaces()[tile];
        const dvec3 middle(
          dvec2(place.x, place.y) + 0.5 * ReliefTiles::Size, 0.5 * (place.z + place.w));
        const double pixels = view.GetPixels(middle);
        const double allowed = NearEnough * (pixels > 0.0 ? std::max(1.0, 1.0 / pixels) : 1.0);
        levels[tile] = FindLevel(tiles, tile, allowed);
      }
    });
  return levels;
}
}

double ReliefPatterns::CountTriangles(const ReliefTiles& tiles)
{
  double number = 0.0;
  for (vtkIdType tile = 0; tile < tiles.GetNumberOfTiles(); ++tile)
  {
    number += 2.0 * (1 << (2 * FindLevel(tiles, tile, NearEnough)));
  }
  return number;
}

// Create the 35 patterns of levels 0 to 4.
void ReliefPatterns::MakePatterns()
{
  const PatternLibrary library;
  for (int i = 0; i <= ReliefTiles::HighestLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        const auto pattern = library.GetPatternOfSegments(1 << i, 1 << j, 1 << k);
        this->Patterns.Require({ { i, j, k } }, pattern->GetNumberOfVertices(), 1,
          [&pattern](std::vector<unsigned int>& indices, int)
          { indices.insert(indices.end(), pattern->Triangles.begin(), pattern->Triangles.end()); });
        const std::vector<float>& weights = pattern->Vertices;
        for (size_t v = 0; v < weights.size(); v += 3)
        {
          this->VertexValues.insert(
            this->VertexValues.end(), { weights[v], weights[v + 1], weights[v + 2], 0.0f });
        }
      }
    }
  }
}

// The levels are those of the edges between corners 0 and 1, 1 and 2, 2 and 0. The permutation
// codes are those of relevoReliefPatternVS.glsl.
void ReliefPatterns::AddHalf(unsigned int half, const Levels& levels)
{
  for (int code = 0; code < 6; ++code)
  {
    const int first = code % 3;
    const int second = (first + (code < 3 ? 1 : 2)) % 3;
    const int third = 3 - first - second;
    const auto level = [&](int a, int b) { return levels[(a + 1) % 3 == b ? a : b]; };
    const Levels sorted = { { level(first, second), level(second, third), level(third, first) } };
    if (sorted[0] >= sorted[1] && sorted[1] >= sorted[2])
    {
      this->InstancesOfPatterns[sorted].push_back(half << 3 | static_cast<unsigned int>(code));
      this->NumberOfTriangles += this->Patterns.GetRanges().at(sorted).NumberOfIndices / 3;
      return;
    }
  }
}

bool ReliefPatterns::Select(
  vtkOpenGLRenderWindow* window, const ReliefTiles& tiles, const ReliefView& view)
{
  if (this->Patterns.IsEmpty())
  {
    this->MakePatterns();
  }
  if (!this->Patterns.IsUploaded() &&
    (!this->Patterns.Upload() || !this->Vertices.Upload(window, this->VertexValues, 4)))
  {
    return false;
  }
  for (auto& entry : this->InstancesOfPatterns)
  {
    entry.second.clear();
  }
  this->NumberOfTriangles = 0;
  const std::vector<unsigned char> levels = FindLevels(tiles, view);
  const size_t number = levels.size();
  // levels of each tile's left side; the others are analogous
  std::vector<unsigned char> left(levels);
  std::vector<unsigned char> lower(levels);
  std::vector<unsigned char> right(levels);
  std::vector<unsigned char> upper(levels);
  for (size_t tile = 0; tile < number; ++tile)
  {
    const ivec2 next = tiles.GetNeighbors()[tile];
    if (next.x >= 0)
    {
      right[tile] = left[next.x] = std::max(levels[tile], levels[next.x]);
    }
    if (next.y >= 0)
    {
      upper[tile] = lower[next.y] = std::max(levels[tile], levels[next.y]);
    }
  }
  for (size_t tile = 0; tile < number; ++tile)
  {
    const vec4& place = tiles.GetPlaces()[tile];
    const dvec2 corner(place.x, place.y);
    if (!view.MaySee(dvec3(corner, place.z), dvec3(corner + double(ReliefTiles::Size), place.w)))
    {
      continue;
    }
    const unsigned int half = static_cast<unsigned int>(tile) << 1;
    // The corners of the first half are lower left, upper right, upper left.
    this->AddHalf(half, { { levels[tile], upper[tile], left[tile] } });
    // The corners of the second half are lower left, lower right, upper right.
    this->AddHalf(half | 1, { { lower[tile], right[tile], levels[tile] } });
  }
  std::vector<unsigned int> instances;
  for (const auto& entry : this->InstancesOfPatterns)
  {
    instances.insert(instances.end(), entry.second.begin(), entry.second.end());
  }
  return this->Instances.Upload(window, instances);
}

void ReliefPatterns::Draw(vtkShaderProgram* program)
{
  this->Vertices.Activate(program, "reliefVertices");
  this->Instances.Activate(program, "reliefInstances");
  this->Patterns.Bind();
  int first = 0;
  for (const auto& entry : this->InstancesOfPatterns)
  {
    const int number = static_cast<int>(entry.second.size());
    if (number > 0)
    {
      const PatternRange& range = this->Patterns.GetRanges().at(entry.first);
      program->SetUniformi("reliefFirstInstance", first);
      glDrawElementsInstancedBaseVertex(GL_TRIANGLES, range.NumberOfIndices, GL_UNSIGNED_INT,
        decltype(this->Patterns)::GetOffset(range), number, range.FirstVertex);
      first += number;
    }
  }
  this->Patterns.Release();
}

void ReliefPatterns::Deactivate()
{
  this->Vertices.Deactivate();
  this->Instances.Deactivate();
}

vtkTypeInt64 ReliefPatterns::GetMemorySize() const
{
  return this->Vertices.GetMemorySize() + this->Instances.GetMemorySize() +
    this->Patterns.GetMemorySize();
}

void ReliefPatterns::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices.ReleaseGraphicsResources(window);
  this->Instances.ReleaseGraphicsResources(window);
  this->Patterns.ReleaseGraphicsResources();
}
}
