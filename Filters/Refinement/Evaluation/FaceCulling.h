// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceCulling
 * @brief   which faces of a mesh a camera cannot see, whatever they are refined to
 *
 * A face is hidden when the box that holds all its refined points lies outside the frustum, or
 * when it is part of a closed surface and every normal it can have faces away from the eye. Neither
 * is ever said of a face that could be seen.
 */
#ifndef FaceCulling_h
#define FaceCulling_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "View/CullingView.h"              // for views

#include <vector> // for members

class vtkAdaptiveRefinement;

namespace relevo
{
class RefinementMesh;

class RELEVOFILTERSREFINEMENT_EXPORT FaceCulling
{
public:
  /// Take a mesh built with the recipe, whose height map must be up to date.
  void Build(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe);

  /**
   * Mark the faces that cannot be seen, a byte per face. With `hideBackFaces`, those too that face
   * away from an eye outside the closed surface they belong to, all of which lies beyond the near
   * plane. Returns how many are marked.
   */
  int FindHidden(
    const CullingView& view, bool hideBackFaces, std::vector<unsigned char>& hidden) const;

  /// Whether faces that face away from a view are hidden, if they are to be.
  bool HidesBackFaces(const CullingView& view, bool hideBackFaces) const;

  /// Whether the mesh is a closed surface, all of it turned outside, whose normals are bounded.
  bool IsClosed() const { return this->Closed; }

  /// Twelve floats per face: middle of the box, cosine of the cone of normals (0 for none); half
  /// the box's sides, reach behind the middle along normals; axis of the cone, 0.
  const std::vector<float>& GetData() const { return this->Data; }

  /// Whether the near plane cuts nothing of the whole mesh: the eye is outside then.
  bool IsUncut(const CullingView& view) const;

private:
  void BuildBoxes(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe);
  void BuildCones(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe);

  std::vector<float> Data;
  float Low[3];
  float High[3];
  bool Closed = false;
};
}

#endif
