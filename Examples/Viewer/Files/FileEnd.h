// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds files that are cut short where VTK's readers do not
 */
#ifndef FileEnd_h
#define FileEnd_h

#include <string>

class ViewerMessages;

/**
 * Throws ViewerError if the file ends before its header or its format says: .ply, .stl,
 * classic netCDF (.ex2, .nc), and VTK's XML files, with the pieces of .pvtu files; or if faces of
 * an .obj file refer to what is not there. Other formats pass.
 */
void CheckFileEnd(const std::string& fileName, ViewerMessages& messages);

/// The same of rasters, with the name of the file in the error. Files that are not there pass.
void CheckRasterEnd(const std::string& fileName, ViewerMessages& messages);

#endif
