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

#include "Buffers/BufferTexture.h" // for members
#include "Buffers/VertexColors.h"  // for members
#include "Shaders/PatchShader.h"   // for PatchColoring

#include <string>

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkScalarsToColors;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class PatchScalars
{
public:
  struct Source
  {
    vtkPolyData* Mesh;
    vtkDataArray* Scalars; // point scalars
    bool AreColors;
    vtkScalarsToColors* Table;
    int Component; // that of vtkMapper; -1 uses that of the table
    bool ByTexture;
    double NoDataMagnitude; // see NoDataTuples
  };

  /// Upload the coefficients of scalars, if there are any. Return false if they do not fit on the
  /// GPU.
  bool Upload(vtkOpenGLRenderWindow* window, const Source& source);

  /// Return the error of the coefficients of scalars, as a sentence; or "".
  static std::string DescribeMisfit(vtkPolyData* mesh, vtkDataArray* scalars);

  PatchColoring GetColoring() const { return this->Coloring; }
  /// Return whether weights of control points differ.
  bool IsRational() const { return this->Rational; }
  /// Return whether each control point has a single coefficient.
  bool IsNumber() const;
  /// Return the number that has been subtracted from the values.
  double GetBias() const { return this->Numbers.GetBias(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool UploadColors(vtkOpenGLRenderWindow* window, vtkDataArray* nodes, int type);

  PatchColoring Coloring = PatchColoring::NONE;
  bool Rational = false;
  VertexColors Numbers;
  BufferTexture Colors;
};
}

#endif
