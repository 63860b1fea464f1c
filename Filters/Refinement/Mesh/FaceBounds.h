// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceBounds
 * @brief   where the refined points of a face can lie
 *
 * Each face's points and positions (surfaces lie within their convex hull, or within the surface's
 * own reach of it), moved by up to the displacement's reach along the normals the face can have.
 */
#ifndef FaceBounds_h
#define FaceBounds_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <cstddef> // for size_t
#include <vector>  // for members

class vtkDisplacement;
class vtkRefinementSurface;

namespace relevo
{
class HeightRanges;
class RefinementMesh;

class RELEVOFILTERSREFINEMENT_EXPORT FaceBounds
{
public:
  /// With `heights`, those of the displacement's height map, boxes reach as far as the heights over
  /// each face; else as far as all heights do.
  FaceBounds(const RefinementMesh& mesh, vtkRefinementSurface* surface,
    vtkDisplacement* displacement, const HeightRanges* heights = nullptr);

  /// A box relative to the mesh's origin. May be called from several threads.
  void GetBox(std::size_t face, double low[3], double high[3]) const;

private:
  void GetReach(std::size_t face, double reach[2]) const;
  void GetMoves(std::size_t face, double moves[3][2]) const;
  const float* GetVectors(std::size_t face) const;

  const RefinementMesh& Mesh;
  vtkRefinementSurface* Surface;
  const std::vector<float>& Directions;
  const HeightRanges* Heights;
  double Scale = 0.0;
  double Offset = 0.0;
  bool AlongNormal = false;
  double Reach[2] = { 0.0, 0.0 };
  double Fixed[3] = { 0.0, 0.0, 0.0 };
  double SurfaceReach = 0.0;
  bool KnowsNormals = true;
  int EdgePositions = 0;
  int FacePositions = 0;
};

/**
 * Bounds of all that a surface and a displacement, which may be nullptr, can make of a mesh, in the
 * input's coordinates.
 */
RELEVOFILTERSREFINEMENT_EXPORT void ComputeBounds(const RefinementMesh& mesh,
  vtkRefinementSurface* surface, vtkDisplacement* displacement, double bounds[6]);
}

#endif
