// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes, depth-tags and heights that the refinement tests share.
#ifndef RelevoTestMeshes_h
#define RelevoTestMeshes_h

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkHeightField.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRefinementSurface.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTexturedSphereSource.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

// Heights given by a function of texel centres.
class RelevoHeights : public vtkHeightField
{
public:
  static RelevoHeights* New()
  {
    RelevoHeights* result = new RelevoHeights;
    result->InitializeObjectBase();
    return result;
  }
  vtkTypeMacro(RelevoHeights, vtkHeightField);

  void Fill(int width, int height, const std::function<double(double, double)>& function)
  {
    this->Dimensions[0] = width;
    this->Dimensions[1] = height;
    this->Samples.resize(static_cast<size_t>(width) * height);
    this->Validity.clear();
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        this->Samples[static_cast<size_t>(y) * width + x] =
          static_cast<float>(function((x + 0.5) / width, (y + 0.5) / height));
      }
    }
    this->Modified();
  }
  void FillRandom(int width, int height, unsigned int seed)
  {
    std::mt19937 random(seed);
    this->Fill(width, height, [&random](double, double) { return random() / 4294967296.0; });
  }
  // Declare the samples for which the function holds to be without data.
  void Punch(const std::function<bool(int, int)>& isHole)
  {
    this->Validity.assign(this->Samples.size(), 1);
    for (size_t i = 0; i < this->Samples.size(); ++i)
    {
      this->Validity[i] =
        isHole(static_cast<int>(i) % this->Dimensions[0], static_cast<int>(i) / this->Dimensions[0])
        ? 0
        : 1;
    }
    this->Modified();
  }

  void FillWaves()
  {
    this->Fill(64, 64,
      [](double u, double v)
      { return std::sin(4 * vtkMath::Pi() * u) * std::sin(3 * vtkMath::Pi() * v); });
  }
  // A round hole and a slot that is open at the border.
  void FillWavesWithHoles()
  {
    this->Fill(48, 40, [](double u, double v) { return std::sin(9 * u) * std::cos(7 * v); });
    this->Punch([](int x, int y)
      { return (x - 20) * (x - 20) + (y - 15) * (y - 15) < 60 || (x > 30 && x < 34 && y > 10); });
  }

  bool Update() override
  {
    if (this->Samples.empty())
    {
      vtkErrorMacro("No heights.");
    }
    return !this->Samples.empty();
  }
  void GetDimensions(int dimensions[2]) override
  {
    dimensions[0] = this->Dimensions[0];
    dimensions[1] = this->Dimensions[1];
  }
  void GetRange(double range[2]) override
  {
    range[0] = 1e300;
    range[1] = -1e300;
    for (size_t i = 0; i < this->Samples.size(); ++i)
    {
      if (this->Validity.empty() || this->Validity[i])
      {
        range[0] = std::min<double>(range[0], this->Samples[i]);
        range[1] = std::max<double>(range[1], this->Samples[i]);
      }
    }
  }
  bool HasNoData() override { return !this->Validity.empty(); }
  vtkMTimeType GetSamplesMTime() override { return this->GetMTime(); }
  const float* GetSamples() override { return this->Samples.data(); }
  const unsigned char* GetValidity() override
  {
    return this->Validity.empty() ? nullptr : this->Validity.data();
  }

protected:
  RelevoHeights() = default;
  ~RelevoHeights() override = default;

private:
  std::vector<float> Samples;
  std::vector<unsigned char> Validity;
  int Dimensions[2] = { 0, 0 };
};

namespace RelevoMeshes
{
using Mesh = vtkSmartPointer<vtkPolyData>;
using Triangle = std::array<vtkIdType, 3>;

inline Mesh Make()
{
  return Mesh::New();
}

inline vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(
  int level, vtkRefinementSurface* surface = nullptr, vtkDisplacement* displacement = nullptr)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(level);
  recipe->SetSurface(surface);
  recipe->SetDisplacement(displacement);
  return recipe;
}

// The filter's output.
inline Mesh Refine(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(input);
  filter->SetRefinement(recipe);
  filter->Update();
  Mesh output = Make();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

inline Mesh FromTriangles(
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

inline void AddTags(vtkPolyData* mesh, unsigned int seed, int maximum)
{
  std::mt19937 random(seed);
  vtkNew<vtkFloatArray> tags;
  tags->SetName("DepthTag");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    tags->InsertNextValue(static_cast<float>(random() % 1000 * 1e-3 * maximum));
  }
  mesh->GetPointData()->AddArray(tags);
}

inline Mesh Tagged(Mesh mesh, int level)
{
  AddTags(mesh, 7, level);
  return mesh;
}

inline void AddTextureCoordinates(
  vtkPolyData* mesh, const std::function<std::array<double, 2>(const double*)>& function)
{
  vtkNew<vtkFloatArray> uvs;
  uvs->SetName("UV");
  uvs->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    uvs->InsertNextTuple(function(mesh->GetPoint(i)).data());
  }
  mesh->GetPointData()->SetTCoords(uvs);
}

// A tuple of `vectors` for every point, by its place.
inline void FillVectors(vtkPolyData* mesh,
  const std::function<std::array<double, 3>(const std::array<double, 3>&)>& function,
  vtkDataArray* vectors)
{
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    mesh->GetPoint(i, p.data());
    vectors->SetTuple(i, function(p).data());
  }
}

// Texture coordinates in [0, 1]^2 that have nothing to do with each other: every point its chart.
inline void AddRandomTextureCoordinates(vtkPolyData* mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  AddTextureCoordinates(mesh,
    [&random](const double*)
    {
      const double u = random() / 4294967296.0;
      return std::array<double, 2>{ { u, random() / 4294967296.0 } };
    });
}

// An array for vtkScalarTaggedSurface, all zero.
inline vtkSmartPointer<vtkFloatArray> AddScalarTags(
  vtkPolyData* mesh, const char* name, int components = 1)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  array->Fill(0.0);
  mesh->GetPointData()->AddArray(array);
  return array;
}

// Tags of any kind at two points in three, some beyond their range; half of the sharp ones have a
// direction.
inline void AddRandomScalarTags(vtkPolyData* mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  const auto sharpness = AddScalarTags(mesh, "Sharpness");
  const auto tension = AddScalarTags(mesh, "Tension");
  const auto bias = AddScalarTags(mesh, "Bias");
  const auto direction = AddScalarTags(mesh, "Direction", 3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const unsigned int kind = random() % 6;
    if (kind < 4)
    {
      sharpness->SetValue(i, static_cast<float>(1.2 * std::abs(number())));
      tension->SetValue(i, kind % 2 ? static_cast<float>(1.1 * number()) : 0.0f);
      bias->SetValue(i, kind % 2 ? 0.0f : static_cast<float>(1.1 * number()));
    }
    if (kind < 2)
    {
      direction->SetTuple3(i, number(), number(), number());
    }
  }
}

// Unit normals in the outer half space of the given ones, or of the faces.
inline void PerturbNormals(vtkPolyData* mesh, unsigned int seed, double amount)
{
  std::mt19937 random(seed);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    for (double& c : n)
    {
      c += amount * (random() / 2147483648.0 - 1.0);
    }
    vtkMath::Normalize(n);
    normals->SetTuple(i, n);
  }
}

// Every triangle with points of its own: nothing but coincident points.
inline Mesh Explode(vtkPolyData* mesh)
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

inline Mesh Sphere(int theta, int phi)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(theta);
  source->SetPhiResolution(phi);
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

// Of radii 1 and 0.5 about the z axis, with its exact normals.
inline Mesh Torus(int u = 14, int v = 9)
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

// With a texture seam: two points per place where u is 0 and 1, many at the poles.
inline Mesh TexturedSphere(int theta, int phi)
{
  vtkNew<vtkTexturedSphereSource> source;
  source->SetThetaResolution(theta);
  source->SetPhiResolution(phi);
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  // The source closes its seam to rounding only.
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

inline Mesh Plane(int nx, int ny)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(nx, ny);
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

// 24 points: split normals and texture coordinates; quads.
inline Mesh Cube()
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

// A polygonal base and slanted sides, normals split at its rim.
inline Mesh Cone()
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

inline Mesh Strips()
{
  Mesh sphere = Sphere(9, 7);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(stripper->GetOutput());
  return mesh;
}

// Three and four faces on an edge, a bow-tie vertex, a face of the wrong orientation.
inline Mesh NonManifold()
{
  return FromTriangles({ { { 0, 0, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 0.2 } }, { { -0.5, 1, 0.3 } },
                         { { -0.5, -1, 0.1 } }, { { 0, 0, 2 } }, { { 1, 1, 2 } },
                         { { 1, -1, 2.2 } }, { { 0.2, 1, 0.9 } }, { { 2, 0.5, 1 } } },
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 0, 4 } }, { { 1, 5, 6 } }, { { 1, 7, 5 } },
      { { 0, 3, 8 } }, { { 3, 8, 1 } }, { { 3, 8, 6 } }, { { 8, 3, 2 } }, { { 2, 9, 6 } } });
}

inline Mesh Moebius()
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

// Long thin triangles in all directions around a fan.
inline Mesh Slivers()
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

// Vertices, lines, a triangle, a quad, a hexagon and a strip, some sharing points.
inline Mesh Mixed()
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

// The same mesh with every point moved, in double coordinates if `dataType` says so.
inline Mesh Moved(vtkPolyData* mesh, double scale, const double offset[3], int dataType)
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

// A flat grid with points at 0 and -0 by turns.
inline Mesh NegativeZeros()
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

#endif
