// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PolyhedronSection.h"

#include <algorithm>

namespace relevo
{
namespace
{
int FindEdge(PolyhedronSection& section, int first, int second)
{
  const std::array<int, 2> edge{ std::min(first, second), std::max(first, second) };
  const auto known = std::find(section.Edges.begin(), section.Edges.end(), edge);
  if (known != section.Edges.end())
  {
    return static_cast<int>(known - section.Edges.begin());
  }
  section.Edges.push_back(edge);
  return static_cast<int>(section.Edges.size()) - 1;
}

// Each run of negative corners gets a segment.
void CutFace(const std::vector<int>& face, const std::vector<double>& values, int id,
  PolyhedronSection& section)
{
  const std::size_t size = face.size();
  const auto isNegative = [&](std::size_t i) { return values[face[i % size]] < 0.0; };
  for (std::size_t begin = 0; begin < size; ++begin)
  {
    if (isNegative(begin) || !isNegative(begin + 1))
    {
      continue;
    }
    std::size_t end = begin + 1;
    while (isNegative(end))
    {
      ++end;
    }
    const int first = FindEdge(section, face[begin], face[(begin + 1) % size]);
    const int last = FindEdge(section, face[(end - 1) % size], face[end % size]);
    section.Segments.push_back({ id, { { first, last } } });
  }
}

// Two faces meet at each edge, so that segments form closed polygons.
void JoinSegments(PolyhedronSection& section)
{
  std::vector<unsigned char> isUsed(section.Segments.size());
  const auto findNext = [&](int edge)
  {
    for (std::size_t i = 0; i < section.Segments.size(); ++i)
    {
      const FaceSegment& segment = section.Segments[i];
      if (!isUsed[i] && (segment.Edges[0] == edge || segment.Edges[1] == edge))
      {
        return static_cast<int>(i);
      }
    }
    return -1;
  };
  for (std::size_t i = 0; i < section.Segments.size(); ++i)
  {
    if (isUsed[i])
    {
      continue;
    }
    isUsed[i] = 1;
    const int start = section.Segments[i].Edges[0];
    int edge = section.Segments[i].Edges[1];
    std::vector<int> polygon{ start };
    while (edge != start)
    {
      polygon.push_back(edge);
      const int next = findNext(edge);
      if (next < 0)
      {
        polygon.clear();
        break;
      }
      isUsed[next] = 1;
      const std::array<int, 2>& ends = section.Segments[next].Edges;
      edge = ends[0] == edge ? ends[1] : ends[0];
    }
    if (polygon.size() >= 3)
    {
      section.Polygons.push_back(polygon);
    }
  }
}
}

PolyhedronSection CutPolyhedron(const PolyhedronFaces& faces, const std::vector<double>& values)
{
  PolyhedronSection section;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    CutFace(faces[i], values, static_cast<int>(i), section);
  }
  JoinSegments(section);
  return section;
}
}
