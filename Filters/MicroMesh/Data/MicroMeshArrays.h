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
 * The cell array MicroMeshLevelErrors (float) has an upper bound of the distance to the surface for
 * each level below the highest one.
 *
 * Further field arrays, MicroMeshPointData:NAME, have the values of the point array NAME at all
 * grid points of all faces, in the order of GetGridIndex(). MicroMeshCellData:NAME have those of
 * the cell array NAME at all triangles of grids, in the order of ForEachGridTriangle().
 *
 * The field array MicroMeshInputBounds (double, 6) has the bounds of the input.
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
constexpr const char* MicroLevelErrorsName = "MicroMeshLevelErrors";
constexpr const char* MicroErrorName = "MicroMeshError";
constexpr const char* MicroInputBoundsName = "MicroMeshInputBounds";
constexpr const char* MicroPointDataPrefix = "MicroMeshPointData:";
constexpr const char* MicroCellDataPrefix = "MicroMeshCellData:";

/// Add the arrays to a mesh whose points and triangles are those of the micro-mesh.
void StoreMicroMesh(const MicroMesh& micro, vtkPolyData* mesh);

/// Add the bounds of the input.
void StoreInputBounds(const double bounds[6], vtkPolyData* mesh);

/// The highest level of a face, or the highest allowed one if the mesh is not a micro-mesh.
int FindFinestLevel(vtkPolyData* mesh);

/// Read a micro-mesh. Returns false and an error for the user if an array is missing or invalid.
bool TakeMicroMesh(vtkPolyData* mesh, MicroMesh& micro, std::string& error);
}

#endif
