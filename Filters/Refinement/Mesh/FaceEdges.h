// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the edges between merged points of the faces of a mesh
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
 * Return for each face the indices of its sorted edges (0,1), (1,2), (0,2) in `edges`, which must
 * belong to the same mesh. A degenerate edge has the index of an edge at its point.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::vector<int> FindFaceEdges(
  const RefinementMesh& mesh, const SurfaceEdges& edges);
}

#endif
