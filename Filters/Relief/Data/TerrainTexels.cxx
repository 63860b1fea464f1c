// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/TerrainTexels.h"

#include "Geodesy/TerrainFrame.h"

namespace relevo
{
namespace
{
dvec2 GetPosition(const TerrainFrame& frame, double u, double v)
{
  std::array<double, 2> place;
  frame.Place(u, v, place);
  return dvec2(place[0], place[1]);
}
}

TerrainTexels::TerrainTexels(const TerrainFrame& frame, const int size[2], int texelsPerSample)
  : Frame(frame)
  , Size(dvec2(size[0], size[1]) * static_cast<double>(texelsPerSample))
  , Regular(!frame.IsGeographic())
  , Samples(this->Regular && texelsPerSample == 1)
{
  const dvec2 corner = GetPosition(frame, 0.0, 0.0);
  if (this->Regular)
  {
    this->SetMatrix(
      corner, GetPosition(frame, 1.0, 0.0) - corner, GetPosition(frame, 0.0, 1.0) - corner);
    return;
  }
  constexpr int steps = 256; // samples along each side
  dvec2 low = corner;
  dvec2 high = corner;
  for (int i = 0; i <= steps; ++i)
  {
    const double along = static_cast<double>(i) / steps;
    for (double side : { 0.0, 1.0 })
    {
      for (const dvec2& place :
        { GetPosition(frame, along, side), GetPosition(frame, side, along) })
      {
        low = min(low, place);
        high = max(high, place);
      }
    }
  }
  this->SetMatrix(low, dvec2(high.x - low.x, 0.0), dvec2(0.0, high.y - low.y));
}

void TerrainTexels::SetMatrix(
  const dvec2& corner, const dvec2& alongColumns, const dvec2& alongRows)
{
  const dvec2 column = alongColumns / this->Size.x;
  const dvec2 row = alongRows / this->Size.y;
  this->Matrix[0] = dvec4(column, 0.0, 0.0);
  this->Matrix[1] = dvec4(row, 0.0, 0.0);
  this->Matrix[3] = dvec4(corner + 0.5 * (column + row), 0.0, 1.0);
}

std::optional<dvec2> TerrainTexels::GetParameters(int column, int row) const
{
  if (this->Regular)
  {
    return dvec2(column + 0.5, row + 0.5) / this->Size;
  }
  const dvec4 place = this->Matrix * dvec4(column, row, 0.0, 1.0);
  std::array<double, 2> uv;
  const bool isInside = this->Frame.ToParameters({ place.x, place.y }, uv) && uv[0] >= 0.0 &&
    uv[0] <= 1.0 && uv[1] >= 0.0 && uv[1] <= 1.0;
  return isInside ? std::optional<dvec2>(dvec2(uv[0], uv[1])) : std::nullopt;
}
}
