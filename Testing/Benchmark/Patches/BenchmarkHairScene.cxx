// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkHairScene.h"

#include "BenchmarkMeshes.h"
#include "BenchmarkPatchMeshes.h"
#include "BenchmarkView.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkHairSource.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkLine.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// The control points of one hair.
class Hair
{
public:
  Hair(vtkUnstructuredGrid* grid, vtkIdType cell)
  {
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(cell, ids);
    const int order[] = { 0, 3, 1, 2 }; // VTK stores the ends first
    for (int i = 0; i < 4; ++i)
    {
      grid->GetPoint(ids->GetId(i), this->Points[order[i]].GetData());
    }
  }

  vtkVector3d Evaluate(double t) const
  {
    const double s = 1.0 - t;
    return this->Points[0] * (s * s * s) + this->Points[1] * (3.0 * s * s * t) +
      this->Points[2] * (3.0 * s * t * t) + this->Points[3] * (t * t * t);
  }

  // The distance of a point from the chord of its segment.
  double Measure(const vtkVector3d& point, int segment, int segments) const
  {
    const vtkVector3d first = this->Evaluate(segment / static_cast<double>(segments));
    const vtkVector3d last = this->Evaluate((segment + 1) / static_cast<double>(segments));
    return std::sqrt(vtkLine::DistanceToLine(point.GetData(), first.GetData(), last.GetData()));
  }

private:
  std::array<vtkVector3d, 4> Points;
};

// Pixels per unit of length at a point; 0 out of view.
class PixelScale
{
public:
  explicit PixelScale(BenchmarkView& view)
    : Camera(view.GetRenderer()->GetActiveCamera())
    , Matrix(this->Camera->GetCompositeProjectionTransformMatrix(
        view.GetRenderer()->GetTiledAspectRatio(), -1.0, 1.0))
    , Unit(0.5 * view.GetHeight() /
        std::tan(0.5 * vtkMath::RadiansFromDegrees(this->Camera->GetViewAngle())))
  {
  }

  double Get(const vtkVector3d& point) const
  {
    double x[4] = { point[0], point[1], point[2], 1.0 };
    this->Matrix->MultiplyPoint(x, x);
    const bool isInView = std::abs(x[0]) <= x[3] && std::abs(x[1]) <= x[3];
    return isInView ? this->Unit / x[3] : 0.0;
  }

private:
  vtkCamera* Camera;
  vtkMatrix4x4* Matrix;
  double Unit;
};
}

BenchmarkHairScene::BenchmarkHairScene(int hairs)
{
  auto mesh = BenchmarkMeshes::ReadBunny();
  if (!mesh)
  {
    mesh = BenchmarkMeshes::MakeSphere(2000.0);
  }
  vtkNew<vtkMassProperties> area;
  area->SetInputData(mesh);
  vtkNew<vtkHairSource> source;
  source->SetInputData(mesh);
  source->SetDensity(hairs / area->GetSurfaceArea());
  source->SetLength(0.15 * mesh->GetLength());
  source->SetGravity(0.0, -0.25, 0.0);
  source->Update();
  this->Hairs = source->GetOutput();
}

BenchmarkHairScene::~BenchmarkHairScene() = default;

std::vector<int> BenchmarkHairScene::CountSegments(BenchmarkView& view) const
{
  vtkNew<vtkAdaptiveCurveFilter> filter;
  filter->SetInputData(this->Hairs);
  filter->SetRefinement(BenchmarkPatchMeshes::MakeRecipe(0.5));
  filter->SetCamera(view.GetRenderer()->GetActiveCamera());
  filter->SetViewportSize(view.GetWidth(), view.GetHeight());
  filter->Update();
  vtkPolyData* lines = filter->GetOutput();
  vtkDataArray* cells = lines->GetCellData()->GetArray("vtkOriginalCellIds");
  std::vector<int> segments(this->Hairs->GetNumberOfCells());
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    segments[static_cast<size_t>(cells->GetComponent(line, 0))] =
      static_cast<int>(lines->GetLines()->GetCellSize(line)) - 1;
  }
  return segments;
}

double BenchmarkHairScene::MeasureError(BenchmarkView& view, const std::vector<int>& segments) const
{
  const PixelScale scale(view);
  double largest = 0.0;
  for (vtkIdType cell = 0; cell < this->Hairs->GetNumberOfCells(); ++cell)
  {
    const Hair hair(this->Hairs, cell);
    for (int segment = 0; segment < segments[cell]; ++segment)
    {
      for (const double share : { 0.25, 0.5, 0.75 })
      {
        const vtkVector3d point = hair.Evaluate((segment + share) / segments[cell]);
        largest =
          std::max(largest, hair.Measure(point, segment, segments[cell]) * scale.Get(point));
      }
    }
  }
  return largest;
}

vtkSmartPointer<vtkPolyData> BenchmarkHairScene::Cut(int segments) const
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(this->Hairs->GetNumberOfCells() * (segments + 1));
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(this->Hairs->GetNumberOfCells(), points->GetNumberOfPoints());
  vtkIdType point = 0;
  for (vtkIdType cell = 0; cell < this->Hairs->GetNumberOfCells(); ++cell)
  {
    const Hair hair(this->Hairs, cell);
    lines->InsertNextCell(segments + 1);
    for (int i = 0; i <= segments; ++i, ++point)
    {
      points->SetPoint(point, hair.Evaluate(i / static_cast<double>(segments)).GetData());
      lines->InsertCellPoint(point);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}
