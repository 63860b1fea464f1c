// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceEvaluation
 * @brief   positions, normals and fields of a surface at weights, on the CPU
 *
 * A part of vtkRefinementSurface. Whatever does not depend on the weights is computed beforehand,
 * as vectors per edge and per face.
 */
#ifndef SurfaceEvaluation_h
#define SurfaceEvaluation_h

#include "Surfaces/SurfaceFace.h"

#include <string> // for errors

class vtkDataArray;
class vtkPolyData;

namespace relevo
{
class SurfaceEvaluation
{
public:
  /**
   * Fill the vectors of the edge from a to b: first the positions, then the normals.
   */
  virtual void ComputeEdgeVectors(const SurfaceCorner&, const SurfaceCorner&, float*) {}

  /**
   * Fill the vectors per face: first the positions, then the normals. The face's edges are
   * complete; `edgeNormals` lets their normals be replaced by others for this face alone.
   */
  virtual void ComputeFaceVectors(const SurfaceFace&, float*, float* /*edgeNormals*/[3]) {}

  /**
   * Whether this face may see other normals at its corners or edges than the faces beside it,
   * though they share points.
   */
  virtual bool SplitsNormals(const SurfaceFace&) { return false; }

  /**
   * Position and normal (not normalised) at the weights of the sorted corners.
   */
  virtual void Evaluate(
    const SurfaceFace& face, const float weights[3], float position[3], float normal[3]) = 0;

  /**
   * The direction, not normalised, that displacement goes along: on edges and at corners the same
   * from all faces around. Unless overridden, the normal.
   */
  virtual void EvaluateDirection(
    const SurfaceFace& face, const float weights[3], float direction[3])
  {
    float position[3];
    this->Evaluate(face, weights, position, direction);
  }

  /**
   * The coefficients by which the surface knows a point array between the corners; nullptr, the
   * default, where it is interpolated linearly.
   */
  virtual vtkDataArray* FindCoefficients(vtkPolyData*, vtkDataArray*) { return nullptr; }

  /**
   * The tuple that such an array has at weights.
   */
  virtual void EvaluateField(
    const SurfaceFace&, const float[3], vtkDataArray* /*coefficients*/, double* /*tuple*/)
  {
  }

  /**
   * Why Evaluate() cannot do what the shader does; empty if it can.
   */
  virtual std::string GetEvaluationError() { return std::string(); }

protected:
  SurfaceEvaluation() = default;
  ~SurfaceEvaluation() = default;
};
}

#endif
