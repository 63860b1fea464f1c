// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how far the triangles of a pattern are from the surface of a micro-mesh
 */
#ifndef MicroPatternMeasure_h
#define MicroPatternMeasure_h

#include "Data/MicroMesh.h"
#include "Metrics/DisplacedFaces.h"

namespace relevo
{
struct FacePattern;

/**
 * Measure the largest distances between points of the pattern's triangles and points of the face
 * with the same weights. `order` are the face's corners that the sorted corners are.
 *
 * On each piece of a pattern's triangle in a triangle of the grid, both are linear, so that the
 * distance is largest at a corner of a piece: at a point of the grid inside of the triangle, or
 * where a side of the triangle crosses a line of the grid.
 */
FaceDeviations MeasureMicroPattern(const MicroMesh& mesh, const MicroMesh::Face& face,
  const std::array<int, 3>& order, const FacePattern& pattern);
}

#endif
