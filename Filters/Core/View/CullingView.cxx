// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/CullingView.h"

#include "Changes/Dependencies.h"
#include "Mathematics/RefinementMathematics.h"
#include "View/WorldView.h"
#include "vtkCamera.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// The point (x, y, z, w) on three planes: their cross product.
dvec4 Intersect(const dvec4& a, const dvec4& b, const dvec4& c)
{
  const auto minor = [&](int i, int j, int k)
  { return dot(dvec3(a[i], a[j], a[k]), cross(dvec3(b[i], b[j], b[k]), dvec3(c[i], c[j], c[k]))); };
  return dvec4(minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2));
}

dvec4 Normalize(const dvec4& plane)
{
  return plane / length(dvec3(plane));
}
}

CullingView::CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld,
  const double origin[3], const std::array<double, 2>& margins)
{
  dmat4 toWorld = MakeMatrix(modelToWorld);
  toWorld[3] = toWorld * dvec4(origin[0], origin[1], origin[2], 1.0);
  const dmat4 toClip =
    MakeMatrix(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)) * toWorld;
  const dmat4 rows = transpose(toClip);
  const dvec4 right = rows[3] * (1.0 + margins[0]);
  const dvec4 upper = rows[3] * (1.0 + margins[1]);
  // The near and far planes are not used, because VTK may clamp depths. The last plane contains the
  // eye.
  const dvec4 planes[NumberOfPlanes] = { right + rows[0], right - rows[0], upper + rows[1],
    upper - rows[1], rows[3] };
  this->Parallel = dvec3(rows[3]) == dvec3(0.0);
  this->Valid = true;
  for (int i = 0; i < NumberOfPlanes; ++i)
  {
    const bool everything = this->Parallel && i == 4;
    const dvec4 plane = everything ? dvec4(0.0, 0.0, 0.0, 1.0) : Normalize(planes[i]);
    for (int c = 0; c < 4; ++c)
    {
      this->Planes[i][c] = static_cast<float>(plane[c]);
      this->Valid = this->Valid && std::isfinite(this->Planes[i][c]);
    }
  }
  const dvec4 nearest = Normalize(rows[3] + rows[2]);
  for (int c = 0; c < 4; ++c)
  {
    this->Near[c] = static_cast<float>(nearest[c]);
    this->Valid = this->Valid && std::isfinite(this->Near[c]);
  }

  // This uses the matrix, not the camera's position: views may be sheared, transformed or stereo.
  const dvec4 point = Intersect(Normalize(planes[0]), Normalize(planes[2]),
    this->Parallel ? dvec4(0.0, 0.0, 0.0, 1.0) : Normalize(rows[3]));
  const dvec3 towardsEye = dvec3(point) * (dot(dvec3(rows[2]), dvec3(point)) < 0.0 ? 1.0 : -1.0);
  const dvec3 eye = this->Parallel ? towardsEye : dvec3(point) / point.w;
  for (int c = 0; c < 3; ++c)
  {
    this->Eye[c] = static_cast<float>(eye[c]);
    this->Valid = this->Valid && std::isfinite(this->Eye[c]);
  }
}

void CullingView::AddTo(Dependencies& dependencies) const
{
  for (const auto& plane : this->Planes)
  {
    std::for_each(plane, plane + 4, [&](float value) { dependencies.Add(value); });
  }
  std::for_each(this->Eye, this->Eye + 3, [&](float value) { dependencies.Add(value); });
  dependencies.Add(this->Parallel);
  dependencies.Add(this->Valid);
}
}
