// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reading of Bézier patches from text files (.bpt)
 *
 * Private to the module.
 */
#ifndef BezierPatchFile_h
#define BezierPatchFile_h

#include "Mathematics/RefinementMathematics.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace relevo
{
struct BezierPatch
{
  ivec2 Degrees;
  std::vector<dvec4> Points; ///< in the order of AddQuadrilateral(), with weight 1
};

/// Reads all patches. Returns false with an `error` "line N: ...".
bool ReadBezierPatches(std::istream& in, std::vector<BezierPatch>& patches, std::string& error);

/// Whether a text starts with a number of patches and, if that is not 0, valid degrees.
bool IsBezierPatchFile(std::istream& in);
}

#endif
