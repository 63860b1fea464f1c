// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FragmentLayers
 * @brief   the translucent fragments of all ranks, which divide rays into slabs
 *
 * Layer i has the fragment of each pixel that i other ones hide. Slab i is the part of rays in
 * front of layer i and behind layer i - 1. Like VTK's dual depth peeling, rays have a front part,
 * which is blended from the front, and a back part, which is blended from the back. Pixels without
 * fragments have only a back part. Only the root has colours.
 *
 * Private to the module.
 */
#ifndef FragmentLayers_h
#define FragmentLayers_h

#include "Segments/RaySegments.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relevo
{
class PeeledPicture;
class RankExchange;
struct SegmentRequest;

class FragmentLayers
{
public:
  /// Merge the fragments of ranks, as TranslucentLayers returns them, and keep the `most` nearest
  /// of each pixel.
  void Merge(const std::vector<RaySegments>& pieces, int most);

  /// Give the depths of the root to all ranks. Collective.
  void Share(const RankExchange& ranks);

  /// Return the largest number of fragments of a pixel.
  int GetNumberOfLayers() const;

  /// Return the number of pixels that have more fragments.
  vtkIdType CountLostPixels() const;

  enum class Part
  {
    Front,
    Back
  };

  /// Set the range of the rays that have a slab in a part; the other ones have no range. The last
  /// slab of a pixel ends at the depth of opaque objects.
  void SetSlab(
    int slab, Part part, const std::vector<float>& opaqueDepths, SegmentRequest& request) const;

  /// At the root, add the colours of a slab to a part, then those of the next layer of this part.
  void Add(int slab, Part part, const std::vector<float>& colors, PeeledPicture& picture) const;

private:
  bool HasSlab(size_t pixel, int slab, Part part) const;
  bool HasFragment(size_t pixel, int layer, Part part) const;

  RaySegments Merged;
  std::vector<std::uint32_t> Offsets; // of the pixels
};
}

#endif
