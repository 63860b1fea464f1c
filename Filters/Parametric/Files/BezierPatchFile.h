// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   text files of Bézier patches (.bpt)
 *
 * Private to the module's own sources.
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
  std::vector<dvec4> Points; ///< in the order of AddQuadrilateral(), of weight 1
};

/// All patches of a text; else what is wrong, "line N: ...".
bool ReadBezierPatches(std::istream& in, std::vector<BezierPatch>& patches, std::string& error);

/// Whether a text begins as one of patches: their number and, if there are any, degrees.
bool IsBezierPatchFile(std::istream& in);
}

#endif
