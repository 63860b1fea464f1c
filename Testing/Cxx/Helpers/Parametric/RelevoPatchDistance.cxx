// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatchDistance.h"

#include "RelevoPatches.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

void RelevoLookAt(vtkDataSet* data, vtkCamera* camera)
{
  double center[3];
  data->GetCenter(center);
  const double direction[3] = { 0.268, -0.894, 0.358 };
  const double distance = 0.5 * data->GetLength() / std::sin(vtkMath::RadiansFromDegrees(15.0));
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + distance * direction[0], center[1] + distance * direction[1],
    center[2] + distance * direction[2]);
  camera->SetViewUp(0.0, 0.0, 1.0);
}

RelevoPatchDistance::RelevoPatchDistance(vtkPolyData* mesh, int parts)
  : Mesh(mesh)
{
  this->Locator->SetDataSet(this->Cut(parts));
  this->Locator->BuildLocator();
}

vtkSmartPointer<vtkPolyData> RelevoPatchDistance::Cut(int parts) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (int patch = 0; patch < RelevoGetNumberOfPatches(this->Mesh); ++patch)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int j = 0; j <= parts; ++j)
    {
      for (int i = 0; i <= parts; ++i)
      {
        // A triangle is a square with one side collapsed to a point.
        const double v = j / static_cast<double>(parts);
        const double width = RelevoIsTriangle(this->Mesh, patch) ? 1.0 - v : 1.0;
        const double u = width * i / static_cast<double>(parts);
        points->InsertNextPoint(RelevoEvaluatePatch(this->Mesh, patch, u, v).data());
        const vtkIdType id = first + j * (parts + 1) + i;
        if (i < parts && j < parts)
        {
          triangles->InsertNextCell({ id, id + 1, id + parts + 2 });
          triangles->InsertNextCell({ id, id + parts + 2, id + parts + 1 });
        }
      }
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  return result;
}

double RelevoPatchDistance::Measure(const RelevoPosition& x) const
{
  double closest[3];
  vtkIdType cell;
  int part;
  double squared;
  vtkNew<vtkGenericCell> buffer;
  const_cast<vtkCellLocator*>(this->Locator.Get())
    ->FindClosestPoint(x.data(), closest, buffer, cell, part, squared);
  return std::sqrt(squared);
}

double RelevoPatchDistance::MeasurePixels(
  vtkPolyData* refined, vtkCamera* camera, int height, int stride) const
{
  const double unit = camera->GetParallelProjection()
    ? 0.5 * height / camera->GetParallelScale()
    : 0.5 * height / std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  double eye[3];
  camera->GetPosition(eye);
  const double weights[4][3] = { { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 }, { 0.5, 0.5, 0.0 },
    { 0.0, 0.5, 0.5 }, { 0.5, 0.0, 0.5 } };
  double largest = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfPolys(); cell += stride)
  {
    refined->GetPolys()->GetCellAtId(cell, ids);
    for (const double* w : weights)
    {
      RelevoPosition x{};
      for (int k = 0; k < 3; ++k)
      {
        double corner[3];
        refined->GetPoint(ids->GetId(k), corner);
        for (int c = 0; c < 3; ++c)
        {
          x[c] += w[k] * corner[c];
        }
      }
      const double off[3] = { x[0] - eye[0], x[1] - eye[1], x[2] - eye[2] };
      const double depth = camera->GetParallelProjection() ? 1.0 : vtkMath::Dot(off, direction);
      if (depth > 0.0)
      {
        largest = std::max(largest, this->Measure(x) * unit / depth);
      }
    }
  }
  return largest;
}
