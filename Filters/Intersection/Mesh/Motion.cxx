// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Motion.h"

#include "Boxes/BoxTree.h"
#include "Exact/ExactPredicates.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Whether the determinant of the linear part is exactly 0.
bool IsSingular(const std::array<double, 16>& m)
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  return Orient3D(origin, &m[0], &m[4], &m[8]) == 0;
}
}

std::string Motion::Set(vtkMatrix4x4* matrix)
{
  std::array<double, 16> elements = Motion().Elements;
  if (matrix)
  {
    std::copy(matrix->GetData(), matrix->GetData() + 16, elements.begin());
  }
  for (double element : elements)
  {
    if (!std::isfinite(element))
    {
      return "has a matrix that is not finite";
    }
  }
  if (elements[12] != 0.0 || elements[13] != 0.0 || elements[14] != 0.0 || elements[15] != 1.0)
  {
    return "has a matrix that is not affine: its last row is not 0 0 0 1";
  }
  if (IsSingular(elements))
  {
    return "has a singular matrix";
  }
  this->Elements = elements;
  return {};
}

DoubleBox Motion::MoveBox(const DoubleBox& box) const
{
  DoubleBox moved;
  for (int corner = 0; corner < 8; ++corner)
  {
    double x[3];
    for (int c = 0; c < 3; ++c)
    {
      x[c] = (corner >> c & 1) != 0 ? box.High[c] : box.Low[c];
    }
    double y[3];
    this->Move(x, y);
    if (!std::isfinite(y[0]) || !std::isfinite(y[1]) || !std::isfinite(y[2]))
    {
      constexpr double all = DoubleBox::Infinity;
      return { { { -all, -all, -all } }, { { all, all, all } } };
    }
    moved.Add(y);
  }
  for (int c = 0; c < 3; ++c)
  {
    // Includes the rounding errors of points in the box.
    const double margin = 8.0 * std::numeric_limits<double>::epsilon() *
      std::max(std::abs(moved.Low[c]), std::abs(moved.High[c]));
    moved.Low[c] -= margin;
    moved.High[c] += margin;
  }
  return moved;
}

double Motion::GetLargestStretch() const
{
  const std::array<double, 16>& m = this->Elements;
  const double linear[3][3] = { { m[0], m[1], m[2] }, { m[4], m[5], m[6] }, { m[8], m[9], m[10] } };
  double u[3][3];
  double stretches[3];
  double v[3][3];
  vtkMath::SingularValueDecomposition3x3(linear, u, stretches, v);
  return std::max({ std::abs(stretches[0]), std::abs(stretches[1]), std::abs(stretches[2]) });
}
}
