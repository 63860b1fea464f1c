// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   faces with several 3D cells on the same side
 *
 * Private to the modules.
 */
#ifndef SharedFaces_h
#define SharedFaces_h

#include "RelevoFiltersVolumeModule.h" // for export macro

#include <cstddef>
#include <string>

namespace relevo
{
class VolumeCells;

/// Returns the number of faces of three or more cells, and of two cells with the same corners.
/// Curved cells are represented by their corners.
RELEVOFILTERSVOLUME_EXPORT size_t CountSharedFaces(const VolumeCells& cells);

/// Returns a warning about them.
RELEVOFILTERSVOLUME_EXPORT std::string DescribeSharedFaces(size_t number);
}

#endif
