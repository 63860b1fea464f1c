// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayView
 * @brief   the uniforms of relevoVolumeRay.glsl: the view of a mesh from a viewport's pixels
 *
 * They are computed in double precision relative to the mesh, which may be far from the origin.
 * Private to the module.
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
   * Compute the view from the renderer's camera and the matrix from the data to the world. Points
   * of the mesh are at center + radius * point in the data. Return false if nothing is visible.
   */
  bool Compute(
    vtkRenderer* renderer, vtkMatrix4x4* dataToWorld, const dvec3& center, double radius);

  /// Set the lower left corner and size in pixels.
  void SetViewport(const dvec4& viewport) { this->Viewport = viewport; }

  void SetUniforms(vtkShaderProgram* program) const;
  /// Set the uniforms of relevoVolumeOutline.glsl.
  void SetOutlineUniforms(vtkShaderProgram* program) const;

  /// Return the position of the eye in the mesh's coordinates; see GetEye() of CameraEye.h.
  const dvec4& GetEye() const { return this->Eye; }

  const dmat4& GetMeshToWorld() const { return this->MeshToWorld; }

  /// Return the world length of a unit length of the mesh, in the direction in which it is longest.
  double GetLargestScale() const;

  /// Return whether lengths in the world are too large for floats.
  bool IsTooLarge() const;

  /// Return whether a box around the mesh's centre, of this half size, is completely in front of
  /// the eye.
  bool IsInFront(const dvec3& half) const;
  /// Return whether the box is completely beyond the near plane.
  bool IsBeyondNear(const dvec3& half) const;

  /// Return the depth of a point as in relevoVolumeOutline.glsl, between near and far plane and
  /// relative to that of the mesh's centre.
  double GetDepth(const dvec3& point) const;
  /// Return a factor that makes the depths of a box between -1 and 1. The box must be in front of
  /// the eye.
  double GetDepthScale(const dvec3& half) const;
  const dmat4& GetMeshToClip() const { return this->MeshToClip; }

private:
  static dvec3 GetBoxCorner(const dvec3& half, int i);
  bool AreCornersAbove(const dvec3& half, const dvec4& plane) const;

  dvec4 Middle;
  dvec4 X;
  dvec4 Y;
  dvec4 Z;
  dvec2 Range;
  dmat4 MeshToWorld;
  dmat3 GradientToWorld; // from units of the mesh to world units, times the radius
  dmat4 MeshToClip;
  dvec4 Eye;
  double MiddleZ = 0.0;      // between near plane -1 and far plane 1
  double MiddleWeight = 1.0; // weight at that depth, in the middle of the view
  dvec4 Viewport = dvec4(0.0, 0.0, 1.0, 1.0);
};
}

#endif
