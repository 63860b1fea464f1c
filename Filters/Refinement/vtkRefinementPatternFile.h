// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementPatternFile
 * @brief   files of refinement patterns
 *
 * Private to the module's own sources. Two formats, chosen by the file's extension:
 *
 * - `.vtp`: a vtkPolyData of all patterns side by side, as equilateral triangles. The point array
 *   "Barycentrics" holds the weights, the point and cell arrays "Pattern" the index of the pattern
 *   (vtkRefinementPatternTable::GetPatternIndex), the field array "MaximumLevel" the level.
 * - any other: binary, little-endian. The eight bytes "RelevoRP"; then as uint32 the version (1),
 *   MaximumLevel and the number of patterns; then for each pattern as uint32 its three numbers of
 *   segments, V vertices and T triangles, followed by 3 V float32 weights and 3 T uint32 indices.
 */
#ifndef vtkRefinementPatternFile_h
#define vtkRefinementPatternFile_h

#include "vtkRefinementPattern.h"

#include <string>
#include <vector>

namespace relevo
{
/**
 * Write all canonical patterns for levels up to `maximumLevel`, in the order of their index.
 * Returns what went wrong, empty on success.
 */
std::string WritePatterns(
  const char* fileName, int maximumLevel, const std::vector<const vtkRefinementPattern*>& patterns);

/**
 * Read what WritePatterns() wrote. Every pattern is checked. Returns what is wrong with the file,
 * empty on success.
 */
std::string ReadPatterns(
  const char* fileName, int& maximumLevel, std::vector<vtkRefinementPattern>& patterns);
}

#endif
