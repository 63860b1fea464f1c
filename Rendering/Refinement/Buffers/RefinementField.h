// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementField
 * @brief   scalars that a surface evaluates at every pixel, on the GPU
 *
 * See SurfaceFieldShading. Private to the module.
 */
#ifndef RefinementField_h
#define RefinementField_h

#include "Buffers/FieldCoefficients.h" // for members

#include <string> // for shader text

class vtkPolyData;
class vtkRefinementSurface;

namespace relevo
{
class RefinementField
{
public:
  /// Upload the values, if the surface evaluates these scalars of points or cells and they have
  /// changed. Return false if they do not fit on the GPU.
  bool Upload(vtkOpenGLRenderWindow* window, vtkRefinementSurface* surface, vtkPolyData* mesh,
    const FieldScalars& scalars, bool areOfCells);
  void Clear() { this->Coefficients.Clear(); }

  FieldColoring GetColoring() const { return this->Coefficients.GetColoring(); }
  /// Return the surface's functions for fragments.
  const std::string& GetShaderSource() const { return this->ShaderSource; }
  /// Return whether a program reads the values. They then replace those of VertexColors.
  bool IsUsed(vtkShaderProgram* program) const;
  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Coefficients.Deactivate(); }
  vtkIdType GetNumberOfUploads() const { return this->Coefficients.GetNumberOfUploads(); }
  vtkTypeInt64 GetMemorySize() const { return this->Coefficients.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  FieldCoefficients Coefficients;
  std::string ShaderSource;
  int Size = 0; // the number of values
};
}

#endif
