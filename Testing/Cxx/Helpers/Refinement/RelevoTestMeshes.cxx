// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTexturedSphereSource.h"

#include <cmath>
#include <random>

namespace RelevoMeshes
{
Mesh Make()
{
  return Mesh::New();
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(
  int level, vtkRefinementSurface* surface, vtkDisplacement* displacement)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(level);
  recipe->SetSurface(surface);
  recipe->SetDisplacement(displacement);
  return recipe;
}

Mesh Refine(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(input);
  filter->SetRefinement(recipe);
  filter->Update();
  Mesh output = Make();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

Mesh FromTriangles(
  const std::vector<std::array<double, 3>>& points, const std::vector<Triangle>& triangles)
{
  Mesh mesh = Make();
  vtkNew<vtkPoints> p;
  for (const auto& point : points)
  {
    p->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const Triangle& triangle : triangles)
  {
    polys->InsertNextCell(3, triangle.data());
  }
  mesh->SetPoints(p);
  mesh->SetPolys(polys);
  return mesh;
}

Mesh Explode(vtkPolyData* mesh)
{
  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> triangles;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    if (ids->GetNumberOfIds() < 3)
    {
      continue; // vertices and lines
    }
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle[i] = static_cast<vtkIdType>(points.size());
      std::array<double, 3> p;
      mesh->GetPoint(ids->GetId(i), p.data());
      points.push_back(p);
      if (mesh->GetPointData()->GetNormals())
      {
        normals->InsertNextTuple(ids->GetId(i), mesh->GetPointData()->GetNormals());
      }
    }
    triangles.push_back(triangle);
  }
  Mesh result = FromTriangles(points, triangles);
  if (mesh->GetPointData()->GetNormals())
  {
    result->GetPointData()->SetNormals(normals);
  }
  return result;
}

Mesh Sphere(int theta, int phi)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(theta);
  source->SetPhiResolution(phi);
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

Mesh Torus(int u, int v)
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(u);
  source->SetVResolution(v);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(source->GetOutputPort());
  clean->SetTolerance(1e-5);
  clean->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(clean->GetOutput());
  AddTextureCoordinates(mesh,
    [](const double* p) {
      return std::array<double, 2>{ { 0.3 * p[0] + 0.5, 0.3 * p[1] + 0.5 } };
    });
  return mesh;
}

Mesh TexturedSphere(int theta, int phi)
{
  vtkNew<vtkTexturedSphereSource> source;
  source->SetThetaResolution(theta);
  source->SetPhiResolution(phi);
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  // The source closes its seam only up to rounding.
  for (int j = 0; j <= phi; ++j)
  {
    double p[3];
    mesh->GetPoint(j, p);
    mesh->GetPoints()->SetPoint(theta * (phi + 1) + j, p);
    for (int i = 0; i <= theta && (j == 0 || j == phi); ++i)
    {
      p[0] = p[1] = 0.0;
      mesh->GetPoints()->SetPoint(i * (phi + 1) + j, p);
    }
  }
  return mesh;
}

Mesh Plane(int nx, int ny)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(nx, ny);
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

Mesh Cube()
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

Mesh Cone()
{
  vtkNew<vtkConeSource> source;
  source->SetResolution(9);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(source->GetOutputPort());
  normals->SetFeatureAngle(30.0);
  normals->SplittingOn();
  normals->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(normals->GetOutput());
  return mesh;
}

Mesh Strips()
{
  Mesh sphere = Sphere(9, 7);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(stripper->GetOutput());
  return mesh;
}

Mesh NonManifold()
{
  return FromTriangles({ { { 0, 0, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 0.2 } }, { { -0.5, 1, 0.3 } },
                         { { -0.5, -1, 0.1 } }, { { 0, 0, 2 } }, { { 1, 1, 2 } },
                         { { 1, -1, 2.2 } }, { { 0.2, 1, 0.9 } }, { { 2, 0.5, 1 } } },
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 0, 4 } }, { { 1, 5, 6 } }, { { 1, 7, 5 } },
      { { 0, 3, 8 } }, { { 3, 8, 1 } }, { { 3, 8, 6 } }, { { 8, 3, 2 } }, { { 2, 9, 6 } } });
}

Mesh Moebius()
{
  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> triangles;
  const int n = 12;
  for (int i = 0; i < n; ++i)
  {
    const double a = 2.0 * vtkMath::Pi() * i / n;
    for (int side = -1; side <= 1; side += 2)
    {
      const double r = 1.0 + 0.3 * side * std::cos(0.5 * a);
      points.push_back({ { r * std::cos(a), r * std::sin(a), 0.3 * side * std::sin(0.5 * a) } });
    }
    const vtkIdType a0 = 2 * i;
    const vtkIdType b0 = a0 + 1;
    const vtkIdType a1 = i + 1 < n ? a0 + 2 : 1;
    const vtkIdType b1 = i + 1 < n ? a0 + 3 : 0;
    triangles.push_back({ { a0, b0, b1 } });
    triangles.push_back({ { a0, b1, a1 } });
  }
  return FromTriangles(points, triangles);
}

Mesh Slivers()
{
  std::mt19937 random(5);
  std::vector<std::array<double, 3>> points{ { { 0, 0, 0 } } };
  std::vector<Triangle> triangles;
  for (int i = 0; i < 40; ++i)
  {
    const double a = 0.15 * i + 1e-3 * (random() / 4294967296.0);
    const double r = i % 3 == 0 ? 1e-3 : 1.0 + i;
    points.push_back({ { r * std::cos(a), r * std::sin(a), random() / 4294967296.0 } });
    if (i > 0)
    {
      triangles.push_back({ { 0, i, i + 1 } });
    }
  }
  return FromTriangles(points, triangles);
}

Mesh Mixed()
{
  Mesh mesh = Make();
  vtkNew<vtkPoints> points;
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 6; ++i)
    {
      points->InsertNextPoint(i, j, 0.1 * ((i * i * 3 + j * 5) % 7));
    }
  }
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  verts->InsertNextCell({ 23 });
  verts->InsertNextCell({ 0, 22 });
  lines->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 1, 6 });
  polys->InsertNextCell({ 1, 2, 8, 7 });
  polys->InsertNextCell({ 2, 3, 4, 10, 9, 8 });
  polys->InsertNextCell({ 1, 7, 6 });
  strips->InsertNextCell({ 6, 12, 7, 13, 8, 14, 9 });
  mesh->SetVerts(verts);
  mesh->SetLines(lines);
  mesh->SetPolys(polys);
  mesh->SetStrips(strips);
  return mesh;
}

Mesh Moved(vtkPolyData* mesh, double scale, const double offset[3], int dataType)
{
  Mesh result = Make();
  result->DeepCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(dataType);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points->InsertNextPoint(
      scale * p[0] + offset[0], scale * p[1] + offset[1], scale * p[2] + offset[2]);
  }
  result->SetPoints(points);
  return result;
}

Mesh NegativeZeros()
{
  Mesh mesh = Explode(FromTriangles(
    { { { -1, 0, 0 } }, { { 0, -1, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 0 } } },
    { { { 0, 1, 4 } }, { { 1, 2, 4 } }, { { 2, 3, 4 } }, { { 3, 0, 4 } } }));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    for (int c = 0; c < 3; ++c)
    {
      p[c] = p[c] == 0.0 && (i + c) % 2 ? -0.0 : p[c];
    }
    mesh->GetPoints()->SetPoint(i, p);
  }
  return mesh;
}
}
