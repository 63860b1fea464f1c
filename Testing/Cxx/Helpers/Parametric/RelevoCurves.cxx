// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCurves.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <cstdlib>
#include <map>
#include <utility>

vtkSmartPointer<vtkUnstructuredGrid> RelevoNewGrid(const std::vector<RelevoPosition>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const RelevoPosition& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->Allocate(1);
  return grid;
}

vtkSmartPointer<vtkAdaptiveCurveFilter> RelevoNewCurveFilter(vtkDataObject* input, int level)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(level);
  auto filter = vtkSmartPointer<vtkAdaptiveCurveFilter>::New();
  filter->SetRefinement(recipe);
  filter->SetInputDataObject(input);
  return filter;
}

std::vector<RelevoPosition> RelevoGetCellPoints(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  std::vector<RelevoPosition> places(ids->GetNumberOfIds());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    mesh->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), places[i].data());
  }
  return places;
}

int RelevoCountOpenEdges(vtkPolyData* mesh)
{
  std::map<std::pair<RelevoPosition, RelevoPosition>, int> edges;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const std::vector<RelevoPosition> corners = RelevoGetCellPoints(mesh, cell);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const RelevoPosition& a = corners[i];
      const RelevoPosition& b = corners[(i + 1) % corners.size()];
      if (a != b)
      {
        edges[a < b ? std::make_pair(a, b) : std::make_pair(b, a)] += a < b ? 1 : -1;
      }
    }
  }
  int open = 0;
  for (const auto& edge : edges)
  {
    open += std::abs(edge.second);
  }
  return open;
}

double RelevoGetVolume(vtkPolyData* mesh)
{
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const std::vector<RelevoPosition> corners = RelevoGetCellPoints(mesh, cell);
    double normal[3];
    vtkMath::Cross(corners[1].data(), corners[2].data(), normal);
    volume += vtkMath::Dot(corners[0].data(), normal) / 6.0;
  }
  return volume;
}
