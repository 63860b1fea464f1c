// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFuzz.h"

#include "vtkBitArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace RelevoFuzz
{
Dice::Dice(unsigned int seed)
  : Random(seed)
{
}

Dice::Dice(const unsigned char* bytes, size_t size)
  : Random(static_cast<unsigned int>(size))
  , Bytes(bytes)
  , End(bytes + size)
{
}

unsigned int Dice::Draw(int bytes)
{
  if (!this->HasBytes())
  {
    return static_cast<unsigned int>(this->Random());
  }
  unsigned int number = 0;
  for (int i = 0; i < bytes && this->HasBytes(); ++i)
  {
    number = number << 8 | *this->Bytes++;
  }
  return number;
}

std::string Dice::TakeBytes()
{
  std::string bytes(this->Bytes, this->End);
  this->Bytes = this->End;
  return bytes;
}

double Dice::Number()
{
  static const std::vector<double> strange = { 0.0, -0.0, 1.0, -1.0, 1e-45, 1e-300, 1e8, -1e9, 1e20,
    1e38, -1e39, 1e300, std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN() };
  return this->Once(5) ? this->Choose(strange)
                       : std::pow(10.0, 4.0 * this->Share() - 3.0) * (this->Once(4) ? -1 : 1);
}

void Fence(vtkDataArray* array)
{
  const auto values = static_cast<size_t>(array->GetNumberOfValues());
  Fence(array,
    array->GetDataType() == VTK_BIT ? (values + 7) / 8
                                    : values * static_cast<size_t>(array->GetDataTypeSize()));
}

vtkSmartPointer<vtkAbstractArray> MakeArray(Dice& dice, vtkIdType size)
{
  vtkSmartPointer<vtkAbstractArray> array;
  const int type = dice.Throw(12);
  switch (type)
  {
    case 0:
      array = vtkSmartPointer<vtkBitArray>::New();
      break;
    case 1:
      array = vtkSmartPointer<vtkStringArray>::New();
      break;
    case 2:
      array = vtkSmartPointer<vtkUnsignedCharArray>::New();
      break;
    case 3:
      array = vtkSmartPointer<vtkIntArray>::New();
      break;
    case 4:
      array = vtkSmartPointer<vtkIdTypeArray>::New();
      break;
    case 5:
    case 6:
      array = vtkSmartPointer<vtkDoubleArray>::New();
      break;
    default:
      array = vtkSmartPointer<vtkFloatArray>::New();
  }
  array->SetNumberOfComponents(dice.Once(2) ? 1 : 1 + dice.Throw(5));
  const vtkIdType tuples =
    dice.Once(8) ? std::max<vtkIdType>(0, size - 1 + 3 * dice.Throw(2)) : size;
  array->SetNumberOfTuples(dice.Once(30) ? 0 : tuples);
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    const bool isReal = numbers->GetDataType() == VTK_FLOAT || numbers->GetDataType() == VTK_DOUBLE;
    const bool isHostile = dice.Once(3);
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      {
        double value = isReal && isHostile ? dice.Number() : 4.0 * dice.Share() - 1.0;
        if (numbers->GetDataType() == VTK_FLOAT && std::abs(value) > 1e38)
        {
          value = 1e38;
        }
        numbers->SetComponent(i, c, isReal ? value : dice.Throw(2));
      }
    }
    Fence(numbers);
  }
  return array;
}

void AddArrays(Dice& dice, vtkDataSetAttributes* data, vtkIdType size)
{
  static const std::vector<std::string> names = { "DepthTag", "Field", "Flow", "Normals", "UV",
    "Sharpness", "Tension", "Bias", "Direction", "Alpha", "vtkOriginalCellIds", "vtkGhostType",
    "" };
  for (int i = dice.Throw(5); i > 0; --i)
  {
    auto array = MakeArray(dice, size);
    const std::string name = dice.Choose(names);
    if (name == "vtkGhostType" && !vtkUnsignedCharArray::SafeDownCast(array))
    {
      continue; // VTK does not check its own types
    }
    array->SetName(name.empty() ? nullptr : name.c_str());
    data->AddArray(array);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      const int components = numbers->GetNumberOfComponents();
      switch (dice.Throw(5))
      {
        case 0:
          data->SetScalars(numbers);
          break;
        case 1:
          components == 3 ? data->SetNormals(numbers) : 0;
          break;
        case 2:
          components <= 3 ? data->SetTCoords(numbers) : 0;
          break;
        case 3:
          components == 3 ? data->SetVectors(numbers) : 0;
          break;
        default:
          break;
      }
    }
  }
}

std::string ChooseName(Dice& dice)
{
  return dice.Choose(std::vector<std::string>{
    "Field", "Flow", "Normals", "Alpha", "Sharpness", "Bias", "no such array", "" });
}

vtkSmartPointer<vtkCellArray> MakeCells(
  Dice& dice, int most, int longest, vtkIdType numberOfPoints, bool dangling)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int i = dice.Throw(most + 1); i > 0; --i)
  {
    const int size = numberOfPoints > 0 || dangling ? dice.Throw(longest + 1) : 0;
    cells->InsertNextCell(size);
    for (int k = 0; k < size; ++k)
    {
      const bool isLost = (dangling && dice.Once(10)) || numberOfPoints == 0;
      cells->InsertCellPoint(isLost ? numberOfPoints + dice.Throw(1000) - 1
                                    : dice.Throw(static_cast<int>(numberOfPoints)));
    }
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> MakeMesh(Dice& dice)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  if (dice.Once(25))
  {
    return mesh; // an empty mesh
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(dice.Once(3) ? VTK_DOUBLE : VTK_FLOAT);
  const bool isHostile = dice.Once(3);
  const vtkIdType numberOfPoints = dice.Once(20) ? 0 : 3 + dice.Throw(14);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    double x[3];
    for (double& coordinate : x)
    {
      coordinate = isHostile && dice.Once(4) ? dice.Number() : 0.25 * dice.Throw(9) - 1.0;
      if (points->GetDataType() == VTK_FLOAT && std::abs(coordinate) > 1e38)
      {
        coordinate = 1e38;
      }
    }
    points->InsertNextPoint(x);
  }
  Fence(points->GetData());
  const bool dangling = dice.Once(12);
  mesh->SetPoints(points);
  mesh->SetPolys(MakeCells(dice, 8, dice.Once(2) ? 8 : 4, numberOfPoints, dangling));
  if (dice.Once(3))
  {
    mesh->SetStrips(MakeCells(dice, 3, 8, numberOfPoints, dangling));
  }
  if (dice.Once(4))
  {
    mesh->SetVerts(MakeCells(dice, 3, 3, numberOfPoints, dangling));
    mesh->SetLines(MakeCells(dice, 3, 4, numberOfPoints, dangling));
  }
  AddArrays(dice, mesh->GetPointData(), numberOfPoints);
  AddArrays(dice, mesh->GetCellData(), mesh->GetNumberOfCells());
  return mesh;
}

bool IsFinite(vtkPolyData* mesh)
{
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double x[3];
      mesh->GetPoint(ids[i], x);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        return false;
      }
    }
  }
  return true;
}

int GetNumber(const char* variable, int otherwise)
{
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}
}
