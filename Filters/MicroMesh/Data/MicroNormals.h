// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   normals of the triangles of a micro-mesh at its samples and corners
 *
 * The normal of a point is the sum of the unit normals of its triangles, weighted by their angles
 * at the point.
 */
#ifndef MicroNormals_h
#define MicroNormals_h

#include "Data/MicroMesh.h"
#include "vtkSmartPointer.h"

class vtkFloatArray;

namespace relevo
{
/// The name of the array of MakePointNormals().
constexpr const char* MicroNormalsName = "Normals";

/// The sums for the corners of a face, of the face's own triangles.
std::array<dvec3, 3> ComputeCornerNormals(const MicroMesh& mesh, const MicroMesh::Face& face);

/// The unit normal per point, or 0 where triangles have no area.
vtkSmartPointer<vtkFloatArray> MakePointNormals(const MicroMesh& mesh);

/// The unit normal per sample, or 0 where triangles have no area.
std::vector<vec3> ComputeSampleNormals(const MicroMesh& mesh);
}

#endif
