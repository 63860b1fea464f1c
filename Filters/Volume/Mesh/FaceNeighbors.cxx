// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceNeighbors.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>

namespace relevo
{
namespace
{
constexpr int None = std::numeric_limits<int>::max(); // comes after all points

// The corners in order, each once, and then None.
std::array<int, 4> SortCorners(std::array<int, 4> face)
{
  if (face[3] < 0)
  {
    face[3] = None;
  }
  const auto order = [&](int i, int j)
  {
    const int low = std::min(face[i], face[j]);
    face[j] = std::max(face[i], face[j]);
    face[i] = low;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  if (face[0] == face[1] || face[1] == face[2] || face[2] == face[3])
  {
    std::fill(std::unique(face.begin(), face.end()), face.end(), None);
  }
  return face;
}

// A face, among those of the same lowest corner.
struct Candidate
{
  bool IsAt(const Candidate& other) const { return this->Higher == other.Higher; }
  bool operator<(const Candidate& other) const
  {
    return this->Higher != other.Higher ? this->Higher < other.Higher : this->Face < other.Face;
  }

  std::array<int, 3> Higher; // corners
  int Face;
};

// How many places more than two have.
size_t MatchCandidates(Candidate* begin, Candidate* end, std::vector<int>& others)
{
  std::sort(begin, end);
  size_t numberOfSharedByMore = 0;
  while (begin != end)
  {
    const Candidate* first = begin;
    begin = std::find_if(begin, end, [=](const Candidate& face) { return !face.IsAt(*first); });
    if (first->Higher[1] == None) // less than three corners
    {
      continue;
    }
    if (begin - first == 2)
    {
      others[first[0].Face] = first[1].Face;
      others[first[1].Face] = first[0].Face;
    }
    numberOfSharedByMore += begin - first > 2 ? 1 : 0;
  }
  return numberOfSharedByMore;
}
}

FaceMatch MatchFaces(const std::vector<std::array<int, 4>>& faces, int numberOfPoints)
{
  FaceMatch match;
  match.Others.assign(faces.size(), -1);
  // A counting sort by the lowest corners: those of point i are from firsts[i] to firsts[i + 1].
  std::vector<int> lowest(faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        lowest[i] = SortCorners(faces[i])[0];
      }
    });
  std::vector<size_t> firsts(static_cast<size_t>(numberOfPoints) + 2, 0);
  for (int point : lowest)
  {
    firsts[point + 2]++;
  }
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  std::vector<Candidate> candidates(faces.size());
  for (size_t i = 0; i < faces.size(); ++i)
  {
    const std::array<int, 4> corners = SortCorners(faces[i]);
    candidates[firsts[corners[0] + 1]++] = { { { corners[1], corners[2], corners[3] } },
      static_cast<int>(i) };
  }

  std::atomic<size_t> numberOfSharedByMore(0);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      size_t sum = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        Candidate* start = candidates.data();
        sum += MatchCandidates(start + firsts[i], start + firsts[i + 1], match.Others);
      }
      numberOfSharedByMore += sum;
    });
  match.NumberOfSharedByMore = numberOfSharedByMore;
  return match;
}
}
