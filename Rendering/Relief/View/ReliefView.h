// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefView
 * @brief   where a relief is seen: the uniforms of relevoReliefRay.glsl and relevoReliefVS.glsl
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
  /// toModel: from the tiles' coordinates to the actor's.
  ReliefView(vtkRenderer* renderer, vtkActor* actor, const dmat4& toModel);

  /// A plane of the world whose positive side stays: what dot(plane, point) is there.
  void AddClippingPlane(const dvec4& plane);

  /// That cut rays off; near and far are two of them.
  int GetNumberOfPlanes() const { return static_cast<int>(this->Planes.size()); }

  void SetUniforms(vtkShaderProgram* program) const;

  /// Of relevoReliefShadow.glsl: the first lamp that is on. false for none.
  bool SetLamp(vtkShaderProgram* program, vtkRenderer* renderer) const;

  /// Whether planes of this height are seen as the relief's own viewer sees them.
  bool SeesFront(double height) const;

  /// false for a box that is out of sight or cut off as a whole; true also for some that are.
  bool MaySee(const dvec3& low, const dvec3& high) const;

  /// Pixels that a step of 1 in any direction covers at most; 0 behind the eye.
  double GetPixels(const dvec3& point) const;

private:
  dmat4 ToWorld;
  dmat4 ToView;
  dmat4 ToClip;
  dvec4 Viewport;            // x, y, width, height in pixels
  std::vector<dvec4> Planes; // of the tiles' coordinates
  std::vector<dvec4> Sides;  // of the view, likewise
};
}

#endif
