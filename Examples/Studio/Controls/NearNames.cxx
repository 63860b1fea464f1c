// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Controls/NearNames.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
const std::size_t MostNames = 3;

// The least number of characters to insert, remove or replace.
std::size_t CountEdits(const std::string& from, const std::string& to)
{
  std::vector<std::size_t> edits(to.size() + 1);
  std::iota(edits.begin(), edits.end(), 0);
  for (std::size_t i = 1; i <= from.size(); ++i)
  {
    std::size_t diagonal = edits[0];
    edits[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j)
    {
      const std::size_t replaced = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
      diagonal = edits[j];
      edits[j] = std::min({ replaced, edits[j] + 1, edits[j - 1] + 1 });
    }
  }
  return edits.back();
}
}

//------------------------------------------------------------------------------
std::vector<std::string> FindNearNames(
  const std::string& name, const std::vector<std::string>& names)
{
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& candidate : names)
  {
    const std::size_t edits = CountEdits(name, candidate);
    const bool isPart = name.size() > 2 && candidate.find(name) != std::string::npos;
    if (isPart || edits <= std::max<std::size_t>(name.size() / 3, 1))
    {
      near.emplace_back(edits, candidate);
    }
  }
  std::sort(near.begin(), near.end());
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < std::min(near.size(), MostNames); ++i)
  {
    nearest.push_back(near[i].second);
  }
  return nearest;
}
