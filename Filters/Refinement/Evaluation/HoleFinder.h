// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the triangles of refined faces that a displacement with holes leaves out
 */
#ifndef HoleFinder_h
#define HoleFinder_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <memory> // for members

class vtkDisplacement;

namespace relevo
{
class PatternSelection;
class RefinementMesh;
struct FacePattern;

/// Which samples of a height map have data, as they were when it was asked.
struct HeightValidity
{
  int Dimensions[2] = { 0, 0 };
  /// See vtkHeightField::GetValidity(); nullptr where nothing is left out.
  std::shared_ptr<const unsigned char> Samples;
};

/**
 * What a displacement, or nullptr, leaves out. Its height map must be up to date.
 */
RELEVOFILTERSREFINEMENT_EXPORT HeightValidity GetHoles(vtkDisplacement* displacement);

/**
 * All methods may be called from several threads.
 */
class RELEVOFILTERSREFINEMENT_EXPORT HoleFinder
{
public:
  /// For a mesh that was built for such a height map, and that must outlive this. There are
  /// samples.
  HoleFinder(const RefinementMesh& mesh, const HeightValidity& validity);
  ~HoleFinder();

  /**
   * Mark the pattern's triangles that are left out on this face: those with a vertex whose height,
   * or with a sample in them that, has no data. `out` holds a byte per triangle, 1 where left out.
   * Returns how many there are.
   */
  int Find(int face, const FacePattern& pattern, unsigned char* out) const;

  /**
   * Whether Find() can find any on this face.
   */
  bool MayHave(int face) const;

  /**
   * Whether the height at these weights has data.
   */
  bool HasData(int face, const float weights[3]) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};

/**
 * Number of triangles of a selection that are left out, on faces that are not hidden: `hidden` has
 * a byte per face, or is nullptr for none.
 */
RELEVOFILTERSREFINEMENT_EXPORT vtkIdType CountHoles(const RefinementMesh& mesh,
  const PatternSelection& selection, const HeightValidity& validity,
  const unsigned char* hidden = nullptr);
}

#endif
