// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the order of faces, edges and samples in the output
 */
#ifndef FaceOrder_h
#define FaceOrder_h

#include "Encoding/MicroMeshEncoder.h"

namespace relevo
{
/**
 * Sort faces so that most follow across an edge of the face before, which becomes their first edge.
 * Edges are numbered in the order of the faces, and samples in that of edges and faces. Files need
 * few bytes then; see TrianglePacking.h. Edges at which points of the output are split are not
 * crossed.
 */
void OrderFaces(EncodedMesh& encoded);
}

#endif
