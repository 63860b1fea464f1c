// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/SectionOutput.h"

#include "Arrays/CellDataCopy.h"
#include "Arrays/SimilarArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImplicitFunction.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace relevo
{
namespace
{
using Edge = std::array<vtkIdType, 2>;

struct EdgeHash
{
  std::size_t operator()(const Edge& edge) const
  {
    // The odd constant spreads neighbouring ids over all bits.
    return static_cast<std::size_t>(edge[0]) * 0x9e3779b97f4a7c15ULL +
      static_cast<std::size_t>(edge[1]);
  }
};

// A point of the output, as one of a section.
struct PointSource
{
  const CellSection* Section;
  std::size_t Point;
};

struct JoinedPoints
{
  std::vector<PointSource> Sources;
  std::vector<std::vector<vtkIdType>> Ids; // for each section, of its points
};

// Linear cells share the points of their edges.
JoinedPoints JoinPoints(const std::vector<CellSection>& sections)
{
  JoinedPoints joined;
  joined.Ids.reserve(sections.size());
  std::unordered_map<Edge, vtkIdType, EdgeHash> known;
  for (const CellSection& section : sections)
  {
    joined.Ids.emplace_back();
    for (std::size_t i = 0; i < section.Points.size(); ++i)
    {
      const auto next = static_cast<vtkIdType>(joined.Sources.size());
      const vtkIdType id =
        section.Edges[i][0] < 0 ? next : known.emplace(section.Edges[i], next).first->second;
      if (id == next)
      {
        joined.Sources.push_back({ &section, i });
      }
      joined.Ids.back().push_back(id);
    }
  }
  return joined;
}

void InterpolateArray(
  const std::vector<PointSource>& sources, vtkAbstractArray* from, vtkAbstractArray* to)
{
  vtkNew<vtkIdList> nodes;
  std::vector<double> weights;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const CellSection& section = *sources[i].Section;
    const std::size_t number = section.Nodes.size();
    const double* all = section.Weights.data() + sources[i].Point * number;
    nodes->Reset();
    weights.clear();
    for (std::size_t k = 0; k < number; ++k)
    {
      if (all[k] != 0.0)
      {
        nodes->InsertNextId(section.Nodes[k]);
        weights.push_back(all[k]);
      }
    }
    to->InterpolateTuple(static_cast<vtkIdType>(i), nodes, from, weights.data());
  }
}

std::vector<std::string> StorePoints(
  const std::vector<PointSource>& sources, vtkDataSet* input, vtkPolyData* output)
{
  const auto number = static_cast<vtkIdType>(sources.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    points->SetPoint(i, &sources[i].Section->Points[sources[i].Point].x);
  }
  output->SetPoints(points);
  vtkNew<vtkPointData> from;
  from->ShallowCopy(input->GetPointData());
  from->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  from->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
  from->SetRationalWeights(nullptr);
  std::vector<std::string> shortArrays;
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (!IsInterpolated(array))
    {
      continue;
    }
    if (array->GetNumberOfTuples() < input->GetNumberOfPoints())
    {
      shortArrays.emplace_back(array->GetName() ? array->GetName() : "");
      continue;
    }
    InterpolateArray(sources, array, AddArrayLike(from, array, output->GetPointData(), number));
  }
  return shortArrays;
}

// Twice the area vector of a polygon.
dvec3 GetNormal(const CellSection& section, const std::vector<int>& polygon)
{
  dvec3 normal(0.0);
  const dvec3& origin = section.Points[polygon[0]];
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    normal += cross(section.Points[polygon[i - 1]] - origin, section.Points[polygon[i]] - origin);
  }
  return normal;
}

bool PointsToPositiveSide(
  const CellSection& section, const std::vector<int>& polygon, vtkImplicitFunction* function)
{
  dvec3 at = section.Points[polygon[0]];
  dvec3 slope;
  function->FunctionGradient(&at.x, &slope.x);
  return dot(GetNormal(section, polygon), slope) > 0.0;
}
}

std::vector<std::string> StoreSections(const std::vector<CellSection>& sections,
  const std::vector<vtkIdType>& cells, vtkDataSet* input, vtkImplicitFunction* function,
  vtkPolyData* polygons, vtkPolyData* lines)
{
  const JoinedPoints joined = JoinPoints(sections);
  std::vector<std::string> shortArrays = StorePoints(joined.Sources, input, polygons);
  lines->SetPoints(polygons->GetPoints());
  lines->GetPointData()->ShallowCopy(polygons->GetPointData());
  vtkNew<vtkCellArray> polygonCells;
  vtkNew<vtkCellArray> lineCells;
  vtkNew<vtkIdTypeArray> polygonOriginals;
  vtkNew<vtkIdTypeArray> lineOriginals;
  std::unordered_set<Edge, EdgeHash> known; // lines, which two linear cells share
  for (std::size_t i = 0; i < sections.size(); ++i)
  {
    const std::vector<vtkIdType>& ids = joined.Ids[i];
    for (std::vector<int> polygon : sections[i].Polygons)
    {
      if (PointsToPositiveSide(sections[i], polygon, function))
      {
        std::reverse(polygon.begin(), polygon.end());
      }
      polygonCells->InsertNextCell(static_cast<int>(polygon.size()));
      for (const int point : polygon)
      {
        polygonCells->InsertCellPoint(ids[point]);
      }
      polygonOriginals->InsertNextValue(cells[i]);
    }
    for (const std::array<int, 2>& line : sections[i].Lines)
    {
      const Edge ends{ std::min(ids[line[0]], ids[line[1]]), std::max(ids[line[0]], ids[line[1]]) };
      if (known.insert(ends).second)
      {
        lineCells->InsertNextCell(2, ends.data());
        lineOriginals->InsertNextValue(cells[i]);
      }
    }
  }
  polygons->SetPolys(polygonCells);
  lines->SetLines(lineCells);
  CopyCellData(input, polygonOriginals, true, polygons->GetCellData(), shortArrays);
  std::vector<std::string> sameArrays;
  CopyCellData(input, lineOriginals, true, lines->GetCellData(), sameArrays);
  return shortArrays;
}
}
