// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceNeighbors.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
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

using Face = std::array<int, 4>;
using Sink = std::function<void(size_t, size_t)>;

// Returns the number of groups of more than two faces.
size_t MatchCandidates(Candidate* begin, Candidate* end, const Sink& match)
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
      match(static_cast<size_t>(first[0].Face), static_cast<size_t>(first[1].Face));
      match(static_cast<size_t>(first[1].Face), static_cast<size_t>(first[0].Face));
    }
    numberOfSharedByMore += begin - first > 2 ? 1 : 0;
  }
  return numberOfSharedByMore;
}

// Faces are matched in parts, by ranges of their lowest corners. They are read in batches. A part
// skips batches without faces of its range, so that most batches of a well-numbered mesh are read
// twice.
constexpr size_t BatchSize = size_t(1) << 16;
constexpr size_t MinimumPart = size_t(1) << 18; // faces
constexpr size_t NumberOfParts = 16;

class FaceMatcher
{
public:
  FaceMatcher(const FaceSource& source, int numberOfPoints, const Sink& match)
    : Source(source)
    , Match(match)
    , Counts(static_cast<size_t>(numberOfPoints), 0)
  {
  }

  size_t Run()
  {
    this->Count();
    const size_t most = std::max(MinimumPart, this->Source.NumberOfFaces / NumberOfParts);
    size_t numberOfSharedByMore = 0;
    for (size_t begin = 0; begin < this->Counts.size();)
    {
      size_t number = 0;
      size_t end = begin;
      while (end < this->Counts.size() && (end == begin || number + this->Counts[end] <= most))
      {
        number += this->Counts[end++];
      }
      numberOfSharedByMore +=
        this->MatchPart(static_cast<int>(begin), static_cast<int>(end), number);
      begin = end;
    }
    return numberOfSharedByMore;
  }

private:
  // Reads a batch, with corners in ascending order.
  void Read(size_t batch)
  {
    const size_t begin = batch * BatchSize;
    this->Batch.resize(std::min(BatchSize, this->Source.NumberOfFaces - begin));
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Batch.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        Face* faces = this->Batch.data();
        this->Source.Read(
          begin + static_cast<size_t>(first), begin + static_cast<size_t>(last), faces + first);
        std::transform(faces + first, faces + last, faces + first, SortCorners);
      });
  }

  void Count()
  {
    for (size_t begin = 0; begin < this->Source.NumberOfFaces; begin += BatchSize)
    {
      this->Read(begin / BatchSize);
      Range range = { None, -1 };
      for (const Face& face : this->Batch)
      {
        if (face[0] >= 0)
        {
          ++this->Counts[static_cast<size_t>(face[0])];
          range = { std::min(range.Low, face[0]), std::max(range.High, face[0]) };
        }
      }
      this->Ranges.push_back(range);
    }
  }

  // Counting sort by lowest corner.
  size_t MatchPart(int begin, int end, size_t number)
  {
    std::vector<size_t> firsts = { 0 };
    for (int point = begin; point < end; ++point)
    {
      firsts.push_back(firsts.back() + this->Counts[static_cast<size_t>(point)]);
    }
    std::vector<size_t> next(firsts.begin(), firsts.end() - 1);
    this->Candidates.resize(number);
    for (size_t batch = 0; batch < this->Ranges.size(); ++batch)
    {
      if (this->Ranges[batch].High < begin || this->Ranges[batch].Low >= end)
      {
        continue;
      }
      this->Read(batch);
      for (size_t i = 0; i < this->Batch.size(); ++i)
      {
        const Face& face = this->Batch[i];
        if (face[0] >= begin && face[0] < end)
        {
          this->Candidates[next[static_cast<size_t>(face[0] - begin)]++] = { face[1], face[2],
            face[3], static_cast<int>(batch * BatchSize + i) };
        }
      }
    }
    std::atomic<size_t> numberOfSharedByMore(0);
    vtkSMPTools::For(0, end - begin,
      [&](vtkIdType first, vtkIdType last)
      {
        size_t sum = 0;
        for (vtkIdType i = first; i < last; ++i)
        {
          Candidate* start = this->Candidates.data();
          sum += MatchCandidates(start + firsts[i], start + firsts[i + 1], this->Match);
        }
        numberOfSharedByMore += sum;
      });
    return numberOfSharedByMore;
  }

  struct Range
  {
    int Low;
    int High;
  };

  const FaceSource& Source;
  const Sink& Match;
  std::vector<std::uint32_t> Counts; // of faces by lowest corner
  std::vector<Range> Ranges;         // of the lowest corners in each batch
  std::vector<Face> Batch;
  std::vector<Candidate> Candidates; // of a part
};
}

FaceMatch MatchFaces(const std::vector<std::array<int, 4>>& faces, int numberOfPoints)
{
  FaceMatch match;
  match.Others.assign(faces.size(), -1);
  const FaceSource source = { faces.size(), [&](size_t begin, size_t end, Face* read) {
                               std::copy(faces.begin() + begin, faces.begin() + end, read);
                             } };
  match.NumberOfSharedByMore = MatchFaces(source, numberOfPoints,
    [&](size_t face, size_t other) { match.Others[face] = static_cast<int>(other); });
  return match;
}

size_t MatchFaces(const FaceSource& source, int numberOfPoints, const Sink& match)
{
  return FaceMatcher(source, numberOfPoints, match).Run();
}
}
