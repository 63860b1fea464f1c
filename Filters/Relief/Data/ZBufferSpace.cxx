// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ZBufferSpace.h"

#include "View/WorldView.h"
#include "vtkCamera.h"

#include <cmath>

namespace relevo
{
namespace
{
// Maps pixel centres, and z in [0, 1], to [-1, 1].
dmat4 GetPixelToView(int width, int height)
{
  dmat4 matrix(1.0);
  matrix[0][0] = 2.0 / width;
  matrix[1][1] = 2.0 / height;
  matrix[2][2] = 2.0;
  matrix[3] = dvec4(1.0 / width - 1.0, 1.0 / height - 1.0, -1.0, 1.0);
  return matrix;
}

dvec4 GetRow(const dmat4& matrix, int row)
{
  return dvec4(matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]);
}
}

ZBufferSpace::ZBufferSpace(vtkCamera* camera, int width, int height)
{
  const double aspect = static_cast<double>(width) / height;
  const dmat4 view = MakeMatrix(camera->GetModelViewTransformMatrix());
  const dmat4 projection = MakeMatrix(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0));
  this->PixelToWorld = inverse(projection * view) * GetPixelToView(width, height);
  const dvec4 depth = GetRow(projection, 3);
  if (dvec3(depth) == dvec3(0.0))
  {
    this->Projection = ReliefProjection::Parallel;
    this->PixelToWorld /= this->PixelToWorld[3][3];
    this->ToHeight = -GetRow(view * this->PixelToWorld, 2);
  }
  else
  {
    // The last homogeneous coordinate, before the division, is proportional to 1 / depth.
    this->Projection = ReliefProjection::Perspective;
    this->ToHeight = GetRow(this->PixelToWorld, 3);
  }
}

bool ZBufferSpace::IsRegular() const
{
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum += dot(abs(this->PixelToWorld[i]), dvec4(1.0)) + std::abs(this->ToHeight[i]);
  }
  return std::isfinite(sum) && this->ToHeight.z != 0.0;
}

double ZBufferSpace::GetDepth(int column, int row, double z) const
{
  const double height = dot(this->ToHeight, dvec4(column, row, z, 1.0));
  return this->Projection == ReliefProjection::Perspective ? 1.0 / height : height;
}

dmat4 ZBufferSpace::GetMatrix(double offset) const
{
  const dvec4& h = this->ToHeight;
  dmat4 toPixel(1.0); // from (column, row, height, 1)
  toPixel[0].z = -h.x / h.z;
  toPixel[1].z = -h.y / h.z;
  toPixel[2].z = 1.0 / h.z;
  toPixel[3].z = -h.w / h.z;
  dmat4 matrix = this->PixelToWorld * toPixel;
  if (this->Projection == ReliefProjection::Perspective)
  {
    std::swap(matrix[2], matrix[3]);
  }
  else
  {
    matrix[3] += offset * matrix[2];
  }
  // The matrix is affine except for rounding errors.
  for (int i = 0; i < 4; ++i)
  {
    matrix[i].w = i == 3 ? 1.0 : 0.0;
  }
  return matrix;
}
}
