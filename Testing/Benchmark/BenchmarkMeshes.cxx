// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkQuadricDecimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>
#include <vector>

namespace
{
using Point = std::array<double, 3>;
using Loop = std::vector<vtkIdType>;

// Points and triangles in the order in which they are added.
class Builder
{
public:
  vtkIdType AddPoint(const Point& point) { return this->Points->InsertNextPoint(point.data()); }

  Loop AddPoints(const std::vector<Point>& points)
  {
    Loop ids;
    for (const Point& point : points)
    {
      ids.push_back(this->AddPoint(point));
    }
    return ids;
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Polys->InsertNextCell({ a, b, c });
  }

  // Two triangles for the quadrilateral a b c d.
  void AddQuad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    this->AddTriangle(a, b, c);
    this->AddTriangle(a, c, d);
  }

  // A band between two chains with equal numbers of points. Closed chains are joined at their ends.
  void AddBand(const Loop& below, const Loop& above, bool isClosed)
  {
    const size_t n = below.size();
    for (size_t i = 0; i + (isClosed ? 0 : 1) < n; ++i)
    {
      const size_t next = (i + 1) % n;
      this->AddQuad(below[i], below[next], above[next], above[i]);
    }
  }

  void AddFan(vtkIdType apex, const Loop& chain, bool isClosed)
  {
    const size_t n = chain.size();
    for (size_t i = 0; i + (isClosed ? 0 : 1) < n; ++i)
    {
      this->AddTriangle(apex, chain[i], chain[(i + 1) % n]);
    }
  }

  vtkSmartPointer<vtkPolyData> GetMesh()
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Polys);
    return mesh;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polys;
};

Loop Reverse(Loop loop)
{
  std::reverse(loop.begin(), loop.end());
  return loop;
}

vtkSmartPointer<vtkPolyData> AddNormals(vtkPolyData* mesh, double featureAngle)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->ConsistencyOff();
  normals->SetSplitting(featureAngle < 180.0);
  normals->SetFeatureAngle(featureAngle);
  normals->Update();
  return normals->GetOutput();
}

template <typename GetNormal>
void SetNormals(vtkPolyData* mesh, const GetNormal& getNormal)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Point point;
    mesh->GetPoint(i, point.data());
    Point normal = getNormal(point);
    vtkMath::Normalize(normal.data());
    normals->InsertNextTuple(normal.data());
  }
  mesh->GetPointData()->SetNormals(normals);
}

// A point of the unit sphere about the z axis. Colatitude 0 is the north pole.
Point GetSpherePoint(double longitude, double colatitude)
{
  return { { std::sin(colatitude) * std::cos(longitude), std::sin(colatitude) * std::sin(longitude),
    std::cos(colatitude) } };
}

// A side of the mouth between a meridian and the axis, both from north to south without the poles.
// The next triangle takes the chain whose next point is higher.
void AddMouthSide(Builder& builder, const Loop& meridian, const std::vector<double>& meridianZ,
  const Loop& axis, const std::vector<double>& axisZ, vtkIdType north, vtkIdType south,
  bool isTurned)
{
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  { isTurned ? builder.AddTriangle(a, c, b) : builder.AddTriangle(a, b, c); };
  size_t m = 0;
  size_t a = 0;
  add(north, meridian[0], axis[0]);
  while (m + 1 < meridian.size() || a + 1 < axis.size())
  {
    const bool takesMeridian =
      a + 1 == axis.size() || (m + 1 < meridian.size() && meridianZ[m + 1] >= axisZ[a + 1]);
    if (takesMeridian)
    {
      add(meridian[m], meridian[m + 1], axis[a]);
      ++m;
    }
    else
    {
      add(meridian[m], axis[a + 1], axis[a]);
      ++a;
    }
  }
  add(meridian[m], south, axis[a]);
}

// A tapered body through cross-sections with equal numbers of points, open at the first one and
// closed at the last. Sections are counter-clockwise when seen from the last.
void AddShell(Builder& builder, const std::vector<std::vector<Point>>& sections)
{
  Loop below;
  for (const auto& section : sections)
  {
    Loop ring = builder.AddPoints(section);
    if (!below.empty())
    {
      builder.AddBand(below, ring, true);
    }
    below = std::move(ring);
  }
  builder.AddFan(below[0], Loop(below.begin() + 1, below.end()), false);
}

// A wing along +y or, mirrored, along -y: a rhombic profile that moves and shrinks along the span.
struct Wing
{
  Point Root; // leading edge
  double Chord, Thickness;
  Point Tip;
  double TipChord, TipThickness;
  int Spans;
};

void AddWing(Builder& builder, const Wing& wing, bool isMirrored)
{
  std::vector<std::vector<Point>> sections;
  for (int i = 0; i <= wing.Spans; ++i)
  {
    const double t = static_cast<double>(i) / wing.Spans;
    const double chord = wing.Chord + t * (wing.TipChord - wing.Chord);
    const double thickness = wing.Thickness + t * (wing.TipThickness - wing.Thickness);
    Point p;
    for (int c = 0; c < 3; ++c)
    {
      p[c] = wing.Root[c] + t * (wing.Tip[c] - wing.Root[c]);
    }
    std::vector<Point> section = { p, { { p[0] - 0.4 * chord, p[1], p[2] + 0.5 * thickness } },
      { { p[0] - chord, p[1], p[2] } }, { { p[0] - 0.4 * chord, p[1], p[2] - 0.5 * thickness } } };
    if (isMirrored)
    {
      for (Point& point : section)
      {
        point[1] = -point[1];
      }
    }
    else
    {
      std::reverse(section.begin(), section.end());
    }
    sections.push_back(section);
  }
  AddShell(builder, sections);
}
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::MakeSphere(int sectors, int rings)
{
  Builder builder;
  const vtkIdType north = builder.AddPoint({ { 0.0, 0.0, 1.0 } });
  const vtkIdType south = builder.AddPoint({ { 0.0, 0.0, -1.0 } });
  Loop above;
  for (int r = 1; r <= rings; ++r)
  {
    std::vector<Point> points;
    for (int s = 0; s < sectors; ++s)
    {
      points.push_back(
        GetSpherePoint(2.0 * vtkMath::Pi() * s / sectors, vtkMath::Pi() * r / (rings + 1)));
    }
    const Loop ring = builder.AddPoints(points);
    if (r == 1)
    {
      builder.AddFan(north, ring, true);
    }
    else
    {
      builder.AddBand(ring, above, true);
    }
    above = ring;
  }
  builder.AddFan(south, Reverse(above), true);
  auto mesh = builder.GetMesh();
  SetNormals(mesh, [](const Point& point) { return point; });
  return mesh;
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::MakeSphere(double faces)
{
  // Square cells at the equator would take twice as many sectors as rings, but the rows near the
  // poles are narrower.
  const int rings = std::max(1, static_cast<int>(std::sqrt(faces / 3.0)));
  return MakeSphere(std::max(3, static_cast<int>(std::ceil(0.5 * faces / rings))), rings);
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::MakeTorus(
  double radius, double tubeRadius, int sectors, int rings)
{
  Builder builder;
  std::vector<Loop> loops;
  for (int s = 0; s < sectors; ++s)
  {
    const double angle = 2.0 * vtkMath::Pi() * s / sectors;
    std::vector<Point> points;
    for (int r = 0; r < rings; ++r)
    {
      const double tube = 2.0 * vtkMath::Pi() * r / rings;
      const double distance = radius + tubeRadius * std::cos(tube);
      points.push_back({ { distance * std::cos(angle), distance * std::sin(angle),
        tubeRadius * std::sin(tube) } });
    }
    loops.push_back(builder.AddPoints(points));
  }
  for (int s = 0; s < sectors; ++s)
  {
    builder.AddBand(loops[(s + 1) % sectors], loops[s], true);
  }
  auto mesh = builder.GetMesh();
  SetNormals(mesh,
    [=](const Point& p)
    {
      const double scale = 1.0 - radius / std::hypot(p[0], p[1]);
      return Point{ { scale * p[0], scale * p[1], p[2] } };
    });
  return mesh;
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::MakePacMan(int sectors, int rings, int axisPoints)
{
  const double mouth = vtkMath::Pi() / 3.0;
  Builder builder;
  const vtkIdType north = builder.AddPoint({ { 0.0, 0.0, 1.0 } });
  const vtkIdType south = builder.AddPoint({ { 0.0, 0.0, -1.0 } });
  Loop first, last, above;
  std::vector<double> meridianZ;
  for (int r = 1; r <= rings; ++r)
  {
    const double colatitude = vtkMath::Pi() * r / (rings + 1);
    std::vector<Point> points;
    for (int s = 0; s <= sectors; ++s)
    {
      points.push_back(
        GetSpherePoint(0.5 * mouth + (2.0 * vtkMath::Pi() - mouth) * s / sectors, colatitude));
    }
    const Loop chain = builder.AddPoints(points);
    if (r == 1)
    {
      builder.AddFan(north, chain, false);
    }
    else
    {
      builder.AddBand(chain, above, false);
    }
    above = chain;
    first.push_back(chain.front());
    last.push_back(chain.back());
    meridianZ.push_back(std::cos(colatitude));
  }
  builder.AddFan(south, Reverse(above), false);

  Loop axis;
  std::vector<double> axisZ;
  for (int a = 1; a <= axisPoints; ++a)
  {
    axisZ.push_back(std::cos(vtkMath::Pi() * a / (axisPoints + 1)));
    axis.push_back(builder.AddPoint({ { 0.0, 0.0, axisZ.back() } }));
  }
  AddMouthSide(builder, first, meridianZ, axis, axisZ, north, south, true);
  AddMouthSide(builder, last, meridianZ, axis, axisZ, north, south, false);
  return AddNormals(builder.GetMesh(), 50.0);
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::MakeJet()
{
  // Along x from the tail at 0 to the nose; z is up.
  Builder builder;
  const int sectors = 8;
  const std::vector<std::array<double, 2>> fuselage = { { { 0.03, 0.055 } }, { { 0.08, 0.065 } },
    { { 0.16, 0.075 } }, { { 0.24, 0.083 } }, { { 0.32, 0.088 } }, { { 0.40, 0.09 } },
    { { 0.48, 0.09 } }, { { 0.56, 0.088 } }, { { 0.64, 0.083 } }, { { 0.72, 0.075 } },
    { { 0.80, 0.062 } }, { { 0.88, 0.045 } }, { { 0.95, 0.023 } } };
  const vtkIdType tail = builder.AddPoint({ { 0.0, 0.0, 0.0 } });
  const vtkIdType nose = builder.AddPoint({ { 1.0, 0.0, 0.0 } });
  Loop behind;
  for (const auto& ring : fuselage)
  {
    std::vector<Point> points;
    for (int s = 0; s < sectors; ++s)
    {
      const double angle = 2.0 * vtkMath::Pi() * s / sectors;
      points.push_back({ { ring[0], ring[1] * std::cos(angle), ring[1] * std::sin(angle) } });
    }
    const Loop loop = builder.AddPoints(points);
    if (behind.empty())
    {
      builder.AddFan(tail, Reverse(loop), true);
    }
    else
    {
      builder.AddBand(behind, loop, true);
    }
    behind = loop;
  }
  builder.AddFan(nose, behind, true);

  const Wing wing = { { { 0.62, 0.04, -0.02 } }, 0.34, 0.03, { { 0.30, 0.48, -0.01 } }, 0.10, 0.01,
    3 };
  const Wing tailPlane = { { { 0.20, 0.03, 0.02 } }, 0.15, 0.015, { { 0.07, 0.22, 0.03 } }, 0.06,
    0.006, 2 };
  for (const bool isMirrored : { false, true })
  {
    AddWing(builder, wing, isMirrored);
    AddWing(builder, tailPlane, isMirrored);
  }
  // The fin has a sharp leading edge.
  AddShell(builder,
    { { { { 0.26, 0.0, 0.03 } }, { { 0.08, 0.02, 0.03 } }, { { 0.08, -0.02, 0.03 } } },
      { { { 0.09, 0.0, 0.26 } }, { { 0.02, 0.01, 0.26 } }, { { 0.02, -0.01, 0.26 } } } });
  return AddNormals(builder.GetMesh(), 50.0);
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::ReadBunny()
{
  const char* folder = std::getenv("RELEVO_TEST_DATA");
  const std::string fileName = std::string(folder ? folder : ".") + "/mesh/bunny.ply";
  if (!std::ifstream(fileName))
  {
    return nullptr;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return AddNormals(reader->GetOutput(), 180.0);
}

vtkSmartPointer<vtkPolyData> BenchmarkMeshes::Decimate(vtkPolyData* bunny, int faces)
{
  vtkNew<vtkQuadricDecimation> coarse;
  coarse->SetInputData(bunny);
  coarse->SetTargetReduction(1.0 - faces / static_cast<double>(bunny->GetNumberOfPolys()));
  coarse->Update();
  return AddNormals(coarse->GetOutput(), 180.0);
}
