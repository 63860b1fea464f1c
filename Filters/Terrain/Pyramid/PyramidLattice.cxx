// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/PyramidLattice.h"

#include "Pyramid/RasterPyramid.h"

#include <utility>

namespace relevo
{
PyramidLattice::PyramidLattice(std::shared_ptr<const RasterPyramid> pyramid)
  : Pyramid(std::move(pyramid))
  , Sampler(this->Pyramid->GetFile())
{
}

PyramidLattice::~PyramidLattice() = default;

const RasterDescription& PyramidLattice::Describe() const
{
  return this->Pyramid->GetFile().Describe();
}

bool PyramidLattice::AreErrorsKnown() const
{
  return this->Pyramid->IsIndexComplete();
}

bool PyramidLattice::AreErrorsPending() const
{
  return !this->Pyramid->IsIndexComplete() && this->Pyramid->GetIndexError().empty();
}

std::shared_ptr<const BlockErrors> PyramidLattice::GetErrors() const
{
  return this->Pyramid->GetBlockErrors();
}

std::shared_ptr<const ElevationRanges> PyramidLattice::GetRanges() const
{
  return this->Pyramid->GetElevationRanges();
}

bool PyramidLattice::Read(HeightTile& tile, std::string& error) const
{
  return this->Sampler.Read(tile, error);
}

bool PyramidLattice::ReadWindow(
  int level, int column, int row, int width, int height, float* heights, std::string& error) const
{
  return this->Sampler.Read(level, column, row, width, height, heights, error);
}
std::int64_t PyramidLattice::GetMemorySize(int threads) const
{
  // The samples of a window as doubles.
  constexpr std::int64_t window = std::int64_t(1) << 19;
  return threads * window + this->Pyramid->GetFile().GetMemoryOfReading(threads) +
    (this->Pyramid->IsIndexComplete() ? this->Pyramid->GetIndex().GetMemorySize() : 0);
}
}
