// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FragmentLayers.h"

#include "PeeledPicture.h"
#include "RankExchange.h"
#include "Stages/SegmentRequest.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr size_t ColorSize = 4;

struct Fragment
{
  float Depth;
  const float* Color;
};

// Collect the fragments of a pixel from front to back. Return whether a piece had more.
bool CollectFragments(const std::vector<RaySegments>& pieces,
  const std::vector<std::vector<std::uint32_t>>& offsets, size_t pixel,
  std::vector<Fragment>& fragments)
{
  bool hasLost = false;
  fragments.clear();
  for (size_t piece = 0; piece < pieces.size(); ++piece)
  {
    const RaySegments& from = pieces[piece];
    hasLost = hasLost || from.HasLost(pixel);
    for (size_t i = offsets[piece][pixel]; i < offsets[piece][pixel + 1]; ++i)
    {
      fragments.push_back({ from.Begins[i], &from.Values[ColorSize * i] });
    }
  }
  std::stable_sort(fragments.begin(), fragments.end(),
    [](const Fragment& a, const Fragment& b) { return a.Depth < b.Depth; });
  return hasLost;
}
}

void FragmentLayers::Merge(const std::vector<RaySegments>& pieces, int most)
{
  this->Merged = RaySegments();
  std::vector<std::vector<std::uint32_t>> offsets;
  for (const RaySegments& piece : pieces)
  {
    offsets.push_back(piece.FindOffsets());
  }
  const size_t pixels = pieces.empty() ? 0 : pieces.front().Counts.size();
  std::vector<Fragment> fragments;
  for (size_t pixel = 0; pixel < pixels; ++pixel)
  {
    bool hasLost = CollectFragments(pieces, offsets, pixel, fragments);
    if (fragments.size() > static_cast<size_t>(most))
    {
      fragments.resize(static_cast<size_t>(most));
      hasLost = true;
    }
    this->Merged.Counts.push_back(
      static_cast<std::uint8_t>(fragments.size() | (hasLost ? RaySegments::Lost : 0u)));
    for (const Fragment& fragment : fragments)
    {
      this->Merged.Begins.push_back(fragment.Depth);
      this->Merged.Values.insert(
        this->Merged.Values.end(), fragment.Color, fragment.Color + ColorSize);
    }
  }
}

void FragmentLayers::Share(const RankExchange& ranks)
{
  ranks.Broadcast(this->Merged.Counts);
  ranks.Broadcast(this->Merged.Begins);
  this->Offsets = this->Merged.FindOffsets();
}

int FragmentLayers::GetNumberOfLayers() const
{
  int most = 0;
  for (size_t pixel = 0; pixel < this->Merged.Counts.size(); ++pixel)
  {
    most = std::max(most, this->Merged.GetCount(pixel));
  }
  return most;
}

vtkIdType FragmentLayers::CountLostPixels() const
{
  return static_cast<vtkIdType>(
    std::count_if(this->Merged.Counts.begin(), this->Merged.Counts.end(),
      [](std::uint8_t count) { return (count & RaySegments::Lost) != 0; }));
}

// The middle slab belongs to the front part.
bool FragmentLayers::HasSlab(size_t pixel, int slab, Part part) const
{
  const int count = this->Merged.GetCount(pixel);
  const bool isFront = count > 0 && slab <= count / 2;
  return slab <= count && isFront == (part == Part::Front);
}

bool FragmentLayers::HasFragment(size_t pixel, int layer, Part part) const
{
  const int count = this->Merged.GetCount(pixel);
  const bool isFront = layer < (count + 1) / 2;
  return layer >= 0 && layer < count && isFront == (part == Part::Front);
}

void FragmentLayers::SetSlab(
  int slab, Part part, const std::vector<float>& opaqueDepths, SegmentRequest& request) const
{
  request.Depths = opaqueDepths;
  request.Begins = opaqueDepths;
  for (size_t pixel = 0; pixel < this->Merged.Counts.size(); ++pixel)
  {
    if (this->HasSlab(pixel, slab, part))
    {
      const float* depths = this->Merged.Begins.data() + this->Offsets[pixel];
      request.Begins[pixel] = slab > 0 ? depths[slab - 1] : 0.0f;
      request.Depths[pixel] =
        slab < this->Merged.GetCount(pixel) ? depths[slab] : opaqueDepths[pixel];
    }
  }
}

void FragmentLayers::Add(
  int slab, Part part, const std::vector<float>& colors, PeeledPicture& picture) const
{
  const bool isFront = part == Part::Front;
  const auto add = isFront ? &PeeledPicture::AddToFront : &PeeledPicture::AddToBack;
  const int layer = isFront ? slab : slab - 1;
  for (size_t pixel = 0; pixel < this->Merged.Counts.size(); ++pixel)
  {
    if (this->HasSlab(pixel, slab, part))
    {
      (picture.*add)(pixel, &colors[ColorSize * pixel]);
    }
    if (this->HasFragment(pixel, layer, part))
    {
      const size_t fragment = this->Offsets[pixel] + static_cast<size_t>(layer);
      (picture.*add)(pixel, &this->Merged.Values[ColorSize * fragment]);
    }
  }
}
}
