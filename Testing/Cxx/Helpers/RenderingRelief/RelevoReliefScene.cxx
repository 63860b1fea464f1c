// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoReliefScene.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace RelevoVectors;

RelevoReliefScene::RelevoReliefScene(vtkDataObject* reliefs, int width, int height)
{
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->SetOffScreenRendering(1);
  this->Window->AddRenderer(this->Renderer);
  this->Mapper->SetInputDataObject(reliefs);
  this->Actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(this->Actor);
  this->ResetCamera();
}

void RelevoReliefScene::ResetCamera()
{
  this->GetCamera()->SetPosition(0.3, 0.5, -1.0);
  this->GetCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  this->GetCamera()->SetViewUp(0.0, 1.0, 0.0);
  this->Renderer->ResetCamera();
}

void RelevoReliefScene::LookStraight()
{
  this->GetCamera()->SetPosition(0.0, 0.0, -1.0);
  this->GetCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  this->GetCamera()->SetViewUp(0.0, 1.0, 0.0);
  this->Renderer->ResetCamera();
}

std::vector<float> RelevoReliefScene::DrawDepths()
{
  this->Window->Render();
  const int* size = this->Window->GetSize();
  vtkNew<vtkFloatArray> depths;
  this->Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  return std::vector<float>(
    depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
}

namespace
{
Vector Transform(const double matrix[16], double x, double y, double z)
{
  const double in[4] = { x, y, z, 1.0 };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(matrix, in, out);
  return { { out[0] / out[3], out[1] / out[3], out[2] / out[3] } };
}
}

void RelevoReliefScene::GetToClip(double toClip[16])
{
  const int* size = this->Window->GetSize();
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(this->GetCamera()->GetCompositeProjectionTransformMatrix(
                              static_cast<double>(size[0]) / size[1], -1.0, 1.0),
    this->Actor->GetMatrix(), matrix);
  std::copy_n(matrix->GetData(), 16, toClip);
}

std::vector<RelevoReliefHit> RelevoReliefScene::Cast(
  vtkImageData* relief, double stretch, const std::function<bool(const RelevoReliefHit&)>& keeps)
{
  const RelevoReliefRays rays(relief, stretch);
  const int width = this->Window->GetSize()[0];
  const int height = this->Window->GetSize()[1];
  double toClip[16];
  this->GetToClip(toClip);
  double fromClip[16];
  vtkMatrix4x4::Invert(toClip, fromClip);
  std::vector<RelevoReliefHit> result(static_cast<size_t>(width) * height);
  vtkSMPTools::For(0, width * height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double x = 2.0 * (i % width + 0.5) / width - 1.0;
        const double y = 2.0 * (i / width + 0.5) / height - 1.0;
        const Vector near = Transform(fromClip, x, y, -1.0);
        const Vector along = Transform(fromClip, x, y, 1.0) - near;
        const auto hits = rays.CastAll(near, along, 0.0, 1.0);
        const auto first = std::find_if(hits.begin(), hits.end(), keeps);
        result[i] = first == hits.end() ? RelevoReliefHit() : *first;
      }
    });
  return result;
}

RelevoReliefComparison RelevoReliefScene::Compare(vtkImageData* relief, double stretch,
  double tolerance, const std::function<bool(const RelevoReliefHit&)>& keeps)
{
  const RelevoReliefRays rays(relief, stretch);
  const std::vector<float> depths = this->DrawDepths();
  const std::vector<RelevoReliefHit> hits = this->Cast(relief, stretch, keeps);
  const int width = this->Window->GetSize()[0];
  const int height = this->Window->GetSize()[1];
  double toClip[16];
  this->GetToClip(toClip);
  double fromClip[16];
  vtkMatrix4x4::Invert(toClip, fromClip);
  RelevoReliefComparison comparison;
  for (size_t i = 0; i < hits.size(); ++i)
  {
    const RelevoReliefHit& hit = hits[i];
    const bool isDrawn = depths[i] < 1.0f;
    comparison.NumberOfHits += hit.IsHit ? 1 : 0;
    comparison.NumberOfMisses += hit.IsHit != isDrawn ? 1 : 0;
    if (hit.IsHit && isDrawn)
    {
      const Vector clip = Transform(toClip, hit.Point[0], hit.Point[1], hit.Point[2]);
      const double x = 2.0 * (i % width + 0.5) / width - 1.0;
      const double y = 2.0 * (i / width + 0.5) / height - 1.0;
      const auto texel = rays.Find(Transform(fromClip, x, y, 2.0 * depths[i] - 1.0));
      comparison.NumberOfWrong +=
        std::hypot(texel[0] - hit.Column, texel[1] - hit.Row) > tolerance ? 1 : 0;
      comparison.NumberFar += std::abs(0.5 * clip[2] + 0.5 - depths[i]) > 1e-5 ? 1 : 0;
    }
  }
  return comparison;
}

double RelevoHills(int column, int row)
{
  return 20.0 + 6.0 * std::sin(0.3 * column) * std::cos(0.25 * row) + 0.1 * row;
}

double RelevoHillsWithHoles(int column, int row)
{
  const bool isHole = std::hypot(column - 20.0, row - 16.0) < 5.0 || column + row > 72 || row == 31;
  return isHole ? std::numeric_limits<double>::quiet_NaN() : RelevoHills(column, row);
}

relevo::dmat4 RelevoSmallTexels()
{
  relevo::dmat4 matrix(0.1);
  matrix[3][3] = 1.0;
  return matrix;
}
