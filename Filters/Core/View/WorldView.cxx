// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/WorldView.h"

#include "Mathematics/FiniteBox.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
dmat4 MakeMatrix(vtkMatrix4x4* matrix)
{
  dmat4 result(1.0);
  if (matrix)
  {
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        result[column][row] = matrix->GetElement(row, column);
      }
    }
  }
  return result;
}

double GetPixelsAtUnitDistance(const RefinementView& view)
{
  const int across = view.Camera->GetUseHorizontalViewAngle() ? 0 : 1;
  const double angle = vtkMath::RadiansFromDegrees(view.Camera->GetViewAngle());
  return view.ViewportSize[across] / (2.0 * std::tan(0.5 * angle));
}

Placement::Placement(const RefinementView& view)
  : ModelToWorld(MakeMatrix(view.ModelToWorld))
{
  // The cofactors are the inverse transpose times the determinant, and exist for singular matrices
  // too.
  const dmat3 linear(this->ModelToWorld);
  this->NormalToWorld =
    dmat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
}

double Placement::GetScale() const
{
  const dmat4& m = this->ModelToWorld;
  double squared = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    squared += dot(dvec3(m[column]), dvec3(m[column]));
  }
  return std::sqrt(squared);
}

dmat3 Placement::GetShape() const
{
  const double scale = this->GetScale();
  const dmat3 linear = dmat3(this->ModelToWorld) * (scale > 0.0 ? 1.0 / scale : 0.0);
  return transpose(linear) * linear;
}

bool Placement::HasShape(const dmat3& shape) const
{
  const dmat3 difference = this->GetShape() - shape;
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    largest = std::max(largest, length(difference[column]));
  }
  return largest < 1e-9;
}

double Placement::GetDiagonal(const FiniteBox& box) const
{
  double squared = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      const double component = box.GetSide(axis) * this->ModelToWorld[axis][row];
      squared += component * component;
    }
  }
  return std::sqrt(squared);
}

dvec3 UnitOrZero(const dvec3& v)
{
  const double squared = dot(v, v);
  return squared > 0.0 && std::isfinite(squared) ? v / std::sqrt(squared) : dvec3(0.0);
}

bool Eye::Set(const RefinementView& view, std::string& error)
{
  if (!view.Camera)
  {
    error = "There is no camera: call SetCamera()";
    return false;
  }
  dvec3 focalPoint;
  view.Camera->GetPosition(&this->Position[0]);
  view.Camera->GetFocalPoint(&focalPoint[0]);
  this->Parallel = view.Camera->GetParallelProjection() != 0;
  if (!std::isfinite(dot(this->Position, dvec3(1.0)) + dot(focalPoint, dvec3(1.0))))
  {
    error = "The camera's position or focal point is not finite";
    return false;
  }
  // Scaling comes first: VTK keeps focal points as close as 1e-20.
  const dvec3 back = this->Position - focalPoint;
  const double scale = std::max({ std::abs(back.x), std::abs(back.y), std::abs(back.z) });
  this->Backwards = scale > 0.0 ? UnitOrZero(back / scale) : dvec3(0.0);
  if (this->Backwards == dvec3(0.0))
  {
    error = "The camera has no direction: its position and focal point coincide";
    return false;
  }
  return true;
}
}
