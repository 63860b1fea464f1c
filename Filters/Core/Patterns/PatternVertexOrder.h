// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   orders triangles and vertices for the cache of transformed vertices
 */
#ifndef PatternVertexOrder_h
#define PatternVertexOrder_h

#include "Patterns/PatternMesh.h"

namespace relevo
{
/**
 * Sort triangles along the Hilbert curve, so that neighbours follow each other, and inner vertices
 * by their first use.
 */
void OrderForCache(PatternMesh& mesh, int numberOfBorderVertices);
}

#endif
