// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   an order of triangles and vertices that suits a cache of transformed vertices
 *
 * Private to the module's own sources.
 */
#ifndef PatternVertexOrder_h
#define PatternVertexOrder_h

#include "Patterns/PatternMesh.h"

namespace relevo
{
/**
 * Put triangles in the order of Hilbert's curve, so that neighbours follow each other, and inner
 * vertices in the order of their first use.
 */
void OrderForCache(PatternMesh& mesh, int numberOfBorderVertices);
}

#endif
