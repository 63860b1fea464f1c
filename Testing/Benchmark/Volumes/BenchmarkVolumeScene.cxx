// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkVolumeScene.h"

#include "vtkByteSwap.h"
#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace
{
// PLOT3D, big-endian numbers of 4 bytes.
template <typename T>
std::vector<T> Read(std::istream& stream, size_t size)
{
  std::vector<T> values(size);
  stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(4 * size));
  vtkByteSwap::Swap4BERange(values.data(), values.size());
  return values;
}

vtkSmartPointer<vtkFloatArray> MakeScalars(size_t size)
{
  auto scalars = vtkSmartPointer<vtkFloatArray>::New();
  scalars->SetName("Scalars");
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(size));
  return scalars;
}

// `component`: 0 density, 1 momentum along x.
vtkSmartPointer<vtkStructuredGrid> ReadGrid(
  const std::string& file, bool hasBlanks, size_t component)
{
  std::ifstream xyz(file + "xyz.bin", std::ios::binary);
  std::ifstream q(file + "q.bin", std::ios::binary);
  if (!xyz || !q)
  {
    return nullptr;
  }
  const std::vector<int> dimensions = Read<int>(xyz, 3);
  const size_t size = static_cast<size_t>(dimensions[0]) * dimensions[1] * dimensions[2];
  const std::vector<float> coordinates = Read<float>(xyz, 3 * size);
  const std::vector<int> blanks = Read<int>(xyz, hasBlanks ? size : 0);
  Read<int>(q, 3 + 4); // dimensions and flow conditions
  const std::vector<float> flow = Read<float>(q, 5 * size);
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(dimensions.data());
  vtkNew<vtkPoints> points;
  const auto scalars = MakeScalars(size);
  for (size_t i = 0; i < size; ++i)
  {
    points->InsertNextPoint(coordinates[i], coordinates[size + i], coordinates[2 * size + i]);
    scalars->SetValue(static_cast<vtkIdType>(i), flow[component * size + i]);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  for (size_t i = 0; i < blanks.size(); ++i)
  {
    if (blanks[i] == 0)
    {
      grid->BlankPoint(static_cast<vtkIdType>(i));
    }
  }
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> MakeGrid(int n, bool isBent)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(n + 1, n + 1, n + 1);
  const vtkIdType size = static_cast<vtkIdType>(n + 1) * (n + 1) * (n + 1);
  vtkNew<vtkPoints> points;
  const auto scalars = MakeScalars(static_cast<size_t>(size));
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double x = static_cast<double>(i % (n + 1)) / n - 0.5;
    const double y = static_cast<double>(i / (n + 1) % (n + 1)) / n - 0.5;
    const double z = static_cast<double>(i / (n + 1) / (n + 1)) / n - 0.5;
    const double angle = isBent ? 2.0 * x : 0.0;
    points->InsertNextPoint(isBent ? (1.0 + y) * std::sin(angle) : x,
      isBent ? (1.0 + y) * std::cos(angle) : y, z + (isBent ? 0.2 * x * y : 0.0));
    scalars->SetValue(i,
      static_cast<float>(
        std::sin(5.0 * x + 1.0) * std::cos(4.0 * y) + std::sqrt(x * x + y * y + z * z)));
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}
}

BenchmarkVolumeScene::BenchmarkVolumeScene(const std::string& name)
  : Name(name)
{
  const size_t space = name.find(' ');
  if (space != std::string::npos)
  {
    this->Grid = MakeGrid(std::stoi(name.substr(space)), name.compare(0, space, "bent") == 0);
  }
  else if (const char* data = std::getenv("RELEVO_TEST_DATA"))
  {
    const bool isPost = name == "post";
    this->Grid = ReadGrid(
      std::string(data) + "/volume/" + (isPost ? "post" : "bluntfin"), isPost, isPost ? 1 : 0);
  }
  if (this->Grid)
  {
    this->Grid->GetPointData()->GetScalars()->GetRange(this->Range);
  }
}

BenchmarkVolumeScene::~BenchmarkVolumeScene() = default;

bool BenchmarkVolumeScene::IsEmpty() const
{
  return !this->Grid;
}

vtkSmartPointer<vtkUnstructuredGrid> BenchmarkVolumeScene::MakeMesh(Split split) const
{
  if (split == FIVE)
  {
    vtkNew<vtkDataSetTriangleFilter> filter;
    filter->SetInputData(this->Grid);
    filter->TetrahedraOnlyOn();
    filter->Update();
    return filter->GetOutput();
  }
  // Around the diagonal from 0 to 6, so that faces match.
  const int six[6][4] = { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 },
    { 0, 4, 5, 6 }, { 0, 5, 1, 6 } };
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->SetPoints(this->Grid->GetPoints());
  mesh->GetPointData()->SetScalars(this->Grid->GetPointData()->GetScalars());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
  {
    if (!this->Grid->IsCellVisible(cell))
    {
      continue;
    }
    this->Grid->GetCellPoints(cell, ids);
    if (split == UNSPLIT)
    {
      mesh->InsertNextCell(VTK_HEXAHEDRON, ids);
      continue;
    }
    for (const auto& corners : six)
    {
      vtkIdType tetrahedron[4];
      for (int k = 0; k < 4; ++k)
      {
        tetrahedron[k] = ids->GetId(corners[k]);
      }
      mesh->InsertNextCell(VTK_TETRA, 4, tetrahedron);
    }
  }
  return mesh;
}

vtkSmartPointer<vtkVolumeProperty> BenchmarkVolumeScene::MakeProperty(
  vtkUnstructuredGrid* mesh, int nodes) const
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (int i = 0; i < nodes; ++i)
  {
    const double x = static_cast<double>(i) / (nodes - 1);
    // Alternates, so that the functions bend at every node.
    const double jump = i % 2 == 0 ? 0.1 : -0.1;
    const double turn = 2.0 * vtkMath::Pi() * x;
    colors->AddRGBPoint(this->GetScalar(x), 0.5 + 0.4 * std::cos(turn) + jump,
      0.5 + 0.4 * std::sin(turn) - jump, 0.1 + 0.8 * x + jump);
    opacities->AddPoint(this->GetScalar(x), 0.15 + 0.4 * x + jump);
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetInterpolationTypeToLinear();
  property->SetScalarOpacityUnitDistance(
    3.0 * mesh->GetLength() / std::cbrt(static_cast<double>(mesh->GetNumberOfCells())));
  return property;
}

double BenchmarkVolumeScene::GetScalar(double part) const
{
  return this->Range[0] + part * (this->Range[1] - this->Range[0]);
}

void BenchmarkVolumeScene::EditOpacity(vtkVolumeProperty* property, double opacity)
{
  vtkPiecewiseFunction* function = property->GetScalarOpacity();
  const int index = function->GetSize() / 2;
  double node[4];
  function->GetNodeValue(index, node);
  node[1] = opacity;
  function->SetNodeValue(index, node);
}
