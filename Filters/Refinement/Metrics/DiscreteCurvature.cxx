// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/DiscreteCurvature.h"

#include "Core/RefinementMathematics.h"
#include "Mesh/SurfaceTriangles.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using glm::dvec3;

enum class Ring : unsigned char
{
  None,   // no triangle
  Open,   // triangles, but no closed ring
  Queued, // open, its value about to be taken from its neighbours
  Known   // has its value
};

// A triangle as one of its corners sees it.
struct Corner
{
  double Angle = 0.0;
  double MixedArea = 0.0;
  double Area = 0.0;
  dvec3 Laplacian{ 0.0, 0.0, 0.0 };
  dvec3 Normal{ 0.0, 0.0, 0.0 }; // twice the area long

  // The corner is at x, the triangle (x, p, q).
  Corner(const dvec3& x, const dvec3& p, const dvec3& q)
  {
    const dvec3 toP = p - x;
    const dvec3 toQ = q - x;
    const dvec3 pToQ = q - p;
    this->Normal = glm::cross(toP, toQ);
    const double twiceArea = glm::length(this->Normal);
    const double dotX = glm::dot(toP, toQ);
    const double dotP = -glm::dot(toP, pToQ);
    const double dotQ = glm::dot(toQ, pToQ);
    this->Angle = std::atan2(twiceArea, dotX);
    if (!(twiceArea > 0.0))
    {
      return;
    }
    const double cotP = dotP / twiceArea;
    const double cotQ = dotQ / twiceArea;
    this->Area = 0.5 * twiceArea;
    this->Laplacian = (-cotQ) * toP + (-cotP) * toQ;
    if (dotX < 0.0)
    {
      this->MixedArea = 0.5 * this->Area;
    }
    else if (dotP < 0.0 || dotQ < 0.0)
    {
      this->MixedArea = 0.25 * this->Area;
    }
    else // the Voronoi area
    {
      this->MixedArea = 0.125 * (cotQ * glm::dot(toP, toP) + cotP * glm::dot(toQ, toQ));
    }
  }
};

// Whether every edge at the place has exactly two triangles. `neighbours` is scratch space.
bool HasClosedRing(
  const relevo::SurfaceTriangles& surface, vtkIdType place, std::vector<vtkIdType>& neighbours)
{
  neighbours.clear();
  surface.ForEachTriangle(place,
    [&neighbours](vtkIdType p, vtkIdType q)
    {
      neighbours.push_back(p);
      neighbours.push_back(q);
    });
  std::sort(neighbours.begin(), neighbours.end());
  for (std::size_t i = 0; i < neighbours.size(); i += 2)
  {
    const bool pair = neighbours[i] == neighbours[i + 1];
    const bool third = i + 2 < neighbours.size() && neighbours[i] == neighbours[i + 2];
    if (!pair || third)
    {
      return false;
    }
  }
  return true;
}

double FiniteOrZero(double x)
{
  return std::isfinite(x) ? x : 0.0;
}
}

namespace relevo
{
DiscreteCurvature ComputeDiscreteCurvature(vtkPolyData* mesh)
{
  DiscreteCurvature curvature;
  const vtkIdType n = mesh->GetNumberOfPoints();
  curvature.Gaussian.assign(n, 0.0);
  curvature.Mean.assign(n, 0.0);
  if (n == 0)
  {
    return curvature;
  }
  const SurfaceTriangles surface(mesh);
  const auto pointAt = [&surface](vtkIdType place)
  {
    dvec3 x;
    surface.GetPoint(place, &x[0]);
    return x;
  };

  std::vector<Ring> rings(n, Ring::None);
  std::vector<double> areas(n, 0.0);
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> scratch;
      for (vtkIdType place = begin; place < end; ++place)
      {
        if (surface.GetNumberOfTriangles(place) == 0)
        {
          continue;
        }
        const dvec3 x = pointAt(place);
        double angle = 0.0;
        double mixedArea = 0.0;
        double area = 0.0;
        dvec3 laplacian(0.0, 0.0, 0.0);
        dvec3 normal(0.0, 0.0, 0.0);
        surface.ForEachTriangle(place,
          [&](vtkIdType p, vtkIdType q)
          {
            const Corner corner(x, pointAt(p), pointAt(q));
            angle += corner.Angle;
            mixedArea += corner.MixedArea;
            area += corner.Area;
            laplacian += corner.Laplacian;
            normal += corner.Normal;
          });
        areas[place] = area;
        if (!HasClosedRing(surface, place, scratch))
        {
          rings[place] = Ring::Open;
          continue;
        }
        rings[place] = Ring::Known;
        const double sign = glm::dot(laplacian, normal) < 0.0 ? -1.0 : 1.0;
        curvature.Gaussian[place] = FiniteOrZero((2.0 * vtkMath::Pi() - angle) / mixedArea);
        curvature.Mean[place] = FiniteOrZero(sign * glm::length(laplacian) / (4.0 * mixedArea));
      }
    });

  // Inwards to outwards: open rings take the mean of the neighbours that have a value already.
  std::vector<vtkIdType> front;
  for (vtkIdType place = 0; place < n; ++place)
  {
    if (rings[place] != Ring::None)
    {
      curvature.Places.push_back(place);
      curvature.AreaOfPlace += areas[place] / 3.0;
    }
    if (rings[place] == Ring::Known)
    {
      front.push_back(place);
    }
  }
  if (!curvature.Places.empty())
  {
    curvature.AreaOfPlace = FiniteOrZero(curvature.AreaOfPlace / curvature.Places.size());
  }
  std::vector<vtkIdType> next;
  while (!front.empty())
  {
    next.clear();
    const auto enqueue = [&](vtkIdType place)
    {
      if (rings[place] == Ring::Open)
      {
        rings[place] = Ring::Queued;
        next.push_back(place);
      }
    };
    for (vtkIdType place : front)
    {
      surface.ForEachTriangle(place,
        [&](vtkIdType p, vtkIdType q)
        {
          enqueue(p);
          enqueue(q);
        });
    }
    for (vtkIdType place : next)
    {
      double gaussian = 0.0;
      double mean = 0.0;
      int count = 0;
      const auto add = [&](vtkIdType neighbour)
      {
        if (rings[neighbour] == Ring::Known)
        {
          gaussian += curvature.Gaussian[neighbour];
          mean += curvature.Mean[neighbour];
          ++count;
        }
      };
      surface.ForEachTriangle(place,
        [&](vtkIdType p, vtkIdType q)
        {
          add(p);
          add(q);
        });
      curvature.Gaussian[place] = FiniteOrZero(gaussian / count);
      curvature.Mean[place] = FiniteOrZero(mean / count);
    }
    for (vtkIdType place : next)
    {
      rings[place] = Ring::Known;
    }
    std::swap(front, next);
  }

  for (vtkIdType point = 0; point < n; ++point)
  {
    const vtkIdType place = surface.GetPlace(point);
    curvature.Gaussian[point] = curvature.Gaussian[place];
    curvature.Mean[point] = curvature.Mean[place];
  }
  return curvature;
}
}
