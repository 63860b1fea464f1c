// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleSplit
 * @brief   counts the triangles of progressive splitting (glsl/relevoSplit.glsl)
 */
#ifndef TriangleSplit_h
#define TriangleSplit_h

#include "Patterns/CanonicalOrder.h" // for HighestLevel
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

#include <array> // for Counts
#include <map>   // for members

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT TriangleSplit
{
public:
  using Levels = std::array<int, 3>;

  /// Triangles after 0, 1, 2, ... steps.
  using Counts = std::array<vtkIdType, HighestLevel + 1>;

  /**
   * Return the counts for a triangle with these remaining levels of the edges (0,1), (1,2), (2,0),
   * each at most HighestLevel. Results are cached.
   */
  const Counts& Count(const Levels& left);

private:
  std::map<Levels, Counts> Known;
};
}

#endif
