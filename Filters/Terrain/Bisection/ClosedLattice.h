// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ClosedLattice
 * @brief   reads the tiles of a raster that is closed on a globe
 *
 * If the raster repeats, tiles have the heights of the first columns beyond the last column, as far
 * as cells of their lattice reach that overlap by one column, and those of the last columns before
 * the first. At a pole, all columns have the same height: the mean of the row next to it.
 *
 * Private to the modules for terrains.
 */
#ifndef ClosedLattice_h
#define ClosedLattice_h

#include "Geodesy/GlobeShape.h"
#include "Lattice/HeightLattice.h"

#include <array>
#include <memory>
#include <string>

namespace relevo
{
class ClosedLattice
{
public:
  ClosedLattice(
    std::shared_ptr<const HeightLattice> lattice, std::shared_ptr<const GlobeShape> shape);

  /// As HeightLattice::Read().
  bool Read(HeightTile& tile, std::string& error) const;

  /// The height of the first and the last row's pole; NaN without one.
  const std::array<float, 2>& GetPoles() const { return this->Poles; }
  /// The largest distance of the heights of the row next to a pole from that of the pole. Rows of
  /// many columns are sampled.
  const std::array<double, 2>& GetPoleErrors() const { return this->PoleErrors; }

private:
  void ReadPole(int pole);
  bool CloseColumns(HeightTile& tile, std::string& error) const;
  void ClosePoles(HeightTile& tile) const;

  std::shared_ptr<const HeightLattice> Lattice;
  std::shared_ptr<const GlobeShape> Shape;
  std::array<float, 2> Poles;
  std::array<double, 2> PoleErrors = { { 0.0, 0.0 } };
};
}

#endif
