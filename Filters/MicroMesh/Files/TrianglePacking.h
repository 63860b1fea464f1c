// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the triangles of a mesh as bytes, about two bits each after compression
 *
 * Packing and unpacking keep a stack of gates: edges of the triangles so far, in the opposite
 * direction, across which a triangle may follow. Each triangle is one operation. It is attached to
 * the gate on the top of the stack, with that gate as its first edge, and with
 *
 * - NEW: the point after the highest one so far,
 * - BEFORE, AFTER: the other end of the gate that ends, or starts, at the gate's start or end,
 * - POINT: a point that is stored.
 *
 * SKIP removes the top gate before. FREE is a triangle with three stored points. Stored points are
 * differences to the highest point so far. All triangles in any order can be packed. Those of
 * OrderFaces() need few bytes.
 *
 * Source: J. Rossignac, "Edgebreaker: Connectivity Compression for Triangle Meshes", IEEE
 * Transactions on Visualization and Computer Graphics 5(1), 1999, for the idea.
 */
#ifndef TrianglePacking_h
#define TrianglePacking_h

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace relevo
{
using PackedTriangle = std::array<int, 3>;

std::string PackTriangles(const std::vector<PackedTriangle>& triangles);

/// Read `number` triangles. Returns false if the bytes do not have them. Points can be out of
/// range.
bool UnpackTriangles(
  std::string_view bytes, std::size_t number, std::vector<PackedTriangle>& triangles);
}

#endif
