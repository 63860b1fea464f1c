// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the export of a height map as a solid with a base
 */
#ifndef TerrainSolid_h
#define TerrainSolid_h

struct ViewerOptions;
class ViewerMessages;

/// Writes the height map with walls and a bottom, for --base. Throws ViewerError.
void ExportTerrainSolid(const ViewerOptions& options, ViewerMessages& messages);

#endif
