// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   collects numbers of points and edges of a surface that neighbouring pieces may share
 */
#ifndef CollectOnce_h
#define CollectOnce_h

#include <cstdint>    // for keys
#include <functional> // for GetKey
#include <vector>     // for numbers

namespace relevo
{
class PieceReduction;
class SurfaceTriangles;

/// A key of an edge, the same in both directions.
std::uint64_t HashEdge(const SurfaceTriangles& surface, const int mergedPoints[2]);

/**
 * Return one number for each key, from all pieces. getKey(i) is the key of values[i]. Collective.
 */
std::vector<double> CollectOnce(const PieceReduction& pieces, std::vector<double> values,
  const std::function<std::uint64_t(std::size_t)>& getKey);
}

#endif
