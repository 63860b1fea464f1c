// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDiscreteCurvature.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkPointPlaces.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using glm::dvec3;

using Triangle = std::array<vtkIdType, 3>;

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

// The triangles of a mesh between places, and which of them meet at each place.
class Surface
{
public:
  explicit Surface(vtkPolyData* mesh)
    : Points(mesh->GetPoints())
    , Places(relevo::ComputePlaces(mesh->GetPoints()))
    , NumberOfPoints(mesh->GetNumberOfPoints())
  {
    this->AddPolygons(mesh->GetPolys());
    this->AddStrips(mesh->GetStrips());

    this->Starts.assign(this->NumberOfPoints + 1, 0);
    for (const Triangle& triangle : this->Triangles)
    {
      for (vtkIdType point : triangle)
      {
        ++this->Starts[point + 1];
      }
    }
    for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
    {
      this->Starts[point + 1] += this->Starts[point];
    }
    this->Uses.resize(3 * this->Triangles.size());
    std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->Uses[next[this->Triangles[t][corner]]++] = 3 * static_cast<vtkIdType>(t) + corner;
      }
    }
  }

  vtkIdType GetPlace(vtkIdType point) const
  {
    return this->Places.empty() ? point : this->Places[point];
  }

  dvec3 GetPoint(vtkIdType point) const
  {
    dvec3 x;
    this->Points->GetPoint(point, &x[0]);
    return x;
  }

  vtkIdType GetNumberOfTriangles(vtkIdType place) const
  {
    return this->Starts[place + 1] - this->Starts[place];
  }

  // Calls f(p, q) for every triangle (place, p, q).
  template <typename Function>
  void ForEachTriangle(vtkIdType place, Function&& f) const
  {
    for (vtkIdType i = this->Starts[place]; i < this->Starts[place + 1]; ++i)
    {
      const Triangle& triangle = this->Triangles[this->Uses[i] / 3];
      const int corner = static_cast<int>(this->Uses[i] % 3);
      f(triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]);
    }
  }

private:
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    Triangle triangle{ a, b, c };
    for (vtkIdType& point : triangle)
    {
      if (point < 0 || point >= this->NumberOfPoints)
      {
        return;
      }
      const dvec3 x = this->GetPoint(point);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        return;
      }
      point = this->GetPlace(point);
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      this->Triangles.push_back(triangle);
    }
  }

  // Calls f(size, points) for every cell.
  template <typename Function>
  static void ForEachCell(vtkCellArray* cells, Function&& f)
  {
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* points;
      cell->GetCurrentCell(size, points);
      f(size, points);
    }
  }

  void AddPolygons(vtkCellArray* polygons)
  {
    this->Triangles.reserve(polygons->GetNumberOfCells());
    ForEachCell(polygons,
      [this](vtkIdType size, const vtkIdType* points)
      {
        for (vtkIdType i = 1; i + 1 < size; ++i)
        {
          this->AddTriangle(points[0], points[i], points[i + 1]);
        }
      });
  }

  void AddStrips(vtkCellArray* strips)
  {
    ForEachCell(strips,
      [this](vtkIdType size, const vtkIdType* points)
      {
        for (vtkIdType i = 0; i + 2 < size; ++i)
        {
          const vtkIdType odd = i % 2;
          this->AddTriangle(points[i], points[i + 1 + odd], points[i + 2 - odd]);
        }
      });
  }

  vtkPoints* Points;
  std::vector<vtkIdType> Places;
  vtkIdType NumberOfPoints;
  std::vector<Triangle> Triangles;
  std::vector<vtkIdType> Starts; // into Uses, per place
  std::vector<vtkIdType> Uses;   // 3 * triangle + corner
};

// Whether every edge at the place has exactly two triangles. `neighbours` is scratch space.
bool HasClosedRing(const Surface& surface, vtkIdType place, std::vector<vtkIdType>& neighbours)
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
  const Surface surface(mesh);

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
        const dvec3 x = surface.GetPoint(place);
        double angle = 0.0;
        double mixedArea = 0.0;
        double area = 0.0;
        dvec3 laplacian(0.0, 0.0, 0.0);
        dvec3 normal(0.0, 0.0, 0.0);
        surface.ForEachTriangle(place,
          [&](vtkIdType p, vtkIdType q)
          {
            const Corner corner(x, surface.GetPoint(p), surface.GetPoint(q));
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
