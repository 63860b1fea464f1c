// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PatchArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace relevo
{
namespace
{
// The components of the array Patches.
enum Record
{
  KIND,
  DEGREE_U,
  DEGREE_V,
  FIRST_POINT,
  RECORD_SIZE
};

constexpr int PointSize = 4;
constexpr int CoordinatesSize = 6;

// Returns the array, converted if it has another type. Returns nullptr and an error if it is
// missing or has the wrong size. Accepts any number of tuples if `tuples` is -1.
template <typename Array>
vtkSmartPointer<Array> TakeArray(
  vtkFieldData* data, const char* name, int components, vtkIdType tuples, std::string& error)
{
  vtkDataArray* array = data->GetArray(name);
  std::ostringstream text;
  if (!array)
  {
    text << "there is no array " << name << " of numbers, which vtkPatchSurfaceFilter creates";
  }
  else if (array->GetNumberOfComponents() != components ||
    (tuples >= 0 && array->GetNumberOfTuples() != tuples))
  {
    text << "the array " << name << " has " << array->GetNumberOfTuples() << " tuples of "
         << array->GetNumberOfComponents() << " components, but ";
    if (tuples >= 0)
    {
      text << tuples << " tuples of ";
    }
    text << components << (tuples >= 0 ? " are needed" : " components are needed");
  }
  error = text.str();
  if (!error.empty())
  {
    return nullptr;
  }
  vtkSmartPointer<Array> result = Array::FastDownCast(array);
  if (!result)
  {
    result = vtkSmartPointer<Array>::New();
    result->DeepCopy(array);
  }
  return result;
}

template <typename Index>
bool Fail(std::string& error, const char* what, Index index, const char* reason)
{
  std::ostringstream text;
  text << what << " " << index << " " << reason;
  error = text.str();
  return false;
}

bool IsDegree(vtkIdType degree)
{
  return degree >= 1 && degree <= LargestDegree;
}
}

bool PatchArrays::AreOn(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->HasArray(PatchesName) ||
    mesh->GetFieldData()->HasArray(PatchPointsName) || mesh->GetCellData()->HasArray(PatchIdsName);
}

void PatchArrays::Remove(vtkPolyData* mesh)
{
  mesh->GetCellData()->RemoveArray(PatchIdsName);
  mesh->GetCellData()->RemoveArray(PatchCoordinatesName);
  vtkFieldData* field = mesh->GetFieldData();
  field->RemoveArray(PatchesName);
  field->RemoveArray(PatchPointsName);
  field->RemoveArray(PatchInnerBordersName);
  const std::string prefix = PatchNodesPrefix;
  for (int a = field->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    const char* name = field->GetArrayName(a);
    if (name &&
      prefix.compare(0, prefix.size(), name, std::min(prefix.size(), std::strlen(name))) == 0)
    {
      field->RemoveArray(a);
    }
  }
}

vtkDataArray* PatchArrays::FindNodes(vtkPolyData* mesh, vtkAbstractArray* pointArray)
{
  vtkFieldData* field = mesh->GetFieldData();
  vtkDataArray* points = field->GetArray(PatchPointsName);
  vtkDataArray* nodes = pointArray->GetName()
    ? field->GetArray((PatchNodesPrefix + std::string(pointArray->GetName())).c_str())
    : nullptr;
  const bool fits = nodes && points && nodes->GetNumberOfTuples() == points->GetNumberOfTuples() &&
    nodes->GetNumberOfComponents() == pointArray->GetNumberOfComponents();
  return fits ? nodes : nullptr;
}

bool PatchArrays::HaveDifferentWeights(vtkPolyData* mesh)
{
  double range[2];
  mesh->GetFieldData()->GetArray(PatchPointsName)->GetRange(range, 3);
  return range[0] < range[1];
}

Dependencies PatchArrays::GetDependencies(vtkPolyData* mesh)
{
  Dependencies dependencies;
  dependencies.AddObject(mesh->GetPoints());
  dependencies.AddObject(mesh->GetPolys());
  for (const char* name : { PatchesName, PatchPointsName, PatchInnerBordersName })
  {
    dependencies.AddObject(mesh->GetFieldData()->GetAbstractArray(name));
  }
  for (const char* name : { PatchIdsName, PatchCoordinatesName })
  {
    dependencies.AddObject(mesh->GetCellData()->GetAbstractArray(name));
  }
  return dependencies;
}

bool PatchArrays::Take(vtkPolyData* mesh, std::string& error)
{
  vtkFieldData* field = mesh->GetFieldData();
  vtkFieldData* cells = mesh->GetCellData();
  const vtkIdType numberOfCells = mesh->GetNumberOfCells();
  this->Patches = TakeArray<vtkIdTypeArray>(field, PatchesName, RECORD_SIZE, -1, error);
  this->Points = !this->Patches
    ? nullptr
    : TakeArray<vtkDoubleArray>(field, PatchPointsName, PointSize, -1, error);
  this->Ids =
    !this->Points ? nullptr : TakeArray<vtkIntArray>(cells, PatchIdsName, 1, numberOfCells, error);
  this->Coordinates = !this->Ids
    ? nullptr
    : TakeArray<vtkFloatArray>(cells, PatchCoordinatesName, CoordinatesSize, numberOfCells, error);
  const bool hasBorders = this->Coordinates && field->HasArray(PatchInnerBordersName);
  this->InnerBorders = hasBorders ? TakeArray<vtkIntArray>(field, PatchInnerBordersName, 1,
                                      this->Patches->GetNumberOfTuples(), error)
                                  : nullptr;
  return this->Coordinates && (!hasBorders || this->InnerBorders) && this->CheckPatches(error) &&
    this->CheckPoints(error) && this->CheckCells(mesh, error);
}

Patch PatchArrays::GetPatch(int patch) const
{
  const vtkIdType* record = this->Patches->GetPointer(RECORD_SIZE * static_cast<vtkIdType>(patch));
  return { record[KIND] == VTK_BEZIER_TRIANGLE,
    ivec2(static_cast<int>(record[DEGREE_U]), static_cast<int>(record[DEGREE_V])),
    record[FIRST_POINT] };
}

bool PatchArrays::CheckPatches(std::string& error) const
{
  const vtkIdType numberOfPatches = this->Patches->GetNumberOfTuples();
  if (numberOfPatches > VTK_INT_MAX)
  {
    error = "there are more than 2147483647 patches";
    return false;
  }
  const vtkIdType numberOfPoints = this->Points->GetNumberOfTuples();
  for (int i = 0; i < static_cast<int>(numberOfPatches); ++i)
  {
    const vtkIdType* record = this->Patches->GetPointer(RECORD_SIZE * static_cast<vtkIdType>(i));
    const bool isTriangle = record[KIND] == VTK_BEZIER_TRIANGLE;
    if (!isTriangle && record[KIND] != VTK_BEZIER_QUADRILATERAL)
    {
      return Fail(error, "patch", i, "is neither a Bézier quadrilateral nor a Bézier triangle");
    }
    if (!IsDegree(record[DEGREE_U]) || !IsDegree(record[DEGREE_V]))
    {
      return Fail(error, "patch", i, "has a degree that is not in [1, 8]");
    }
    if (isTriangle && record[DEGREE_U] != record[DEGREE_V])
    {
      return Fail(error, "patch", i, "is a triangle with two different degrees");
    }
    const vtkIdType first = record[FIRST_POINT];
    if (first < 0 || first > numberOfPoints ||
      this->GetPatch(i).GetNumberOfPoints() > numberOfPoints - first)
    {
      return Fail(
        error, "patch", i, "refers to control points that do not exist in the array PatchPoints");
    }
  }
  return true;
}

bool PatchArrays::CheckPoints(std::string& error) const
{
  for (vtkIdType i = 0; i < this->GetNumberOfPoints(); ++i)
  {
    const double* x = this->Points->GetPointer(PointSize * i);
    // A sum of finite numbers could overflow.
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]) ||
      !std::isfinite(x[3]) || !(x[3] > 0.0))
    {
      return Fail(error, "control point", i, "is not finite, or its weight is not positive");
    }
  }
  return true;
}

bool PatchArrays::CheckTriangle(vtkIdType cell, std::string& error) const
{
  const int patch = this->GetPatchId(cell);
  if (patch < 0 || patch >= this->GetNumberOfPatches())
  {
    return Fail(
      error, "triangle", cell, "refers to a patch that does not exist in the array Patches");
  }
  const bool isTriangle = this->GetPatch(patch).IsTriangle;
  for (int corner = 0; corner < 3; ++corner)
  {
    const vec2 uv = this->GetCoordinates(cell, corner);
    const float high = isTriangle ? uv.x + uv.y : std::max(uv.x, uv.y);
    if (!(uv.x >= 0.0f && uv.y >= 0.0f && high <= 1.0f))
    {
      return Fail(error, "triangle", cell, "has PatchCoordinates outside its patch");
    }
  }
  return true;
}

bool PatchArrays::CheckCells(vtkPolyData* mesh, std::string& error) const
{
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkCellArray* polygons = mesh->GetPolys();
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    if (polygons->GetCellSize(i) != 3)
    {
      return Fail(error, "cell", first + i, "is not a triangle, but patches consist of triangles");
    }
    if (!this->CheckTriangle(first + i, error))
    {
      return false;
    }
  }
  if (mesh->GetNumberOfStrips() > 0)
  {
    error = "the mesh has triangle strips, but patches consist of triangles";
    return false;
  }
  return true;
}
}
