// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveBuffers
 * @brief   control points of curves, and what else there is of them, on the GPU
 *
 * Private to the module.
 */
#ifndef CurveBuffers_h
#define CurveBuffers_h

#include "Buffers/BufferTexture.h"
#include "Mathematics/RefinementMathematics.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace relevo
{
class CurveFrames;
class CurveMesh;

class CurveBuffers
{
public:
  /// Take the curves, relative to a place. False where they do not fit, here and below.
  bool Upload(vtkOpenGLRenderWindow* window, const CurveMesh& curves, const dvec3& origin);

  /// Radii at control points; none where all curves have the same.
  bool UploadRadii(vtkOpenGLRenderWindow* window, const std::vector<double>& radii);

  /// What ribbons and tubes are across to.
  bool UploadFrames(vtkOpenGLRenderWindow* window, const CurveFrames& frames);

  /// Numbers of cells, for selections. What is there stays.
  bool UploadCells(vtkOpenGLRenderWindow* window, const CurveMesh& curves);

  /// The degree that all curves have; 0 where they differ.
  int GetDegree() const { return this->Degree; }
  bool IsRational() const { return this->Rational; }
  bool HasRadii() const { return !this->Radii.IsEmpty(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  BufferTexture Points; // three numbers each, or four where weights differ
  BufferTexture Curves; // first control point << 3 | degree - 1, where degrees differ
  BufferTexture Cells;
  BufferTexture Radii;
  BufferTexture Frames;   // by curve, see relevoCurveTables.glsl
  BufferTexture Stations; // tangent and normal of each
  int Degree = 0;
  bool Rational = false;
};
}

#endif
