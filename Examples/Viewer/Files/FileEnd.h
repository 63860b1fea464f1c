// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds truncated files that VTK's readers accept
 */
#ifndef FileEnd_h
#define FileEnd_h

#include <string>

class ViewerMessages;

/**
 * Throws ViewerError if the file is shorter than its header or its format says: .ply, .stl, classic
 * netCDF (.ex2, .nc), and VTK's XML files with the pieces of .pvtu files. Also throws if faces of
 * an .obj file refer to missing points. Other formats are not checked.
 */
void CheckFileEnd(const std::string& fileName, ViewerMessages& messages);

/// Checks rasters in the same way. The error names the file. Missing files pass.
void CheckRasterEnd(const std::string& fileName, ViewerMessages& messages);

#endif
