// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceBounds
 * @brief   bounds of the refined points of a face
 *
 * The bounds contain each face's points and positions (surfaces are within their convex hull or the
 * surface's reach of it), moved by up to the displacement's reach along the possible normals of the
 * face.
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
  /// With `heights`, the height ranges of the displacement's height map, boxes use the range over
  /// each face. Otherwise they use the range of all heights.
  FaceBounds(const RefinementMesh& mesh, vtkRefinementSurface* surface,
    vtkDisplacement* displacement, const HeightRanges* heights = nullptr);

  /// Get a box relative to the mesh's origin. Thread-safe.
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
 * Compute the bounds of a mesh with a surface and a displacement, which may be nullptr, in the
 * input's coordinates.
 */
RELEVOFILTERSREFINEMENT_EXPORT void ComputeBounds(const RefinementMesh& mesh,
  vtkRefinementSurface* surface, vtkDisplacement* displacement, double bounds[6]);
}

#endif
