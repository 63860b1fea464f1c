// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkSurface.h"

#include "BenchmarkLevels.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
constexpr double Width = 4.0;
constexpr double Height = 3.0;
constexpr double LevelSwing = 1.5; // over the whole surface
constexpr double LevelNoise = 2.0; // from point to point

struct Wave
{
  double Z, Dx, Dy;
};

Wave GetWave(double x, double y)
{
  const double amplitude = 0.06;
  const double fx = 5.0;
  const double fy = 4.0;
  return { amplitude * std::sin(fx * x) * std::cos(fy * y),
    amplitude * fx * std::cos(fx * x) * std::cos(fy * y),
    -amplitude * fy * std::sin(fx * x) * std::sin(fy * y) };
}

vtkSmartPointer<vtkDisplacement> MakeDisplacement()
{
  const int size = 512;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* heights = static_cast<float*>(image->GetScalarPointer());
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      heights[j * size + i] = static_cast<float>(std::sin(0.31 * i) * std::cos(0.23 * j));
    }
  }
  vtkNew<vtkHeightMap> map;
  map->SetImageData(image);
  auto displacement = vtkSmartPointer<vtkDisplacement>::New();
  displacement->SetHeightMap(map);
  displacement->SetScale(0.01);
  return displacement;
}
}

BenchmarkSurface::BenchmarkSurface(int numberOfFaces, double numberOfTriangles)
{
  this->BuildGrid(numberOfFaces);
  BenchmarkLevels::FindTags(this->Mesh, numberOfTriangles, -LevelSwing - LevelNoise,
    vtkRefinementPatternTable::HighestLevel + LevelSwing + LevelNoise,
    [this](double level) { this->SetMeanLevel(level); });
}

BenchmarkSurface::~BenchmarkSurface() = default;

void BenchmarkSurface::BuildGrid(int numberOfFaces)
{
  const int columns =
    std::max(1, static_cast<int>(std::lround(std::sqrt(0.5 * numberOfFaces * Width / Height))));
  const int rows = std::max(1, static_cast<int>(std::lround(0.5 * numberOfFaces / columns)));
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkFloatArray> coordinates;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetName("TextureCoordinates");
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const double u = static_cast<double>(i) / columns;
      const double v = static_cast<double>(j) / rows;
      const double x = Width * u;
      const double y = Height * v;
      const Wave wave = GetWave(x, y);
      const double length = std::sqrt(wave.Dx * wave.Dx + wave.Dy * wave.Dy + 1.0);
      points->InsertNextPoint(x, y, wave.Z);
      normals->InsertNextTuple3(-wave.Dx / length, -wave.Dy / length, 1.0 / length);
      coordinates->InsertNextTuple2(u, v);
    }
  }
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const vtkIdType p = static_cast<vtkIdType>(j) * (columns + 1) + i;
      triangles->InsertNextCell({ p, p + 1, p + columns + 2 });
      triangles->InsertNextCell({ p, p + columns + 2, p + columns + 1 });
    }
  }
  this->Mesh->SetPoints(points);
  this->Mesh->SetPolys(triangles);
  this->Mesh->GetPointData()->SetNormals(normals);
  this->Mesh->GetPointData()->SetTCoords(coordinates);
}

void BenchmarkSurface::SetMeanLevel(double level)
{
  std::minstd_rand random;
  std::uniform_real_distribution<double> noise(-LevelNoise, LevelNoise);
  vtkFloatArray* tags = BenchmarkLevels::GetTags(this->Mesh);
  for (vtkIdType i = 0; i < tags->GetNumberOfTuples(); ++i)
  {
    double p[3];
    this->Mesh->GetPoint(i, p);
    const double swing = LevelSwing * std::sin(2.3 * p[0] + 0.7) * std::sin(3.1 * p[1] + 0.4);
    tags->SetValue(i, static_cast<float>(std::max(0.0, level + swing + noise(random))));
  }
}

vtkSmartPointer<vtkAdaptiveRefinement> BenchmarkSurface::MakeLinearRecipe()
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(vtkRefinementPatternTable::HighestLevel);
  return recipe;
}

vtkSmartPointer<vtkAdaptiveRefinement> BenchmarkSurface::MakePNRecipe()
{
  auto recipe = MakeLinearRecipe();
  vtkNew<vtkPNTriangleSurface> surface;
  recipe->SetSurface(surface);
  return recipe;
}

vtkSmartPointer<vtkAdaptiveRefinement> BenchmarkSurface::MakeDisplacedRecipe()
{
  auto recipe = MakePNRecipe();
  recipe->SetDisplacement(MakeDisplacement());
  return recipe;
}

vtkSmartPointer<vtkPolyData> BenchmarkSurface::MakeRefinedMesh()
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(this->Mesh);
  filter->SetRefinement(MakeLinearRecipe());
  filter->Update();
  auto refined = vtkSmartPointer<vtkPolyData>::New();
  refined->SetPoints(filter->GetOutput()->GetPoints());
  refined->SetPolys(filter->GetOutput()->GetPolys());
  refined->GetPointData()->SetNormals(filter->GetOutput()->GetPointData()->GetNormals());
  return refined;
}
