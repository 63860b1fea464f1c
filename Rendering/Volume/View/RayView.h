// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayView
 * @brief   how the pixels of a viewport see a mesh: what relevoVolumeRay.glsl asks for
 *
 * Computed in double precision relative to the mesh, which may lie anywhere. Private to the module.
 */
#ifndef RayView_h
#define RayView_h

#include "Mathematics/RefinementMathematics.h"

class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;

namespace relevo
{
class RayView
{
public:
  /**
   * By the renderer's camera, and the matrix from the data to the world; points of the mesh are at
   * center + radius * point in the data. false if nothing can be seen.
   */
  bool Compute(
    vtkRenderer* renderer, vtkMatrix4x4* dataToWorld, const dvec3& center, double radius);

  /// Lower left corner and size in pixels.
  void SetViewport(const dvec4& viewport) { this->Viewport = viewport; }

  void SetUniforms(vtkShaderProgram* program) const;
  /// What relevoVolumeOutline.glsl asks for.
  void SetOutlineUniforms(vtkShaderProgram* program) const;

  /// Where the mesh is seen from, in its coordinates; see GetEye() of CameraEye.h.
  const dvec4& GetEye() const { return this->Eye; }

  const dmat4& GetMeshToWorld() const { return this->MeshToWorld; }

  /// The world's length of what is 1 long in the mesh, in the direction where this is longest.
  double GetLargestScale() const;

  /// Whether all of a box around the mesh's middle, of this half size, is in front of the eye.
  bool IsInFront(const dvec3& half) const;
  /// Of the near plane.
  bool IsBeyondNear(const dvec3& half) const;

private:
  bool AreCornersAbove(const dvec3& half, const dvec4& plane) const;

  dvec4 Middle;
  dvec4 X;
  dvec4 Y;
  dvec4 Z;
  dvec2 Range;
  dmat4 MeshToWorld;
  dmat3 GradientToWorld; // by radii of the mesh to by lengths of the world, times the radius
  dmat4 MeshToClip;
  dvec4 Eye;
  double MiddleZ = 0.0;      // of near plane -1, far plane 1
  double MiddleWeight = 1.0; // of what is there in the middle of the view
  dvec4 Viewport = dvec4(0.0, 0.0, 1.0, 1.0);
};
}

#endif
