// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveOutputs.h"

#include "Curves/CurveSegments.h"
#include "Curves/IntersectionPoints.h"
#include "Curves/JoinedLines.h"
#include "Mesh/MovedSurface.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Cells with the ids of the intersecting cells, and their points.
class Cells
{
public:
  Cells(const MovedSurface& first, const MovedSurface& second,
    const std::vector<IntersectingPair>& pairs, const IntersectionPoints& points)
    : Surfaces{ &first, &second }
    , Pairs(pairs)
    , All(points)
    , NewIds(points.GetNumberOfPoints(), -1)
  {
    for (int side = 0; side < 2; ++side)
    {
      this->CellIds[side]->SetName(side == 0 ? "Input0CellID" : "Input1CellID");
    }
  }

  void Add(vtkCellArray* cells, const std::vector<vtkIdType>& points, std::array<vtkIdType, 2> ids)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(points.size()));
    for (vtkIdType point : points)
    {
      vtkIdType& id = this->NewIds[point];
      if (id < 0)
      {
        id = static_cast<vtkIdType>(this->Used.size());
        this->Used.push_back(point);
      }
      cells->InsertCellPoint(id);
    }
    this->CellIds[0]->InsertNextValue(ids[0]);
    this->CellIds[1]->InsertNextValue(ids[1]);
  }

  std::array<vtkIdType, 2> GetCellIds(std::size_t pair) const
  {
    const auto& triangles = this->Pairs[pair].Triangles;
    std::array<vtkIdType, 2> ids{ this->Surfaces[0]->GetCell(triangles[0]),
      this->Surfaces[1]->GetCell(triangles[1]) };
    return ids;
  }

  void Finish(vtkPolyData* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Used.size()));
    vtkSMPTools::For(0, points->GetNumberOfPoints(),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          double x[3];
          this->All.Compute(this->Used[i], x);
          points->SetPoint(i, x);
        }
      });
    output->SetPoints(points);
    output->GetCellData()->AddArray(this->CellIds[0]);
    output->GetCellData()->AddArray(this->CellIds[1]);
  }

private:
  const MovedSurface* Surfaces[2];
  const std::vector<IntersectingPair>& Pairs;
  const IntersectionPoints& All;
  std::vector<vtkIdType> NewIds;
  std::vector<vtkIdType> Used;
  vtkNew<vtkIdTypeArray> CellIds[2];
};

// Returns the ids if all segments of a line have the same, otherwise -1.
std::array<vtkIdType, 2> GetCommonIds(
  const Cells& cells, const JoinedLine& line, const CurveSegments& segments)
{
  const auto getIds = [&](std::size_t segment)
  { return cells.GetCellIds(segments.Segments[segment].Pair); };
  std::array<vtkIdType, 2> common = getIds(line.Segments.front());
  for (std::size_t segment : line.Segments)
  {
    const auto ids = getIds(segment);
    for (int side = 0; side < 2; ++side)
    {
      common[side] = ids[side] == common[side] ? common[side] : -1;
    }
  }
  return common;
}

void AddJoinedLines(const CurveSegments& segments, vtkIdType numberOfPoints, Cells& cells,
  vtkCellArray* lines, vtkPolyData* curves)
{
  const std::vector<JoinedLine> joined = JoinSegments(segments.Segments, numberOfPoints);
  const std::vector<vtkIdType> components = FindComponents(joined, numberOfPoints);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ComponentId");
  // Vertices are the first cells, but have the last components.
  vtkIdType next = 0;
  for (vtkIdType component : components)
  {
    next = std::max(next, component + 1);
  }
  for (std::size_t i = 0; i < segments.Touches.size(); ++i)
  {
    ids->InsertNextValue(next + static_cast<vtkIdType>(i));
  }
  for (std::size_t i = 0; i < joined.size(); ++i)
  {
    cells.Add(lines, joined[i].Points, GetCommonIds(cells, joined[i], segments));
    ids->InsertNextValue(components[i]);
  }
  curves->GetCellData()->AddArray(ids);
}
}

void MakeCurves(const MovedSurface& first, const MovedSurface& second,
  const std::vector<IntersectingPair>& pairs, bool joinSegments, vtkPolyData* curves,
  vtkPolyData* overlaps)
{
  const IntersectionPoints points(first, second, pairs);
  const CurveSegments segments(pairs, points);
  Cells cells(first, second, pairs, points);
  vtkNew<vtkCellArray> vertices;
  for (const CurveSegments::Touch& touch : segments.Touches)
  {
    cells.Add(vertices, { touch.Point }, cells.GetCellIds(touch.Pair));
  }
  vtkNew<vtkCellArray> lines;
  if (joinSegments)
  {
    AddJoinedLines(segments, points.GetNumberOfPoints(), cells, lines, curves);
  }
  else
  {
    for (const CurveSegments::Segment& segment : segments.Segments)
    {
      cells.Add(lines, { segment.Points[0], segment.Points[1] }, cells.GetCellIds(segment.Pair));
    }
  }
  cells.Finish(curves);
  curves->SetVerts(vertices);
  curves->SetLines(lines);

  Cells polygonCells(first, second, pairs, points);
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> corners;
  for (std::size_t pair : segments.Overlaps)
  {
    corners.clear();
    for (int i = 0; i < pairs[pair].Common.Count; ++i)
    {
      corners.push_back(points.GetId(pair, i));
    }
    polygonCells.Add(polygons, corners, polygonCells.GetCellIds(pair));
  }
  polygonCells.Finish(overlaps);
  overlaps->SetPolys(polygons);
}
}
