// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DisplacedFaces
 * @brief   how far the triangles of refined faces are from the displaced surface
 *
 * DisplacedSurface creates it for a mesh. Ghost cells are not included.
 */
#ifndef DisplacedFaces_h
#define DisplacedFaces_h

#include <array>  // for corners and tags
#include <vector> // for edges

namespace relevo
{
class SurfaceEdges;
struct PointBox; // of View/PixelScale.h

/// The largest deviations of a refined face, in units of the mesh.
struct FaceDeviations
{
  /// On the sorted edges (0,1), (1,2), (0,2).
  std::array<float, 3> Edges{ { 0.0f, 0.0f, 0.0f } };
  float Inside = 0.0f;
};

class DisplacedFaces
{
public:
  virtual ~DisplacedFaces() = default;

  virtual int GetNumberOfFaces() const = 0;
  /// The merged points of the sorted corners of a face.
  virtual std::array<int, 3> GetMergedPoints(int face) const = 0;
  /// The indices of the sorted edges of each face in the edges of the mesh.
  virtual std::vector<int> FindEdges(const SurfaceEdges& edges) const = 0;
  /// A box that contains the refined face.
  virtual PointBox GetBox(int face) const = 0;

  /**
   * Measure a face with the pattern for the tags of its sorted edges. Results are cached.
   * Thread-safe for different faces.
   */
  virtual FaceDeviations Measure(int face, const std::array<float, 3>& tags) = 0;
};
}

#endif
