// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds the triangles of refined faces that are removed because of missing heights
 */
#ifndef HoleFinder_h
#define HoleFinder_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <memory> // for members

class vtkDisplacement;

namespace relevo
{
class RefinementMesh;
struct FacePattern;

/// Marks the valid samples of a height map at the time of the call.
struct HeightValidity
{
  int Dimensions[2] = { 0, 0 };
  /// See vtkHeightField::GetValidity(); nullptr if nothing is removed.
  std::shared_ptr<const unsigned char> Samples;
};

/**
 * Return the samples whose triangles a displacement, which may be nullptr, removes. Its height map
 * must be up to date.
 */
RELEVOFILTERSREFINEMENT_EXPORT HeightValidity GetHoles(vtkDisplacement* displacement);

/**
 * All methods are thread-safe.
 */
class RELEVOFILTERSREFINEMENT_EXPORT HoleFinder
{
public:
  /// Create a finder for a mesh that was built with this height map and outlives the finder.
  /// `validity` must have samples.
  HoleFinder(const RefinementMesh& mesh, const HeightValidity& validity);
  ~HoleFinder();

  /**
   * Mark the triangles of the pattern that are removed from this face: those with a missing height
   * at a vertex, or with a missing sample inside. `out` has one byte per triangle, 1 for removed
   * triangles. Returns the number of removed triangles.
   */
  int Find(int face, const FacePattern& pattern, unsigned char* out) const;

  /**
   * Whether Find() can find any on this face.
   */
  bool MayHave(int face) const;

  /**
   * Whether the height at these weights is valid.
   */
  bool HasData(int face, const float weights[3]) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
