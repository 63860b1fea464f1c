// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/PixelRays.h"

#include "View/WorldView.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

namespace relevo
{
namespace
{
dmat4 Invert(vtkMatrix4x4* matrix)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(matrix, inverse);
  return MakeMatrix(inverse);
}
}

PixelRays::PixelRays(vtkCamera* camera, int width, int height)
  : Size{ width, height }
  , ViewToWorld(Invert(camera->GetViewTransformMatrix()))
  , ClipToView(
      Invert(camera->GetProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0)))
{
}

Ray PixelRays::Make(double column, double row) const
{
  const double x = (2.0 * column + 1.0) / this->Size[0] - 1.0;
  const double y = (2.0 * row + 1.0) / this->Size[1] - 1.0;
  const auto getPoint = [=](double depth)
  {
    const dvec4 point = this->ClipToView * dvec4(x, y, depth, 1.0);
    return dvec3(this->ViewToWorld * dvec4(dvec3(point) / point.w, 1.0));
  };
  const dvec3 nearest = getPoint(-1.0);
  const dvec3 way = getPoint(1.0) - nearest;
  return { nearest, normalize(way), length(way) };
}
}
