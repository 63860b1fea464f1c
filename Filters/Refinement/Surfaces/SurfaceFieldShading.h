// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceFieldShading
 * @brief   evaluates point arrays of a surface at every pixel, in GLSL
 *
 * A vtkRefinementSurface can derive from this class. Mappers otherwise interpolate point arrays
 * between the corners of faces.
 */
#ifndef SurfaceFieldShading_h
#define SurfaceFieldShading_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <string> // for shader text

namespace relevo
{
class RELEVOFILTERSREFINEMENT_EXPORT SurfaceFieldShading
{
public:
  /**
   * Return GLSL for fragments that evaluates point arrays like EvaluateField(). It defines a struct
   * FieldPlace with ivec3 Indices, of tuples of the array of FindCoefficients(), and vec3 Weights,
   * and FieldPlace fieldPlace(ivec2 record, vec3 weights). GetShaderSource() also defines ivec2
   * surfaceFieldRecord() and, from the weights of the sorted corners, vec3
   * surfaceFieldWeights(vec3). These must be linear on the face.
   */
  virtual std::string GetFieldShaderSource() = 0;

protected:
  SurfaceFieldShading() = default;
  virtual ~SurfaceFieldShading() = default;
};
}

#endif
