// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceEvaluation
 * @brief   evaluates positions, normals and fields of a surface on the CPU
 *
 * Part of vtkRefinementSurface. Values that do not depend on the weights are precomputed as vectors
 * per edge and per face.
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
   * Compute the vectors of the edge from a to b: first the positions, then the normals.
   */
  virtual void ComputeEdgeVectors(const SurfaceCorner&, const SurfaceCorner&, float*) {}

  /**
   * Compute the vectors of the face: first the positions, then the normals. The vectors of the
   * face's edges have been computed. Write to `edgeNormals` to replace their normals in this face.
   */
  virtual void ComputeFaceVectors(const SurfaceFace&, float*, float* /*edgeNormals*/[3]) {}

  /**
   * Return whether this face may have normals at its corners or edges that differ from those of
   * adjacent faces, although they share points.
   */
  virtual bool SplitsNormals(const SurfaceFace&) { return false; }

  /**
   * Compute the position and the normal (not normalised) for the weights of the sorted corners.
   */
  virtual void Evaluate(
    const SurfaceFace& face, const float weights[3], float position[3], float normal[3]) = 0;

  /**
   * Compute the direction of displacement (not normalised). All faces at a corner or an edge must
   * return the same direction there. The default is the normal.
   */
  virtual void EvaluateDirection(
    const SurfaceFace& face, const float weights[3], float direction[3])
  {
    float position[3];
    this->Evaluate(face, weights, position, direction);
  }

  /**
   * Return the coefficients for evaluating a point array between the corners. The default is
   * nullptr: the array is interpolated linearly.
   */
  virtual vtkDataArray* FindCoefficients(vtkPolyData*, vtkDataArray*) { return nullptr; }

  /**
   * Evaluate a tuple from these coefficients.
   */
  virtual void EvaluateField(
    const SurfaceFace&, const float[3], vtkDataArray* /*coefficients*/, double* /*tuple*/)
  {
  }

  /**
   * Return why Evaluate() cannot reproduce the shader, or an empty string if it can.
   */
  virtual std::string GetEvaluationError() { return std::string(); }

protected:
  SurfaceEvaluation() = default;
  ~SurfaceEvaluation() = default;
};
}

#endif
