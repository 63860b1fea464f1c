// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveColors
 * @brief   the colours of curves, or values to map to colours, on the GPU
 *
 * Private to the module.
 */
#ifndef CurveColors_h
#define CurveColors_h

#include "Buffers/BufferTexture.h"
#include "Buffers/VertexColors.h"
#include "Shaders/CurveShader.h"

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkScalarsToColors;
class vtkShaderProgram;
class vtkUnsignedCharArray;

namespace relevo
{
class CurveMesh;

class CurveColors
{
public:
  /// Remove the colours.
  void Clear(vtkWindow* window);

  //@{
  /**
   * Upload colours of four components by cell or by point, or values of points. `component` is that
   * of vtkMapper. Return false if they do not fit. If the shader cannot map the values, the
   * colouring is ACTOR.
   */
  bool UploadCells(
    vtkOpenGLRenderWindow* window, const CurveMesh& curves, vtkUnsignedCharArray* colors);
  bool UploadPoints(
    vtkOpenGLRenderWindow* window, const CurveMesh& curves, vtkUnsignedCharArray* colors);
  bool UploadValues(vtkOpenGLRenderWindow* window, const CurveMesh& curves, vtkDataArray* values,
    vtkScalarsToColors* table, int component, bool ofFragments);
  //@}

  CurveColoring GetColoring() const { return this->Coloring; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window) { this->Clear(window); }

private:
  CurveColoring Coloring = CurveColoring::ACTOR;
  BufferTexture Cells;
  BufferTexture Points;
  VertexColors Values;
};
}

#endif
