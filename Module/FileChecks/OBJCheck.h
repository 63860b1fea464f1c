// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks that the faces of an OBJ file refer to existing points, texture coordinates and
 * normals
 */
#ifndef OBJCheck_h
#define OBJCheck_h

#include <string>

/// Throws FileError for an invalid reference: VTK's reader would write beyond its arrays.
void CheckOBJ(const std::string& fileName);

#endif
