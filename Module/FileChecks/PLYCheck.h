// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks that a PLY file contains everything that its header declares
 */
#ifndef PLYCheck_h
#define PLYCheck_h

#include <string>

/// Throws FileError for a truncated file: VTK's reader would read beyond the end of the data.
void CheckPLY(const std::string& fileName);

#endif
