// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkDenseMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkMicroMeshSurface.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkQuadricDecimation.h"
#include "vtkStaticCellLocator.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace
{
vtkSmartPointer<vtkPolyData> MakeMesh(vtkPoints* points, vtkCellArray* triangles)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadOFF(const std::string& fileName)
{
  std::ifstream file(fileName);
  std::string word;
  vtkIdType numbers[3] = { 0, 0, 0 };
  file >> word >> numbers[0] >> numbers[1] >> numbers[2];
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < numbers[0]; ++i)
  {
    double x[3];
    file >> x[0] >> x[1] >> x[2];
    points->InsertNextPoint(x);
  }
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < numbers[1]; ++i)
  {
    vtkIdType ids[4];
    file >> ids[0] >> ids[1] >> ids[2] >> ids[3];
    triangles->InsertNextCell(3, ids + 1);
  }
  return MakeMesh(points, triangles);
}

// Five octaves of relief, down to about 20 triangles per wave at a million triangles.
double GetRadius(double x, double y, double z)
{
  double radius = 1.0 + 0.05 * std::sin(5.0 * x + 1.0) * std::sin(6.0 * y) * std::sin(4.0 * z);
  double height = 0.012;
  double frequency = 11.0;
  for (int octave = 0; octave < 4; ++octave)
  {
    radius += height * std::sin(frequency * x + octave) * std::sin(1.1 * frequency * y) *
      std::sin(0.9 * frequency * z + 3.0 * octave);
    height *= 0.45;
    frequency *= 2.1;
  }
  return radius;
}

vtkSmartPointer<vtkPolyData> MakeSphere(double triangles)
{
  const auto rings = static_cast<vtkIdType>(std::sqrt(triangles / 4.0));
  const vtkIdType sectors = 2 * rings;
  vtkNew<vtkPoints> points;
  for (vtkIdType j = 0; j <= rings; ++j)
  {
    for (vtkIdType i = 0; i < (j == 0 || j == rings ? 1 : sectors); ++i)
    {
      const double theta = vtkMath::Pi() * double(j) / double(rings);
      const double phi = 2.0 * vtkMath::Pi() * double(i) / double(sectors);
      const double x = std::sin(theta) * std::cos(phi);
      const double y = std::sin(theta) * std::sin(phi);
      const double z = std::cos(theta);
      const double radius = GetRadius(x, y, z);
      points->InsertNextPoint(radius * x, radius * y, radius * z);
    }
  }
  const auto getId = [&](vtkIdType i, vtkIdType j)
  {
    const vtkIdType first = 1 + (j - 1) * sectors;
    return j == 0 ? 0 : first + (j == rings ? 0 : i % sectors);
  };
  vtkNew<vtkCellArray> cells;
  for (vtkIdType j = 0; j < rings; ++j)
  {
    for (vtkIdType i = 0; i < sectors; ++i)
    {
      if (j + 1 < rings)
      {
        cells->InsertNextCell({ getId(i, j), getId(i, j + 1), getId(i + 1, j + 1) });
      }
      if (j > 0)
      {
        cells->InsertNextCell({ getId(i, j), getId(i + 1, j + 1), getId(i + 1, j) });
      }
    }
  }
  return MakeMesh(points, cells);
}

double GetDistanceTo(vtkStaticCellLocator* locator, vtkPolyData* mesh)
{
  double largest = 0.0;
  vtkNew<vtkGenericCell> cell;
  const auto measure = [&](double x[3])
  {
    double closest[3];
    double distance2;
    vtkIdType id;
    int part;
    locator->FindClosestPoint(x, closest, cell, id, part, distance2);
    largest = std::max(largest, distance2);
  };
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetCellPoints(i, size, ids);
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType corner = 0; corner < size; ++corner)
    {
      double x[3];
      mesh->GetPoint(ids[corner], x);
      std::transform(
        x, x + 3, middle, middle, [&](double a, double b) { return a / double(size) + b; });
      measure(x);
    }
    measure(middle);
  }
  return std::sqrt(largest);
}
}

vtkSmartPointer<vtkPolyData> BenchmarkDenseMeshes::Make(const std::string& name)
{
  const double triangles = std::atof(name.c_str());
  if (triangles > 0.0)
  {
    return MakeSphere(triangles);
  }
  const char* folder = std::getenv("RELEVO_TEST_DATA");
  const std::string file = std::string(folder ? folder : ".") + "/mesh/" + name;
  if (std::ifstream(file + ".off"))
  {
    return ReadOFF(file + ".off");
  }
  if (!std::ifstream(file + ".ply"))
  {
    return nullptr;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((file + ".ply").c_str());
  reader->Update();
  return MakeMesh(reader->GetOutput()->GetPoints(), reader->GetOutput()->GetPolys());
}

double BenchmarkDenseMeshes::GetFileSize(vtkPolyData* mesh)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->Write();
  return static_cast<double>(writer->GetOutputString().size());
}

double BenchmarkDenseMeshes::GetDistance(vtkPolyData* one, vtkPolyData* other)
{
  double largest = 0.0;
  for (int direction = 0; direction < 2; ++direction)
  {
    vtkNew<vtkStaticCellLocator> locator;
    locator->SetDataSet(direction == 0 ? other : one);
    locator->BuildLocator();
    largest = std::max(largest, GetDistanceTo(locator, direction == 0 ? one : other));
  }
  return largest;
}

vtkSmartPointer<vtkPolyData> BenchmarkDenseMeshes::Decode(vtkPolyData* micro, int level)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(vtkNew<vtkMicroMeshSurface>());
  recipe->SetMaximumLevel(level);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(micro);
  filter->SetRefinement(recipe);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> BenchmarkDenseMeshes::Decimate(vtkPolyData* dense, double distance)
{
  // The distance grows with the reduction, about.
  vtkSmartPointer<vtkPolyData> best = dense;
  double low = 0.0;
  double high = 1.0;
  constexpr int steps = 7;
  for (int step = 0; step < steps; ++step)
  {
    const double middle = 0.5 * (low + high);
    vtkNew<vtkQuadricDecimation> decimate;
    decimate->SetInputData(dense);
    decimate->SetTargetReduction(middle);
    decimate->Update();
    vtkPolyData* mesh = decimate->GetOutput();
    const bool isWithin = mesh->GetNumberOfCells() > 0 && GetDistance(mesh, dense) <= distance;
    (isWithin ? low : high) = middle;
    if (isWithin)
    {
      best = mesh;
    }
  }
  return best;
}
