// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidLattice
 * @brief   the heights of a raster pyramid as a terrain is drawn from them
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef PyramidLattice_h
#define PyramidLattice_h

#include "Lattice/HeightLattice.h"
#include "Pyramid/LatticeSampler.h"

#include <memory>

namespace relevo
{
class RasterPyramid;

class PyramidLattice : public HeightLattice
{
public:
  explicit PyramidLattice(std::shared_ptr<const RasterPyramid> pyramid);
  ~PyramidLattice() override;

  const RasterDescription& Describe() const override;
  bool AreErrorsKnown() const override;
  bool AreErrorsPending() const override;
  std::shared_ptr<const BlockErrors> GetErrors() const override;
  std::shared_ptr<const ElevationRanges> GetRanges() const override;
  bool Read(HeightTile& tile, std::string& error) const override;
  bool ReadWindow(int level, int column, int row, int width, int height, float* heights,
    std::string& error) const override;
  std::int64_t GetMemorySize(int threads) const override;

private:
  std::shared_ptr<const RasterPyramid> Pyramid;
  LatticeSampler Sampler;
};
}

#endif
