// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   order of nodes and control points of triangles
 */
#ifndef TriangleIndex_h
#define TriangleIndex_h

namespace relevo
{
/// Returns the index in rows j = 0 to degree of i = 0 to degree - j.
constexpr int GetTriangleIndex(int degree, int i, int j)
{
  return j * (degree + 1) - j * (j - 1) / 2 + i;
}
}

#endif
