// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   samples of a micro-mesh: their places, and their displacements onto a dense surface
 */
#ifndef SurfaceSampling_h
#define SurfaceSampling_h

#include "Data/MicroMesh.h"
#include "Distance/TriangleTree.h"

#include <functional> // for aborts

namespace relevo
{
/// Number the samples of a mesh by the levels of its edges and faces, and resize Samples.
void NumberSamples(MicroMesh& mesh);

/**
 * Displace all samples onto the surface. A sample goes to the nearest intersection of the line
 * along its direction with a triangle of the same orientation, within a distance that depends on
 * the size of the face or edge. Without an intersection, it goes towards the nearest point of the
 * surface. Returns false after an abort.
 */
bool SampleSurface(
  MicroMesh& mesh, const TriangleTree& surface, const std::function<bool()>& isAborted);

/**
 * Return the mesh with the lowest levels whose grids differ by at most `deviation` from those of
 * the mesh's levels.
 */
MicroMesh ReduceLevels(const MicroMesh& mesh, double deviation);
}

#endif
