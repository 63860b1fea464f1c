// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurveLines.h"

#include "Arrays/CellDataCopy.h"
#include "Arrays/GhostCells.h"
#include "CellSubset.h"
#include "Cells/CellKind.h"
#include "FacePolygons.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>
#include <string>
#include <vector>

namespace relevo
{
namespace
{
constexpr const char* TypesName = "relevo::CurveTypes";     // of cells
constexpr const char* WeightsName = "relevo::CurveWeights"; // of points

// Add the weights of all nodes, 1 by default, so that all pieces have them.
void AddWeights(vtkUnstructuredGrid* grid, vtkPolyData* lines)
{
  vtkDataArray* given = grid->GetPointData()->GetRationalWeights();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName(WeightsName);
  weights->SetNumberOfValues(grid->GetNumberOfPoints());
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    weights->SetValue(point, given ? given->GetComponent(point, 0) : 1.0);
  }
  lines->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::RATIONALWEIGHTS);
  lines->GetPointData()->AddArray(weights);
}

void AddPointIds(vtkPolyData* mesh)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalPointIdsName);
  ids->SetNumberOfValues(mesh->GetNumberOfPoints());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), 0);
  mesh->GetPointData()->AddArray(ids);
}

vtkSmartPointer<vtkPolyData> ExtractLines(vtkPolyData* mesh)
{
  const GhostCells ghosts(mesh);
  const vtkIdType first = mesh->GetNumberOfVerts();
  std::vector<bool> kept(static_cast<std::size_t>(mesh->GetNumberOfCells()), false);
  for (vtkIdType cell = first; cell < first + mesh->GetNumberOfLines(); ++cell)
  {
    kept[static_cast<std::size_t>(cell)] = !ghosts.Has(cell);
  }
  return ExtractCells(mesh, kept);
}
}

vtkSmartPointer<vtkPolyData> MakeCurveLines(vtkUnstructuredGrid* grid)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->GetFieldData()->ShallowCopy(grid->GetFieldData());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIdTypeArray> originals;
  vtkNew<vtkIdList> points;
  types->SetName(TypesName);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    if (GetCellKind(type, 0).Shape == CellTopology::Curve)
    {
      grid->GetCellPoints(cell, points);
      cells->InsertNextCell(points);
      types->InsertNextValue(static_cast<unsigned char>(type));
      originals->InsertNextValue(cell);
    }
  }
  if (originals->GetNumberOfValues() == 0)
  {
    return lines;
  }
  lines->SetPoints(grid->GetPoints());
  lines->SetLines(cells);
  lines->GetPointData()->ShallowCopy(grid->GetPointData());
  std::vector<std::string> shortArrays; // they cannot be drawn
  CopyCellData(grid, originals, true, lines->GetCellData(), shortArrays);
  lines->GetCellData()->AddArray(types);
  AddWeights(grid, lines);
  AddPointIds(lines);
  return ExtractLines(lines);
}

vtkSmartPointer<vtkPolyData> MakeCurveLines(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> lines;
  lines->ShallowCopy(mesh);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalCellIdsName);
  ids->SetNumberOfValues(mesh->GetNumberOfCells());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), 0);
  lines->GetCellData()->AddArray(ids);
  AddPointIds(lines);
  return ExtractLines(lines);
}

vtkSmartPointer<vtkUnstructuredGrid> MakeCurveGrid(vtkPolyData* lines)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->GetFieldData()->ShallowCopy(lines->GetFieldData());
  if (lines->GetNumberOfLines() == 0)
  {
    return grid;
  }
  auto given = vtkUnsignedCharArray::SafeDownCast(lines->GetCellData()->GetArray(TypesName));
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(lines->GetNumberOfLines());
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    const int type = given ? static_cast<int>(given->GetValue(line)) : 0;
    types->SetValue(
      line, static_cast<unsigned char>(type == VTK_EMPTY_CELL ? VTK_POLY_LINE : type));
  }
  grid->SetPoints(lines->GetPoints());
  grid->SetCells(types, lines->GetLines());
  grid->GetPointData()->ShallowCopy(lines->GetPointData());
  grid->GetCellData()->ShallowCopy(lines->GetCellData());
  grid->GetCellData()->RemoveArray(TypesName);
  if (vtkSmartPointer<vtkDataArray> weights = grid->GetPointData()->GetArray(WeightsName))
  {
    double range[2];
    weights->GetRange(range, 0);
    grid->GetPointData()->RemoveArray(WeightsName);
    if (range[0] != 1.0 || range[1] != 1.0)
    {
      grid->GetPointData()->SetRationalWeights(weights);
    }
  }
  return grid;
}
}
