// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoReliefRays.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

using RelevoVectors::Vector;

RelevoReliefRays::RelevoReliefRays(vtkImageData* relief, double maximumStretch)
  : Stretch(maximumStretch)
{
  this->Width = relief->GetDimensions()[0];
  this->Height = relief->GetDimensions()[1];
  this->IsPerspective =
    relief->GetFieldData()->GetArray("ReliefProjection")->GetComponent(0, 0) == 1.0;
  vtkDataArray* matrix = relief->GetFieldData()->GetArray("ReliefMatrix");
  for (int i = 0; i < 16; ++i)
  {
    this->Matrix[i] = matrix->GetComponent(i, 0);
  }
  vtkMatrix4x4::Invert(this->Matrix, this->Inverse);
  vtkDataArray* depths = relief->GetPointData()->GetArray("Depth");
  for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
  {
    this->Depths.push_back(depths->GetComponent(i, 0));
  }
  for (int row = 0; row + 1 < this->Height; ++row)
  {
    for (int column = 0; column + 1 < this->Width; ++column)
    {
      if (this->AreJoined(column, row, column + 1, row) &&
        this->AreJoined(column, row + 1, column + 1, row + 1) &&
        this->AreJoined(column, row, column, row + 1) &&
        this->AreJoined(column + 1, row, column + 1, row + 1))
      {
        this->Quads.push_back({ { column, row } });
      }
    }
  }
}

Vector RelevoReliefRays::GetPoint(double column, double row, double depth) const
{
  const double factor = this->IsPerspective ? depth : 1.0;
  const double in[4] = { column * factor, row * factor, depth, 1.0 };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(this->Matrix, in, out);
  return { { out[0] / out[3], out[1] / out[3], out[2] / out[3] } };
}

bool RelevoReliefRays::AreJoined(int column, int row, int otherColumn, int otherRow) const
{
  const double depth = this->GetDepth(column, row);
  const double other = this->GetDepth(otherColumn, otherRow);
  if (!std::isfinite(depth) || !std::isfinite(other))
  {
    return false;
  }
  const double nearer = std::min(depth, other);
  const auto length = [](const Vector& a, const Vector& b)
  { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); };
  return length(this->GetPoint(column, row, depth), this->GetPoint(otherColumn, otherRow, other)) <=
    this->Stretch *
    length(this->GetPoint(column, row, nearer), this->GetPoint(otherColumn, otherRow, nearer));
}

// Homogeneous column and row, and the value that is bilinear.
RelevoReliefRays::Four RelevoReliefRays::ToTexel(const Four& world) const
{
  Four texel;
  vtkMatrix4x4::MultiplyPoint(this->Inverse, world.data(), texel.data());
  if (this->IsPerspective)
  {
    std::swap(texel[2], texel[3]); // (c d, r d, 1, d) is (c, r, 1 / d, 1)
  }
  return texel;
}

std::array<double, 2> RelevoReliefRays::Find(const Vector& point) const
{
  const Four texel = this->ToTexel({ { point[0], point[1], point[2], 1.0 } });
  return { { texel[0] / texel[3], texel[1] / texel[3] } };
}

std::vector<RelevoReliefHit> RelevoReliefRays::CastAll(
  const Vector& origin, const Vector& direction, double least, double most) const
{
  const Four a = this->ToTexel({ { origin[0], origin[1], origin[2], 1.0 } });
  const Four b = this->ToTexel({ { direction[0], direction[1], direction[2], 0.0 } });
  std::vector<RelevoReliefHit> hits;
  const auto at = [&](int i, double t) { return a[i] + t * b[i]; };
  // The ray as a line over the texels. Quads entirely on one side are missed.
  const Vector line = { { a[1] * b[3] - a[3] * b[1], a[3] * b[0] - a[0] * b[3],
    a[0] * b[1] - a[1] * b[0] } };
  const double reach = 0.5 * (std::abs(line[0]) + std::abs(line[1])) +
    1e-9 * (std::abs(line[0]) * this->Width + std::abs(line[1]) * this->Height + std::abs(line[2]));
  for (const auto& quad : this->Quads)
  {
    if (std::abs(line[0] * (quad[0] + 0.5) + line[1] * (quad[1] + 0.5) + line[2]) > reach)
    {
      continue;
    }
    const auto height = [&](int c, int r)
    {
      const double depth = this->GetDepth(quad[0] + c, quad[1] + r);
      return this->IsPerspective ? 1.0 / depth : depth;
    };
    const double first = height(0, 0);
    const double right = height(1, 0) - first;
    const double up = height(0, 1) - first;
    const double twist = first - height(1, 0) - height(0, 1) + height(1, 1);
    // Of degree 2, so three values determine the polynomial.
    const auto value = [&](double t)
    {
      const double weight = at(3, t);
      const double x = at(0, t) - quad[0] * weight;
      const double y = at(1, t) - quad[1] * weight;
      return (at(2, t) - first * weight - right * x - up * y) * weight - twist * x * y;
    };
    const double middle = 0.5 * (least + most);
    const double half = 0.5 * (most - least);
    const double v[3] = { value(least), value(middle), value(most) };
    const double p = 0.5 * (v[0] + v[2]) - v[1];
    const double q = 0.5 * (v[2] - v[0]);
    const double discriminant = q * q - 4.0 * p * v[1];
    if (discriminant < 0.0)
    {
      continue;
    }
    const double sum = -0.5 * (q + std::copysign(std::sqrt(discriminant), q));
    for (double root : { sum / p, v[1] / sum })
    {
      if (!(std::abs(root) <= 1.0))
      {
        continue;
      }
      RelevoReliefHit hit;
      hit.IsHit = true;
      hit.Distance = middle + half * root;
      const double weight = at(3, hit.Distance);
      hit.Column = at(0, hit.Distance) / weight;
      hit.Row = at(1, hit.Distance) / weight;
      if (hit.Column >= quad[0] && hit.Column <= quad[0] + 1 && hit.Row >= quad[1] &&
        hit.Row <= quad[1] + 1)
      {
        for (int i = 0; i < 3; ++i)
        {
          hit.Point[i] = origin[i] + hit.Distance * direction[i];
        }
        hits.push_back(hit);
      }
    }
  }
  std::sort(hits.begin(), hits.end(),
    [](const RelevoReliefHit& first, const RelevoReliefHit& second)
    { return first.Distance < second.Distance; });
  return hits;
}

RelevoReliefHit RelevoReliefRays::Cast(
  const Vector& origin, const Vector& direction, double least, double most) const
{
  const auto hits = this->CastAll(origin, direction, least, most);
  return hits.empty() ? RelevoReliefHit() : hits.front();
}
