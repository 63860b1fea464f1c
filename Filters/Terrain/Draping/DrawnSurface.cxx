// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping/DrawnSurface.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Draping/FacePatch.h"
#include "Draping/LatticePatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
DrawnSurface::DrawnSurface(const AdaptiveTerrain& terrain, double exaggeration)
  : Placement(terrain.GetPlacement(exaggeration))
  , LastSample{ { terrain.GetLattice().Describe().Width - 1.0,
      terrain.GetLattice().Describe().Height - 1.0 } }
{
  if (const GlobeShape* globe = terrain.GetGlobe())
  {
    this->LastSample = globe->GetBorder();
    // A closed raster overlaps.
    const double period = globe->GetPeriod();
    this->LastSample[0] = period > 0.0 ? period : this->LastSample[0];
  }
  for (std::size_t i = 0; i < terrain.GetFaces().size(); ++i)
  {
    const GlobeFaces::Vertices* vertices =
      terrain.GetVertices().empty() ? nullptr : terrain.GetVertices()[i];
    this->Members.push_back(std::make_unique<FacePatch>(
      terrain.GetFaces()[i], vertices, this->Placement, this->LastSample));
  }
  constexpr double tolerance = std::numeric_limits<double>::max();
  for (const HiddenBlock& block : terrain.GetHiddenBlocks())
  {
    const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), block.Level);
    const double column = static_cast<double>(block.Column) * size;
    const double row = static_cast<double>(block.Row) * size;
    MapBox box;
    box.Add({ { column, row } });
    box.Add({ { column + size, row + size } });
    box.Clip(this->LastSample);
    this->Members.push_back(
      std::make_unique<LatticePatch>(*block.Tile, this->Placement, box, tolerance));
  }
  if (this->Members.empty())
  {
    this->AddFlatPatch(terrain);
  }
  this->Nodes.resize(1);
  this->MakeNode(0, this->Members.begin(), this->Members.end());
}

DrawnSurface::~DrawnSurface() = default;

void DrawnSurface::AddFlatPatch(const AdaptiveTerrain& terrain)
{
  const RasterDescription& contents = terrain.GetLattice().Describe();
  const MapPosition last = { { contents.Width - 1.0, contents.Height - 1.0 } };
  constexpr int coarsest = 64; // coarser than any level
  const ElevationRanges::Range heights =
    terrain.GetLattice().GetRanges()->Get(coarsest, { { 0.0, last[0] } }, { { 0.0, last[1] } });
  // One cell is larger than the raster.
  while (std::ldexp(1.0, this->FlatTile.Level) <= std::max(last[0], last[1]))
  {
    ++this->FlatTile.Level;
  }
  this->FlatTile.Heights.assign(static_cast<std::size_t>(HeightTile::Stride) * HeightTile::Stride,
    heights[0] <= heights[1] ? 0.5f * (heights[0] + heights[1]) : 0.0f);
  MapBox box = this->GetBox();
  box.Clip({ { last[0] + 1.0, last[1] + 1.0 } }); // a globe is closed
  this->Members.push_back(
    std::make_unique<LatticePatch>(this->FlatTile, this->Placement, box, 1.0));
}

void DrawnSurface::MakeNode(std::size_t node, Patches::iterator begin, Patches::iterator end)
{
  MapBox box;
  for (auto patch = begin; patch != end; ++patch)
  {
    box.AddBox((*patch)->GetBox());
  }
  this->Nodes[node].Box = box;
  if (end - begin == 1)
  {
    this->Nodes[node].Patch = begin->get();
    return;
  }
  const int axis = box.High[0] - box.Low[0] >= box.High[1] - box.Low[1] ? 0 : 1;
  const auto getCenter = [axis](const std::unique_ptr<TerrainPatch>& patch)
  { return patch->GetBox().Low[axis] + patch->GetBox().High[axis]; };
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(
    begin, middle, end, [&](const auto& a, const auto& b) { return getCenter(a) < getCenter(b); });
  const std::size_t first = this->Nodes.size();
  this->Nodes[node].First = first;
  this->Nodes.resize(first + 2);
  this->MakeNode(first, begin, middle);
  this->MakeNode(first + 1, middle, end);
}

void DrawnSurface::Visit(const MapBox& box, const MapSegment* segment, const Visitor& visitor)
{
  std::vector<std::size_t> nodes = { 0 };
  while (!nodes.empty())
  {
    const Node& node = this->Nodes[nodes.back()];
    nodes.pop_back();
    if (!node.Box.Overlaps(box) || (segment && !node.Box.Overlaps(*segment)))
    {
      continue;
    }
    if (!node.Patch)
    {
      nodes.push_back(node.First);
      nodes.push_back(node.First + 1);
    }
    else if (!visitor(*node.Patch))
    {
      return;
    }
  }
}
}
