// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/TrianglePacking.h"

#include "Files/ArrayPacking.h"
#include "Files/LittleEndian.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

namespace relevo
{
namespace
{
enum Operation : char
{
  NEW,
  BEFORE,
  AFTER,
  POINT,
  SKIP,
  FREE
};

constexpr int BitsOfPoint = 32;
constexpr std::size_t SizeOfNumber = 8;
// To find the gate of a triangle.
constexpr std::size_t MostSkips = 64;
constexpr std::size_t MostGates = 256;

// The gates of the triangles so far, and the highest point.
class Gates
{
public:
  struct Gate
  {
    int From;
    int To;
  };

  // Removes closed gates from the top. Returns whether there is a gate.
  bool FindTop()
  {
    while (!this->Stack.empty() && !this->IsOpen(this->Stack.back()))
    {
      this->Stack.pop_back();
    }
    return !this->Stack.empty();
  }
  const Gate& GetTop() const { return this->Stack.back(); }
  void Skip() { this->Stack.pop_back(); }

  // How many open gates are above the one with these ends, or MostSkips.
  std::size_t FindDepth(int from, int to) const
  {
    std::size_t depth = 0;
    const std::size_t size = this->Stack.size();
    const std::size_t last = size > MostGates ? size - MostGates : 0;
    for (std::size_t i = size; i-- > last && depth < MostSkips;)
    {
      if (this->Stack[i].From == from && this->Stack[i].To == to)
      {
        return this->IsOpen(this->Stack[i]) ? depth : MostSkips;
      }
      depth += this->IsOpen(this->Stack[i]) ? 1 : 0;
    }
    return MostSkips;
  }

  // The ends of neighbouring gates, or -1. They can be closed.
  int GetBefore(const Gate& gate) const { return Find(this->Starts, gate.From); }
  int GetAfter(const Gate& gate) const { return Find(this->Ends, gate.To); }
  std::uint32_t GetNext() const { return this->Next; }

  void Add(const PackedTriangle& triangle)
  {
    // The edge from corner 1 to corner 2 is on the top.
    for (int e : { 0, 2, 1 })
    {
      const int from = triangle[static_cast<std::size_t>(e)];
      const int to = triangle[static_cast<std::size_t>((e + 1) % 3)];
      if (this->Open.erase(GetKey(from, to)) == 0)
      {
        // A triangle across the edge has it in the opposite direction.
        this->Stack.push_back({ to, from });
        this->Open.insert(GetKey(to, from));
        this->Ends[to] = from;
        this->Starts[from] = to;
      }
    }
    for (int point : triangle)
    {
      this->Next = std::max(this->Next, static_cast<std::uint32_t>(point) + 1u);
    }
  }

private:
  static std::uint64_t GetKey(int from, int to)
  {
    return std::uint64_t{ static_cast<std::uint32_t>(from) } << 32 | static_cast<std::uint32_t>(to);
  }
  static int Find(const std::unordered_map<int, int>& map, int key)
  {
    const auto found = map.find(key);
    return found == map.end() ? -1 : found->second;
  }
  bool IsOpen(const Gate& gate) const { return this->Open.count(GetKey(gate.From, gate.To)) != 0; }

  std::vector<Gate> Stack;
  std::unordered_set<std::uint64_t> Open;
  std::unordered_map<int, int> Ends;   // of the last gate that starts at a point
  std::unordered_map<int, int> Starts; // of the last gate that ends at a point
  std::uint32_t Next = 0;
};
}

std::string PackTriangles(const std::vector<PackedTriangle>& triangles)
{
  std::string operations;
  std::vector<std::uint64_t> points;
  Gates gates;
  const auto addPoint = [&](int point)
  { points.push_back(gates.GetNext() - static_cast<std::uint32_t>(point)); };
  for (const PackedTriangle& triangle : triangles)
  {
    std::size_t depth = gates.FindDepth(triangle[0], triangle[1]);
    for (; depth < MostSkips && depth > 0; --depth)
    {
      gates.FindTop();
      gates.Skip();
      operations.push_back(SKIP);
    }
    if (depth == MostSkips || !gates.FindTop())
    {
      operations.push_back(FREE);
      std::for_each(triangle.begin(), triangle.end(), addPoint);
    }
    else
    {
      const Gates::Gate gate = gates.GetTop();
      if (static_cast<std::uint32_t>(triangle[2]) == gates.GetNext())
      {
        operations.push_back(NEW);
      }
      else if (triangle[2] == gates.GetBefore(gate))
      {
        operations.push_back(BEFORE);
      }
      else if (triangle[2] == gates.GetAfter(gate))
      {
        operations.push_back(AFTER);
      }
      else
      {
        operations.push_back(POINT);
        addPoint(triangle[2]);
      }
    }
    gates.Add(triangle);
  }
  std::string bytes;
  AppendNumber(bytes, operations.size(), SizeOfNumber);
  bytes += operations;
  PackNumbers(points, BitsOfPoint, bytes);
  return bytes;
}

bool UnpackTriangles(
  std::string_view bytes, std::size_t number, std::vector<PackedTriangle>& triangles)
{
  const std::uint64_t size = TakeNumber(bytes, SizeOfNumber);
  constexpr std::size_t sizeOfPoint = BitsOfPoint / 8;
  if (size > bytes.size() || number > size || (bytes.size() - size) % sizeOfPoint != 0)
  {
    return false;
  }
  const std::string_view operations = bytes.substr(0, size);
  bytes.remove_prefix(size);
  std::vector<std::uint64_t> points(bytes.size() / sizeOfPoint);
  UnpackNumbers(bytes, BitsOfPoint, points);
  std::size_t place = 0;
  Gates gates;
  const auto takePoint = [&]
  {
    const std::uint64_t point = place < points.size() ? points[place] : 0;
    ++place;
    return static_cast<int>(gates.GetNext() - static_cast<std::uint32_t>(point));
  };
  for (char operation : operations)
  {
    PackedTriangle triangle{};
    if (operation == FREE)
    {
      std::generate(triangle.begin(), triangle.end(), takePoint);
    }
    else if (!gates.FindTop())
    {
      return false;
    }
    else if (operation == SKIP)
    {
      gates.Skip();
      continue;
    }
    else
    {
      const Gates::Gate gate = gates.GetTop();
      triangle = { { gate.From, gate.To,
        operation == NEW        ? static_cast<int>(gates.GetNext())
          : operation == BEFORE ? gates.GetBefore(gate)
          : operation == AFTER  ? gates.GetAfter(gate)
                                : takePoint() } };
    }
    triangles.push_back(triangle);
    gates.Add(triangle);
  }
  return triangles.size() == number && place == points.size();
}
}
