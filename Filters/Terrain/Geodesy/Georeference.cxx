// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/Georeference.h"

#include <cmath>

namespace relevo
{
void Georeference::SetSize(int width, int height)
{
  this->System = Kind::None;
  this->Corner = { 0.0, 0.0 };
  this->AlongU = { static_cast<double>(width), 0.0 };
  this->AlongV = { 0.0, static_cast<double>(height) };
  this->FlipColumns = false;
  this->FlipRows = true;
}

bool Georeference::SetAffineTransform(const double transform[6], int width, int height)
{
  const double determinant = transform[1] * transform[5] - transform[2] * transform[4];
  if (!std::isfinite(determinant) || determinant == 0.0 || !std::isfinite(transform[0]) ||
    !std::isfinite(transform[3]))
  {
    return false;
  }
  this->FlipColumns = transform[1] < 0.0;
  this->FlipRows = (determinant < 0.0) != this->FlipColumns;
  this->Corner = { transform[0], transform[3] };
  this->AlongU = { transform[1] * width, transform[4] * width };
  this->AlongV = { transform[2] * height, transform[5] * height };
  const auto reverse = [this](std::array<double, 2>& along)
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Corner[i] += along[i];
      along[i] = -along[i];
    }
  };
  if (this->FlipColumns)
  {
    reverse(this->AlongU);
  }
  if (this->FlipRows)
  {
    reverse(this->AlongV);
  }
  return true;
}

std::array<double, 2> Georeference::Coordinates(double u, double v) const
{
  return { this->Corner[0] + u * this->AlongU[0] + v * this->AlongV[0],
    this->Corner[1] + u * this->AlongU[1] + v * this->AlongV[1] };
}

std::array<double, 2> Georeference::Parameters(const std::array<double, 2>& coordinates) const
{
  const double x = coordinates[0] - this->Corner[0];
  const double y = coordinates[1] - this->Corner[1];
  const double area = this->AlongU[0] * this->AlongV[1] - this->AlongU[1] * this->AlongV[0];
  return { (x * this->AlongV[1] - y * this->AlongV[0]) / area,
    (y * this->AlongU[0] - x * this->AlongU[1]) / area };
}
}
