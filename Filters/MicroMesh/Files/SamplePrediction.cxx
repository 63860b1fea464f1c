// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SamplePrediction.h"

#include "Files/ArrayPacking.h"

#include <cstdint>
#include <vector>

namespace relevo
{
namespace
{
constexpr int BitsOfSample = 8 * SizeOfPackedSample;

int DivideRounded(int value, int divisor)
{
  const int doubled = 2 * value + divisor;
  return doubled >= 0 ? doubled / (2 * divisor) : -((-doubled + 2 * divisor - 1) / (2 * divisor));
}

// Visits each sample once, with its prediction from those that were visited before.
class SampleOrder
{
public:
  explicit SampleOrder(const MicroMesh& mesh)
    : Mesh(mesh)
    , AreVisited(mesh.Samples.size(), 0)
  {
  }

  // Calls visit(sample, prediction).
  template <typename Visitor>
  void Visit(const Visitor& visit)
  {
    for (int level = 1; level <= LargestMicroLevel; ++level)
    {
      for (const MicroMesh::Edge& edge : this->Mesh.Edges)
      {
        for (int k = 1; k < 1 << level && level <= edge.Level; k += 2)
        {
          const int sample = edge.First + (k << (edge.Level - level)) - 1;
          this->VisitSample(
            sample, [&] { return this->PredictOnEdge(edge, level, k); }, visit);
        }
      }
      for (const MicroMesh::Face& face : this->Mesh.Faces)
      {
        if (level <= face.Level)
        {
          this->VisitInner(face, level, visit);
        }
      }
    }
    for (std::size_t i = 0; i < this->AreVisited.size(); ++i) // of no edge or face
    {
      this->VisitSample(
        static_cast<int>(i), [] { return 0; }, visit);
    }
  }

private:
  template <typename Predict, typename Visitor>
  void VisitSample(int sample, const Predict& predict, const Visitor& visit)
  {
    char& isVisited = this->AreVisited[static_cast<std::size_t>(sample)];
    if (isVisited == 0)
    {
      visit(sample, predict());
      isVisited = 1;
    }
  }

  template <typename Visitor>
  void VisitInner(const MicroMesh::Face& face, int level, const Visitor& visit)
  {
    const int stride = 1 << (face.Level - level);
    const int n = 1 << face.Level;
    ForEachGridPoint(1 << level,
      [&](const GridPoint& point)
      {
        const bool isOld = (point[0] & 1) == 0 && (point[1] & 1) == 0 && (point[2] & 1) == 0;
        if (!isOld && GetGridEdge(point) < 0)
        {
          const GridPoint place{ { point[0] * stride, point[1] * stride, point[2] * stride } };
          this->VisitSample(
            face.FirstInner + GetInnerIndex(n, place),
            [&] { return this->PredictInside(face, level, point); }, visit);
        }
      });
  }

  int GetSample(int sample) const { return this->Mesh.Samples[static_cast<std::size_t>(sample)]; }

  // The displacement at place k of an edge with 2^level segments; 0 beyond its ends.
  int GetOnEdge(const MicroMesh::Edge& edge, int level, int k) const
  {
    return k <= 0 || k >= 1 << level
      ? 0
      : this->GetSample(edge.First + (k << (edge.Level - level)) - 1);
  }

  int PredictOnEdge(const MicroMesh::Edge& edge, int level, int k) const
  {
    return DivideRounded(
      this->GetOnEdge(edge, level, k - 1) + this->GetOnEdge(edge, level, k + 1), 2);
  }

  // The displacement at a point of the grid with 2^level segments. Between samples of an edge, it
  // is linear.
  int GetInside(const MicroMesh::Face& face, int level, const GridPoint& point) const
  {
    const int n = 1 << level;
    for (int number : point)
    {
      if (number == n)
      {
        return 0;
      }
    }
    const int stride = 1 << (face.Level - level);
    const GridPoint place{ { point[0] * stride, point[1] * stride, point[2] * stride } };
    const int e = GetGridEdge(point);
    if (e < 0)
    {
      return this->GetSample(face.FirstInner + GetInnerIndex(n * stride, place));
    }
    const MicroMesh::Edge& edge = this->Mesh.Edges[static_cast<std::size_t>(face.Edges[e] >> 1)];
    const int along = (face.Edges[e] & 1) != 0 ? place[e] : place[(e + 1) % 3];
    const int segment = 1 << (face.Level - edge.Level);
    const int k = along / segment;
    const int rest = along % segment;
    const int before = this->GetOnEdge(edge, edge.Level, k);
    const int after = rest == 0 ? 0 : this->GetOnEdge(edge, edge.Level, k + 1);
    return DivideRounded(before * (segment - rest) + after * rest, segment);
  }

  int PredictInside(const MicroMesh::Face& face, int level, const GridPoint& point) const
  {
    // Two numbers are odd. The point is in the middle between two points of the lower level.
    const int even = (point[0] & 1) == 0 ? 0 : ((point[1] & 1) == 0 ? 1 : 2);
    GridPoint ends[2] = { point, point };
    for (int end = 0; end < 2; ++end)
    {
      ends[end][(even + 1) % 3] += 2 * end - 1;
      ends[end][(even + 2) % 3] += 1 - 2 * end;
    }
    return DivideRounded(
      this->GetInside(face, level, ends[0]) + this->GetInside(face, level, ends[1]), 2);
  }

  const MicroMesh& Mesh;
  std::vector<char> AreVisited;
};
}

std::string PackSamples(const MicroMesh& mesh)
{
  std::vector<std::uint64_t> numbers;
  numbers.reserve(mesh.Samples.size());
  SampleOrder(mesh).Visit(
    [&](int sample, int prediction)
    {
      const auto difference = static_cast<std::int16_t>(
        static_cast<std::uint16_t>(mesh.Samples[static_cast<std::size_t>(sample)] - prediction));
      const int magnitude = difference < 0 ? -1 - difference : difference;
      numbers.push_back(static_cast<std::uint64_t>(2 * magnitude + (difference < 0 ? 1 : 0)));
    });
  std::string bytes;
  PackNumbers(numbers, BitsOfSample, bytes);
  return bytes;
}

void UnpackSamples(std::string_view bytes, MicroMesh& mesh)
{
  std::vector<std::uint64_t> numbers(mesh.Samples.size());
  UnpackNumbers(bytes, BitsOfSample, numbers);
  std::size_t place = 0;
  SampleOrder(mesh).Visit(
    [&](int sample, int prediction)
    {
      const auto magnitude = static_cast<int>(numbers[place] >> 1);
      const int difference = (numbers[place] & 1) != 0 ? -1 - magnitude : magnitude;
      mesh.Samples[static_cast<std::size_t>(sample)] =
        static_cast<std::int16_t>(static_cast<std::uint16_t>(prediction + difference));
      ++place;
    });
}
}
