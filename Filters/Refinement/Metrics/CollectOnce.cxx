// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/CollectOnce.h"

#include "Mesh/SurfaceTriangles.h"
#include "Parallel/PieceReduction.h"
#include "Points/MergedPoints.h"

#include <cstring>
#include <map>

namespace relevo
{
std::uint64_t HashEdge(const SurfaceTriangles& surface, const int mergedPoints[2])
{
  std::uint64_t hash = 0;
  for (int end = 0; end < 2; ++end)
  {
    double x[3];
    surface.GetPoint(mergedPoints[end], x);
    hash += HashPoint(x);
  }
  return hash;
}

std::vector<double> CollectOnce(const PieceReduction& pieces, std::vector<double> values,
  const std::function<std::uint64_t(std::size_t)>& getKey)
{
  if (pieces.IsWhole())
  {
    return values;
  }
  std::vector<double> keys(values.size());
  static_assert(sizeof(double) == sizeof(std::uint64_t), "keys travel as the bits of numbers");
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::uint64_t key = getKey(i);
    std::memcpy(&keys[i], &key, sizeof(key));
  }
  keys = pieces.Collect(std::move(keys));
  values = pieces.Collect(std::move(values));
  std::map<std::uint64_t, double> distinct;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    std::uint64_t key;
    std::memcpy(&key, &keys[i], sizeof(key));
    distinct.emplace(key, values[i]);
  }
  values.clear();
  for (const auto& value : distinct)
  {
    values.push_back(value.second);
  }
  return values;
}
}
