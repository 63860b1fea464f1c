// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LineTable
 * @brief   the lines at the vertices of a mesh, most of which have none
 */
#ifndef LineTable_h
#define LineTable_h

#include <cstddef> // for std::size_t
#include <vector>  // for members

namespace relevo
{
/// The other end of a line's edge at a vertex.
struct LineEnd
{
  int Vertex;
  unsigned char Flags; // of DenseMesh
};

class LineTable
{
public:
  using Ends = std::vector<LineEnd>;

  explicit LineTable(std::size_t vertices = 0)
    : Places(vertices, -1)
  {
  }

  const Ends& operator[](std::size_t vertex) const
  {
    static const Ends none;
    return this->Places[vertex] < 0 ? none
                                    : this->Lists[static_cast<std::size_t>(this->Places[vertex])];
  }
  /// The ends at a vertex that has any.
  Ends& Get(std::size_t vertex)
  {
    return this->Lists[static_cast<std::size_t>(this->Places[vertex])];
  }
  void Add(std::size_t vertex, const LineEnd& end)
  {
    if (this->Places[vertex] < 0)
    {
      this->Places[vertex] = static_cast<int>(this->Lists.size());
      this->Lists.emplace_back();
    }
    this->Get(vertex).push_back(end);
  }

private:
  std::vector<int> Places; // of lists, or -1
  std::vector<Ends> Lists;
};
}

#endif
