// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MetricFrame
 * @brief   converts the view of one frame to the parameters of a metric's functions
 *
 * Values per frame are computed here in doubles, so that values per point can be computed in
 * floats. Points are first translated relative to the camera, exactly: its position is the sum of
 * two floats. No precision is lost far from the origin.
 */
#ifndef MetricFrame_h
#define MetricFrame_h

#include "Metrics/MetricShader.h"
#include "View/WorldView.h"

namespace relevo
{
class MetricFrame
{
public:
  /// Set parameters 0 and 1. `eye` is the camera's position in world coordinates. `origin` is the
  /// origin of the points in the mesh's coordinates. Overwrites the shader's Parameters.
  MetricFrame(MetricShader& shader, const Placement& placement, const dvec3& eye,
    const double origin[3], int maximumLevel);

  /// Set parameters 2 to 4: vectors from the eye are measured in a `unit` of the world. If it is 0,
  /// points are at least 2 units away.
  void SetUnit(double unit);
  /// Set parameters 2 to 5 to the rows of a matrix for the mesh's coordinates.
  void SetMatrix(const dmat4& matrix);
  /// Set parameters 5 to 8, and 1.w: the direction of a parallel camera, and the transformation of
  /// normals.
  void SetDirections(const Eye& eye);
  /// Set parameter 9.
  void SetOwn(double x, double y = 0.0);

private:
  void SetRow(int row, const dvec4& value);

  MetricShader& Shader;
  const Placement& ToWorld;
  dvec3 WorldEye;
  /// In the mesh's coordinates.
  dvec3 Camera;
};
}

#endif
