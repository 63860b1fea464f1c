// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the edges between places that the faces of a mesh have
 */
#ifndef FaceEdges_h
#define FaceEdges_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <vector> // for return value

namespace relevo
{
class RefinementMesh;
class SurfaceEdges;

/**
 * For each face the indices of its sorted edges (0,1), (1,2), (0,2) among `edges`, those of the
 * same mesh. An edge that is one point has the index of one that leads there.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::vector<int> FindFaceEdges(
  const RefinementMesh& mesh, const SurfaceEdges& edges);
}

#endif
