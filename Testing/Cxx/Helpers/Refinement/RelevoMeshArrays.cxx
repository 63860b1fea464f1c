// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoMeshArrays.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <random>

namespace RelevoMeshes
{
void AddTags(vtkPolyData* mesh, unsigned int seed, int maximum)
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

Mesh Tagged(Mesh mesh, int level)
{
  AddTags(mesh, 7, level);
  return mesh;
}

void AddTextureCoordinates(
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

void FillVectors(vtkPolyData* mesh,
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

void AddRandomTextureCoordinates(vtkPolyData* mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  AddTextureCoordinates(mesh,
    [&random](const double*)
    {
      const double u = random() / 4294967296.0;
      return std::array<double, 2>{ { u, random() / 4294967296.0 } };
    });
}

Mesh Textured(Mesh mesh)
{
  AddRandomTextureCoordinates(mesh, 3);
  return mesh;
}

vtkSmartPointer<vtkFloatArray> AddScalarTags(vtkPolyData* mesh, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  array->Fill(0.0);
  mesh->GetPointData()->AddArray(array);
  return array;
}

void AddRandomScalarTags(vtkPolyData* mesh, unsigned int seed)
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

void PerturbNormals(vtkPolyData* mesh, unsigned int seed, double amount)
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
}
