// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveEvaluator
 * @brief   the functions of curves that shaders and C++ share, in double precision
 *
 * Private to the modules.
 */
#ifndef CurveEvaluator_h
#define CurveEvaluator_h

#include "Curves/CurveMesh.h"
#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
class CurveEvaluator
{
public:
  using Real = double;
  using Real2 = dvec2;
  using Real3 = dvec3;
  using Real4 = dvec4;

  CurveEvaluator(const CurveMesh& mesh, vtkIdType curve)
    : Points(&mesh.GetPoints()[mesh.GetCurves()[curve].FirstPoint])
    , Degree(mesh.GetCurves()[curve].Degree)
  {
  }

  /// Sets the stations of the curve, one more than intervals, for frames. See CurveFrames.
  void SetStations(int intervals, const dvec3* tangents, const dvec3* normals)
  {
    this->Intervals = intervals;
    this->Tangents = tangents;
    this->Normals = normals;
  }

  /// Sets the coefficients of the curve, for values: up to 4 components of tuples of `stride`
  /// components.
  void SetCoefficients(const double* coefficients, int components, int stride)
  {
    this->Coefficients = coefficients;
    this->Components = components;
    this->Stride = stride;
  }

  int curveDegree() const { return this->Degree; }
  const dvec4& curvePoint(int i) const { return this->Points[i]; }
  dvec4 curveValue(int i) const
  {
    dvec4 value(0.0);
    for (int c = 0; c < this->Components; ++c)
    {
      value[c] = this->Coefficients[i * this->Stride + c];
    }
    return value;
  }
  int curveIntervals() const { return this->Intervals; }
  const dvec3& curveStationTangent(int k) const { return this->Tangents[k]; }
  const dvec3& curveStationNormal(int k) const { return this->Normals[k]; }

#include "glsl/relevoCurve.glsl"
#include "glsl/relevoCurveFrames.glsl"
#include "glsl/relevoCurveValues.glsl"

private:
  const dvec4* Points;
  int Degree;
  int Intervals = 1;
  const dvec3* Tangents = nullptr;
  const dvec3* Normals = nullptr;
  const double* Coefficients = nullptr;
  int Components = 0;
  int Stride = 0;
};
}

#endif
