// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveBuffers
 * @brief   control points of curves, their radii, frames and cells, on the GPU
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
  /// Upload the curves, relative to an origin. All methods return false if the data do not fit.
  bool Upload(vtkOpenGLRenderWindow* window, const CurveMesh& curves, const dvec3& origin);

  /// Upload radii at control points, or none if all curves have the same.
  bool UploadRadii(vtkOpenGLRenderWindow* window, const std::vector<double>& radii);

  /// Upload the frames that orient ribbons and tubes.
  bool UploadFrames(vtkOpenGLRenderWindow* window, const CurveFrames& frames);

  /// Upload ids of cells for selections, unless that has been done.
  bool UploadCells(vtkOpenGLRenderWindow* window, const CurveMesh& curves);

  /// Return the degree of all curves; 0 if they differ.
  int GetDegree() const { return this->Degree; }
  bool IsRational() const { return this->Rational; }
  bool HasRadii() const { return !this->Radii.IsEmpty(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  BufferTexture Points; // three floats each, or four if weights differ
  BufferTexture Curves; // first control point << 3 | degree - 1, if degrees differ
  BufferTexture Cells;
  BufferTexture Radii;
  BufferTexture Frames;   // per curve, see relevoCurveTables.glsl
  BufferTexture Stations; // tangent and normal at each station
  int Degree = 0;
  bool Rational = false;
};
}

#endif
