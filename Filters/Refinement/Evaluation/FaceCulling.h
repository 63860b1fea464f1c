// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceCulling
 * @brief   finds the faces of a mesh that a camera cannot see at any refinement
 *
 * A face is hidden if the box of all its refined points is outside the frustum, or if it belongs to
 * a closed surface and all its possible normals face away from the eye. The test is conservative:
 * visible faces are never hidden.
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
  /// Set a mesh that was built with the recipe. The height map must be up to date.
  void Build(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe);

  /**
   * Mark the faces that cannot be seen, one byte per face. `hideBackFaces` also marks faces that
   * face away from the eye, if the eye is outside the closed surface and all of the surface is
   * beyond the near plane. Returns the number of marked faces.
   */
  int FindHidden(
    const CullingView& view, bool hideBackFaces, std::vector<unsigned char>& hidden) const;

  /// Whether back faces are hidden in a view, if `hideBackFaces` is set.
  bool HidesBackFaces(const CullingView& view, bool hideBackFaces) const;

  /// Whether the mesh is a closed surface, oriented outwards, whose normals are bounded.
  bool IsClosed() const { return this->Closed; }

  /// Twelve floats per face: the centre of the box, the cosine of the cone of normals (0 for none),
  /// half the sides of the box, the reach behind the centre along normals, the axis of the cone,
  /// and 0.
  const std::vector<float>& GetData() const { return this->Data; }

  /// Whether the near plane clips nothing of the mesh. The eye is then outside.
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
