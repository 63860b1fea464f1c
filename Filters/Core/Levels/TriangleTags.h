// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   tags of points and edges by the levels of the triangles at them
 */
#ifndef TriangleTags_h
#define TriangleTags_h

#include "RelevoFiltersCoreModule.h" // for export macro

class vtkFloatArray;

namespace relevo
{
class SurfaceEdges;
class SurfaceTriangles;

/// Give every point the largest level of the triangles at its place, and 0 where there is none.
RELEVOFILTERSCORE_EXPORT void TagPointsByTriangles(
  const SurfaceTriangles& surface, const float* levels, vtkFloatArray* tags);

/// Give every edge the largest level of the triangles beside it.
RELEVOFILTERSCORE_EXPORT void TagEdgesByTriangles(
  const SurfaceEdges& edges, const float* levels, vtkFloatArray* tags);
}

#endif
