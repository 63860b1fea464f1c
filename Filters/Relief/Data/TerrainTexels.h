// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainTexels
 * @brief   texels of a relief of a terrain, seen from above
 *
 * For planar coordinates, texels are the samples of the raster. Samples in longitude and latitude
 * are not on a regular grid in terrain coordinates. In this case, texels are a regular grid in x
 * and y that covers the raster.
 *
 * Private to the module.
 */
#ifndef TerrainTexels_h
#define TerrainTexels_h

#include "Mathematics/RefinementMathematics.h"

#include <optional>

namespace relevo
{
class TerrainFrame;

class TerrainTexels
{
public:
  /// `frame` must outlive this object. `size` is the number of samples in each direction.
  TerrainTexels(const TerrainFrame& frame, const int size[2], int texelsPerSample);

  /// Whether texels are samples.
  bool AreSamples() const { return this->Samples; }
  /// Returns u (east) and v (north) at the centre of a texel, or none outside of the raster.
  std::optional<dvec2> GetParameters(int column, int row) const;
  /// Returns the matrix from (column, row, z, 1) to terrain coordinates.
  const dmat4& GetMatrix() const { return this->Matrix; }

private:
  void SetMatrix(const dvec2& corner, const dvec2& alongColumns, const dvec2& alongRows);

  const TerrainFrame& Frame;
  const dvec2 Size;
  const bool Regular; // whether samples are on a regular grid in terrain coordinates
  const bool Samples;
  dmat4 Matrix = dmat4(1.0);
};
}

#endif
