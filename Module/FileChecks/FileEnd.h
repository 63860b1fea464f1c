// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds truncated files that VTK's readers accept
 */
#ifndef FileEnd_h
#define FileEnd_h

#include <functional>
#include <string>

/**
 * Throws FileError if the file is shorter than its header or its format says: .ply, .stl, classic
 * netCDF (.nc, and .ex2 and other extensions of Exodus), and VTK's XML files with the pieces of
 * .pvtu files. Also throws if faces of an .obj file refer to missing points. Other formats are not
 * checked. warn() takes texts about smaller faults.
 */
void CheckFileEnd(const std::string& fileName, const std::function<void(const std::string&)>& warn);

#endif
