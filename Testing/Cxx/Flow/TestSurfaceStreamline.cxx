// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that streamlines on surfaces follow curves that are known exactly: circles on spheres and
// straight lines on planes.
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

// A mesh with a vector array, which may have missing values.
class Field
{
public:
  Field(vtkPolyData* mesh, const std::function<Vector(const Vector&)>& function)
    : Mesh(mesh)
  {
    RelevoMeshes::FillVectors(mesh, function, this->Array);
    this->Vectors = std::make_unique<SurfaceVectors>(mesh, this->Array, false, NoDataMagnitude);
  }
  // Uses one vector per cell.
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

  // Returns where a line from a point is after some steps. `done` receives the number of steps
  // taken.
  Vector Walk(
    vtkIdType point, bool forward, double step, int numberOfSteps, int* done = nullptr) const
  {
    SurfaceStreamline line(*this->Vectors, forward, true);
    line.StartAt(this->Vectors->GetTriangles().GetMergedPoint(point));
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

// On the unit sphere, lines are circles about an axis. After a length of 1, the error is at most
// the square of the mesh's edge length.
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
      CHECK_CASE(way);
      int done;
      const Vector end = field.Walk(point, way > 0.0, 1.0 / steps, steps, &done);
      CHECK_EQUAL(done, steps);
      const double angle = way / length(arm);
      const double error =
        length(end - (centre + std::cos(angle) * arm + std::sin(angle) * cross(axis, arm)));
      largest = std::max(largest, error);
      sum += error;
      ++lines;
    }
  }
  std::cout << sphere->GetNumberOfCells() << " triangles, " << lines << " lines: error "
            << sum / lines << " on average, at most " << largest << "\n";
  CHECK_GREATER(lines, n * n);
  CHECK_LESS(sum / lines, 0.25 * edge * edge);
  CHECK_LESS(largest, 0.5 * edge * edge);
}

// Axes of a plane that is rotated in space.
struct Axes
{
  Vector E1 = normalize({ { 0.6, 0.3, -0.5 } });
  Vector E2 = normalize(cross(this->E1, { { 0.1, 0.9, 0.2 } }));
  Vector Normal = cross(this->E1, this->E2);
};

// A uniform field on a square of side 1 about the origin, whose streamlines are straight.
class StraightField
{
public:
  StraightField(vtkPolyData* mesh, const Axes& axes, double degrees)
    : Square(mesh)
    , Along(axes)
    , Toward{ { std::cos(vtkMath::RadiansFromDegrees(degrees)),
        std::sin(vtkMath::RadiansFromDegrees(degrees)) } }
    , Policy(this->Toward[0] * axes.E1 + this->Toward[1] * axes.E2)
    // The part along the normal has no effect.
    , Lines(mesh,
        [this](const Vector& p) { return (2.0 + p[0]) * this->Policy + p[1] * this->Along.Normal; })
  {
  }

  // A line from the point is straight up to the border.
  void CheckLine(RelevoCheck& check, vtkIdType point) const
  {
    constexpr double Step = 0.03;
    Vector start;
    this->Square->GetPoint(point, start.data());
    const double most = this->GetWayToBorder(start);
    int done;
    const int steps = static_cast<int>((most - 1e-9) / Step);
    const Vector end = this->Lines.Walk(point, true, Step, steps, &done);
    CHECK_EQUAL(done, steps);
    if (steps > 0)
    {
      CHECK_LESS(length(end - (start + steps * Step * this->Policy)), 1e-6);
    }
    if (most > 1e-6)
    {
      // The line ends exactly at the border.
      const Vector border = this->Lines.Walk(point, true, Step, steps + 2, &done);
      CHECK(done == steps || std::abs(most - (steps + 1) * Step) < 1e-6);
      CHECK_LESS(length(border - (start + most * this->Policy)), 1e-6);
    }
  }

private:
  double GetWayToBorder(const Vector& start) const
  {
    const double at[2] = { dot(start, this->Along.E1), dot(start, this->Along.E2) };
    double most = 1e9;
    for (int i = 0; i < 2; ++i)
    {
      if (std::abs(this->Toward[i]) > 1e-9)
      {
        most = std::min(most, (std::copysign(0.5, this->Toward[i]) - at[i]) / this->Toward[i]);
      }
    }
    return most;
  }

  vtkSmartPointer<vtkPolyData> Square;
  Axes Along;
  std::array<double, 2> Toward;
  Vector Policy;
  Field Lines;
};

// Splits the quads of a mesh along either diagonal, with random winding.
void SplitAtRandom(vtkPolyData* mesh)
{
  std::mt19937 random(3);
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> quad;
    mesh->GetCellPoints(cell, quad);
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
  mesh->SetPolys(triangles);
}

void Tilt(vtkPolyData* mesh, const Axes& axes)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vector p;
    mesh->GetPoint(i, p.data());
    points->InsertNextPoint((p[0] * axes.E1 + p[1] * axes.E2).data());
  }
  mesh->SetPoints(points);
}

// On a plane of random triangles, lines from every point are straight up to the border. Neither
// winding nor unshared points change this.
void CheckPlane(RelevoCheck& check)
{
  auto plane = RelevoMeshes::Plane(9, 7);
  SplitAtRandom(plane);
  const Axes axes;
  Tilt(plane, axes);
  auto exploded = RelevoMeshes::Explode(plane);
  // Directions along the edges are included: such lines follow the border to its end.
  for (double degrees : { 0.0, 90.0, 37.0, 161.0, 254.0 })
  {
    CHECK_CASE(degrees);
    for (vtkPolyData* mesh : { plane.Get(), exploded.Get() })
    {
      const StraightField field(mesh, axes, degrees);
      for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
      {
        field.CheckLine(check, point);
      }
    }
  }
}

// Two cells that meet on the y axis, each with one vector.
RelevoMeshes::Mesh Roof()
{
  return RelevoMeshes::FromTriangles(
    { { { 0, -1, 0 } }, { { 0, 1, 0 } }, { { -1, 0, -0.5 } }, { { 1, 0, -0.5 } } },
    { { { 0, 1, 2 } }, { { 1, 0, 3 } } });
}

// If both triangles of an edge lead a line towards it, the line slides along the edge.
void CheckSliding(RelevoCheck& check)
{
  int done;
  auto roof = Roof();
  const Field along(roof, { { { 2, 1, 1 } }, { { -1, 1, 0.5 } } });
  Vector end = along.Walk(2, true, 0.1, 15, &done); // starts at the left corner
  CHECK_EQUAL(done, 15);
  // The part sqrt(5/6) of the unit vector points up the slope, whose length is sqrt(1.25).
  const double slope = std::sqrt(1.25) * std::sqrt(6.0 / 5.0);
  CHECK_NEAR(end[0], 0.0, 1e-12);
  CHECK_NEAR(end[2], 0.0, 1e-12);
  CHECK_NEAR(end[1], slope * std::sqrt(1.0 / 6.0) + (1.5 - slope), 1e-9);
  along.Walk(2, true, 0.1, 50, &done);
  CHECK_LESS(done, 50);
  // These vectors point at each other, so the line stops at the edge.
  const Field against(roof, { { { 2, 0, 1 } }, { { -2, 0, 1 } } });
  end = against.Walk(2, true, 0.1, 50, &done);
  CHECK_EQUAL(done, static_cast<int>(std::sqrt(1.25) / 0.1));
  CHECK_NEAR(length(end), 0.0, 1e-9);
  // These vectors lead away from the edge, so nothing slides.
  const Field apart(roof, { { { -2, 1, -1 } }, { { 1, 1, -0.5 } } });
  CHECK_GREATER(std::abs(apart.Walk(0, true, 0.1, 3)[0]), 0.1);
}

// Lines end at missing and vanishing vectors.
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
    field.Walk(20, true, 0.01, 100, &done); // starts inside missing data
    CHECK_EQUAL(done, 0);
  }
  // These vectors shrink to zero towards x = 0.
  const Field still(strip, [&](const Vector& p) { return std::max(0.0, -p[0]) * right; });
  int done;
  CHECK_LESS(still.Walk(0, true, 0.01, 100, &done)[0], 1e-6);
  CHECK_LESS_EQUAL(done, 50);
  const Field none(strip, [&](const Vector&) { return Vector{}; });
  none.Walk(0, true, 0.01, 100, &done);
  CHECK_EQUAL(done, 0);
  // This edge has three triangles, one of them without area.
  auto fin = Roof();
  fin->GetPoints()->InsertNextPoint(0, 0, 1);
  fin->GetPolys()->InsertNextCell({ 0, 1, 4 });
  const Field over(fin, { { { 2, 0, 1 } }, { { 2, 0, -1 } }, { { 0, 0, 1 } } });
  over.Walk(2, true, 0.1, 50, &done);
  CHECK_EQUAL(done, static_cast<int>(std::sqrt(1.25) / 0.1));
  auto thin = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0.5, 0 } }, { { 0, 0.4, 0 } }, { { 1, 0.5, 0 } } },
    { { { 0, 1, 2 } }, { { 0, 3, 1 } }, { { 0, 4, 3 } }, { { 3, 4, 1 } } });
  const Field into(thin, [&](const Vector&) { return right; });
  into.Walk(2, true, 0.1, 50, &done);
  CHECK(done == 9 || done == 10);
}

// On arbitrary meshes and vectors, lines stay on the mesh and their points stay finite.
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
      CHECK_CASE(scale);
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
          CHECK_CASE(step);
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
    CHECK_CASE(n);
    CheckCircles(check, n);
  }
  CheckPlane(check);
  CheckSliding(check);
  CheckEnds(check);
  CheckHostile(check);
  return check.GetResult();
}
