// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainTexels
 * @brief   the texels of a relief that looks down on a terrain
 *
 * Where the raster's coordinates are lengths, texels are its samples. Longitude and latitude make
 * no regular grid in terrain coordinates: there texels are one, along x and y, over all of the
 * raster.
 *
 * Private to the module's own sources.
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
  /// The frame must outlive this. Of the samples' width and height, and texels along a sample.
  TerrainTexels(const TerrainFrame& frame, const int size[2], int texelsPerSample);

  /// Whether texels are samples.
  bool AreSamples() const { return this->Samples; }
  /// The texture coordinates, u east and v north, of a texel's centre; none outside the raster.
  std::optional<dvec2> GetParameters(int column, int row) const;
  /// From (column, row, z, 1) to terrain coordinates.
  const dmat4& GetMatrix() const { return this->Matrix; }

private:
  void SetMatrix(const dvec2& corner, const dvec2& alongColumns, const dvec2& alongRows);

  const TerrainFrame& Frame;
  const dvec2 Size;
  const bool Regular; // whether the samples are a grid on the ground
  const bool Samples;
  dmat4 Matrix = dmat4(1.0);
};
}

#endif
