// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads and writes files of refinement patterns
 *
 * vtkRefinementPatternTable::Write() describes the formats.
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
 * Returns the error, or an empty string.
 */
RELEVOFILTERSCORE_EXPORT std::string WritePatterns(
  const char* fileName, int maximumLevel, const RefinementPatterns& patterns);

/**
 * Read a file of WritePatterns() and check every pattern. Returns the error, or an empty string.
 */
RELEVOFILTERSCORE_EXPORT std::string ReadPatterns(
  const char* fileName, int& maximumLevel, std::vector<RefinementPattern>& patterns);
}

#endif
