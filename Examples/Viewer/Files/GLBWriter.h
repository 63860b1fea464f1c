// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes the triangles of a mesh as binary glTF 2.0
 */
#ifndef GLBWriter_h
#define GLBWriter_h

#include "Files/ExportedMesh.h"

#include <functional>
#include <string>

/**
 * Writes a .glb file with normals, texture coordinates and the picture. Positions are floats
 * relative to the origin of the mesh. The matrix of the node moves them to the world and turns the
 * up axis to y, as glTF requires. Returns an error message, or an empty string. The function gets
 * the progress from 0 to 1.
 */
std::string WriteGLB(const ExportedMesh& mesh, const std::string& fileName,
  const std::function<void(double)>& progress);

#endif
