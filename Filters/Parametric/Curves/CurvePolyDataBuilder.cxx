// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurvePolyDataBuilder.h"

#include "Arrays/CellDataCopy.h"
#include "Curves/CurveEvaluator.h"
#include "Curves/CurveMesh.h"
#include "Curves/CurvePointData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
int GetWidth(const CurveStyle& style)
{
  return style.Shape == CurveShape::Lines
    ? 1
    : (style.Shape == CurveShape::Ribbons ? 2 : style.NumberOfSides);
}

CurveFrames MakeFrames(const CurveMesh& mesh, const CurveStyle& style)
{
  CurveFrames frames;
  if (style.Shape != CurveShape::Lines)
  {
    frames.Build(mesh);
  }
  return frames;
}

// Computes the points and normals of a row.
class RowShape
{
public:
  RowShape(const CurveStyle& style, const std::vector<dvec2>& angles)
    : Style(style)
    , Angles(angles)
  {
  }

  // Calls work(i, position, normal) for each point of a row. For `cap`, see
  // CurveRows::ForEachRow().
  template <typename Work>
  void Place(CurveEvaluator& curve, double t, int cap, const Work& work) const
  {
    const CurveEvaluator::CurveLine line = curve.curveLine(t);
    const dvec3 middle = curve.curvePosition(line, t);
    if (this->Style.Shape == CurveShape::Lines)
    {
      work(0, middle, dvec3(0.0));
      return;
    }
    double radius = this->Style.Radius;
    double slope = 0.0;
    if (this->Style.RadiusArray)
    {
      const CurveEvaluator::CurveValueLine values = curve.curveValueLine(t);
      radius = std::max(curve.curveValueAt(line, values, t).x, 0.0);
      slope = curve.curveSlope(line, values).x;
    }
    const dvec3 tangent = curve.curveFrameTangent(line, t);
    const dvec3 normal = curve.curveFrameNormal(tangent, t);
    if (this->Style.Shape == CurveShape::Ribbons)
    {
      const dvec3 toEye = dvec3(this->Style.Eye) - this->Style.Eye.w * middle;
      const dvec3 side = curve.ribbonSide(tangent, normal, toEye);
      const dvec3 front = curve.ribbonNormal(tangent, side);
      work(0, middle - radius * side, front);
      work(1, middle + radius * side, front);
      return;
    }
    for (std::size_t i = 0; i < this->Angles.size(); ++i)
    {
      const dvec3 direction = curve.tubeDirection(tangent, normal, this->Angles[i]);
      work(static_cast<int>(i), middle + radius * direction,
        cap == 0 ? curve.tubeNormal(tangent, direction, slope)
                 : static_cast<double>(cap) * tangent);
    }
  }

private:
  const CurveStyle& Style;
  const std::vector<dvec2>& Angles;
};

std::vector<dvec2> MakeAngles(const CurveStyle& style)
{
  std::vector<dvec2> angles;
  for (int i = 0; style.Shape == CurveShape::Tubes && i < style.NumberOfSides; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / style.NumberOfSides;
    angles.emplace_back(std::cos(angle), std::sin(angle));
  }
  return angles;
}

vtkIdType* AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType* next)
{
  next[0] = a;
  next[1] = b;
  next[2] = c;
  return next + 3;
}
}

CurvePolyDataBuilder::CurvePolyDataBuilder(vtkPointSet* input, const CurveMesh& mesh,
  const std::vector<int>& segments, const CurveStyle& style)
  : Input(input)
  , Mesh(mesh)
  , Style(style)
  , Frames(MakeFrames(mesh, style))
  , Rows(mesh, segments, GetWidth(style), style.Shape == CurveShape::Tubes ? &Frames : nullptr)
{
}

void CurvePolyDataBuilder::Build(double noDataMagnitude, vtkPolyData* output)
{
  const bool areLines = this->Style.Shape == CurveShape::Lines;
  this->BuildPoints(output);
  const std::vector<vtkIdType> cells =
    areLines ? this->BuildLines(output) : this->BuildTriangles(output);
  EvaluatePointData(this->Input, this->Mesh, this->Rows, areLines, noDataMagnitude,
    output->GetPointData(), this->ShortArrays);
  vtkNew<vtkIdTypeArray> originals;
  originals->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
  std::copy(cells.begin(), cells.end(), originals->GetPointer(0));
  CopyCellData(this->Input, originals, areLines, output->GetCellData(), this->ShortArrays);
  output->GetFieldData()->PassData(this->Input->GetFieldData());
}

void CurvePolyDataBuilder::BuildPoints(vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  const bool areFloats = this->Input->GetPoints()->GetDataType() == VTK_FLOAT;
  points->SetDataType(areFloats ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(this->Rows.GetNumberOfPoints());
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  const bool hasNormals = this->Style.Shape != CurveShape::Lines;
  normals->SetNumberOfTuples(hasNormals ? this->Rows.GetNumberOfPoints() : 0);

  const std::vector<dvec2> angles = MakeAngles(this->Style);
  const RowShape shape(this->Style, angles);
  const std::vector<double> radii = this->Style.RadiusArray
    ? this->Mesh.ComputeCoefficients(this->Style.RadiusArray)
    : std::vector<double>();
  vtkSMPTools::For(0, this->Mesh.GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        CurveEvaluator curve(this->Mesh, c);
        if (hasNormals)
        {
          this->Frames.Set(curve, c);
        }
        if (!radii.empty())
        {
          curve.SetCoefficients(&radii[this->Mesh.GetCurves()[c].FirstPoint], 1, 1);
        }
        const auto placeRow = [&](double t, vtkIdType first, int cap)
        {
          const auto placePoint = [&](int i, const dvec3& position, const dvec3& normal)
          {
            points->SetPoint(first + i, &position.x);
            if (hasNormals)
            {
              normals->SetTuple(first + i, &normal.x);
            }
          };
          shape.Place(curve, t, cap, placePoint);
        };
        this->Rows.ForEachRow(c, placeRow);
      }
    });
  output->SetPoints(points);
  if (hasNormals)
  {
    output->GetPointData()->SetNormals(normals);
  }
}

// Curves of one cell become one poly-line. Returns the input cell of each line.
std::vector<vtkIdType> CurvePolyDataBuilder::BuildLines(vtkPolyData* output) const
{
  std::vector<vtkIdType> cells;
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  ids->Allocate(this->Rows.GetNumberOfPoints() + this->Mesh.GetNumberOfCurves());
  vtkIdType last = -1;
  for (vtkIdType c = 0; c < this->Mesh.GetNumberOfCurves(); ++c)
  {
    const vtkIdType cell = this->Mesh.GetCurves()[c].Cell;
    if (cells.empty() || cells.back() != cell)
    {
      cells.push_back(cell);
      offsets->InsertNextValue(ids->GetNumberOfValues());
      last = -1;
    }
    for (int row = 0; row <= this->Rows.GetSegments(c); ++row)
    {
      const vtkIdType point = this->Rows.GetRow(c, row);
      if (point != last)
      {
        ids->InsertNextValue(point);
      }
      last = point;
    }
  }
  offsets->InsertNextValue(ids->GetNumberOfValues());
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, ids);
  output->SetLines(lines);
  return cells;
}

// Returns the index of the first triangle of each curve, and the number of triangles.
std::vector<vtkIdType> CurvePolyDataBuilder::CountTriangles() const
{
  const int width = this->Rows.GetWidth();
  const int strips = this->Style.Shape == CurveShape::Ribbons ? 1 : width;
  std::vector<vtkIdType> first(this->Mesh.GetCurves().size() + 1, 0);
  for (vtkIdType c = 0; c < this->Mesh.GetNumberOfCurves(); ++c)
  {
    const int caps =
      (this->Rows.GetCap(c, 0) >= 0 ? 1 : 0) + (this->Rows.GetCap(c, 1) >= 0 ? 1 : 0);
    first[c + 1] = first[c] + 2 * strips * static_cast<vtkIdType>(this->Rows.GetSegments(c)) +
      caps * (width - 2);
  }
  return first;
}

// Adds the strip between two points of each row. Its front is visible where `to` is to the right of
// `from`, seen along the curve.
vtkIdType* CurvePolyDataBuilder::AddStrip(vtkIdType curve, int from, int to, vtkIdType* next) const
{
  for (int row = 0; row < this->Rows.GetSegments(curve); ++row)
  {
    const vtkIdType here = this->Rows.GetRow(curve, row);
    const vtkIdType there = this->Rows.GetRow(curve, row + 1);
    next = AddTriangle(here + from, here + to, there + to, next);
    next = AddTriangle(here + from, there + to, there + from, next);
  }
  return next;
}

vtkIdType* CurvePolyDataBuilder::AddCap(vtkIdType curve, int end, vtkIdType* next) const
{
  const vtkIdType first = this->Rows.GetCap(curve, end);
  for (int i = 1; first >= 0 && i + 1 < this->Rows.GetWidth(); ++i)
  {
    next = end == 0 ? AddTriangle(first, first + i + 1, first + i, next)
                    : AddTriangle(first, first + i, first + i + 1, next);
  }
  return next;
}

// Returns the input cell of each triangle.
std::vector<vtkIdType> CurvePolyDataBuilder::BuildTriangles(vtkPolyData* output) const
{
  const std::vector<vtkIdType> first = this->CountTriangles();
  const int width = this->Rows.GetWidth();
  const bool areTubes = this->Style.Shape == CurveShape::Tubes;
  std::vector<vtkIdType> cells(first.back());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(3 * first.back());
  vtkSMPTools::For(0, this->Mesh.GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        std::fill(
          cells.begin() + first[c], cells.begin() + first[c + 1], this->Mesh.GetCurves()[c].Cell);
        vtkIdType* next = ids->GetPointer(3 * first[c]);
        for (int side = 0; side < (areTubes ? width : 1); ++side)
        {
          next = this->AddStrip(c, side, (side + 1) % width, next);
        }
        next = this->AddCap(c, 0, next);
        this->AddCap(c, 1, next);
      }
    });
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(first.back() + 1);
  for (vtkIdType i = 0; i <= first.back(); ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, ids);
  output->SetPolys(polys);
  return cells;
}
}
