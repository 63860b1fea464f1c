// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   sorts levels in descending order and finds the permutation of the pattern
 *
 * vtkRefinementPatternTable offers the same functions to users.
 */
#ifndef CanonicalOrder_h
#define CanonicalOrder_h

#include "RelevoFiltersCoreModule.h" // for export macro

namespace relevo
{
/// The highest level of an edge.
constexpr int HighestLevel = 7;

//@{
/// See vtkRefinementPatternTable.
RELEVOFILTERSCORE_EXPORT int Canonicalize(int ijk[3]);
RELEVOFILTERSCORE_EXPORT void GetPermutation(int lambda, int permutation[3]);
RELEVOFILTERSCORE_EXPORT bool IsOdd(int lambda);
constexpr int GetPatternIndex(int i, int j, int k)
{
  return i * (i + 1) * (i + 2) / 6 + j * (j + 1) / 2 + k;
}
//@}
}

#endif
