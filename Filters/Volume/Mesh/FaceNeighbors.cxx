// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceNeighbors.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <tuple>

namespace relevo
{
namespace
{
constexpr int None = std::numeric_limits<int>::max(); // sorts after all point ids

void Order(int& a, int& b)
{
  const int low = a < b ? a : b;
  const int high = a < b ? b : a;
  a = low;
  b = high;
}

// Returns the distinct corners in ascending order, filled up with None.
std::array<int, 4> SortCorners(const std::array<int, 4>& face)
{
  int a = face[0];
  int b = face[1];
  int c = face[2];
  int d = face[3] < 0 ? None : face[3];
  Order(a, b);
  Order(c, d);
  Order(a, c);
  Order(b, d);
  Order(b, c);
  std::array<int, 4> corners = { { a, b, c, d } };
  if (a == b || b == c || c == d)
  {
    std::fill(std::unique(corners.begin(), corners.end()), corners.end(), None);
  }
  return corners;
}

// A face with a given lowest corner.
struct Candidate
{
  bool IsAt(const Candidate& other) const
  {
    return this->Second == other.Second && this->Third == other.Third &&
      this->Fourth == other.Fourth;
  }
  bool operator<(const Candidate& other) const
  {
    return std::tie(this->Second, this->Third, this->Fourth, this->Face) <
      std::tie(other.Second, other.Third, other.Fourth, other.Face);
  }

  int Second; // corner
  int Third;
  int Fourth;
  int Face;
};

// Returns the number of groups of more than two faces.
size_t MatchCandidates(Candidate* begin, Candidate* end, std::vector<int>& others)
{
  std::sort(begin, end);
  size_t numberOfSharedByMore = 0;
  while (begin != end)
  {
    const Candidate* first = begin;
    begin = std::find_if(begin, end, [=](const Candidate& face) { return !face.IsAt(*first); });
    if (first->Third == None) // less than three corners
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
  // Counting sort by lowest corner: faces of point i are from firsts[i] to firsts[i + 1].
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
    candidates[firsts[corners[0] + 1]++] = { corners[1], corners[2], corners[3],
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
