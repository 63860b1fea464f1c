// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the arrays of a vtkPolyData that make it a micro-mesh
 *
 * - Point array MicroMeshDirections (float, 3): the displacement of a sample of 1.
 * - Cell array MicroMeshFaces (int, 5): for each edge from corner e to e + 1 of the triangle, the
 *   index of the edge times 2, plus 1 if its samples run from corner e + 1 to e; the first sample
 *   that is not on an edge; the level.
 * - Field array MicroMeshEdges (int, 2): the first sample and the level.
 * - Field array MicroMeshDisplacements (signed char or short): the samples.
 *
 * @sa MicroMesh
 */
#ifndef MicroMeshArrays_h
#define MicroMeshArrays_h

#include "Data/MicroMesh.h"

#include <string> // for errors

class vtkPolyData;

namespace relevo
{
constexpr const char* MicroDirectionsName = "MicroMeshDirections";
constexpr const char* MicroFacesName = "MicroMeshFaces";
constexpr const char* MicroEdgesName = "MicroMeshEdges";
constexpr const char* MicroDisplacementsName = "MicroMeshDisplacements";
constexpr const char* MicroErrorName = "MicroMeshError";

/// Add the arrays to a mesh whose points and triangles are those of the micro-mesh.
void StoreMicroMesh(const MicroMesh& micro, vtkPolyData* mesh);

/// Read a micro-mesh. Returns false and an error for the user if an array is missing or invalid.
bool TakeMicroMesh(vtkPolyData* mesh, MicroMesh& micro, std::string& error);
}

#endif
