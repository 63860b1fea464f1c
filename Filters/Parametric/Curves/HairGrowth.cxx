// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/HairGrowth.h"

#include "Arrays/GhostCells.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace relevo
{
namespace
{
constexpr double ThickestRadius = 0.01; // at the root, for a hair of length 1
constexpr double ThinnestShare = 0.1;   // radius at the tip / radius at the root
constexpr double ShortestShare = 0.8;   // shortest hair / Length
constexpr double WidestCurl = 0.15;     // radius of the helix with many turns, for a hair of length
                                        // 1
constexpr double HalfWidthTurns = 0.25; // number of turns where the radius of the helix is half of
                                        // that

// The random numbers of a hair.
enum Throws
{
  AREA,
  FIRST_SIDE,
  SECOND_SIDE,
  LENGTH,
  PHASE
};

// The finalizer of SplitMix64 (S. Vigna, "Further scramblings of Marsaglia's xorshift generators",
// 2017).
std::uint64_t Scramble(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

vtkIdType CountTriangles(vtkCellArray* cells)
{
  return std::max<vtkIdType>(
    cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells(), 0);
}

dvec3 GetPosition(const SurfaceTriangles& triangles, vtkIdType point)
{
  dvec3 place;
  triangles.GetPoint(point, &place.x);
  return place;
}

dvec3 GetAreaNormal(const SurfaceTriangles& triangles, vtkIdType triangle)
{
  const SurfaceTriangles::Triangle& corners = triangles.GetPoints(triangle);
  const dvec3 first = GetPosition(triangles, corners[0]);
  return 0.5 *
    cross(GetPosition(triangles, corners[1]) - first, GetPosition(triangles, corners[2]) - first);
}

dvec3 GetAcross(const dvec3& normal)
{
  const dvec3 axis = std::abs(normal.x) < 0.6 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0);
  return normalize(cross(normal, axis));
}

struct Placed
{
  dvec3 Place;
  dvec3 Derivative;
};

// A hair of length 1 at the origin. Gravity displaces it by the square of the distance s from the
// root. It winds in a helix of radius Width (s (2 - s))^2, so that it starts along the normal and
// has almost its full width from the middle on.
class Strand
{
public:
  Strand(const dvec3& normal, const HairSettings& settings, double phase)
    : Normal(normal)
    , First(GetAcross(normal))
    , Second(cross(normal, First))
    , Gravity(settings.Gravity)
    , Phase(phase)
    , Turn(2.0 * vtkMath::Pi() * settings.Curl)
    , Width(WidestCurl * settings.Curl / (HalfWidthTurns + settings.Curl))
  {
  }

  Placed Evaluate(double s) const
  {
    const double angle = this->Phase + this->Turn * s;
    const dvec3 out = this->First * std::cos(angle) + this->Second * std::sin(angle);
    const dvec3 along = this->Second * std::cos(angle) - this->First * std::sin(angle);
    const double rise = s * (2.0 - s);
    const double width = this->Width * rise * rise;
    const double widening = this->Width * 4.0 * rise * (1.0 - s);
    return { this->Normal * s + this->Gravity * (s * s) + out * width,
      this->Normal + this->Gravity * (2.0 * s) + out * widening + along * (width * this->Turn) };
  }

private:
  dvec3 Normal;
  dvec3 First;
  dvec3 Second;
  dvec3 Gravity;
  double Phase;
  double Turn;
  double Width;
};
}

HairGrowth::HairGrowth(vtkPolyData* mesh, const HairSettings& settings)
  : Settings(settings)
  , Triangles(mesh)
  , Normals(mesh->GetPointData()->GetNormals())
  , NumberOfBadTriangles(CountTriangles(mesh->GetPolys()) + CountTriangles(mesh->GetStrips()))
  , Curves(std::max(1, static_cast<int>(std::ceil(2.0 * settings.Curl))))
{
  if (this->Normals && this->Normals->GetNumberOfTuples() < mesh->GetNumberOfPoints())
  {
    this->Normals = nullptr;
  }
  const GhostCells ghosts(mesh);
  double sum = 0.0;
  const auto number = static_cast<vtkIdType>(this->Triangles.GetTriangles().size());
  this->Areas.reserve(number);
  for (vtkIdType triangle = 0; triangle < number; ++triangle)
  {
    const double area = length(GetAreaNormal(this->Triangles, triangle));
    this->NumberOfBadTriangles -= area > 0.0 && std::isfinite(area) ? 1 : 0;
    sum += std::isfinite(area) && !ghosts.Has(this->Triangles.GetCell(triangle)) ? area : 0.0;
    this->Areas.push_back(sum);
  }
}

double HairGrowth::GetNumberOfHairs() const
{
  return std::floor(this->Settings.Density * this->GetArea() + 0.5);
}

// Returns a random number in [0, 1).
double HairGrowth::Throw(vtkIdType hair, int which) const
{
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  std::uint64_t x = Scramble(static_cast<std::uint64_t>(this->Settings.Seed) + golden);
  x = Scramble(x + golden * static_cast<std::uint64_t>(hair + 1));
  x = Scramble(x + golden * static_cast<std::uint64_t>(which + 1));
  return std::ldexp(static_cast<double>(x >> 11), -53);
}

dvec3 HairGrowth::GetNormal(vtkIdType triangle, const dvec3& weights) const
{
  const dvec3 flat = normalize(GetAreaNormal(this->Triangles, triangle));
  dvec3 sum(0.0);
  for (int corner = 0; this->Normals && corner < 3; ++corner)
  {
    dvec3 normal(0.0);
    this->Normals->GetTuple(this->Triangles.GetPoints(triangle)[corner], &normal.x);
    sum += weights[corner] * normal;
  }
  const double size = length(sum);
  return size > 0.0 && std::isfinite(size) ? sum / size : flat;
}

// Each hair has an equal share of the area, so that the density is uniform.
HairGrowth::Root HairGrowth::FindRoot(vtkIdType hair) const
{
  const double area = (static_cast<double>(hair) + this->Throw(hair, AREA)) /
    this->GetNumberOfHairs() * this->GetArea();
  // The first triangle whose prefix sum is greater has an area.
  auto found = std::upper_bound(this->Areas.begin(), this->Areas.end(), area);
  if (found == this->Areas.end())
  {
    found = std::lower_bound(this->Areas.begin(), this->Areas.end(), this->GetArea());
  }
  const vtkIdType triangle = found - this->Areas.begin();
  const double first = std::sqrt(this->Throw(hair, FIRST_SIDE));
  const double second = this->Throw(hair, SECOND_SIDE);
  const dvec3 weights(1.0 - first, first * (1.0 - second), first * second);
  const SurfaceTriangles::Triangle& corners = this->Triangles.GetPoints(triangle);
  dvec3 place(0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    place += weights[corner] * GetPosition(this->Triangles, corners[corner]);
  }
  return { place, this->GetNormal(triangle, weights), this->Triangles.GetCell(triangle) };
}

vtkIdType HairGrowth::Grow(vtkIdType hair, dvec3* points) const
{
  const Root root = this->FindRoot(hair);
  const double share = ShortestShare + (1.0 - ShortestShare) * this->Throw(hair, LENGTH);
  const double size = this->Settings.Length * share;
  const Strand strand(root.Normal, this->Settings, 2.0 * vtkMath::Pi() * this->Throw(hair, PHASE));
  // Cubic Hermite curves are C1 continuous at joints.
  const double third = 1.0 / (3.0 * this->Curves);
  for (int i = 0; i <= this->Curves; ++i)
  {
    const Placed joint = strand.Evaluate(static_cast<double>(i) / this->Curves);
    for (int side = i == 0 ? 0 : -1; side <= (i == this->Curves ? 0 : 1); ++side)
    {
      points[3 * i + side] = root.Place + size * (joint.Place + (side * third) * joint.Derivative);
    }
  }
  return root.Cell;
}

double HairGrowth::GetRadius(int point) const
{
  const double s = static_cast<double>(point) / (3 * this->Curves);
  return ThickestRadius * this->Settings.Length * (1.0 - (1.0 - ThinnestShare) * s);
}
}
