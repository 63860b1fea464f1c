// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/NumberPrediction.h"

#include "Data/MicroGrid.h"
#include "Files/ArrayPacking.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace relevo
{
namespace
{
constexpr int BitsOfNumber = 8 * SizeOfPackedNumber;

// Arithmetic without overflow, for damaged files.
int Add(int a, int b)
{
  return static_cast<int>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

int Subtract(int a, int b)
{
  return static_cast<int>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

int GetSegments(int level)
{
  return 1 << (level >= 0 && level <= LargestMicroLevel ? level : 0);
}

int CountInner(int level)
{
  const int n = GetSegments(level);
  return n > 1 ? GetNumberOfInnerPoints(n) : 0;
}

// Predicts the numbers of faces, one number after the other.
class FacePredictor
{
public:
  FacePredictor(const std::vector<PackedTriangle>& triangles, const std::vector<EdgeNumbers>& edges)
    : Triangles(triangles)
    , Edges(edges)
    , FirstInner(edges.empty() ? 0 : Add(edges.back()[0], GetSegments(edges.back()[1]) - 1))
  {
  }

  int Predict(std::size_t face, std::size_t number, const FaceNumbers& before) const
  {
    if (number < 3)
    {
      const auto found = this->Sides.find(this->GetSide(face, (number + 1) % 3, number));
      return found != this->Sides.end() ? found->second ^ 1 : Add(this->Highest | 1, 1);
    }
    return number == 3 ? this->FirstInner : this->GetLevel(before);
  }

  void Take(std::size_t face, const FaceNumbers& numbers, std::size_t number)
  {
    if (number < 3)
    {
      this->Sides[this->GetSide(face, number, (number + 1) % 3)] = numbers[number];
      this->Highest = std::max(this->Highest, numbers[number]);
    }
    else if (number == 4)
    {
      this->FirstInner = Add(numbers[3], CountInner(numbers[4]));
    }
  }

private:
  std::uint64_t GetSide(std::size_t face, std::size_t from, std::size_t to) const
  {
    return std::uint64_t{ static_cast<std::uint32_t>(this->Triangles[face][from]) } << 32 |
      static_cast<std::uint32_t>(this->Triangles[face][to]);
  }

  int GetLevel(const FaceNumbers& numbers) const
  {
    int level = 0;
    for (std::size_t e = 0; e < 3; ++e)
    {
      const auto edge = static_cast<std::size_t>(std::max(numbers[e], 0) >> 1);
      level = edge < this->Edges.size() ? std::max(level, this->Edges[edge][1]) : level;
    }
    return level;
  }

  const std::vector<PackedTriangle>& Triangles;
  const std::vector<EdgeNumbers>& Edges;
  std::unordered_map<std::uint64_t, int> Sides;
  int Highest = -1;
  int FirstInner;
};

void PackDifferences(const std::vector<std::uint64_t>& differences, std::string& bytes)
{
  PackNumbers(differences, BitsOfNumber, bytes);
}

std::uint64_t GetDifference(int value, int prediction)
{
  return static_cast<std::uint32_t>(Subtract(value, prediction));
}

int PredictFirst(const std::vector<EdgeNumbers>& edges, std::size_t edge)
{
  return edge == 0 ? 0 : Add(edges[edge - 1][0], GetSegments(edges[edge - 1][1]) - 1);
}
}

std::string PackEdgeNumbers(const std::vector<EdgeNumbers>& edges)
{
  std::vector<std::uint64_t> firsts;
  std::vector<std::uint64_t> levels;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    firsts.push_back(GetDifference(edges[e][0], PredictFirst(edges, e)));
    levels.push_back(GetDifference(edges[e][1], 0));
  }
  std::string bytes;
  PackDifferences(levels, bytes);
  PackDifferences(firsts, bytes);
  return bytes;
}

void UnpackEdgeNumbers(std::string_view bytes, std::vector<EdgeNumbers>& edges)
{
  std::vector<std::uint64_t> levels(edges.size());
  std::vector<std::uint64_t> firsts(edges.size());
  UnpackNumbers(bytes, BitsOfNumber, levels);
  UnpackNumbers(bytes, BitsOfNumber, firsts);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    edges[e][1] = static_cast<int>(levels[e]);
    edges[e][0] = Add(static_cast<int>(firsts[e]), PredictFirst(edges, e));
  }
}

std::string PackFaceNumbers(const std::vector<FaceNumbers>& faces,
  const std::vector<PackedTriangle>& triangles, const std::vector<EdgeNumbers>& edges)
{
  FacePredictor predictor(triangles, edges);
  std::array<std::vector<std::uint64_t>, std::tuple_size<FaceNumbers>::value> differences;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (std::size_t i = 0; i < differences.size(); ++i)
    {
      differences[i].push_back(GetDifference(faces[f][i], predictor.Predict(f, i, faces[f])));
      predictor.Take(f, faces[f], i);
    }
  }
  std::string bytes;
  for (const std::vector<std::uint64_t>& ofNumber : differences)
  {
    PackDifferences(ofNumber, bytes);
  }
  return bytes;
}

void UnpackFaceNumbers(std::string_view bytes, const std::vector<PackedTriangle>& triangles,
  const std::vector<EdgeNumbers>& edges, std::vector<FaceNumbers>& faces)
{
  FacePredictor predictor(triangles, edges);
  std::array<std::vector<std::uint64_t>, std::tuple_size<FaceNumbers>::value> differences;
  for (std::vector<std::uint64_t>& ofNumber : differences)
  {
    ofNumber.resize(faces.size());
    UnpackNumbers(bytes, BitsOfNumber, ofNumber);
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (std::size_t i = 0; i < differences.size(); ++i)
    {
      faces[f][i] = Add(static_cast<int>(differences[i][f]), predictor.Predict(f, i, faces[f]));
      predictor.Take(f, faces[f], i);
    }
  }
}
}
