// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveMesh.h"

#include "Curves/CurveCells.h"
#include "Mathematics/LagrangeToBezier.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>

namespace relevo
{
namespace
{
// Calls work(cell, kind, points) for all cells that may be curves, in parallel.
template <typename Work>
void ForEachCurveCell(const CurveCells& cells, const Work& work)
{
  vtkSMPTools::For(0, cells.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> points;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const CurveCells::Kinds kind = cells.GetKind(cell);
        if (kind != CurveCells::NO_CURVE)
        {
          cells.GetPoints(cell, kind, points);
          work(cell, kind, points.Get());
        }
      }
    });
}

// Calls work(first, size) with the range of points of each curve of a cell.
template <typename Work>
void ForEachCurve(CurveCells::Kinds kind, vtkIdList* points, const Work& work)
{
  const vtkIdType number = points->GetNumberOfIds();
  const vtkIdType size = kind == CurveCells::LINES ? 2 : number;
  for (vtkIdType first = 0; first + size <= number; first += size - 1)
  {
    work(first, size);
  }
}

dvec3 GetPoint(vtkPointSet* input, vtkIdType id)
{
  dvec3 point;
  input->GetPoint(id, &point.x);
  return point;
}

bool IsDegenerate(vtkPointSet* input, vtkIdList* points, vtkIdType first, vtkIdType size)
{
  const dvec3 place = GetPoint(input, points->GetId(first));
  vtkIdType i = first + 1;
  while (i < first + size && GetPoint(input, points->GetId(i)) == place)
  {
    ++i;
  }
  return i == first + size;
}

// The numbers of a cell.
struct CurveCounts
{
  vtkIdType Curves = 0;
  vtkIdType Points = 0;
  bool HasError = false;
};

// Counts the curves and control points of each cell, and computes their offsets.
class CurvePlaces
{
public:
  CurvePlaces(vtkPointSet* input, const CurveCells& cells)
    : Counts(cells.GetNumberOfCells() + 1)
  {
    std::atomic<vtkIdType> degenerate(0);
    ForEachCurveCell(cells,
      [&](vtkIdType cell, CurveCells::Kinds kind, vtkIdList* points)
      {
        CurveCounts& counts = this->Counts[cell];
        counts.HasError = !cells.FindError(cell, kind, points).empty();
        if (counts.HasError)
        {
          return;
        }
        ForEachCurve(kind, points,
          [&](vtkIdType first, vtkIdType size)
          {
            const bool isCurve = !IsDegenerate(input, points, first, size);
            counts.Curves += isCurve ? 1 : 0;
            counts.Points += isCurve ? size : 0;
            degenerate += isCurve ? 0 : 1;
          });
      });
    this->NumberOfDegenerateCurves = degenerate;
    CurveCounts sum;
    for (CurveCounts& counts : this->Counts)
    {
      std::swap(sum.Curves, counts.Curves);
      std::swap(sum.Points, counts.Points);
      sum.Curves += counts.Curves;
      sum.Points += counts.Points;
    }
  }

  const CurveCounts& operator[](vtkIdType cell) const { return this->Counts[cell]; }
  const CurveCounts& GetEnd() const { return this->Counts.back(); }

  std::string GetError(const CurveCells& cells) const
  {
    const auto hasError = [](const CurveCounts& counts) { return counts.HasError; };
    const auto first = std::find_if(this->Counts.begin(), this->Counts.end(), hasError);
    if (first == this->Counts.end())
    {
      return std::string();
    }
    const vtkIdType cell = first - this->Counts.begin();
    const CurveCells::Kinds kind = cells.GetKind(cell);
    vtkNew<vtkIdList> points;
    cells.GetPoints(cell, kind, points);
    const auto more = std::count_if(first + 1, this->Counts.end(), hasError);
    return "Cell " + std::to_string(cell) + " " + cells.FindError(cell, kind, points) + ". " +
      (more == 0      ? "It is left out."
          : more == 1 ? "It and 1 more cell are left out."
                      : "It and " + std::to_string(more) + " more cells are left out.");
  }

  std::string GetWarning() const
  {
    return this->NumberOfDegenerateCurves == 0 ? std::string()
                                               : std::to_string(this->NumberOfDegenerateCurves) +
        " degenerate curves are left out: all their control points coincide.";
  }

private:
  std::vector<CurveCounts> Counts;
  vtkIdType NumberOfDegenerateCurves = 0;
};
}

void CurveMesh::Build(vtkPointSet* input)
{
  const CurveCells cells(input);
  const CurvePlaces places(input, cells);
  this->Error = places.GetError(cells);
  this->Warning = places.GetWarning();
  this->Curves.resize(places.GetEnd().Curves);
  this->Points.resize(places.GetEnd().Points);
  this->Nodes.resize(places.GetEnd().Points);
  std::atomic<bool> isRational(false);
  ForEachCurveCell(cells,
    [&](vtkIdType cell, CurveCells::Kinds kind, vtkIdList* points)
    {
      if (places[cell].HasError)
      {
        return;
      }
      CurveCounts next = places[cell];
      ForEachCurve(kind, points,
        [&](vtkIdType first, vtkIdType size)
        {
          if (IsDegenerate(input, points, first, size))
          {
            return;
          }
          const int degree = static_cast<int>(size - 1);
          const bool isLagrange = kind == CurveCells::LAGRANGE;
          this->Curves[next.Curves++] = { next.Points, cell, degree, isLagrange };
          dvec4* place = &this->Points[next.Points];
          for (vtkIdType i = 0; i < size; ++i)
          {
            const vtkIdType id = points->GetId(first + i);
            this->Nodes[next.Points++] = id;
            place[i] = dvec4(GetPoint(input, id), cells.GetWeight(kind, id));
            if (place[i].w != 1.0)
            {
              isRational = true;
            }
          }
          if (isLagrange)
          {
            ConvertLagrangeToBezier(degree, 3, &place->x, 4);
          }
        });
    });
  this->Rational = isRational;
}

std::vector<double> CurveMesh::ComputeCoefficients(vtkDataArray* array) const
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> values(this->Points.size() * components);
  vtkSMPTools::For(0, this->GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        const Curve& curve = this->Curves[c];
        double* first = &values[curve.FirstPoint * components];
        for (int i = 0; i <= curve.Degree; ++i)
        {
          array->GetTuple(this->Nodes[curve.FirstPoint + i], first + i * components);
        }
        if (curve.IsLagrange)
        {
          ConvertLagrangeToBezier(curve.Degree, components, first, components);
        }
      }
    });
  return values;
}

vtkSmartPointer<vtkPolyData> CurveMesh::NewControlPolygons() const
{
  const vtkIdType number = this->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(number);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  weights->SetNumberOfValues(this->Rational ? number : 0);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(number);
  vtkSMPTools::For(0, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        points->SetPoint(i, &this->Points[i].x);
        ids->SetValue(i, i);
        if (this->Rational)
        {
          weights->SetValue(i, this->Points[i].w);
        }
      }
    });
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(this->GetNumberOfCurves() + 1);
  for (vtkIdType c = 0; c < this->GetNumberOfCurves(); ++c)
  {
    offsets->SetValue(c, this->Curves[c].FirstPoint);
  }
  offsets->SetValue(this->GetNumberOfCurves(), number);
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, ids);
  auto polygons = vtkSmartPointer<vtkPolyData>::New();
  polygons->SetPoints(points);
  polygons->SetLines(lines);
  if (this->Rational)
  {
    polygons->GetPointData()->SetRationalWeights(weights);
  }
  return polygons;
}
}
