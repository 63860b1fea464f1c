// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPixelPoints.h"

#include "BenchmarkView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

BenchmarkPixelPoints::BenchmarkPixelPoints(BenchmarkView& view)
  : Width(view.GetWidth())
  , Height(view.GetHeight())
{
  vtkRenderer* renderer = view.GetRenderer();
  vtkMatrix4x4::Invert(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                         renderer->GetTiledAspectRatio(), 0.0, 1.0),
    this->ToWorld);
}

BenchmarkPixelPoints::~BenchmarkPixelPoints() = default;

std::array<double, 3> BenchmarkPixelPoints::Get(int pixel, double depth) const
{
  const double place[4] = { 2.0 * (pixel % this->Width + 0.5) / this->Width - 1.0,
    2.0 * (pixel / this->Width + 0.5) / this->Height - 1.0, depth, 1.0 };
  double world[4];
  this->ToWorld->MultiplyPoint(place, world);
  return { { world[0] / world[3], world[1] / world[3], world[2] / world[3] } };
}
