// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that curvatures of vtkCurvatureDepthTagMetric agree with those of vtkCurvatures.
#include "RelevoCheck.h"
#include "RelevoCurvatures.h"

#include "vtkCurvatures.h"
#include "vtkFeatureEdges.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iostream>
#include <set>
#include <vector>

namespace
{
using namespace RelevoCurvatures;

// The bunny, or a sphere if the data are not available.
vtkSmartPointer<vtkPolyData> ReadMesh()
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string bunny = data ? std::string(data) + "/mesh/bunny.ply" : std::string();
  vtkNew<vtkPLYReader> reader;
  if (data && vtkPLYReader::CanReadFile(bunny.c_str()))
  {
    reader->SetFileName(bunny.c_str());
    reader->Update();
  }
  vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  if (mesh->GetNumberOfPolys() == 0)
  {
    std::cout << "no bunny.ply: a sphere instead\n";
    mesh = MakeSphere(1.0, 3);
  }
  return mesh;
}

// Points whose cells do not touch a border.
std::vector<vtkIdType> FindInnerPoints(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  std::set<std::vector<double>> open;
  for (vtkIdType id = 0; id < edges->GetOutput()->GetNumberOfPoints(); ++id)
  {
    const double* x = edges->GetOutput()->GetPoint(id);
    open.insert({ x[0], x[1], x[2] });
  }
  mesh->BuildLinks();
  std::vector<vtkIdType> inner;
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    const double* x = mesh->GetPoint(id);
    vtkNew<vtkIdList> cells;
    mesh->GetPointCells(id, cells);
    if (cells->GetNumberOfIds() > 0 && !open.count({ x[0], x[1], x[2] }))
    {
      inner.push_back(id);
    }
  }
  return inner;
}

// vtkCurvatures divides the same angle defect by a third of the triangles' area. The mixed area
// lies between a quarter and a half of each triangle.
void TestGaussian(RelevoCheck& check, vtkPolyData* mesh, const std::vector<vtkIdType>& inner)
{
  vtkNew<vtkCurvatures> reference;
  reference->SetInputData(mesh);
  reference->SetCurvatureTypeToGaussian();
  reference->Update();
  vtkDataArray* referenceGaussian =
    reference->GetOutput()->GetPointData()->GetArray("Gauss_Curvature");
  const auto gaussian = Gaussian(mesh);
  size_t within = 0;
  for (vtkIdType id : inner)
  {
    const double expected = referenceGaussian->GetComponent(id, 0);
    const double slack = 1e-6 * std::abs(expected);
    const double low = std::min(expected * 2 / 3, expected * 4 / 3) - slack;
    const double high = std::max(expected * 2 / 3, expected * 4 / 3) + slack;
    within += gaussian[id] >= low && gaussian[id] <= high ? 1 : 0;
  }
  std::cout << within << " of " << inner.size() << " Gaussian curvatures within vtkCurvatures' "
            << "bounds\n";
  CHECK_EQUAL(within, inner.size());
}

// vtkCurvatures computes mean curvature from angles between triangles, which agrees only in the
// limit.
void TestMean(RelevoCheck& check, vtkPolyData* mesh, const std::vector<vtkIdType>& inner)
{
  vtkNew<vtkCurvatures> reference;
  reference->SetInputData(mesh);
  reference->SetCurvatureTypeToMean();
  reference->Update();
  vtkDataArray* referenceMean = reference->GetOutput()->GetPointData()->GetArray("Mean_Curvature");
  const auto mean = Mean(mesh);
  double products[3] = { 0.0, 0.0, 0.0 };
  std::vector<double> ratios;
  for (vtkIdType id : inner)
  {
    const double expected = referenceMean->GetComponent(id, 0);
    products[0] += mean[id] * expected;
    products[1] += mean[id] * mean[id];
    products[2] += expected * expected;
    ratios.push_back(mean[id] / expected);
  }
  std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
  const double correlation = products[0] / std::sqrt(products[1] * products[2]);
  std::cout << "mean curvature: correlation with vtkCurvatures " << correlation
            << ", median of the ratios " << ratios[ratios.size() / 2] << "\n";
  CHECK_GREATER(correlation, 0.9);
  CHECK_NEAR(ratios[ratios.size() / 2], 1.0, 0.1);
}
}

int TestCurvatureDepthTagMetricReference(int, char*[])
{
  RelevoCheck check;
  const auto mesh = ReadMesh();
  const auto inner = FindInnerPoints(mesh);
  CHECK_GREATER(inner.size(), 600);
  TestGaussian(check, mesh, inner);
  TestMean(check, mesh, inner);
  return check.GetResult();
}
