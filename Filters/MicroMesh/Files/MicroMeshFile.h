// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a micro-mesh as the bytes of an .rmm file
 *
 * The first chunk is a table with an entry for each further chunk, which is an array (see
 * ArrayPacking.h). An entry has 1 byte for the owner (0 points, 1 triangles, 2 point data, 3 cell
 * data, 4 field data), 1 byte for VTK's type, 1 byte for the bits per value, 1 byte for the role
 * (0, or VTK's attribute type plus 1), 4 bytes for the number of components, 8 bytes for the number
 * of tuples, 4 bytes for the length of the name, and the name.
 */
#ifndef MicroMeshFile_h
#define MicroMeshFile_h

#include <string>
#include <string_view>
#include <vector>

class vtkPolyData;

namespace relevo
{
/**
 * Return the file. The mesh must be a micro-mesh. Arrays of other types than numbers are left out,
 * and their names returned.
 */
std::string PackMicroMesh(vtkPolyData* mesh, std::vector<std::string>& leftOut);

/// Read a file. Returns the error without a full stop, or "".
std::string UnpackMicroMesh(std::string_view file, vtkPolyData* mesh);
}

#endif
