// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   where a triangle's nodes and control points stand
 *
 * Private to the module's own sources.
 */
#ifndef TriangleIndex_h
#define TriangleIndex_h

namespace relevo
{
/// Rows j = 0 to degree of i = 0 to degree - j.
constexpr int GetTriangleIndex(int degree, int i, int j)
{
  return j * (degree + 1) - j * (j - 1) / 2 + i;
}
}

#endif
