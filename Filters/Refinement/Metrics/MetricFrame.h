// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MetricFrame
 * @brief   the view of one frame as the parameters of a metric's functions
 *
 * What is computed once a frame is computed here, in doubles, so that what is computed for each
 * point can be floats: points are taken relative to the camera before anything else, exactly
 * (its position is the sum of two floats), so that nothing is lost far from the origin.
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
  /// Sets parameters 0 and 1. `eye` is the camera's position in the world, `origin` that of the
  /// points in the mesh's coordinates. What the shader has as Parameters is overwritten.
  MetricFrame(MetricShader& shader, const Placement& placement, const dvec3& eye,
    const double origin[3], int maximumLevel);

  /// Sets parameters 2 to 4: vectors from the eye are measured in a `unit` of the world; nothing
  /// is nearer than 2 units where that is 0.
  void SetUnit(double unit);
  /// Sets parameters 2 to 5 to the rows of a matrix that takes the mesh's coordinates.
  void SetMatrix(const dmat4& matrix);
  /// Sets parameters 5 to 8, and 1.w: the direction of a parallel camera, and where normals go.
  void SetDirections(const Eye& eye);
  /// Sets parameter 9.
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
