// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFlow.h"

#include "BenchmarkMeshes.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataSetReader.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace
{
using Vector = std::array<double, 3>;
using Field = std::function<Vector(const Vector&)>;
// z of the surface at (x, y) and z of its unit normal there; not finite outside the surface.
using Surface = std::function<std::array<double, 2>(double, double)>;

constexpr double TorusRadius = 0.65;
constexpr double TubeRadius = 0.3;

// Excludes the surroundings of singular points, of the plane's border and, by the normal's z, of
// the silhouette.
constexpr double SingularRadius = 0.06;
constexpr double PlaneHalf = 0.95;
constexpr double SmallestNormal = 0.5;

void AddVectors(vtkPolyData* mesh, const Field& field)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName(FlowScene::VectorsName);
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vector point;
    mesh->GetPoint(i, point.data());
    vectors->SetTuple(i, field(point).data());
  }
  mesh->GetPointData()->SetVectors(vectors);
}

FlowScene MakeScene(const std::string& name, vtkPolyData* mesh, const Field& field,
  const Surface& surface, const std::vector<std::array<double, 2>>& singularPoints)
{
  AddVectors(mesh, field);
  const auto getDirection = [=](double x, double y) -> std::array<double, 2>
  {
    for (const auto& point : singularPoints)
    {
      if (std::hypot(x - point[0], y - point[1]) < SingularRadius)
      {
        return { 0.0, 0.0 };
      }
    }
    const auto [z, normal] = surface(x, y);
    if (!(normal > SmallestNormal))
    {
      return { 0.0, 0.0 };
    }
    const Vector v = field({ x, y, z });
    return { v[0], v[1] };
  };
  return { name, mesh, getDirection };
}

FlowScene MakePlane(const std::string& name, int resolution, const Field& field,
  const std::vector<std::array<double, 2>>& singularPoints)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 0.0);
  plane->SetPoint1(1.0, -1.0, 0.0);
  plane->SetPoint2(-1.0, 1.0, 0.0);
  plane->SetResolution(resolution, resolution);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  const auto surface = [](double x, double y) -> std::array<double, 2> {
    return { 0.0, std::abs(x) < PlaneHalf && std::abs(y) < PlaneHalf ? 1.0 : 0.0 };
  };
  return MakeScene(name, triangles->GetOutput(), field, surface, singularPoints);
}

FlowScene MakeFromFile(const std::string& name, vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->CopyStructure(triangles->GetOutput());
  vtkDataArray* vectors = triangles->GetOutput()->GetPointData()->GetArray("V");
  AddVectors(mesh, [](const Vector&) { return Vector(); });
  mesh->GetPointData()->GetVectors()->DeepCopy(vectors);
  mesh->GetPointData()->GetVectors()->SetName(FlowScene::VectorsName);
  return { name, mesh, {} };
}
}

void FlowScene::LookAlongZ(vtkCamera* camera)
{
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 4.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
}

FlowScene BenchmarkFlow::MakeUniform(int resolution)
{
  const double angle = 0.3;
  return MakePlane("uniform", resolution,
    [=](const Vector&) {
      return Vector{ std::cos(angle), std::sin(angle), 0.0 };
    },
    {});
}

FlowScene BenchmarkFlow::MakeVortex(int resolution)
{
  return MakePlane("vortex", resolution,
    [](const Vector& p) {
      return Vector{ -p[1], p[0], 0.0 };
    },
    { { 0.0, 0.0 } });
}

FlowScene BenchmarkFlow::MakeSaddle(int resolution)
{
  return MakePlane("saddle", resolution,
    [](const Vector& p) {
      return Vector{ p[0], -p[1], 0.0 };
    },
    { { 0.0, 0.0 } });
}

FlowScene BenchmarkFlow::MakeDipole(int resolution)
{
  const double half = 0.5;
  const auto field = [=](const Vector& p)
  {
    Vector sum{ 0.0, 0.0, 0.0 };
    for (const double side : { -1.0, 1.0 })
    {
      const double x = p[0] - side * half;
      const double weight = side / (x * x + p[1] * p[1] + 1e-3);
      sum[0] += weight * x;
      sum[1] += weight * p[1];
    }
    return sum;
  };
  return MakePlane("dipole", resolution, field, { { -half, 0.0 }, { half, 0.0 } });
}

FlowScene BenchmarkFlow::MakeSphere(int resolution)
{
  // A pole of this axis is visible.
  const Vector axis{ 0.3, 0.5, 0.81 };
  const auto field = [=](const Vector& p)
  {
    return Vector{ axis[1] * p[2] - axis[2] * p[1], axis[2] * p[0] - axis[0] * p[2],
      axis[0] * p[1] - axis[1] * p[0] };
  };
  const auto surface = [](double x, double y) -> std::array<double, 2>
  {
    const double z = std::sqrt(1.0 - x * x - y * y);
    return { z, z };
  };
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  return MakeScene("sphere", BenchmarkMeshes::MakeSphere(resolution, resolution), field, surface,
    { { axis[0] / length, axis[1] / length } });
}

FlowScene BenchmarkFlow::MakeTorus(int resolution)
{
  // The field moves as fast around the tube as around the axis.
  const auto field = [](const Vector& p)
  {
    const double r = std::hypot(p[0], p[1]);
    const double c = p[0] / r;
    const double s = p[1] / r;
    const double inwards = -p[2] / TubeRadius;
    return Vector{ -s + inwards * c, c + inwards * s, (r - TorusRadius) / TubeRadius };
  };
  const auto surface = [](double x, double y) -> std::array<double, 2>
  {
    const double r = std::hypot(x, y) - TorusRadius;
    const double z = std::sqrt(TubeRadius * TubeRadius - r * r);
    return { z, z / TubeRadius };
  };
  return MakeScene("torus",
    BenchmarkMeshes::MakeTorus(TorusRadius, TubeRadius, resolution, resolution / 2), field, surface,
    {});
}

std::string BenchmarkFlow::FindFile(const std::string& name)
{
  const char* folder = std::getenv("RELEVO_TEST_DATA");
  const std::string path = std::string(folder ? folder : ".") + "/flow/" + name;
  return folder && std::ifstream(path) ? path : std::string();
}

std::vector<FlowScene> BenchmarkFlow::ReadScenes()
{
  std::vector<FlowScene> scenes;
  const std::string grid = FindFile("SurfaceVectors.vtk");
  if (!grid.empty())
  {
    vtkNew<vtkDataSetReader> reader;
    reader->SetFileName(grid.c_str());
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputConnection(reader->GetOutputPort());
    surface->Update();
    scenes.push_back(MakeFromFile("SurfaceVectors", surface->GetOutput()));
  }
  const std::string disk = FindFile("disk_out_ref_surface.vtp");
  if (!disk.empty())
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(disk.c_str());
    reader->Update();
    scenes.push_back(MakeFromFile("disk_out_ref", reader->GetOutput()));
  }
  return scenes;
}
