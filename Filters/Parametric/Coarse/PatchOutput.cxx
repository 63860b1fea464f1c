// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Coarse/PatchOutput.h"

#include "Arrays/CellDataCopy.h"
#include "Arrays/NearestTuple.h"
#include "Mesh/PatchArrays.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>

namespace relevo
{
namespace
{
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

// Returns the names of grid arrays that are too short.
std::vector<std::string> StoreTriangles(
  const ControlNets& nets, const CoarseMesh& mesh, vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  const auto number = static_cast<vtkIdType>(mesh.Triangles.size());
  auto originals = NewArray<vtkIdTypeArray>(nullptr, 1, number);
  auto patches = NewArray<vtkIntArray>(PatchIdsName, 1, number);
  auto coordinates = NewArray<vtkFloatArray>(PatchCoordinatesName, 6, number);
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(number, 3 * number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    const CoarseTriangle& triangle = mesh.Triangles[i];
    polys->InsertNextCell(3, triangle.Points.data());
    originals->SetValue(i, nets.GetPatches()[triangle.Patch].Cell);
    patches->SetValue(i, static_cast<int>(triangle.Patch));
    for (int k = 0; k < 3; ++k)
    {
      coordinates->SetComponent(i, 2 * k, triangle.Coordinates[k].x);
      coordinates->SetComponent(i, 2 * k + 1, triangle.Coordinates[k].y);
    }
  }
  output->SetPolys(polys);
  std::vector<std::string> shortArrays;
  CopyCellData(grid, originals, false, output->GetCellData(), shortArrays);
  output->GetCellData()->AddArray(patches);
  output->GetCellData()->AddArray(coordinates);
  return shortArrays;
}

void StorePoints(const CoarseMesh& mesh, vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  const auto number = static_cast<vtkIdType>(mesh.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(number);
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(number);
  to->SetNumberOfIds(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    from->SetId(i, mesh.Points[i].GridPoint);
    to->SetId(i, i);
    points->SetPoint(i, &mesh.Points[i].Place.x);
  }
  output->SetPoints(points);
  output->GetPointData()->CopyAllocate(grid->GetPointData(), number);
  output->GetPointData()->CopyData(grid->GetPointData(), from, to);
}

vtkSmartPointer<vtkFloatArray> NewNormals(const CoarseMesh& mesh)
{
  const auto number = static_cast<vtkIdType>(mesh.Normals.size());
  auto normals = NewArray<vtkFloatArray>("Normals", 3, number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    normals->SetTuple(i, &mesh.Normals[i].x);
  }
  return normals;
}

// Stores inner borders if there are any.
void StoreInnerBorders(const std::vector<FacePatch>& patches, vtkPolyData* output)
{
  auto borders =
    NewArray<vtkIntArray>(PatchInnerBordersName, 1, static_cast<vtkIdType>(patches.size()));
  bool hasSome = false;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    borders->SetValue(static_cast<vtkIdType>(i), patches[i].InnerBorders);
    hasSome = hasSome || patches[i].InnerBorders != 0;
  }
  if (hasSome)
  {
    output->GetFieldData()->AddArray(borders);
  }
}

void StoreNets(const ControlNets& nets, const std::vector<dvec4>& points, vtkPolyData* output)
{
  const std::vector<FacePatch>& patches = nets.GetPatches();
  auto table = NewArray<vtkIdTypeArray>(PatchesName, 4, static_cast<vtkIdType>(patches.size()));
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    const std::array<vtkIdType, 4> tuple{ patches[i].IsTriangle ? VTK_BEZIER_TRIANGLE
                                                                : VTK_BEZIER_QUADRILATERAL,
      patches[i].Degrees.x, patches[i].Degrees.y, patches[i].FirstPoint };
    table->SetTypedTuple(static_cast<vtkIdType>(i), tuple.data());
  }
  auto places = NewArray<vtkDoubleArray>(PatchPointsName, 4, static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    places->SetTypedTuple(static_cast<vtkIdType>(i), &points[i].x);
  }
  output->GetFieldData()->AddArray(table);
  output->GetFieldData()->AddArray(places);
  StoreInnerBorders(patches, output);
}

// Returns the arrays that can be interpolated between points.
std::vector<vtkDataArray*> GetInterpolatedArrays(vtkUnstructuredGrid* grid)
{
  vtkPointData* data = grid->GetPointData();
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const int attribute = data->IsArrayAnAttribute(i);
    const bool isOther = attribute == vtkDataSetAttributes::GLOBALIDS ||
      attribute == vtkDataSetAttributes::PEDIGREEIDS ||
      attribute == vtkDataSetAttributes::RATIONALWEIGHTS;
    const bool isGhosts = array == data->GetArray(vtkDataSetAttributes::GhostArrayName());
    if (array && array->GetName() && !isOther && !isGhosts)
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

void StoreCoefficients(const ControlNets& nets, vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  for (vtkDataArray* array : GetInterpolatedArrays(grid))
  {
    const std::string name = std::string(PatchNodesPrefix) + array->GetName();
    const std::vector<double> values = nets.Convert(array);
    auto coefficients = NewArray<vtkDoubleArray>(
      name.c_str(), array->GetNumberOfComponents(), nets.GetNumberOfControlPoints());
    std::copy(values.begin(), values.end(), coefficients->GetPointer(0));
    output->GetFieldData()->AddArray(coefficients);
  }
}

// Returns the weighted sum of the coefficients of a patch.
void EvaluateTuple(vtkDataArray* coefficients, const FacePatch& patch,
  const std::vector<double>& shares, std::vector<double>& tuple)
{
  tuple.assign(static_cast<std::size_t>(coefficients->GetNumberOfComponents()), 0.0);
  vtkIdType node = patch.FirstPoint;
  for (double share : shares)
  {
    for (std::size_t c = 0; c < tuple.size(); ++c)
    {
      tuple[c] += share * coefficients->GetComponent(node, static_cast<int>(c));
    }
    ++node;
  }
}

// Evaluates arrays at points that are not nodes.
void EvaluateArrays(
  const ControlNets& nets, const ControlPoints& points, const CoarseMesh& mesh, vtkPolyData* output)
{
  vtkPointData* data = output->GetPointData();
  std::vector<std::pair<vtkDataArray*, vtkDataArray*>> arrays;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    vtkDataArray* coefficients = array ? PatchArrays::FindNodes(output, array) : nullptr;
    if (coefficients)
    {
      arrays.emplace_back(array, coefficients);
    }
  }
  std::vector<double> tuple;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const CoarsePoint& point = mesh.Points[i];
    if (point.IsNode)
    {
      continue;
    }
    const FacePatch& patch = nets.GetPatches()[point.Patch];
    const std::vector<double> shares = EvaluateShares(patch, points, point.Coordinates);
    for (const auto& [array, coefficients] : arrays)
    {
      EvaluateTuple(coefficients, patch, shares, tuple);
      SetNearestTuple(array, static_cast<vtkIdType>(i), tuple.data());
    }
  }
}
}

std::vector<std::string> StorePatches(const ControlNets& nets, const std::vector<dvec4>& points,
  const ControlPoints& homogeneous, const CoarseMesh& mesh, vtkUnstructuredGrid* grid,
  vtkPolyData* output)
{
  StorePoints(mesh, grid, output);
  const std::vector<std::string> shortArrays = StoreTriangles(nets, mesh, grid, output);
  StoreNets(nets, points, output);
  StoreCoefficients(nets, grid, output);
  EvaluateArrays(nets, homogeneous, mesh, output);
  output->GetPointData()->SetNormals(NewNormals(mesh));
  return shortArrays;
}
}
