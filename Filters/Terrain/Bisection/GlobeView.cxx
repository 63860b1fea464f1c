// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/GlobeView.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
using EarthPoint = std::array<double, 3>;

// Errors of squares are at least this many times those of their faces.
const double Saturation = std::exp2(0.125);

double GetLength(const EarthPoint& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

EarthPoint Subtract(const EarthPoint& a, const EarthPoint& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

double Multiply(const EarthPoint& a, const EarthPoint& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
}

GlobeView::GlobeView(const TerrainPlacement& placement, const std::array<double, 3>& eye)
  : Placement(placement)
  , Shape(*this->Placement.Globe)
  , Eye(eye)
{
  const GeocentricFrame& frame = this->Shape.GetFrame();
  EarthPoint geographic = frame.ToGeographic(eye);
  this->EyeHeight = geographic[2];
  geographic[2] = 0.0;
  this->Ground = frame.ToWorld(geographic);
  const double axis = frame.GetSemiMajorAxis();
  const double ratio = 1.0 - frame.GetFlattening();
  const double radii[3] = { axis, axis * ratio * ratio, axis / ratio };
  this->SmallestRadius = *std::min_element(radii, radii + 3);
  this->LargestRadius = *std::max_element(radii, radii + 3);
}

TerrainBox GlobeView::Clamp(const TerrainBox& box) const
{
  TerrainBox clamped = box;
  for (int end = 0; end < 2; ++end)
  {
    clamped.Columns[end] = std::clamp(box.Columns[end], 0.0, this->Shape.GetEnd()[0]);
    clamped.Rows[end] = std::clamp(box.Rows[end], 0.0, this->Shape.GetEnd()[1]);
    clamped.Heights[end] = box.Heights[end] * this->Placement.HeightScale;
  }
  std::sort(clamped.Heights.begin(), clamped.Heights.end());
  if (this->Shape.GetGeoid().HasGeoid())
  {
    const double exaggeration = this->Placement.Exaggeration;
    clamped.Heights[0] +=
      std::min(GeoidHeights::Lowest * exaggeration, GeoidHeights::Highest * exaggeration);
    clamped.Heights[1] +=
      std::max(GeoidHeights::Lowest * exaggeration, GeoidHeights::Highest * exaggeration);
  }
  return clamped;
}

double GlobeView::GetDistance(const TerrainBox& box) const
{
  const TerrainBox inside = this->Clamp(box);
  const EarthPoint center = this->Shape.GetPosition(
    0.5 * (inside.Columns[0] + inside.Columns[1]), 0.5 * (inside.Rows[0] + inside.Rows[1]));
  const GlobeShape::Bounds bounds = this->Shape.GetBounds(inside.Columns, inside.Rows);
  const double radius = 0.5 *
    (bounds.Lengths[0] * (inside.Columns[1] - inside.Columns[0]) +
      bounds.Lengths[1] * (inside.Rows[1] - inside.Rows[0]));
  const double distance = GetLength(Subtract(center, this->Ground));
  const double chord = distance > radius ? distance - radius : 0.0; // 0 for NaN
  // On a sphere, the squared distance of two points is that of their heights plus the squared chord
  // times both (1 + height / radius). An ellipsoid differs by less than three times its flattening.
  const auto scale = [this](double height)
  {
    return std::max(
      0.0, 1.0 + height / (height > 0.0 ? this->LargestRadius : this->SmallestRadius));
  };
  const double flatness =
    std::max(0.0, 1.0 - 3.0 * std::abs(this->Shape.GetFrame().GetFlattening()));
  const double vertical =
    std::max({ inside.Heights[0] - this->EyeHeight, this->EyeHeight - inside.Heights[1], 0.0 });
  return std::sqrt(vertical * vertical +
    flatness * scale(this->EyeHeight) * scale(inside.Heights[0]) * chord * chord);
}

double GlobeView::GetShapeError(int level, bool isSquare, const TerrainBox& box) const
{
  if (!(box.Heights[0] <= box.Heights[1]))
  {
    return 0.0;
  }
  const TerrainBox inside = this->Clamp(box);
  const GlobeShape::Bounds bounds = this->Shape.GetBounds(inside.Columns, inside.Rows);
  const double growth = 1.0 + std::max(0.0, inside.Heights[1]) / this->SmallestRadius;
  // A triangle of a pattern is at most one cell of the lattice wide and high. Slopes are up to 45
  // degrees before the exaggeration.
  // The geoid is curved more than the ellipsoid in some parts.
  const double cell = (this->Shape.GetGeoid().HasGeoid() ? 2.0 : 1.0) * growth *
    bounds.GetDistance({ { 1.0, 1.0 } }, std::max(1.0, std::abs(this->Placement.Exaggeration)));
  double error =
    std::ldexp(cell, 2 * level) / std::max(1e-300, std::abs(this->Placement.HeightScale));
  double closing = 0.0;
  if (this->Shape.GetPeriod() > 0 && box.Columns[1] > this->Shape.GetPeriod() - 1.0)
  {
    closing += box.Heights[1] - box.Heights[0];
  }
  closing += box.Rows[0] < 1.0 ? this->Placement.PoleErrors[0] : 0.0;
  closing += box.Rows[1] > this->Shape.GetEnd()[1] - 1.0 ? this->Placement.PoleErrors[1] : 0.0;
  error += closing * (level > 0 ? std::exp2(0.25 * level) : std::ldexp(1.0, 2 * level));
  return isSquare ? Saturation * error : error;
}

bool GlobeView::IsVisible(
  const TerrainBox& box, const std::array<std::array<double, 4>, 6>* planes, bool hasHorizon) const
{
  if (!(box.Heights[0] <= box.Heights[1]))
  {
    return false;
  }
  const TerrainBox inside = this->Clamp(box);
  double columns[4];
  double rows[4];
  for (int i = 0; i < 4; ++i)
  {
    columns[i] = inside.Columns[i % 2];
    rows[i] = inside.Rows[i / 2];
  }
  GlobeShape::Vertex vertices[4];
  this->Shape.Locate(4, columns, rows, vertices);
  std::array<EarthPoint, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    vertices[i % 4].Geoid = 0.0; // is a part of the box
    corners[i] = vertices[i % 4].ToWorld(inside.Heights[i / 4], 1.0);
    if (std::isnan(corners[i][0]))
    {
      return true;
    }
  }
  // The distance of the box from the convex hull of its corners.
  const double highest = std::max(std::abs(inside.Heights[0]), std::abs(inside.Heights[1]));
  const GlobeShape::Bounds bounds = this->Shape.GetBounds(inside.Columns, inside.Rows);
  const double margin = (1.0 + highest / this->SmallestRadius) *
    bounds.GetDistance(
      { { inside.Columns[1] - inside.Columns[0], inside.Rows[1] - inside.Rows[0] } });
  for (int i = 0; planes && i < 6; ++i)
  {
    const std::array<double, 4>& plane = (*planes)[i];
    const double length = GetLength({ { plane[0], plane[1], plane[2] } });
    const bool isOutside = std::all_of(corners.begin(), corners.end(),
      [&plane, limit = -margin * length](const EarthPoint& p)
      { return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] < limit; });
    if (isOutside)
    {
      return false;
    }
  }
  return !hasHorizon || !this->IsBehindHorizon(corners, margin);
}

// The points that the unit sphere hides from the eye are a convex set: those behind the plane of
// the horizon and inside of the cone through it.
bool GlobeView::IsBehindHorizon(const std::array<EarthPoint, 8>& corners, double margin) const
{
  const GeocentricFrame& frame = this->Shape.GetFrame();
  const double across = frame.GetSemiMajorAxis() + this->Placement.LowestHeight;
  const double along =
    frame.GetSemiMajorAxis() * (1.0 - frame.GetFlattening()) + this->Placement.LowestHeight;
  if (!(std::min(across, along) > 0.0))
  {
    return false;
  }
  const auto toSphere = [across, along](const EarthPoint& p) {
    return EarthPoint{ { p[0] / across, p[1] / across, p[2] / along } };
  };
  const EarthPoint eye = toSphere(this->Eye);
  const double distance = GetLength(eye);
  if (!(distance > 1.0))
  {
    return false;
  }
  const double limit = margin / std::min(across, along);
  const double sine = 1.0 / distance; // of the half angle of the cone
  const double cosine = std::sqrt(1.0 - sine * sine);
  return std::all_of(corners.begin(), corners.end(),
    [&](const EarthPoint& corner)
    {
      const EarthPoint toCorner = Subtract(toSphere(corner), eye);
      const double depth = -Multiply(toCorner, eye) / distance;
      const double side = std::sqrt(std::max(0.0, Multiply(toCorner, toCorner) - depth * depth));
      return depth - (distance - sine) > limit && depth * sine - side * cosine > limit;
    });
}
}
