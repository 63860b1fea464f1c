// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/MicroMeshAppender.h"

#include "Blocks/ContourSettings.h"
#include "Data/MicroMeshArrays.h"
#include "Data/MicroNormals.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"

#include <algorithm>
#include <limits>

namespace relevo
{
namespace
{
// Appends the tuples of all arrays to those with the same names.
bool AppendArrays(vtkFieldData* from, vtkFieldData* to, std::string& error)
{
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = to->GetAbstractArray(i);
    vtkAbstractArray* more = from->GetAbstractArray(array->GetName());
    if (!more || more->GetNumberOfComponents() != array->GetNumberOfComponents() ||
      more->GetDataType() != array->GetDataType())
    {
      error = "Blocks of the input differ: the array \"" + std::string(array->GetName()) +
        "\" is missing or has another type.";
      return false;
    }
    array->InsertTuples(array->GetNumberOfTuples(), more->GetNumberOfTuples(), 0, more);
  }
  return true;
}

// Gives samples the type that all displacements fit, and level errors a component per level.
void UnifyTypes(vtkPolyData* block)
{
  auto samples =
    vtkDataArray::SafeDownCast(block->GetFieldData()->GetAbstractArray(MicroDisplacementsName));
  if (samples && samples->GetDataType() != VTK_SHORT)
  {
    vtkNew<vtkShortArray> wide;
    wide->DeepCopy(samples);
    wide->SetName(MicroDisplacementsName);
    block->GetFieldData()->AddArray(wide);
  }
  auto errors =
    vtkFloatArray::SafeDownCast(block->GetCellData()->GetAbstractArray(MicroLevelErrorsName));
  if (errors)
  {
    vtkNew<vtkFloatArray> wide;
    wide->SetName(MicroLevelErrorsName);
    wide->SetNumberOfComponents(LargestMicroLevel);
    wide->SetNumberOfTuples(errors->GetNumberOfTuples());
    for (int level = 0; level < LargestMicroLevel; ++level)
    {
      if (level < errors->GetNumberOfComponents())
      {
        wide->CopyComponent(level, errors, level);
      }
      else
      {
        wide->FillComponent(level, 0.0);
      }
    }
    block->GetCellData()->AddArray(wide);
  }
}

// Restores the smallest types that fit.
void ReduceTypes(vtkPolyData* joined, int levels)
{
  auto samples =
    vtkShortArray::SafeDownCast(joined->GetFieldData()->GetAbstractArray(MicroDisplacementsName));
  if (samples)
  {
    double range[2];
    samples->GetRange(range);
    constexpr int most = std::numeric_limits<signed char>::max();
    if (range[0] >= -most && range[1] <= most)
    {
      auto narrow = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_SIGNED_CHAR));
      narrow->DeepCopy(samples);
      narrow->SetName(MicroDisplacementsName);
      joined->GetFieldData()->AddArray(narrow);
    }
  }
  auto errors =
    vtkFloatArray::SafeDownCast(joined->GetCellData()->GetAbstractArray(MicroLevelErrorsName));
  if (errors)
  {
    vtkNew<vtkFloatArray> narrow;
    narrow->SetName(MicroLevelErrorsName);
    narrow->SetNumberOfComponents(std::max(1, levels));
    narrow->SetNumberOfTuples(errors->GetNumberOfTuples());
    for (int level = 0; level < narrow->GetNumberOfComponents(); ++level)
    {
      narrow->CopyComponent(level, errors, level);
    }
    joined->GetCellData()->AddArray(narrow);
  }
}

// Shifts the numbers of edges and samples of a block.
void ShiftNumbers(vtkPolyData* block, int firstEdge, int firstSample)
{
  auto faces = vtkIntArray::SafeDownCast(block->GetCellData()->GetAbstractArray(MicroFacesName));
  for (vtkIdType f = 0; f < faces->GetNumberOfTuples(); ++f)
  {
    int* numbers = faces->GetPointer(5 * f);
    for (int e = 0; e < 3; ++e)
    {
      numbers[e] += 2 * firstEdge;
    }
    numbers[3] += firstSample;
  }
  auto edges = vtkIntArray::SafeDownCast(block->GetFieldData()->GetAbstractArray(MicroEdgesName));
  for (vtkIdType e = 0; e < edges->GetNumberOfTuples(); ++e)
  {
    *edges->GetPointer(2 * e) += firstSample;
  }
}

vtkIdType CountTuples(vtkFieldData* data, const char* name)
{
  vtkAbstractArray* array = data->GetAbstractArray(name);
  return array ? array->GetNumberOfTuples() : 0;
}
}

MicroMeshAppender::MicroMeshAppender() = default;
MicroMeshAppender::~MicroMeshAppender() = default;

void MicroMeshAppender::AddNormals(vtkPolyData* block)
{
  const vtkIdType first = this->Joined ? this->Joined->GetNumberOfPoints() : 0;
  vtkDataArray* marks = block->GetPointData()->GetArray(FixedPointsName);
  MicroMesh micro;
  std::string error; // the filter has made the arrays
  if (!marks || !TakeMicroMesh(block, micro, error))
  {
    return;
  }
  const auto isFixed = [&](int point) { return marks->GetComponent(point, 0) != 0.0; };
  const auto find = [&](int point) -> Border&
  {
    std::array<double, 3> x{};
    block->GetPoint(point, x.data());
    return this->Borders[x];
  };
  for (int point = 0; point < static_cast<int>(micro.Points.size()); ++point)
  {
    if (isFixed(point))
    {
      find(point).Points.push_back(first + point);
    }
  }
  for (const MicroMesh::Face& face : micro.Faces)
  {
    if (std::any_of(face.Corners.begin(), face.Corners.end(), isFixed))
    {
      const std::array<dvec3, 3> normals = ComputeCornerNormals(micro, face);
      for (std::size_t c = 0; c < 3; ++c)
      {
        if (isFixed(face.Corners[c]))
        {
          find(face.Corners[c]).Normal += normals[c];
        }
      }
    }
  }
}

bool MicroMeshAppender::Append(vtkPolyData* block, std::string& error)
{
  if (block->GetNumberOfPolys() == 0)
  {
    return true;
  }
  this->AddNormals(block);
  auto errors =
    vtkFloatArray::SafeDownCast(block->GetCellData()->GetAbstractArray(MicroLevelErrorsName));
  this->NumberOfLevels =
    std::max(this->NumberOfLevels, errors ? errors->GetNumberOfComponents() : 0);
  UnifyTypes(block);
  block->GetFieldData()->RemoveArray(MicroInputBoundsName); // those of the block
  if (!this->Joined)
  {
    this->Joined = vtkSmartPointer<vtkPolyData>::New();
    this->Joined->DeepCopy(block);
    return true;
  }
  vtkFieldData* fields = this->Joined->GetFieldData();
  const vtkIdType firstEdge = CountTuples(fields, MicroEdgesName);
  const vtkIdType firstSample = CountTuples(fields, MicroDisplacementsName);
  constexpr vtkIdType most = std::numeric_limits<int>::max() / 2;
  if (firstEdge + CountTuples(block->GetFieldData(), MicroEdgesName) > most ||
    firstSample + CountTuples(block->GetFieldData(), MicroDisplacementsName) > most)
  {
    error = "The micro-mesh has more than " + std::to_string(most) + " samples or edges.";
    return false;
  }
  ShiftNumbers(block, static_cast<int>(firstEdge), static_cast<int>(firstSample));
  auto bounds = vtkDoubleArray::SafeDownCast(fields->GetAbstractArray(MicroErrorName));
  auto more = vtkDoubleArray::SafeDownCast(block->GetFieldData()->GetAbstractArray(MicroErrorName));
  for (int i = 0; i < 2; ++i)
  {
    bounds->SetValue(i, std::max(bounds->GetValue(i), more->GetValue(i)));
  }
  const vtkSmartPointer<vtkDoubleArray> largest = bounds;
  fields->RemoveArray(MicroErrorName);
  const vtkIdType firstPoint = this->Joined->GetNumberOfPoints();
  vtkPoints* points = this->Joined->GetPoints();
  points->GetData()->InsertTuples(
    firstPoint, block->GetNumberOfPoints(), 0, block->GetPoints()->GetData());
  points->Modified();
  this->Joined->GetPolys()->Append(block->GetPolys(), firstPoint);
  const bool isSame = AppendArrays(block->GetPointData(), this->Joined->GetPointData(), error) &&
    AppendArrays(block->GetCellData(), this->Joined->GetCellData(), error) &&
    AppendArrays(block->GetFieldData(), fields, error);
  fields->AddArray(largest);
  return isSame;
}

void MicroMeshAppender::Finish(vtkPolyData* output)
{
  if (!this->Joined)
  {
    return;
  }
  vtkDataArray* normals = this->Joined->GetPointData()->GetNormals();
  for (const auto& border : this->Borders)
  {
    const double size = length(border.second.Normal);
    const dvec3 normal = size > 0.0 ? border.second.Normal / size : dvec3(0.0);
    for (vtkIdType point : border.second.Points)
    {
      normals->SetTuple(point, &normal.x);
    }
  }
  this->Joined->GetPointData()->RemoveArray(FixedPointsName);
  ReduceTypes(this->Joined, this->NumberOfLevels);
  this->Joined->Squeeze();
  output->ShallowCopy(this->Joined);
  this->Joined = nullptr;
  this->Borders.clear();
}
}
