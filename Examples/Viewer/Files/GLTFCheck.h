// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether a glTF file is one that VTK's reader can take
 */
#ifndef GLTFCheck_h
#define GLTFCheck_h

#include <string>

/**
 * Throws ViewerError where a file is missing, or where what one part of the scene says of another
 * is not so: VTK's reader does not look, and reads whatever there is in memory.
 */
void CheckGLTF(const std::string& fileName);

#endif
