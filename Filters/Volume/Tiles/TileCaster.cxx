// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles/TileCaster.h"

#include "Integral/CurveIntegral.h"

#include <algorithm>

namespace relevo
{
const std::vector<dvec4>& TileCaster::Cast(const TileScene& scene, int number)
{
  const PixelCells::Tile tile = scene.Pixels.GetTile(number);
  this->Rays.clear();
  for (int row = tile.Bottom; row < tile.Top; ++row)
  {
    for (int column = tile.Left; column < tile.Right; ++column)
    {
      this->Rays.push_back(scene.Planes.Clip(scene.Rays.Make(column, row)));
    }
  }
  const CurveIntegral* integral = scene.Blend.FindCurveIntegral();
  if (integral && !this->Scalars)
  {
    this->Scalars = std::make_shared<ScalarTile>(
      scene.Crossing, scene.Pixels, *integral, scene.Blend.IsAdditive());
  }
  if (integral)
  {
    this->Scalars->Cast(number, this->Rays, this->Colors);
  }
  else
  {
    this->CastParts(scene, number);
  }
  return this->Colors;
}

void TileCaster::CastParts(const TileScene& scene, int number)
{
  this->Candidates.resize(std::max(this->Candidates.size(), this->Rays.size()));
  for (std::vector<int>& candidates : this->Candidates)
  {
    candidates.clear();
  }
  for (const int cell : scene.Pixels.FindCells(number))
  {
    scene.Pixels.FindOutline(cell, this->Outline);
    scene.Pixels.GetTile(number).Visit(
      this->Outline, [&](size_t pixel) { this->Candidates[pixel].push_back(cell); });
  }
  this->Colors.resize(this->Rays.size());
  for (size_t i = 0; i < this->Rays.size(); ++i)
  {
    const Ray& ray = this->Rays[i];
    this->Colors[i] =
      scene.Blend.Blend(scene.Crossing.Cross(ray, this->Candidates[i]), ray.Direction);
  }
}
}
