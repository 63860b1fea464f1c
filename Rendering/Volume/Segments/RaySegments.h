// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RaySegments
 * @brief   for each pixel of a view, the segments of its ray inside the cells of one piece
 *
 * Pixels are numbered row by row from the lower left corner. The segments of a pixel are contiguous
 * and in the order of depth. Depths are positions on the ray as in relevoVolumeRay.glsl, in units
 * of MeshExtent::GetRadius(). All pieces that are cast with the same extent and view have the same
 * depth at shared faces, apart from rounding. With isosurfaces, the bits are the same, too. Private
 * to the modules.
 */
#ifndef RaySegments_h
#define RaySegments_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "Segments/SegmentFormat.h"

#include <cstddef> // for sizes
#include <cstdint> // for counts
#include <vector>  // for members

namespace relevo
{
class RELEVORENDERINGVOLUME_EXPORT RaySegments
{
public:
  /// The largest number of segments of a pixel.
  static constexpr int MaximumPerPixel = 127;

  int Width = 0;
  int Height = 0;
  SegmentFormat Format;

  /// The number of segments of each pixel; the highest bit is set if there were more.
  std::vector<std::uint8_t> Counts;
  static constexpr std::uint8_t Lost = 0x80;

  std::vector<float> Begins;
  std::vector<float> Ends;
  std::vector<float> Values; // Format.GetNumberOfValues() of each segment

  /// Start over without segments.
  void Reset(int width, int height, const SegmentFormat& format);

  int GetCount(size_t pixel) const { return this->Counts[pixel] & ~Lost; }
  bool HasLost(size_t pixel) const { return (this->Counts[pixel] & Lost) != 0; }
  /// Return whether a pixel had more segments.
  bool HasLost() const;
  size_t GetNumberOfSegments() const { return this->Begins.size(); }
  /// Return the first segment of each pixel, and the number of segments.
  std::vector<std::uint32_t> FindOffsets() const;

  /**
   * Take records in any order in which those of a pixel are from front to back: the number of the
   * pixel, the bits of the depths at the begin and the end, and those of the values. Of a pixel,
   * the first `most` are kept.
   */
  void Sort(const std::vector<std::uint32_t>& records, int most);

  /**
   * Return a message for another process: a header, a byte for each pixel of the rectangle with
   * segments, then the segments. A segment with a colour has 10 bytes: its begin as a float, and
   * the colour with 11 bits for each component and a common exponent of 4 bits. Its error is at
   * most 1/2047 of the largest component, or 2^-25 if this is more. In blend modes that do not
   * depend on the order, a segment has no begin: 8 bytes for additive blending, otherwise 4 for
   * each value. Ends are left out, because the order does not depend on them; in Unpack() they
   * equal the begins.
   */
  std::vector<std::uint8_t> Pack() const;
  /// Read a message. Return false if it is damaged.
  bool Unpack(const std::vector<std::uint8_t>& message);
};
}

#endif
