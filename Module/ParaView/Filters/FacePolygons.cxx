// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FacePolygons.h"

#include "Arrays/GhostCells.h"
#include "CellSubset.h"
#include "Cells/CellKind.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace relevo
{
namespace
{
// Cell arrays.
constexpr const char* TypesName = "relevo::FaceTypes";     // VTK's cell types
constexpr const char* DegreesName = "relevo::FaceDegrees"; // as in HigherOrderDegrees
constexpr const char* SolidsName = "relevo::FacesOfSolids";
constexpr const char* CellIdsName = "relevo::OriginalCellIds";
// A point array.
constexpr const char* WeightsName = "relevo::FaceWeights";

bool IsLinear(unsigned char type)
{
  return type == VTK_EMPTY_CELL || type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON;
}

void AddTypes(vtkUnstructuredGrid* faces, vtkUnstructuredGrid* grid, vtkPolyData* polygons)
{
  const vtkIdType number = faces->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIntArray> degrees;
  vtkNew<vtkUnsignedCharArray> solids;
  types->SetName(TypesName);
  degrees->SetName(DegreesName);
  solids->SetName(SolidsName);
  degrees->SetNumberOfComponents(3);
  types->SetNumberOfValues(number);
  degrees->SetNumberOfTuples(number);
  degrees->Fill(0.0);
  solids->SetNumberOfValues(number);
  vtkDataArray* given = faces->GetCellData()->GetHigherOrderDegrees();
  auto originals =
    vtkIdTypeArray::SafeDownCast(faces->GetCellData()->GetAbstractArray(OriginalCellIdsName));
  for (vtkIdType face = 0; face < number; ++face)
  {
    types->SetValue(face, static_cast<unsigned char>(faces->GetCellType(face)));
    if (given)
    {
      degrees->SetTuple(face, given->GetTuple(face));
    }
    const int type = grid->GetCellType(originals->GetValue(face));
    solids->SetValue(face, GetCellKind(type, 0).IsSolid() ? 1 : 0);
  }
  polygons->GetCellData()->AddArray(types);
  polygons->GetCellData()->AddArray(degrees);
  polygons->GetCellData()->AddArray(solids);
}

// Add the weights of all nodes, 1 by default, so that all pieces have them.
void AddWeights(vtkUnstructuredGrid* faces, vtkPolyData* polygons)
{
  vtkDataArray* given = faces->GetPointData()->GetRationalWeights();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName(WeightsName);
  weights->SetNumberOfValues(faces->GetNumberOfPoints());
  for (vtkIdType point = 0; point < faces->GetNumberOfPoints(); ++point)
  {
    weights->SetValue(point, given ? given->GetComponent(point, 0) : 1.0);
  }
  polygons->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::RATIONALWEIGHTS);
  polygons->GetPointData()->AddArray(weights);
}

void RenameArray(vtkDataSetAttributes* data, const char* from, const char* to)
{
  if (vtkAbstractArray* array = data->GetAbstractArray(from))
  {
    auto copy = vtk::TakeSmartPointer(array->NewInstance());
    copy->DeepCopy(array);
    copy->SetName(to);
    data->RemoveArray(from);
    data->AddArray(copy);
  }
}

// Return the polygons alone.
vtkSmartPointer<vtkPolyData> RemoveOtherCells(vtkPolyData* mesh)
{
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  if (first == 0 && mesh->GetNumberOfStrips() == 0)
  {
    return mesh;
  }
  std::vector<bool> kept(static_cast<std::size_t>(mesh->GetNumberOfCells()), false);
  for (vtkIdType cell = first; cell < first + mesh->GetNumberOfPolys(); ++cell)
  {
    kept[static_cast<std::size_t>(cell)] = true;
  }
  return ExtractCells(mesh, kept);
}

int GetLinearType(vtkIdType size)
{
  return size == 3 ? VTK_TRIANGLE : size == 4 ? VTK_QUAD : VTK_POLYGON;
}

// Convert arrays of polygons to attributes of the grid.
void SetAttributes(vtkUnstructuredGrid* grid)
{
  vtkCellData* cells = grid->GetCellData();
  if (vtkSmartPointer<vtkDataArray> degrees = cells->GetArray(DegreesName))
  {
    cells->SetHigherOrderDegrees(degrees);
  }
  vtkPointData* points = grid->GetPointData();
  vtkSmartPointer<vtkDataArray> weights = points->GetArray(WeightsName);
  double range[2] = { 1.0, 1.0 };
  if (weights)
  {
    weights->GetRange(range, 0);
    points->RemoveArray(WeightsName);
  }
  if (range[0] != 1.0 || range[1] != 1.0)
  {
    points->SetRationalWeights(weights);
  }
}
}

vtkSmartPointer<vtkPolyData> MakeFacePolygons(vtkUnstructuredGrid* faces, vtkUnstructuredGrid* grid)
{
  auto polygons = vtkSmartPointer<vtkPolyData>::New();
  polygons->GetFieldData()->ShallowCopy(faces->GetFieldData());
  if (faces->GetNumberOfCells() == 0)
  {
    return polygons;
  }
  polygons->SetPoints(faces->GetPoints());
  polygons->SetPolys(faces->GetCells());
  polygons->GetPointData()->ShallowCopy(faces->GetPointData());
  vtkCellData* cells = polygons->GetCellData();
  cells->ShallowCopy(faces->GetCellData());
  AddTypes(faces, grid, polygons);
  AddWeights(faces, polygons);
  if (vtkDataArray* degrees = cells->GetHigherOrderDegrees())
  {
    cells->RemoveArray(degrees->GetName());
  }
  const GhostCells ghosts(polygons);
  if (ghosts.AreAmong(0, polygons->GetNumberOfCells()))
  {
    std::vector<bool> kept;
    for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
    {
      kept.push_back(!ghosts.Has(cell));
    }
    polygons = ExtractCells(polygons, kept);
  }
  return polygons;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeFaceGrid(vtkPolyData* polygons)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const vtkSmartPointer<vtkPolyData> faces = RemoveOtherCells(polygons);
  grid->GetFieldData()->ShallowCopy(polygons->GetFieldData());
  if (faces->GetNumberOfPolys() == 0)
  {
    return grid;
  }
  auto given = vtkUnsignedCharArray::SafeDownCast(faces->GetCellData()->GetArray(TypesName));
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(faces->GetNumberOfPolys());
  for (vtkIdType face = 0; face < faces->GetNumberOfPolys(); ++face)
  {
    const int type = given ? static_cast<int>(given->GetValue(face)) : 0;
    const int linear = GetLinearType(faces->GetPolys()->GetCellSize(face));
    types->SetValue(face, static_cast<unsigned char>(type == VTK_EMPTY_CELL ? linear : type));
  }
  grid->SetPoints(faces->GetPoints());
  grid->SetCells(types, faces->GetPolys());
  grid->GetPointData()->ShallowCopy(faces->GetPointData());
  grid->GetCellData()->ShallowCopy(faces->GetCellData());
  grid->GetCellData()->RemoveArray(TypesName);
  grid->GetCellData()->RemoveArray(SolidsName);
  RenameArray(grid->GetCellData(), OriginalCellIdsName, CellIdsName);
  SetAttributes(grid);
  return grid;
}

void RestoreOriginalIds(vtkPolyData* mesh)
{
  RenameArray(mesh->GetCellData(), CellIdsName, OriginalCellIdsName);
  mesh->GetCellData()->RemoveArray(DegreesName);
  mesh->GetPointData()->RemoveArray(WeightsName);
}

FaceCornerCounter::FaceCornerCounter(vtkPolyData* polygons)
  : Types(vtkUnsignedCharArray::SafeDownCast(polygons->GetCellData()->GetArray(TypesName)))
  , Solids(vtkUnsignedCharArray::SafeDownCast(polygons->GetCellData()->GetArray(SolidsName)))
{
}

vtkIdType FaceCornerCounter::Count(vtkIdType cell, vtkIdType size) const
{
  const unsigned char type =
    this->Types ? this->Types->GetValue(cell) : static_cast<unsigned char>(VTK_EMPTY_CELL);
  if (IsLinear(type))
  {
    return size;
  }
  return GetCellKind(type, size).Shape == CellTopology::Triangle ? 3 : 4;
}

bool FaceCornerCounter::IsOfSolid(vtkIdType cell) const
{
  return this->Solids && this->Solids->GetValue(cell) != 0;
}

vtkSmartPointer<vtkPolyData> MakeCornerPolygons(vtkPolyData* polygons)
{
  const FaceCornerCounter corners(polygons);
  vtkNew<vtkCellArray> cells;
  vtkIdType cell = polygons->GetNumberOfVerts() + polygons->GetNumberOfLines();
  auto iterator = vtk::TakeSmartPointer(polygons->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* points;
    iterator->GetCurrentCell(size, points);
    cells->InsertNextCell(corners.Count(cell++, size), points);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(polygons->GetPoints());
  mesh->SetPolys(cells);
  return mesh;
}
}
