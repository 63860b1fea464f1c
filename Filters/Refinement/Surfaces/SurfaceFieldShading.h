// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceFieldShading
 * @brief   evaluates arrays of a surface at every pixel, in GLSL
 *
 * A vtkRefinementSurface can derive from this class. Mappers otherwise interpolate point arrays
 * between the corners of faces, and faces have the values of their cells.
 */
#ifndef SurfaceFieldShading_h
#define SurfaceFieldShading_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDataArray.h"                  // for results
#include "vtkSmartPointer.h"               // for results

#include <string> // for shader text

class vtkPolyData;

namespace relevo
{
struct SurfaceFace;

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

  /**
   * Return values of a cell array that differ on the faces, or nullptr if each cell has one value.
   */
  virtual vtkSmartPointer<vtkDataArray> FindCellValues(vtkPolyData* mesh, vtkDataArray* cellArray);

  /**
   * Return the tuple of these values for the weights of the sorted corners.
   */
  virtual vtkIdType FindCellTuple(const SurfaceFace& face, const float weights[3]);

  /**
   * Return the same as GetFieldShaderSource(), for tuples of FindCellValues().
   */
  virtual std::string GetCellFieldShaderSource();

protected:
  SurfaceFieldShading() = default;
  virtual ~SurfaceFieldShading() = default;
};

inline vtkSmartPointer<vtkDataArray> SurfaceFieldShading::FindCellValues(
  vtkPolyData*, vtkDataArray*)
{
  return nullptr;
}

inline vtkIdType SurfaceFieldShading::FindCellTuple(const SurfaceFace&, const float[3])
{
  return 0;
}

inline std::string SurfaceFieldShading::GetCellFieldShaderSource()
{
  return std::string();
}
}

#endif
