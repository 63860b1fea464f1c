// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefView
 * @brief   the view of a relief: the uniforms of relevoReliefRay.glsl and relevoReliefVS.glsl
 *
 * Private to the module.
 */
#ifndef ReliefView_h
#define ReliefView_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

class vtkActor;
class vtkRenderer;
class vtkShaderProgram;

namespace relevo
{
class ReliefView
{
public:
  /// toModel is the matrix from coordinates of the tiles to the actor's.
  ReliefView(vtkRenderer* renderer, vtkActor* actor, const dmat4& toModel);

  /// Add a clipping plane in world coordinates; the positive side of dot(plane, point) is kept.
  void AddClippingPlane(const dvec4& plane);

  /// Return the number of planes that clip rays, including near and far.
  int GetNumberOfPlanes() const { return static_cast<int>(this->Planes.size()); }

  void SetUniforms(vtkShaderProgram* program) const;

  /// Set the uniforms of relevoReliefShadow.glsl for the first light that is on. Return false if
  /// there is none.
  bool SetLamp(vtkShaderProgram* program, vtkRenderer* renderer) const;

  /// Return whether planes of this height are seen from the same side as by the relief's viewer.
  bool SeesFront(double height) const;

  /// Return false for a box that is completely outside the view or clipped. Some such boxes return
  /// true.
  bool MaySee(const dvec3& low, const dvec3& high) const;

  /// Return the largest number of pixels that a step of length 1 at a point covers; 0 behind the
  /// camera.
  double GetPixels(const dvec3& point) const;

private:
  dmat4 ToWorld;
  dmat4 ToView;
  dmat4 ToClip;
  dvec4 Viewport;            // x, y, width, height in pixels
  std::vector<dvec4> Planes; // in coordinates of the tiles
  std::vector<dvec4> Sides;  // the frustum's side planes, in coordinates of the tiles
};
}

#endif
