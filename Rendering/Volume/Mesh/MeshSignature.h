// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a checksum of the points and cells of data sets
 *
 * Readers create new objects for each time step, even if only values change. The content of the
 * objects tells whether the mesh is the same.
 *
 * Private to the module.
 */
#ifndef MeshSignature_h
#define MeshSignature_h

#include <string>
#include <vector>

namespace relevo
{
struct MeshScalars;

/// Return an MD5 checksum of the points, cells and ghost arrays, but not of other arrays. It is
/// empty for polyhedra and for data sets of other classes than VTK's usual ones.
std::string ComputeMeshSignature(const std::vector<MeshScalars>& meshes);
}

#endif
