// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Coarse/Diagonals.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <set>

namespace relevo
{
namespace
{
using Pair = std::array<vtkIdType, 2>;

Pair GetPair(vtkIdType a, vtkIdType b)
{
  return { std::min(a, b), std::max(a, b) };
}

struct Candidate
{
  Pair Ends;
  std::size_t Patch;

  bool operator<(const Candidate& other) const
  {
    return this->Ends < other.Ends || (this->Ends == other.Ends && this->Patch < other.Patch);
  }
};
}

void ChooseDiagonals(const PatchEdges& edges, const std::vector<CornerPoints>& places,
  std::vector<Diagonal>& diagonals)
{
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < diagonals.size(); ++i)
  {
    if (diagonals[i] == Diagonal::First || diagonals[i] == Diagonal::Fixed)
    {
      candidates.push_back({ GetPair(places[i][0], places[i][2]), i });
    }
  }
  vtkSMPTools::Sort(candidates.begin(), candidates.end());
  std::vector<std::size_t> refused;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const Pair& ends = candidates[i].Ends;
    const bool isTaken =
      ends[0] == ends[1] || edges.AreJoined(ends) || (i > 0 && candidates[i - 1].Ends == ends);
    if (isTaken && diagonals[candidates[i].Patch] == Diagonal::First)
    {
      refused.push_back(candidates[i].Patch);
    }
  }
  std::set<Pair> seconds;
  for (std::size_t patch : refused)
  {
    const Pair ends = GetPair(places[patch][1], places[patch][3]);
    const bool isTaken = ends[0] == ends[1] || edges.AreJoined(ends) ||
      std::binary_search(candidates.begin(), candidates.end(), Candidate{ ends, 0 },
        [](const Candidate& a, const Candidate& b) { return a.Ends < b.Ends; });
    diagonals[patch] = !isTaken && seconds.insert(ends).second ? Diagonal::Second : Diagonal::None;
  }
}
}
