// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementField
 * @brief   point scalars that a surface evaluates at every pixel, on the GPU
 *
 * See SurfaceFieldShading. Private to the module.
 */
#ifndef RefinementField_h
#define RefinementField_h

#include "Buffers/BufferTexture.h"           // for members
#include "Buffers/VertexColors.h"            // for members
#include "Shaders/RefinementShaderOptions.h" // for FieldColoring

#include <string> // for shader text

class vtkDataArray;
class vtkPolyData;
class vtkRefinementSurface;

namespace relevo
{
class RefinementField
{
public:
  struct Source
  {
    vtkRefinementSurface* Surface;
    vtkPolyData* Mesh;
    vtkAbstractArray* Scalars; // of points
    bool AreColors;
    vtkScalarsToColors* Table;
    int Component; // that of vtkMapper; -1 uses that of the table
    bool ByTexture;
    double NoDataMagnitude; // see NoDataTuples
  };

  /// Upload the values, if the surface evaluates these scalars. Return false if they do not fit on
  /// the GPU.
  bool Upload(vtkOpenGLRenderWindow* window, const Source& source);
  void Clear() { this->Coloring = FieldColoring::NONE; }

  FieldColoring GetColoring() const { return this->Coloring; }
  /// Return the surface's functions for fragments.
  const std::string& GetShaderSource() const { return this->ShaderSource; }
  /// Return whether a program reads the values. They then replace those of VertexColors.
  bool IsUsed(vtkShaderProgram* program) const;
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  FieldColoring Coloring = FieldColoring::NONE;
  std::string ShaderSource;
  VertexColors Numbers;
  BufferTexture Colors;
  int Size = 0; // the number of values
};
}

#endif
