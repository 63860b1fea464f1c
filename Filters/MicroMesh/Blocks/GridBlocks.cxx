// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/GridBlocks.h"

#include "Blocks/BlockBorders.h"
#include "Boxes/BoundingBox.h"
#include "Cells/CellChecks.h"
#include "vtkCellData.h"
#include "vtkContourGrid.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace relevo
{
bool GridBlocks::Find(vtkUnstructuredGrid* grid, const ContourSettings& settings,
  vtkIdType mostCells, std::string& error)
{
  vtkDataArray* scalars = FindScalars(grid, settings, error);
  if (!scalars)
  {
    return false;
  }
  const CellChecks checks = CheckCells(grid);
  if (!checks.Errors.empty())
  {
    error = checks.Errors.front();
    return false;
  }
  std::vector<char> areSolid(checks.Uses.size());
  std::transform(checks.Uses.begin(), checks.Uses.end(), areSolid.begin(),
    [](CellUse use) { return use == CellUse::Solid ? 1 : 0; });
  this->FindCells(grid, scalars, settings.Values, areSolid);
  this->Divide(grid, mostCells);
  this->MarkSharedPoints(grid);
  return true;
}

void GridBlocks::FindCells(vtkUnstructuredGrid* grid, vtkDataArray* scalars,
  const std::vector<double>& values, const std::vector<char>& areSolid)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (areSolid[static_cast<std::size_t>(cell)] == 0)
    {
      continue;
    }
    grid->GetCellPoints(cell, points);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      const double value = scalars->GetComponent(points->GetId(i), 0);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (std::any_of(values.begin(), values.end(),
          [=](double value) { return low <= value && value <= high; }))
    {
      this->Cells.push_back(cell);
    }
  }
}

void GridBlocks::Divide(vtkUnstructuredGrid* grid, vtkIdType mostCells)
{
  struct Centre
  {
    std::array<double, 3> Point;
    vtkIdType Cell;
  };
  std::vector<Centre> centres;
  for (vtkIdType cell : this->Cells)
  {
    double box[6];
    grid->GetCellBounds(cell, box);
    centres.push_back({ { { box[0] + box[1], box[2] + box[3], box[4] + box[5] } }, cell });
  }
  this->Firsts.assign(1, 0);
  std::vector<std::pair<std::size_t, std::size_t>> ranges; // a stack
  if (!centres.empty())
  {
    ranges.emplace_back(0, centres.size());
  }
  while (!ranges.empty())
  {
    const auto range = ranges.back();
    ranges.pop_back();
    const auto at = [&](std::size_t i) { return centres.begin() + static_cast<std::ptrdiff_t>(i); };
    if (range.second - range.first <= static_cast<std::size_t>(mostCells))
    {
      // The cells of a block are in the order of the grid.
      std::sort(at(range.first), at(range.second),
        [](const Centre& a, const Centre& b) { return a.Cell < b.Cell; });
      this->Firsts.push_back(range.second);
      continue;
    }
    BoundingBox<double> box;
    std::for_each(at(range.first), at(range.second),
      [&](const Centre& centre) { box.Add(centre.Point.data()); });
    const auto axis = static_cast<std::size_t>(box.GetLongestAxis());
    const std::size_t middle = range.first + (range.second - range.first) / 2;
    std::nth_element(at(range.first), at(middle), at(range.second),
      [=](const Centre& a, const Centre& b)
      { return a.Point[axis] != b.Point[axis] ? a.Point[axis] < b.Point[axis] : a.Cell < b.Cell; });
    ranges.emplace_back(middle, range.second);
    ranges.emplace_back(range.first, middle);
  }
  std::transform(centres.begin(), centres.end(), this->Cells.begin(),
    [](const Centre& centre) { return centre.Cell; });
}

void GridBlocks::MarkSharedPoints(vtkUnstructuredGrid* grid)
{
  this->Marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  this->Marks->SetName(FixedPointsName);
  this->Marks->SetNumberOfComponents(2);
  this->Marks->SetNumberOfTuples(grid->GetNumberOfPoints());
  this->Marks->Fill(0.0);
  // The last block of each point.
  std::vector<int> blocks(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> points;
  for (int block = 0; block < this->GetNumberOfBlocks(); ++block)
  {
    const auto last = this->Firsts[static_cast<std::size_t>(block) + 1];
    for (std::size_t i = this->Firsts[static_cast<std::size_t>(block)]; i < last; ++i)
    {
      grid->GetCellPoints(this->Cells[i], points);
      for (vtkIdType p = 0; p < points->GetNumberOfIds(); ++p)
      {
        const auto point = static_cast<std::size_t>(points->GetId(p));
        if (blocks[point] >= 0 && blocks[point] != block)
        {
          unsigned char* mark = this->Marks->GetPointer(2 * points->GetId(p));
          mark[mark[0] == 0 ? 0 : 1] = BlockBorders::IsShared;
        }
        blocks[point] = block;
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> GridBlocks::Contour(
  vtkUnstructuredGrid* grid, int block, const ContourSettings& settings) const
{
  vtkNew<vtkUnstructuredGrid> volume;
  volume->CopyStructure(grid);
  std::string error; // Find() has reported it
  CopyContourArrays(grid, FindScalars(grid, settings, error), settings, volume->GetPointData());
  volume->GetPointData()->AddArray(this->Marks);
  vtkNew<vtkIdList> ids;
  const auto last = this->Firsts[static_cast<std::size_t>(block) + 1];
  for (std::size_t i = this->Firsts[static_cast<std::size_t>(block)]; i < last; ++i)
  {
    ids->InsertNextId(this->Cells[i]);
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(volume);
  extract->SetCellList(ids);
  vtkNew<vtkContourGrid> contour;
  contour->SetInputConnection(extract->GetOutputPort());
  contour->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, settings.Scalars.c_str());
  contour->SetComputeScalars(settings.ContourValues ? 1 : 0);
  contour->SetNumberOfContours(static_cast<int>(settings.Values.size()));
  for (std::size_t i = 0; i < settings.Values.size(); ++i)
  {
    contour->SetValue(static_cast<int>(i), settings.Values[i]);
  }
  contour->Update();
  vtkSmartPointer<vtkPolyData> surface = contour->GetOutput();
  BlockBorders::SetFixedPoints(surface);
  surface->GetCellData()->Initialize();
  if (!settings.ContourValues)
  {
    surface->GetPointData()->RemoveArray(settings.Scalars.c_str());
  }
  CleanContour(volume->GetPointData(), surface);
  return surface;
}
}
