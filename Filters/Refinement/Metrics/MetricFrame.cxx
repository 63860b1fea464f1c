// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MetricFrame.h"

#include <cmath>

namespace
{
// A larger value comes from the inverse of a singular matrix.
constexpr double FarthestCamera = 1e30;
}

namespace relevo
{
MetricFrame::MetricFrame(MetricShader& shader, const Placement& placement, const dvec3& eye,
  const double origin[3], int maximumLevel)
  : Shader(shader)
  , ToWorld(placement)
  , WorldEye(eye)
{
  const dvec3 start(origin[0], origin[1], origin[2]);
  dvec3 camera = dvec3(inverse(placement.ModelToWorld) * dvec4(eye, 1.0)) - start;
  if (!(dot(camera, camera) < FarthestCamera))
  {
    // Any point is suitable, because the matrices contain the remaining translation.
    camera = dvec3(0.0);
  }
  const dvec3 high(vec3(camera.x, camera.y, camera.z));
  const dvec3 low(vec3(camera - high));
  this->Camera = start + high + low;
  this->SetRow(0, dvec4(high, maximumLevel));
  this->SetRow(1, dvec4(low, 0.0));
}

void MetricFrame::SetRow(int row, const dvec4& value)
{
  for (int c = 0; c < 4; ++c)
  {
    this->Shader.Parameters[4 * row + c] = static_cast<float>(value[c]);
  }
}

void MetricFrame::SetUnit(double unit)
{
  dmat4 fromEye = this->ToWorld.ModelToWorld;
  fromEye[3] -= dvec4(this->WorldEye, 0.0);
  if (unit > 0.0)
  {
    this->SetMatrix(fromEye * (1.0 / unit));
  }
  else
  {
    this->SetMatrix(dmat4(0.0));
    this->SetRow(2, dvec4(0.0, 0.0, 0.0, 2.0));
  }
}

void MetricFrame::SetMatrix(const dmat4& matrix)
{
  const dvec4 atCamera = matrix * dvec4(this->Camera, 1.0);
  for (int row = 0; row < 4; ++row)
  {
    this->SetRow(2 + row, dvec4(matrix[0][row], matrix[1][row], matrix[2][row], atCamera[row]));
  }
}

void MetricFrame::SetDirections(const Eye& eye)
{
  this->Shader.Parameters[7] = eye.IsParallel() ? 1.0f : 0.0f;
  this->SetRow(5, dvec4(eye.GetBackwards(), 0.0));
  dmat3 normals = this->ToWorld.NormalToWorld;
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    largest = std::max(largest, length(normals[column]));
  }
  if (largest > 0.0)
  {
    normals *= 1.0 / largest;
  }
  for (int row = 0; row < 3; ++row)
  {
    this->SetRow(6 + row, dvec4(normals[0][row], normals[1][row], normals[2][row], 0.0));
  }
}

void MetricFrame::SetOwn(double x, double y)
{
  this->SetRow(9, dvec4(x, y, 0.0, 0.0));
}
}
