// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   files of refinement patterns
 *
 * Private to the module's own sources. vtkRefinementPatternTable::Write() describes the formats.
 */
#ifndef RefinementPatternFile_h
#define RefinementPatternFile_h

#include "Patterns/RefinementPattern.h"
#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>
#include <vector>

namespace relevo
{
/**
 * Write all canonical patterns for levels up to `maximumLevel`, in the order of their index.
 * Returns what went wrong, empty on success.
 */
RELEVOFILTERSCORE_EXPORT std::string WritePatterns(
  const char* fileName, int maximumLevel, const RefinementPatterns& patterns);

/**
 * Read what WritePatterns() wrote. Every pattern is checked. Returns what is wrong with the file,
 * empty on success.
 */
RELEVOFILTERSCORE_EXPORT std::string ReadPatterns(
  const char* fileName, int& maximumLevel, std::vector<RefinementPattern>& patterns);
}

#endif
