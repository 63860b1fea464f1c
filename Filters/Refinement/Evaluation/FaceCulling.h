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

#include <array>  // for margins
#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkCamera;
class vtkMatrix4x4;

namespace relevo
{
class Dependencies;
class RefinementMesh;

/**
 * A camera in the coordinates of a mesh's points.
 */
struct RELEVOFILTERSREFINEMENT_EXPORT CullingView
{
  /**
   * `aspect` is width over height. `margins` are what drawn things reach beyond their points to the
   * sides and up and down, as shares of half the width and height. A matrix that cannot be inverted
   * gives a view that hides nothing.
   */
  CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld,
    const RefinementMesh& mesh, const std::array<double, 2>& margins = { { 0.0, 0.0 } });
  /// The same for points relative to a place.
  CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld, const double origin[3],
    const std::array<double, 2>& margins);

  static constexpr int NumberOfPlanes = 5;
  /// Sides of the frustum and the plane of the eye, pointing inside.
  float Planes[NumberOfPlanes][4];
  /// The near plane, pointing inside.
  float Near[4];
  /// Position of the eye, or with a parallel camera the direction towards it.
  float Eye[3];
  bool Parallel;
  bool Valid;

  /// All but the near plane, of which FaceCulling::HidesBackFaces() tells what matters.
  void AddTo(Dependencies& dependencies) const;
};

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
