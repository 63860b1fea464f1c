// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks that VTK's reader can safely read a glTF file
 */
#ifndef GLTFCheck_h
#define GLTFCheck_h

#include <string>

/**
 * Throws FileError if a referenced file is missing or if parts of the scene refer to each other
 * incorrectly. VTK's reader does not check this and reads arbitrary memory.
 */
void CheckGLTF(const std::string& fileName);

#endif
