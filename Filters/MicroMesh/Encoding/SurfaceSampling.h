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
#include <vector>     // for members

namespace relevo
{
/// Number the samples of a mesh by the levels of its edges and faces, and resize Samples.
void NumberSamples(MicroMesh& mesh);

/// Edges and faces whose samples are known.
struct SampledParts
{
  std::vector<char> Edges;
  std::vector<char> Faces;
};

/**
 * Displace all samples onto the surface. A sample goes to the nearest intersection of the line
 * along its direction with a triangle of the same orientation, within a distance that depends on
 * the size of the face or edge. Without an intersection, it goes towards the nearest point of the
 * surface. Samples that are known are not changed.
 * Returns false after an abort.
 */
bool SampleSurface(MicroMesh& mesh, const SampledParts& sampled, const TriangleTree& surface,
  const std::function<bool()>& isAborted);

/// Copy samples that are the same on a mesh that was sampled before. `matches` are its faces, or
/// -1, for all faces of the mesh.
SampledParts CopyEqualSamples(
  MicroMesh& mesh, const MicroMesh& before, const std::vector<int>& matches);

/// Per face, whether the grid differs by more than `deviation` from that of the next lower level.
std::vector<char> FindUneven(const MicroMesh& mesh, double deviation);

/**
 * Return the mesh with the lowest levels whose grids differ by at most `deviations` per face from
 * those of the mesh's levels.
 */
MicroMesh ReduceLevels(const MicroMesh& mesh, const std::vector<double>& deviations);
}

#endif
