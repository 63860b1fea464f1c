// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/NestedPatternMesh.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace
{
using namespace relevo;

/// The finest grid has 2^7 steps and contains all vertices.
constexpr int FinestLevel = 7;
constexpr int Size = 1 << FinestLevel;

/// The coordinates (s, y) of relevoMorph.glsl.
struct Place
{
  int S;
  int Y;
};

constexpr int StepOf(int level)
{
  return Size >> level;
}

constexpr int RoundDown(int coordinate, int level)
{
  return coordinate & -StepOf(level);
}

/**
 * Builds the mesh of the finest of its levels. Vertices that do not exist yet are merged into the
 * vertex that they start from, and the degenerate triangles are removed.
 */
class NestedMeshMaker
{
public:
  explicit NestedMeshMaker(const std::array<int, 3>& levels)
    : Levels(levels)
    , Numbers((Size + 1) * (Size + 1), -1)
  {
    const auto [lowest, highest] = std::minmax_element(levels.begin(), levels.end());
    const int middle = levels[0] + levels[1] + levels[2] - *lowest - *highest;
    this->Highest = *highest;
    this->Inner = std::max(std::min(middle, *lowest + 1), FirstInner);
    this->AddBorderVertices();
    this->AddStrips();
    this->AddInside();
  }

  PatternMesh Mesh;

private:
  /// The first level with inner vertices.
  static constexpr int FirstInner = 2;

  void AddBorderVertices()
  {
    const int segments[3] = { 1 << this->Levels[0], 1 << this->Levels[1], 1 << this->Levels[2] };
    for (const PatternWeights& weights : MakeBorderVertices(segments, Size))
    {
      this->AddVertex({ static_cast<int>(weights[1] + weights[2]), static_cast<int>(weights[2]) });
    }
  }

  /// Add the triangles that have a side or a corner on an edge.
  void AddStrips()
  {
    const int level = std::max(this->Highest, FirstInner);
    const int n = 1 << level;
    const int step = StepOf(level);
    auto add = [&](Place a, Place b, Place c)
    {
      this->AddTriangle(
        { a.S * step, a.Y * step }, { b.S * step, b.Y * step }, { c.S * step, c.Y * step });
    };
    for (int k = 0; k < n; ++k)
    {
      const int i = std::clamp(k + 1, 2, n - 1); // of the grid's vertices next to edges 01 and 02
      add({ k, 0 }, { k + 1, 0 }, { i, 1 });
      add({ n, k }, { n, k + 1 }, { n - 1, std::clamp(k, 1, n - 2) });
      add({ k, k }, { i, i - 1 }, { k + 1, k + 1 });
    }
    for (int i = 2; i < n - 1; ++i)
    {
      add({ i, 0 }, { i + 1, 1 }, { i, 1 });
      add({ n - 1, i - 1 }, { n, i }, { n - 1, i });
      add({ i, i - 1 }, { i + 1, i }, { i, i });
    }
  }

  void AddInside()
  {
    const int step = StepOf(this->Inner);
    for (int y = step; y < Size; y += step)
    {
      for (int s = y + step; s < Size - step; s += step)
      {
        this->AddTriangle({ s, y }, { s + step, y }, { s + step, y + step });
        if (s > y + step)
        {
          this->AddTriangle({ s, y }, { s + step, y + step }, { s, y + step });
        }
      }
    }
  }

  void AddTriangle(Place a, Place b, Place c)
  {
    const std::array<int, 3> triangle = { this->GetVertex(a), this->GetVertex(b),
      this->GetVertex(c) };
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      this->Mesh.Triangles.push_back(triangle);
    }
  }

  /// Return the vertex at a position, of any level.
  int GetVertex(Place place)
  {
    place = this->GetOrigin(place);
    const int number = this->Numbers[IndexOf(place)];
    return number < 0 ? this->AddVertex(place) : number;
  }

  int AddVertex(Place place)
  {
    const int number = static_cast<int>(this->Mesh.Vertices.size());
    this->Numbers[IndexOf(place)] = number;
    constexpr std::int64_t unit = WeightScale / Size;
    this->Mesh.Vertices.push_back(
      { (Size - place.S) * unit, (place.S - place.Y) * unit, place.Y * unit });
    return number;
  }

  static std::size_t IndexOf(Place place)
  {
    return static_cast<std::size_t>(place.S * (Size + 1) + place.Y);
  }

  /// Return the position that relevoMorph.glsl computes for a vertex at the lowest tags of the
  /// levels.
  Place GetOrigin(Place place) const
  {
    if (place.Y == 0)
    {
      return { RoundDown(place.S, this->Levels[0]), 0 };
    }
    if (place.S == Size)
    {
      return { Size, RoundDown(place.Y, this->Levels[1]) };
    }
    if (place.S == place.Y)
    {
      const int s = RoundDown(place.S, this->Levels[2]);
      return { s, s };
    }
    const int step = StepOf(this->Inner);
    const int y = std::clamp(RoundDown(place.Y, this->Inner), step, Size - 2 * step);
    const int s = std::clamp(RoundDown(place.S, this->Inner), y + step, Size - step);
    return this->Highest < FirstInner ? this->GetFirstOrigin({ s, y }) : Place{ s, y };
  }

  /// Does the same for the inner vertices of level 2 if no edge has this level. If edges 01 and 02
  /// both have a midpoint, one vertex remains between the two.
  Place GetFirstOrigin(Place place) const
  {
    constexpr int half = Size / 2;
    if (place.S - place.Y == half)
    {
      return this->GetOrigin({ Size, half });
    }
    if (this->Levels[2] == 0)
    {
      return this->GetOrigin({ half, 0 });
    }
    return this->Levels[0] == 0 ? Place{ half, half } : Place{ half, half / 2 };
  }

  std::array<int, 3> Levels;
  int Highest;
  int Inner;
  /// The number of the vertex at each position; -1 if there is none yet.
  std::vector<int> Numbers;
};
}

namespace relevo
{
PatternMesh MakeNestedMesh(const std::array<int, 3>& levels)
{
  return std::move(NestedMeshMaker(levels).Mesh);
}
}
