// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether a PLY file has all that its header says
 */
#ifndef PLYCheck_h
#define PLYCheck_h

#include <string>

/// Throws ViewerError. VTK's reader would read beyond the end of the file's data.
void CheckPLY(const std::string& fileName);

#endif
