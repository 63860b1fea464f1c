// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   computes tags of points and edges from the levels of adjacent triangles
 */
#ifndef TriangleTags_h
#define TriangleTags_h

#include "RelevoFiltersCoreModule.h" // for export macro

class vtkFloatArray;

namespace relevo
{
class SurfaceEdges;
class SurfaceTriangles;

/// Set the tag of each point to the largest level of its triangles, or 0 if there are none.
RELEVOFILTERSCORE_EXPORT void TagPointsByTriangles(
  const SurfaceTriangles& surface, const float* levels, vtkFloatArray* tags);

/// Set the tag of each edge to the largest level of its triangles.
RELEVOFILTERSCORE_EXPORT void TagEdgesByTriangles(
  const SurfaceEdges& edges, const float* levels, vtkFloatArray* tags);
}

#endif
