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
 * Throws ViewerError if the file ends before its header or its format says: .ply, .stl, and VTK's
 * XML files. Other formats pass.
 */
void CheckFileEnd(const std::string& fileName, ViewerMessages& messages);

#endif
