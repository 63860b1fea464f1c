// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/PixelScale.h"

#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace relevo
{
namespace
{
// Returns the tangent of the angle from the viewing direction to the farthest viewport corner.
double GetLargestTangent(const RefinementView& view)
{
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(view.Camera->GetViewAngle()));
  const double across = view.ViewportSize[view.Camera->GetUseHorizontalViewAngle() ? 0 : 1];
  const double* center = view.Camera->GetWindowCenter();
  const double x = tangent * view.ViewportSize[0] / across * (1.0 + std::abs(center[0]));
  const double y = tangent * view.ViewportSize[1] / across * (1.0 + std::abs(center[1]));
  return std::hypot(x, y);
}
}

PixelScale::PixelScale(const RefinementView& view)
  : ToWorld(view)
{
  const dmat4& m = this->ToWorld.ModelToWorld;
  double linear[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      linear[row][column] = m[column][row];
    }
  }
  double u[3][3];
  double w[3];
  double vt[3][3];
  vtkMath::SingularValueDecomposition3x3(linear, u, w, vt);
  this->MaximumStretch = std::max({ std::abs(w[0]), std::abs(w[1]), std::abs(w[2]) });
  this->MinimumStretch = std::min({ std::abs(w[0]), std::abs(w[1]), std::abs(w[2]) });
}

bool PixelScale::Check(const RefinementView& view, std::string& error)
{
  if (view.ViewportSize[0] < 1 || view.ViewportSize[1] < 1)
  {
    std::ostringstream text;
    text << "The viewport has no pixels: it is " << view.ViewportSize[0] << " x "
         << view.ViewportSize[1];
    error = text.str();
    return false;
  }
  if (!this->View.Set(view, error))
  {
    return false;
  }
  this->Pixels = this->View.IsParallel()
    ? 0.5 * view.ViewportSize[1] / view.Camera->GetParallelScale()
    : GetPixelsAtUnitDistance(view);
  this->Tangent = GetLargestTangent(view);
  this->MeshEye = dvec3(inverse(this->ToWorld.ModelToWorld) * dvec4(this->View.GetPosition(), 1.0));
  return true;
}

// Returns a lower bound of the distance from the eye in world coordinates.
double PixelScale::GetDistance(const PointBox& box) const
{
  const dvec3 off = max(max(box.Low - this->MeshEye, this->MeshEye - box.High), dvec3(0.0));
  const double distance = this->MinimumStretch * length(off);
  return std::isfinite(distance) ? distance : 0.0; // a flat placement has no inverse
}

double PixelScale::GetPixels(const PointBox& box) const
{
  const double unit = this->Pixels * this->MaximumStretch;
  if (this->View.IsParallel())
  {
    return unit;
  }
  const dvec3 forward = -this->View.GetBackwards();
  double depth = std::numeric_limits<double>::infinity();
  double squaredTangent = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const dvec3 x(corner & 1 ? box.High.x : box.Low.x, corner & 2 ? box.High.y : box.Low.y,
      corner & 4 ? box.High.z : box.Low.z);
    const dvec3 off = this->ToWorld.GetPoint(x) - this->View.GetPosition();
    const double z = dot(off, forward);
    depth = std::min(depth, z);
    // Points with at most a given tangent form a cone. It is convex and contains the box.
    squaredTangent = std::max(squaredTangent, dot(off, off) / (z * z) - 1.0);
  }
  const double most = this->Tangent * this->Tangent;
  squaredTangent = depth > 0.0 ? std::min(squaredTangent, most) : most;
  const double z = std::max(depth, this->GetDistance(box) / std::sqrt(1.0 + most));
  return z > 0.0 ? unit * std::sqrt(1.0 + squaredTangent) / z
                 : std::numeric_limits<double>::infinity();
}
}
