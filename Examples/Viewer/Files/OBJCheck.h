// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether the faces of an OBJ file refer to points, texture coordinates and normals that
 *          are there
 */
#ifndef OBJCheck_h
#define OBJCheck_h

#include <string>

/// Throws ViewerError. VTK's reader would write beyond its arrays.
void CheckOBJ(const std::string& fileName);

#endif
