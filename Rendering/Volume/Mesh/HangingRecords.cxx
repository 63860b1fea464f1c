// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HangingRecords.h"

#include "Mesh/CurvedRecords.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr size_t WordsOfBlock = 4;
}

HangingRecords::HangingRecords(
  const HangingFaces& faces, const std::vector<int>& places, std::vector<std::uint32_t>& words)
  : Faces(faces)
  , Places(places)
  , Words(words)
{
  if (this->Words.empty()) // no list has the address 0
  {
    this->Words.resize(WordsOfBlock);
  }
}

int HangingRecords::GetPlace(std::uint32_t point) const
{
  return this->Places.empty() ? static_cast<int>(point) : this->Places[point];
}

std::vector<int> HangingRecords::GetPoints(std::uint32_t a, std::uint32_t b) const
{
  return this->Faces.GetPoints(this->GetPlace(a), this->GetPlace(b));
}

bool HangingRecords::HasPoints(const std::array<std::uint32_t, 4>& tetrahedron) const
{
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      if (!this->GetPoints(tetrahedron[i], tetrahedron[j]).empty())
      {
        return true;
      }
    }
  }
  return false;
}

std::uint32_t HangingRecords::Append(const std::vector<std::uint32_t>& list)
{
  const auto address = static_cast<std::uint32_t>(this->Words.size() / WordsOfBlock);
  this->Words.insert(this->Words.end(), list.begin(), list.end());
  this->Words.resize((this->Words.size() + WordsOfBlock - 1) / WordsOfBlock * WordsOfBlock);
  return address;
}

std::uint32_t HangingRecords::AddEdges(const std::array<std::uint32_t, 8>& corners)
{
  std::vector<std::uint32_t> list(NumberOfRecordEdges, 0);
  bool hasPoints = false;
  for (int edge = 0; edge < NumberOfRecordEdges; ++edge)
  {
    const auto ends = GetRecordEdge(edge);
    const std::vector<int> points = this->GetPoints(corners[ends[0]], corners[ends[1]]);
    if (!points.empty())
    {
      std::vector<std::uint32_t> chain = { static_cast<std::uint32_t>(points.size()) };
      chain.insert(chain.end(), points.begin(), points.end());
      list[edge] = this->Append(chain);
      hasPoints = true;
    }
  }
  return hasPoints ? this->Append(list) : 0;
}

std::uint32_t HangingRecords::AddParts(const std::vector<Part>& parts)
{
  std::vector<std::uint32_t> list = { static_cast<std::uint32_t>(parts.size()) };
  for (const Part& part : parts)
  {
    list.push_back(part.Neighbor);
    const size_t count = list.size();
    list.push_back(0);
    for (size_t i = 0; i < part.Corners.size(); ++i)
    {
      const auto corner = static_cast<std::uint32_t>(part.Corners[i]);
      const auto next = static_cast<std::uint32_t>(part.Corners[(i + 1) % part.Corners.size()]);
      list.push_back(corner);
      const std::vector<int> points = this->GetPoints(corner, next);
      list.insert(list.end(), points.begin(), points.end());
    }
    list[count] = static_cast<std::uint32_t>(list.size() - count - 1);
  }
  return this->Append(list);
}
}
