// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a micro-mesh as the bytes of an .rmm file
 *
 * The first chunk is a table with an entry for each further chunk, which is an array. An entry has
 * 1 byte for the owner (0 points, 1 triangles, 2 point data, 3 cell data, 4 field data), 1 byte for
 * VTK's type, 1 byte for the bits per value, 1 byte for the role (0, or VTK's attribute type plus
 * 1), 1 byte for the coding, 4 bytes for the number of components, 8 bytes for the number of
 * tuples, 4 bytes for the length of the name, and the name. Codings are:
 *
 * - 0: the values, see ArrayPacking.h.
 * - 1: triangles, see TrianglePacking.h.
 * - 2: directions, see DirectionPacking.h. 3, 4: MicroMeshEdges and MicroMeshFaces, see
 *   NumberPrediction.h. 5: displacements, see SamplePrediction.h. These arrays follow each other.
 * - 6: point data and cell data that follow from the arrays above, see ComputedArray.h.
 * - 7: points, see PointPacking.h.
 */
#ifndef MicroMeshFile_h
#define MicroMeshFile_h

#include "Data/MicroMesh.h"

#include <string>
#include <string_view>
#include <vector>

class vtkPolyData;

namespace relevo
{
/**
 * Return the file of a mesh, which TakeMicroMesh() has read. Arrays of other types than numbers are
 * left out, and their names returned.
 */
std::string PackMicroMesh(
  vtkPolyData* mesh, const MicroMesh& micro, std::vector<std::string>& leftOut);

/// Read a file. Returns the error without a full stop, or "".
std::string UnpackMicroMesh(std::string_view file, vtkPolyData* mesh);
}

#endif
