// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CreaseNormals.h"

#include "Mathematics/DisjointSets.h"
#include "Mesh/GivenNormals.h"
#include "Mesh/SurfaceEdges.h"
#include "Mesh/SurfaceNormals.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>

namespace relevo
{
namespace
{
constexpr double FlatAngle = 1e-3; // radians; rounding of points causes smaller angles

double getAngle(const dvec3& a, const dvec3& b)
{
  return std::atan2(length(cross(a, b)), dot(a, b));
}

dvec3 getUnit(const dvec3& vector)
{
  const double size = length(vector);
  return size > 0.0 && std::isfinite(size) ? vector / size : dvec3(0.0);
}

// Returns the mesh's normal at a point, or 0 if there is none.
dvec3 getGiven(vtkDataArray* normals, vtkIdType point)
{
  dvec3 normal(0.0);
  const bool isGiven = normals && IsLengthOfNormal(GetUnitNormal(normals, point, &normal[0]));
  return isGiven ? normal : dvec3(0.0);
}
}

CreaseNormals::CreaseNormals(vtkPolyData* mesh, double featureAngle, bool keepCoarseFlat)
  : Triangles(std::make_shared<SurfaceTriangles>(mesh))
  , AreaVectors(SurfaceNormals(this->Triangles).GetAreaVectors())
{
  // Angles equal to the feature angle up to rounding are not creases.
  const double limit = featureAngle + FlatAngle;
  const vtkIdType firstStrip =
    mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() + mesh->GetNumberOfPolys();
  const SurfaceEdges edges(this->Triangles);
  DisjointSets corners(static_cast<vtkIdType>(3 * this->AreaVectors.size()));
  const bool isNoisy = keepCoarseFlat && this->AreCreasesNoise(edges, limit);
  const double largest = isNoisy ? vtkMath::Pi() : limit;
  const bool isCoarse = this->UniteCorners(edges, firstStrip, largest, corners) && !isNoisy;
  const std::vector<dvec3> polygons = this->SumPolygons(firstStrip);
  const vtkIdType numberOfOwn = this->ChooseNormals(mesh, largest, corners, polygons);
  if (keepCoarseFlat && isCoarse && 2 * numberOfOwn < static_cast<vtkIdType>(polygons.size()))
  {
    std::transform(polygons.begin(), polygons.end(), this->Normals.begin(), getUnit);
  }
  this->CountCreases(edges);
  this->Curved = this->Curved && !isNoisy; // the noise would make curved faces bulge
}

vtkIdType CreaseNormals::ChooseNormals(
  vtkPolyData* mesh, double featureAngle, DisjointSets& corners, const std::vector<dvec3>& polygons)
{
  const auto numberOfCorners = static_cast<vtkIdType>(polygons.size());
  // Weighting by area keeps a large flat face next to the narrow faces of a fillet flat.
  std::vector<dvec3> sums(polygons.size(), dvec3(0.0));
  for (vtkIdType corner = 0; corner < numberOfCorners; ++corner)
  {
    sums[corners.Find(corner)] += this->AreaVectors[corner / 3];
  }
  vtkDataArray* given = GetGivenNormals(mesh);
  vtkIdType numberOfGiven = 0;
  this->Normals.resize(polygons.size());
  for (vtkIdType corner = 0; corner < numberOfCorners; ++corner)
  {
    const dvec3 own = getUnit(polygons[corner]);
    // A larger angle would bend the face away from its plane, as at the tip of a cone.
    const auto fits = [&](const dvec3& normal)
    { return dot(normal, normal) > 0.0 && getAngle(normal, own) <= featureAngle; };
    const vtkIdType point = this->Triangles->GetPoints(corner / 3)[corner % 3];
    const dvec3 ofPoint = getGiven(given, point);
    const dvec3 mean = getUnit(sums[corners.Find(corner)]);
    numberOfGiven += fits(ofPoint) ? 1 : 0;
    this->Normals[corner] = fits(ofPoint) ? ofPoint : fits(mean) ? mean : own;
  }
  return numberOfGiven;
}

bool CreaseNormals::AreCreasesNoise(const SurfaceEdges& edges, double featureAngle) const
{
  const double nearby = 1.5;
  const auto& triangles = this->Triangles->GetTriangles();
  vtkIdType numberOfBends = 0;
  vtkIdType numberOfNearBends = 0; // slightly less than the feature angle
  vtkIdType numberOfCreases = 0;
  std::map<vtkIdType, std::array<int, 2>> creases; // at a merged point: ridges, valleys
  for (const SurfaceEdgeSides& sides : edges.GetSides())
  {
    const vtkIdType a = sides.Triangles[0];
    const vtkIdType b = sides.Triangles[1];
    if (a < 0 || b < 0 || sides.Type != SurfaceEdgeSides::INNER)
    {
      continue;
    }
    const double angle = getAngle(this->AreaVectors[a], this->AreaVectors[b]);
    numberOfBends += angle > FlatAngle ? 1 : 0;
    numberOfNearBends += angle > featureAngle / nearby && angle <= featureAngle ? 1 : 0;
    if (angle > featureAngle)
    {
      ++numberOfCreases;
      const auto& mergedPoints = edges.GetEdges()[sides.Edge].MergedPoints;
      // In a valley, the opposite corner of b is above the plane of a.
      const SurfaceTriangles::Triangle& corners = triangles[b];
      const vtkIdType beyond =
        corners[0] + corners[1] + corners[2] - mergedPoints[0] - mergedPoints[1];
      dvec3 ends[2];
      this->Triangles->GetPoint(beyond, &ends[0][0]);
      this->Triangles->GetPoint(mergedPoints[0], &ends[1][0]);
      const int isValley = dot(this->AreaVectors[a], ends[0] - ends[1]) > 0.0 ? 1 : 0;
      ++creases[mergedPoints[0]][isValley];
      ++creases[mergedPoints[1]][isValley];
    }
  }
  const auto numberOfTornPlaces = std::count_if(creases.begin(), creases.end(),
    [](const auto& mergedPoint)
    {
      const std::array<int, 2>& signs = mergedPoint.second;
      return signs[0] + signs[1] == 1 || (signs[0] > 0 && signs[1] > 0);
    });
  return 50 * numberOfCreases > numberOfBends && 4 * numberOfNearBends > numberOfCreases &&
    2 * numberOfTornPlaces > static_cast<std::ptrdiff_t>(creases.size());
}

bool CreaseNormals::UniteCorners(
  const SurfaceEdges& edges, vtkIdType firstStrip, double featureAngle, DisjointSets& corners)
{
  const double coarse = 1.5;
  vtkIdType numberOfBends = 0;
  vtkIdType numberOfCoarseBends = 0;
  for (const SurfaceEdgeSides& sides : edges.GetSides())
  {
    const vtkIdType a = sides.Triangles[0];
    const vtkIdType b = sides.Triangles[1];
    if (a < 0 || b < 0)
    {
      continue;
    }
    const vtkIdType cell = this->Triangles->GetCell(a);
    const bool isOnePolygon = cell == this->Triangles->GetCell(b) && cell < firstStrip;
    const double angle = getAngle(this->AreaVectors[a], this->AreaVectors[b]);
    numberOfBends += !isOnePolygon && angle > FlatAngle ? 1 : 0;
    numberOfCoarseBends +=
      !isOnePolygon && angle > featureAngle / coarse && angle < featureAngle * coarse ? 1 : 0;
    if (isOnePolygon || (sides.Type == SurfaceEdgeSides::INNER && angle <= featureAngle))
    {
      for (int mergedPoint : edges.GetEdges()[sides.Edge].MergedPoints)
      {
        corners.Unite(this->FindCorner(a, mergedPoint), this->FindCorner(b, mergedPoint));
      }
    }
  }
  return 2 * numberOfCoarseBends > numberOfBends;
}

void CreaseNormals::CountCreases(const SurfaceEdges& edges)
{
  for (const SurfaceEdgeSides& sides : edges.GetSides())
  {
    const vtkIdType a = sides.Triangles[0];
    const vtkIdType b = sides.Triangles[1];
    if (a < 0 || b < 0)
    {
      continue;
    }
    const auto& mergedPoints = edges.GetEdges()[sides.Edge].MergedPoints;
    const bool isCrease = std::all_of(std::begin(mergedPoints), std::end(mergedPoints),
      [&](int mergedPoint)
      {
        return getAngle(this->Normals[this->FindCorner(a, mergedPoint)],
                 this->Normals[this->FindCorner(b, mergedPoint)]) > FlatAngle;
      });
    this->NumberOfCreases += isCrease ? 1 : 0;
    this->Curved = this->Curved ||
      (!isCrease && getAngle(this->AreaVectors[a], this->AreaVectors[b]) > FlatAngle);
  }
}

std::vector<dvec3> CreaseNormals::SumPolygons(vtkIdType firstStrip) const
{
  const vtkIdType numberOfTriangles = static_cast<vtkIdType>(this->AreaVectors.size());
  std::vector<dvec3> sums(3 * this->AreaVectors.size());
  std::vector<vtkIdType> order;
  for (vtkIdType first = 0, end; first < numberOfTriangles; first = end)
  {
    const vtkIdType cell = this->Triangles->GetCell(first);
    end = first + 1;
    while (cell < firstStrip && end < numberOfTriangles && this->Triangles->GetCell(end) == cell)
    {
      ++end;
    }
    order.resize(3 * (end - first));
    std::iota(order.begin(), order.end(), 3 * first);
    const auto getPlace = [&](vtkIdType corner)
    { return this->Triangles->GetTriangles()[corner / 3][corner % 3]; };
    std::sort(order.begin(), order.end(),
      [&](vtkIdType a, vtkIdType b) { return getPlace(a) < getPlace(b); });
    for (auto begin = order.begin(); begin != order.end();)
    {
      dvec3 sum(0.0);
      auto next = begin;
      for (; next != order.end() && getPlace(*next) == getPlace(*begin); ++next)
      {
        sum += this->AreaVectors[*next / 3];
      }
      for (; begin != next; ++begin)
      {
        sums[*begin] = sum;
      }
    }
  }
  return sums;
}

vtkIdType CreaseNormals::FindCorner(vtkIdType triangle, vtkIdType mergedPoint) const
{
  const SurfaceTriangles::Triangle& corners = this->Triangles->GetTriangles()[triangle];
  return 3 * triangle + (std::find(corners.begin(), corners.end(), mergedPoint) - corners.begin());
}
}
