// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/ContourAnchors.h"

#include "Bisection/AdaptiveTerrain.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace relevo
{
namespace
{
// The finest tiles are magnified in close views.
constexpr int CellsPerPart = 64;
constexpr int CellsPerFinestPart = 16;
// Labels need this distance of neighbouring lines, in cells.
constexpr double LineDistance = 3.0;
// How far an anchor moves to the line of another tile, in cells.
constexpr int Reach = 3;

// The height at a place in a tile, in vertices from its first one; NaN beside missing data.
double GetTileHeight(const HeightTile& tile, double x, double y)
{
  const int i = std::clamp(static_cast<int>(std::floor(x)), -1, HeightTile::CellsPerTile);
  const int j = std::clamp(static_cast<int>(std::floor(y)), -1, HeightTile::CellsPerTile);
  const auto mix = [](double a, double b, double t) { return t > 0.0 ? a + t * (b - a) : a; };
  const double u = x - i;
  const double v = y - j;
  // Vertices without weight may lack data.
  const double first = mix(tile.GetHeight(i, j), tile.GetHeight(i + 1, j), u);
  return v > 0.0 ? mix(first, mix(tile.GetHeight(i, j + 1), tile.GetHeight(i + 1, j + 1), u), v)
                 : first;
}

// A line through a tile, parallel to its rows or columns.
struct TileLine
{
  const HeightTile& Tile;
  bool IsAlongRow;
  double Across; // the coordinate that is constant

  double GetHeight(double along, double across = 0.0) const
  {
    return this->IsAlongRow ? GetTileHeight(this->Tile, along, this->Across + across)
                            : GetTileHeight(this->Tile, this->Across + across, along);
  }

  // Whether contour lines have some distance from each other there.
  bool IsGentle(double along, double interval) const
  {
    const double here = this->GetHeight(along);
    const double slope =
      std::hypot(this->GetHeight(along + 1.0) - here, this->GetHeight(along, 1.0) - here);
    return slope * LineDistance < interval; // false for NaN
  }
};

struct Crossing
{
  double Along = 0.0;
  double Value = 0.0;
};

// Finds the crossing of a contour line that is nearest to `center`: any, or the one of a value.
std::optional<Crossing> FindCrossing(const TileLine& line, int first, int last, double center,
  double interval, std::optional<double> value)
{
  std::optional<Crossing> best;
  double height = line.GetHeight(first);
  for (int i = first; i < last; ++i)
  {
    const double next = line.GetHeight(i + 1);
    const double low = std::min(height, next);
    const double high = std::max(height, next);
    const double wanted = value.value_or(interval * std::floor(high / interval));
    if (low < wanted && wanted <= high) // false for NaN
    {
      const double along = i + (wanted - height) / (next - height);
      if (!best || std::abs(along - center) < std::abs(best->Along - center))
      {
        best = Crossing{ along, wanted };
      }
    }
    height = next;
  }
  return best && line.IsGentle(std::floor(best->Along), interval) ? best : std::nullopt;
}

ContourAnchors::Anchor MakeAnchor(
  const TileLine& line, const Crossing& crossing, const TerrainPlacement& placement)
{
  ContourAnchors::Anchor anchor;
  const std::array<double, 2> local = { { line.IsAlongRow ? crossing.Along : line.Across,
    line.IsAlongRow ? line.Across : crossing.Along } };
  const std::array<int, 2> tile = { { line.Tile.Column, line.Tile.Row } };
  for (int axis = 0; axis < 2; ++axis)
  {
    anchor.Sample[axis] = std::ldexp(
      static_cast<double>(HeightTile::CellsPerTile) * tile[axis] + local[axis], line.Tile.Level);
  }
  anchor.Value = crossing.Value;
  anchor.IsAlongRow = line.IsAlongRow;
  anchor.Level = line.Tile.Level;
  anchor.Position = placement.ToWorld(anchor.Sample[0], anchor.Sample[1], anchor.Value);
  return anchor;
}

// At most one anchor per part, near its middle.
std::vector<ContourAnchors::Anchor> FindAnchors(const HeightTile& tile,
  const TerrainPlacement& placement, double interval, const std::array<double, 2>& end)
{
  std::vector<ContourAnchors::Anchor> anchors;
  const int cells = tile.Level > 0 ? CellsPerPart : CellsPerFinestPart;
  const int parts = HeightTile::CellsPerTile / cells;
  for (int part = 0; part < parts * parts; ++part)
  {
    const std::array<int, 2> first = { { part % parts * cells, part / parts * cells } };
    for (int axis = 0; axis < 2; ++axis)
    {
      const TileLine line = { tile, axis == 0, first[1 - axis] + 0.5 * cells };
      const auto crossing = FindCrossing(
        line, first[axis], first[axis] + cells, first[axis] + 0.5 * cells, interval, std::nullopt);
      if (!crossing)
      {
        continue;
      }
      const ContourAnchors::Anchor anchor = MakeAnchor(line, *crossing, placement);
      if (anchor.Sample[0] <= end[0] && anchor.Sample[1] <= end[1] &&
        std::isfinite(anchor.Position[0]))
      {
        anchors.push_back(anchor);
        break;
      }
    }
  }
  return anchors;
}
}

std::vector<ContourAnchors::Anchor> ContourAnchors::Find(
  const AdaptiveTerrain& terrain, double exaggeration, double interval)
{
  const TerrainPlacement placement = terrain.GetPlacement(exaggeration);
  const RasterDescription& contents = terrain.GetLattice().Describe();
  const std::array<double, 2> end = { { contents.Width - 1.0, contents.Height - 1.0 } };
  std::unordered_map<std::uint64_t, Part> last;
  last.swap(this->Tiles);
  this->Levels = { { TerrainTile::CoarsestLevel, 0 } };
  for (const MipmapTiles::Item& item : terrain.GetShadingTiles())
  {
    if (item.Tile->GetKind() != TerrainTile::Kind::Heights)
    {
      continue;
    }
    const auto& tile = static_cast<const HeightTile&>(*item.Tile);
    const std::uint64_t key = GetTileKey(tile);
    const auto known = last.find(key);
    this->Tiles[key] = { &tile,
      known != last.end() ? std::move(known->second.Anchors)
                          : FindAnchors(tile, placement, interval, end) };
    this->Levels = { { std::min(this->Levels[0], tile.Level),
      std::max(this->Levels[1], tile.Level) } };
  }
  std::vector<Anchor> anchors;
  for (const auto& [key, part] : this->Tiles)
  {
    std::copy_if(part.Anchors.begin(), part.Anchors.end(), std::back_inserter(anchors),
      [this](const Anchor& anchor)
      { return this->FindTile(anchor.Sample)->Level == anchor.Level; });
  }
  return anchors;
}

const HeightTile* ContourAnchors::FindTile(const std::array<double, 2>& sample) const
{
  for (int level = this->Levels[0]; level <= this->Levels[1]; ++level)
  {
    const double size = std::ldexp(static_cast<double>(HeightTile::CellsPerTile), level);
    const auto found = this->Tiles.find(GetTileKey(TerrainTile::Kind::Heights, level,
      static_cast<int>(sample[0] / size), static_cast<int>(sample[1] / size)));
    if (found != this->Tiles.end())
    {
      return found->second.Tile;
    }
  }
  return nullptr;
}

bool ContourAnchors::Update(
  const TerrainPlacement& placement, double interval, Anchor& anchor) const
{
  const HeightTile* tile = this->FindTile(anchor.Sample);
  if (!tile || tile->Level == anchor.Level)
  {
    return tile != nullptr;
  }
  const std::array<double, 2> local = { { std::ldexp(anchor.Sample[0], -tile->Level) -
      HeightTile::CellsPerTile * tile->Column,
    std::ldexp(anchor.Sample[1], -tile->Level) - HeightTile::CellsPerTile * tile->Row } };
  const int axis = anchor.IsAlongRow ? 0 : 1;
  const TileLine line = { *tile, anchor.IsAlongRow, local[1 - axis] };
  const int cell = static_cast<int>(std::floor(local[axis]));
  const auto crossing = FindCrossing(line, std::max(cell - Reach, -1),
    std::min(cell + Reach + 1, HeightTile::CellsPerTile + 1), local[axis], interval, anchor.Value);
  if (!crossing)
  {
    return false;
  }
  anchor = MakeAnchor(line, *crossing, placement);
  return true;
}
}
