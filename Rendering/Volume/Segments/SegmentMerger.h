// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   merges the ray segments of the pieces of a mesh to a picture
 *
 * This is deep compositing: every piece provides all of its segments for a pixel instead of one
 * colour, so that pieces of any shape can be interleaved. S. Sahistan, S. Demirci, I. Wald, S.
 * Zellmann, J. Barbosa, N. Morrical, U. Gudukbay, "Visualization of Large Non-Trivially Partitioned
 * Unstructured Data with Native Distribution on High-Performance Computing Systems",
 * arXiv:2209.14537.
 *
 * The results do not depend on the order of the pieces. Private to the modules.
 */
#ifndef SegmentMerger_h
#define SegmentMerger_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "Segments/SegmentFormat.h"

#include <vector>

namespace relevo
{
class RaySegments;
struct MeshExtent;

/// The values of a single segment for the whole ray of each pixel. Pixels without segments have 0,
/// or NaN for maximum and minimum.
struct MergedSegments
{
  SegmentFormat Format;
  std::vector<float> Values; // Format.GetNumberOfValues() of each pixel
};

/**
 * Merge the segments of pieces of the same size. Pieces with segments have the same format.
 * Segments with colours are composited from front to back, and those that begin at the same depth
 * in the order of their ends.
 */
RELEVORENDERINGVOLUME_EXPORT MergedSegments MergeSegments(
  const std::vector<const RaySegments*>& pieces);

/**
 * Return red, green, blue and opacity of each pixel, premultiplied. The functions are those of all
 * pieces, and `whole` is the extent that they were cast with.
 */
RELEVORENDERINGVOLUME_EXPORT std::vector<float> MapSegments(
  MergedSegments merged, const TransferFunctions& functions, const MeshExtent& whole);

/// Mark the pixels where a piece had too many segments. Without any, `lost` can be empty.
RELEVORENDERINGVOLUME_EXPORT void MarkLostPixels(
  const std::vector<const RaySegments*>& pieces, std::vector<bool>& lost);
}

#endif
