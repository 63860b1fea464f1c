// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SegmentFormat
 * @brief   the values of a ray's segments
 *
 * Scalars are stored values of a RayCastMesh, from 0 to 1, one or MaximumComponents. The values
 * are:
 * - composite and isosurface: the premultiplied colour and the opacity of the segment,
 * - additive: the sums of colour times extinction, and of extinction,
 * - maximum and minimum: the extreme scalars, then with 2D functions their gradient magnitudes,
 * - average: the integrals of the scalars along the ray and the length in world units, then with
 *   2D functions the integrals of the gradient magnitudes.
 *
 * Private to the modules.
 */
#ifndef SegmentFormat_h
#define SegmentFormat_h

#include "Integral/TransferFunctions.h"
#include "Rays/BlendMode.h"

namespace relevo
{
struct SegmentFormat
{
  BlendMode Blending = BlendMode::Composite;
  bool AreIndependent = true; // each component has its extreme scalar; otherwise the last decides
  int NumberOfComponents = 1;
  bool HasSteepness = false; // gradient magnitudes, for 2D functions

  static constexpr int MaximumValues = 2 * MaximumComponents + 1;

  bool operator==(const SegmentFormat& other) const
  {
    return this->Blending == other.Blending &&
      this->NumberOfComponents == other.NumberOfComponents &&
      this->AreIndependent == other.AreIndependent && this->HasSteepness == other.HasSteepness;
  }

  /// Return whether the segments are composited from front to back. Otherwise a ray has at most one
  /// segment.
  bool IsOrdered() const
  {
    return this->Blending == BlendMode::Composite || this->Blending == BlendMode::IsoSurface;
  }
  bool IsExtreme() const
  {
    return this->Blending == BlendMode::Maximum || this->Blending == BlendMode::Minimum;
  }
  /// Return the number of stored scalars.
  int GetWidth() const { return this->NumberOfComponents == 1 ? 1 : MaximumComponents; }
  /// Return the number of values of a segment.
  int GetNumberOfValues() const
  {
    const int scalars = (this->HasSteepness ? 2 : 1) * this->GetWidth();
    return this->IsExtreme() ? scalars : this->Blending == BlendMode::Average ? scalars + 1 : 4;
  }
};
}

#endif
