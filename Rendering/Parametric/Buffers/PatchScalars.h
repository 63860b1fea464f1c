// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchScalars
 * @brief   the scalars of patches as coefficients of their control points, on the GPU
 *
 * Private to the module.
 */
#ifndef PatchScalars_h
#define PatchScalars_h

#include "Buffers/FieldCoefficients.h" // for members

#include <string>

class vtkDataArray;
class vtkPolyData;

namespace relevo
{
class PatchScalars
{
public:
  /// Upload the coefficients of scalars, if there are any and they have changed. Return false if
  /// they do not fit on the GPU.
  bool Upload(vtkOpenGLRenderWindow* window, vtkPolyData* mesh, const FieldScalars& scalars);

  /// Return the error of the coefficients of scalars, as a sentence; or "".
  static std::string DescribeMisfit(vtkPolyData* mesh, vtkDataArray* scalars);

  FieldColoring GetColoring() const { return this->Coefficients.GetColoring(); }
  /// Return whether weights of control points differ.
  bool IsRational() const { return this->Rational; }
  /// Return whether each control point has a single coefficient.
  bool IsNumber() const { return this->Coefficients.IsNumber(); }
  /// Return the number that has been subtracted from the values.
  double GetBias() const { return this->Coefficients.GetBias(); }

  void Activate(vtkShaderProgram* program) { this->Coefficients.Activate(program); }
  void Deactivate() { this->Coefficients.Deactivate(); }
  vtkTypeInt64 GetMemorySize() const { return this->Coefficients.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  FieldCoefficients Coefficients;
  bool Rational = false;
};
}

#endif
