// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternVertexOrder.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace
{
using namespace relevo;

/// The position of a cell on the Hilbert curve through a grid of 2^bits x 2^bits cells.
std::uint32_t HilbertIndex(std::uint32_t x, std::uint32_t y, int bits)
{
  std::uint32_t index = 0;
  for (std::uint32_t s = 1u << (bits - 1); s > 0; s /= 2)
  {
    const std::uint32_t rx = (x & s) ? 1 : 0;
    const std::uint32_t ry = (y & s) ? 1 : 0;
    index += s * s * ((3 * rx) ^ ry);
    if (ry == 0)
    {
      if (rx == 1)
      {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

void OrderTriangles(PatternMesh& mesh)
{
  constexpr int bits = 12; // cells much smaller than the finest triangles, which are 1/128 wide
  constexpr std::int64_t cell = 3 * WeightScale >> bits; // in sums of three corners
  std::vector<std::pair<std::uint32_t, std::array<int, 3>>> order;
  order.reserve(mesh.Triangles.size());
  for (const auto& triangle : mesh.Triangles)
  {
    std::int64_t v = 0;
    std::int64_t w = 0;
    for (int vertex : triangle)
    {
      v += mesh.Vertices[vertex][1];
      w += mesh.Vertices[vertex][2];
    }
    order.push_back({ HilbertIndex(static_cast<std::uint32_t>(v / cell),
                        static_cast<std::uint32_t>(w / cell), bits),
      triangle });
  }
  std::sort(order.begin(), order.end());
  std::transform(order.begin(), order.end(), mesh.Triangles.begin(),
    [](const auto& entry) { return entry.second; });
}

void OrderInnerVertices(PatternMesh& mesh, int numberOfBorderVertices)
{
  constexpr int unused = -1;
  std::vector<int> numbers(mesh.Vertices.size(), unused);
  std::vector<PatternWeights> vertices(
    mesh.Vertices.begin(), mesh.Vertices.begin() + numberOfBorderVertices);
  for (auto& triangle : mesh.Triangles)
  {
    for (int& vertex : triangle)
    {
      if (vertex < numberOfBorderVertices)
      {
        continue;
      }
      int& number = numbers[vertex];
      if (number == unused)
      {
        number = static_cast<int>(vertices.size());
        vertices.push_back(mesh.Vertices[vertex]);
      }
      vertex = number;
    }
  }
  mesh.Vertices.swap(vertices);
}
}

namespace relevo
{
void OrderForCache(PatternMesh& mesh, int numberOfBorderVertices)
{
  OrderTriangles(mesh);
  OrderInnerVertices(mesh, numberOfBorderVertices);
}
}
