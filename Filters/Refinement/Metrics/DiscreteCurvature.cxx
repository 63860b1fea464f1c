// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/DiscreteCurvature.h"

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceTriangles.h"
#include "vtkMath.h"
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
  Queued, // open, about to get a value from its neighbours
  Known   // has a value
};

// A triangle, relative to one of its corners.
struct Corner
{
  double Angle = 0.0;
  double MixedArea = 0.0;
  dvec3 Laplacian{ 0.0, 0.0, 0.0 };
  dvec3 Normal{ 0.0, 0.0, 0.0 }; // length is twice the area

  // The corner is at x, the triangle is (x, p, q).
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
    const double area = 0.5 * twiceArea;
    this->Laplacian = (-cotQ) * toP + (-cotP) * toQ;
    if (dotX < 0.0)
    {
      this->MixedArea = 0.5 * area;
    }
    else if (dotP < 0.0 || dotQ < 0.0)
    {
      this->MixedArea = 0.25 * area;
    }
    else // the Voronoi area
    {
      this->MixedArea = 0.125 * (cotQ * glm::dot(toP, toP) + cotP * glm::dot(toQ, toQ));
    }
  }
};

// Whether every edge at the merged point has exactly two triangles. `neighbours` is scratch space.
bool HasClosedRing(const relevo::SurfaceTriangles& surface, vtkIdType mergedPoint,
  std::vector<vtkIdType>& neighbours)
{
  neighbours.clear();
  surface.ForEachTriangle(mergedPoint,
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

// Computes the curvatures of all merged points, from the middle of the surface to its border.
class Curvatures
{
public:
  Curvatures(
    const relevo::SurfaceTriangles& surface, vtkIdType size, relevo::DiscreteCurvature& result)
    : Surface(surface)
    , Result(result)
    , Rings(size, Ring::None)
  {
  }

  // Computes the curvature if the triangles form a closed ring. `neighbours` is scratch space.
  void Measure(vtkIdType mergedPoint, std::vector<vtkIdType>& neighbours)
  {
    if (this->Surface.GetNumberOfTriangles(mergedPoint) == 0)
    {
      return;
    }
    relevo::RingCurvature curvature(this->GetPoint(mergedPoint));
    this->Surface.ForEachTriangle(mergedPoint,
      [&](vtkIdType p, vtkIdType q) { curvature.Add(this->GetPoint(p), this->GetPoint(q)); });
    if (!HasClosedRing(this->Surface, mergedPoint, neighbours))
    {
      this->Rings[mergedPoint] = Ring::Open;
      return;
    }
    this->Rings[mergedPoint] = Ring::Known;
    this->Result.Gaussian[mergedPoint] = curvature.GetGaussian();
    this->Result.Mean[mergedPoint] = curvature.GetMean();
  }

  void FindPlaces()
  {
    for (size_t mergedPoint = 0; mergedPoint < this->Rings.size(); ++mergedPoint)
    {
      if (this->Rings[mergedPoint] != Ring::None)
      {
        this->Result.MergedPoints.push_back(static_cast<vtkIdType>(mergedPoint));
      }
    }
  }

  // Sets points with open rings to the mean of the neighbours that have a value, from the measured
  // points outwards.
  void Spread()
  {
    std::vector<vtkIdType> front;
    for (vtkIdType mergedPoint : this->Result.MergedPoints)
    {
      if (this->Rings[mergedPoint] == Ring::Known)
      {
        front.push_back(mergedPoint);
      }
    }
    while (!front.empty())
    {
      const std::vector<vtkIdType> next = this->QueueNeighbours(front);
      for (vtkIdType mergedPoint : next)
      {
        this->TakeMean(mergedPoint);
      }
      for (vtkIdType mergedPoint : next)
      {
        this->Rings[mergedPoint] = Ring::Known;
      }
      front = next;
    }
  }

private:
  dvec3 GetPoint(vtkIdType mergedPoint) const
  {
    dvec3 x;
    this->Surface.GetPoint(mergedPoint, &x[0]);
    return x;
  }

  std::vector<vtkIdType> QueueNeighbours(const std::vector<vtkIdType>& front)
  {
    std::vector<vtkIdType> queue;
    const auto enqueue = [&](vtkIdType mergedPoint)
    {
      if (this->Rings[mergedPoint] == Ring::Open)
      {
        this->Rings[mergedPoint] = Ring::Queued;
        queue.push_back(mergedPoint);
      }
    };
    for (vtkIdType mergedPoint : front)
    {
      this->Surface.ForEachTriangle(mergedPoint,
        [&](vtkIdType p, vtkIdType q)
        {
          enqueue(p);
          enqueue(q);
        });
    }
    return queue;
  }

  void TakeMean(vtkIdType mergedPoint)
  {
    double gaussian = 0.0;
    double mean = 0.0;
    int count = 0;
    const auto add = [&](vtkIdType neighbour)
    {
      if (this->Rings[neighbour] == Ring::Known)
      {
        gaussian += this->Result.Gaussian[neighbour];
        mean += this->Result.Mean[neighbour];
        ++count;
      }
    };
    this->Surface.ForEachTriangle(mergedPoint,
      [&](vtkIdType p, vtkIdType q)
      {
        add(p);
        add(q);
      });
    this->Result.Gaussian[mergedPoint] = FiniteOrZero(gaussian / count);
    this->Result.Mean[mergedPoint] = FiniteOrZero(mean / count);
  }

  const relevo::SurfaceTriangles& Surface;
  relevo::DiscreteCurvature& Result;
  std::vector<Ring> Rings;
};
}

namespace relevo
{
void RingCurvature::Add(const dvec3& p, const dvec3& q)
{
  const Corner corner(this->Point, p, q);
  this->Angle += corner.Angle;
  this->MixedArea += corner.MixedArea;
  this->Laplacian += corner.Laplacian;
  this->Normal += corner.Normal;
}

double RingCurvature::GetGaussian() const
{
  return FiniteOrZero((2.0 * vtkMath::Pi() - this->Angle) / this->MixedArea);
}

double RingCurvature::GetMean() const
{
  const double sign = glm::dot(this->Laplacian, this->Normal) < 0.0 ? -1.0 : 1.0;
  return FiniteOrZero(sign * glm::length(this->Laplacian) / (4.0 * this->MixedArea));
}

DiscreteCurvature ComputeDiscreteCurvature(const SurfaceTriangles& surface)
{
  DiscreteCurvature result;
  const vtkIdType n = surface.GetNumberOfPoints();
  result.Gaussian.assign(n, 0.0);
  result.Mean.assign(n, 0.0);
  if (n == 0)
  {
    return result;
  }
  Curvatures curvatures(surface, n, result);
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> neighbours;
      for (vtkIdType mergedPoint = begin; mergedPoint < end; ++mergedPoint)
      {
        curvatures.Measure(mergedPoint, neighbours);
      }
    });
  curvatures.FindPlaces();
  curvatures.Spread();
  for (vtkIdType point = 0; point < n; ++point)
  {
    const vtkIdType mergedPoint = surface.GetMergedPoint(point);
    result.Gaussian[point] = result.Gaussian[mergedPoint];
    result.Mean[point] = result.Mean[mergedPoint];
  }
  return result;
}
}
