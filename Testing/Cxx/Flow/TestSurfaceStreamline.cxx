// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Streamlines of surfaces against ones that are known.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "Surface/SurfaceStreamline.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

#include <iostream>
#include <limits>
#include <random>

namespace
{
using namespace RelevoVectors;
using relevo::SurfaceStreamline;
using relevo::SurfaceVectors;

constexpr double NoDataMagnitude = 1e8;

// The vectors of a mesh; both stay.
class Field
{
public:
  Field(vtkPolyData* mesh, const std::function<Vector(const Vector&)>& function)
    : Mesh(mesh)
  {
    RelevoMeshes::FillVectors(mesh, function, this->Array);
    this->Vectors = std::make_unique<SurfaceVectors>(mesh, this->Array, false, NoDataMagnitude);
  }
  // One vector for each cell.
  Field(vtkPolyData* mesh, const std::vector<Vector>& vectors)
    : Mesh(mesh)
  {
    this->Array->SetNumberOfComponents(3);
    for (const Vector& v : vectors)
    {
      this->Array->InsertNextTuple(v.data());
    }
    this->Vectors = std::make_unique<SurfaceVectors>(mesh, this->Array, true, NoDataMagnitude);
  }

  // Where a line from a point is after some steps; `done` says after how many.
  Vector Walk(
    vtkIdType point, bool forward, double step, int numberOfSteps, int* done = nullptr) const
  {
    SurfaceStreamline line(*this->Vectors, forward, true);
    line.StartAt(this->Vectors->GetTriangles().GetPlace(point));
    int k = 0;
    while (k < numberOfSteps && line.Advance(step))
    {
      ++k;
    }
    if (done)
    {
      *done = k;
    }
    return line.GetPosition();
  }

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkDoubleArray> Array;
  std::unique_ptr<SurfaceVectors> Vectors;
};

// Circles about an axis on the unit sphere, some of them great: the end points, at a length of 1,
// are as far from the mesh's edges squared.
void CheckCircles(RelevoCheck& check, int n)
{
  const Vector axis = normalize({ { 0.3, -0.5, 0.8 } });
  auto sphere = RelevoMeshes::Sphere(2 * n, n);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    Vector p;
    sphere->GetPoint(i, p.data());
    sphere->GetPoints()->SetPoint(i, normalize(p).data());
  }
  const Field field(sphere, [&](const Vector& p) { return cross(axis, p); });
  const double edge = vtkMath::Pi() / n;
  const int steps = 4 * n / 3;
  double largest = 0.0;
  double sum = 0.0;
  int lines = 0;
  for (vtkIdType point = 0; point < sphere->GetNumberOfPoints(); ++point)
  {
    Vector start;
    sphere->GetPoint(point, start.data());
    const Vector centre = dot(axis, start) * axis;
    const Vector arm = start - centre;
    if (length(arm) < 0.3)
    {
      continue;
    }
    for (double way : { 1.0, -1.0 })
    {
      int done;
      const Vector end = field.Walk(point, way > 0.0, 1.0 / steps, steps, &done);
      CHECK(done == steps);
      const double angle = way / length(arm);
      const double error =
        length(end - (centre + std::cos(angle) * arm + std::sin(angle) * cross(axis, arm)));
      largest = std::max(largest, error);
      sum += error;
      ++lines;
    }
  }
  std::cout << sphere->GetNumberOfCells() << " triangles, " << lines << " lines: off by "
            << sum / lines << " on the mean, at most " << largest << "\n";
  CHECK(lines > n * n);
  CHECK(sum / lines < 0.25 * edge * edge);
  CHECK(largest < 0.5 * edge * edge);
}

// Straight lines on a plane of random triangles, from all points, as far as the border; however its
// triangles wind, and with points of their own.
void CheckPlane(RelevoCheck& check)
{
  auto plane = RelevoMeshes::Plane(9, 7);
  std::mt19937 random(3);
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < plane->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> quad;
    plane->GetCellPoints(cell, quad);
    const vtkIdType turn = static_cast<vtkIdType>(random() % 2);
    for (vtkIdType half : { 0, 2 })
    {
      vtkIdType corners[3];
      for (vtkIdType i = 0; i < 3; ++i)
      {
        corners[i] = quad->GetId((turn + half + i) % 4);
      }
      if (random() % 2)
      {
        std::swap(corners[0], corners[1]);
      }
      triangles->InsertNextCell(3, corners);
    }
  }
  plane->SetPolys(triangles);
  // Turned in space.
  const Vector e1 = normalize({ { 0.6, 0.3, -0.5 } });
  const Vector e2 = normalize(cross(e1, { { 0.1, 0.9, 0.2 } }));
  const Vector normal = cross(e1, e2);
  std::vector<Vector> flat;
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    Vector p;
    plane->GetPoint(i, p.data());
    flat.push_back({ { p[0], p[1], 0.0 } });
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& p : flat)
  {
    points->InsertNextPoint((p[0] * e1 + p[1] * e2).data());
  }
  plane->SetPoints(points);
  auto exploded = RelevoMeshes::Explode(plane);
  constexpr double Step = 0.03;
  // Along the edges as well: on the border as far as its end.
  for (double degrees : { 0.0, 90.0, 37.0, 161.0, 254.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const Vector way = std::cos(angle) * e1 + std::sin(angle) * e2;
    for (vtkPolyData* mesh : { plane.Get(), exploded.Get() })
    {
      // What stands on the surface does not count.
      const Field field(mesh, [&](const Vector& p) { return (2.0 + p[0]) * way + p[1] * normal; });
      for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
      {
        Vector start;
        mesh->GetPoint(point, start.data());
        const double at[2] = { dot(start, e1), dot(start, e2) };
        const double toward[2] = { std::cos(angle), std::sin(angle) };
        double most = 1e9;
        for (int i = 0; i < 2; ++i)
        {
          if (std::abs(toward[i]) > 1e-9)
          {
            most = std::min(most, (std::copysign(0.5, toward[i]) - at[i]) / toward[i]);
          }
        }
        int done;
        const int steps = static_cast<int>((most - 1e-9) / Step);
        const Vector end = field.Walk(point, true, Step, steps, &done);
        CHECK(done == steps);
        if (steps > 0)
        {
          CHECK(length(end - (start + steps * Step * way)) < 1e-6);
        }
        if (most > 1e-6)
        {
          // It ends at the border, and there it is.
          const Vector border = field.Walk(point, true, Step, steps + 2, &done);
          CHECK(done == steps || std::abs(most - (steps + 1) * Step) < 1e-6);
          CHECK(length(border - (start + most * way)) < 1e-6);
        }
      }
    }
  }
}

// Two cells that meet on the y axis, with a vector each.
RelevoMeshes::Mesh Roof()
{
  return RelevoMeshes::FromTriangles(
    { { { 0, -1, 0 } }, { { 0, 1, 0 } }, { { -1, 0, -0.5 } }, { { 1, 0, -0.5 } } },
    { { { 0, 1, 2 } }, { { 1, 0, 3 } } });
}

// Where both triangles of an edge send a line to it, it slides.
void CheckSliding(RelevoCheck& check)
{
  int done;
  auto roof = Roof();
  const Field along(roof, { { { 2, 1, 1 } }, { { -1, 1, 0.5 } } });
  Vector end = along.Walk(2, true, 0.1, 15, &done); // of the left corner
  CHECK(done == 15);
  // sqrt(5/6) of each 1 is up the slope, of length sqrt(1.25).
  const double slope = std::sqrt(1.25) * std::sqrt(6.0 / 5.0);
  CHECK_NEAR(end[0], 0.0, 1e-12);
  CHECK_NEAR(end[2], 0.0, 1e-12);
  CHECK_NEAR(end[1], slope * std::sqrt(1.0 / 6.0) + (1.5 - slope), 1e-9);
  along.Walk(2, true, 0.1, 50, &done);
  CHECK(done < 50);
  // Head-on.
  const Field against(roof, { { { 2, 0, 1 } }, { { -2, 0, 1 } } });
  end = against.Walk(2, true, 0.1, 50, &done);
  CHECK(done == static_cast<int>(std::sqrt(1.25) / 0.1));
  CHECK_NEAR(length(end), 0.0, 1e-9);
  // Away from the edge nothing slides.
  const Field apart(roof, { { { -2, 1, -1 } }, { { 1, 1, -0.5 } } });
  CHECK(std::abs(apart.Walk(0, true, 0.1, 3)[0]) > 0.1);
}

// What ends a line.
void CheckEnds(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector right{ { 1, 0, 0 } };
  auto strip = RelevoMeshes::Plane(20, 1);
  for (double sentinel : { nan, -1e9, 1e20, static_cast<double>(HUGE_VAL) })
  {
    const Field field(strip,
      [&](const Vector& p) {
        return p[0] > 0.01 ? Vector{ { sentinel, 1, 0 } } : right;
      });
    int done;
    const Vector end = field.Walk(0, true, 0.01, 100, &done);
    CHECK(done == 50 || done == 49);
    CHECK_NEAR(end[0], 0.0, 1e-6);
    field.Walk(20, true, 0.01, 100, &done); // in the midst of no data
    CHECK(done == 0);
  }
  const Field still(
    strip, [&](const Vector& p) { return std::max(0.0, -p[0]) * right; }); // shorter and shorter
  int done;
  CHECK(still.Walk(0, true, 0.01, 100, &done)[0] < 1e-6);
  CHECK(done <= 50);
  const Field none(strip, [&](const Vector&) { return Vector{}; });
  none.Walk(0, true, 0.01, 100, &done);
  CHECK(done == 0);
  // Three triangles at an edge; one without area.
  auto fin = Roof();
  fin->GetPoints()->InsertNextPoint(0, 0, 1);
  fin->GetPolys()->InsertNextCell({ 0, 1, 4 });
  const Field over(fin, { { { 2, 0, 1 } }, { { 2, 0, -1 } }, { { 0, 0, 1 } } });
  over.Walk(2, true, 0.1, 50, &done);
  CHECK(done == static_cast<int>(std::sqrt(1.25) / 0.1));
  auto thin = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0.5, 0 } }, { { 0, 0.4, 0 } }, { { 1, 0.5, 0 } } },
    { { { 0, 1, 2 } }, { { 0, 3, 1 } }, { { 0, 4, 3 } }, { { 3, 4, 1 } } });
  const Field into(thin, [&](const Vector&) { return right; });
  into.Walk(2, true, 0.1, 50, &done);
  CHECK(done == 9 || done == 10);
}

// Whatever the mesh and its vectors, lines end or go on, and are somewhere.
void CheckHostile(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<RelevoMeshes::Mesh> meshes{ RelevoMeshes::Mixed(), RelevoMeshes::NonManifold(),
    RelevoMeshes::Moebius(), RelevoMeshes::Slivers(), RelevoMeshes::Strips(), RelevoMeshes::Cone(),
    RelevoMeshes::Cube(), RelevoMeshes::Torus(), RelevoMeshes::TexturedSphere(9, 7) };
  std::mt19937 random(9);
  const auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  for (vtkPolyData* mesh : meshes)
  {
    double bounds[6];
    mesh->GetBounds(bounds);
    for (double scale : { 1e-30, 1.0, 1e7 })
    {
      const Field field(mesh,
        [&](const Vector&)
        {
          const double size = random() % 10 ? scale : (random() % 2 ? 0.0 : nan);
          return Vector{ { size * number(), size * number(), size * number() } };
        });
      for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
      {
        for (double step : { 1e-3, 0.3, 100.0 })
        {
          int done;
          const Vector end = field.Walk(point, random() % 2, step, 20, &done);
          for (int i = 0; i < 3 && done > 0; ++i)
          {
            CHECK(end[i] >= bounds[2 * i] - 1e-9 && end[i] <= bounds[2 * i + 1] + 1e-9);
          }
        }
      }
    }
  }
}
}

int TestSurfaceStreamline(int, char*[])
{
  RelevoCheck check;
  for (int n : { 20, 40, 80 })
  {
    CheckCircles(check, n);
  }
  CheckPlane(check);
  CheckSliding(check);
  CheckEnds(check);
  CheckHostile(check);
  return check.GetResult();
}
