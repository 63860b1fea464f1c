// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   warnings about cells that are not drawn, or not as expected
 *
 * Private to the modules.
 */
#ifndef CellReports_h
#define CellReports_h

#include "RelevoFiltersVolumeModule.h" // for export macro

#include <string>
#include <vector>

namespace relevo
{
class CellCounts;
struct MeshScalars;

/**
 * Returns warnings about cells without volume or with points that are not finite, and about cells
 * that fold over themselves. The counts are those of these data sets, in this order. The warnings
 * name the blocks.
 */
RELEVOFILTERSVOLUME_EXPORT std::vector<std::string> DescribeBadCells(
  const CellCounts& counts, const std::vector<MeshScalars>& meshes);

/// Returns a warning about cells with scalars that are not finite, or "". It names the array and
/// the blocks.
RELEVOFILTERSVOLUME_EXPORT std::string DescribeMissingValues(
  const CellCounts& counts, const std::vector<MeshScalars>& meshes);
}

#endif
