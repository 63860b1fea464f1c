// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/JoinedLines.h"

#include "Mathematics/DisjointSets.h"

#include <unordered_map>

namespace relevo
{
namespace
{
class Joiner
{
public:
  Joiner(const std::vector<CurveSegments::Segment>& segments, vtkIdType numberOfPoints)
    : Segments(segments)
    , Starts(numberOfPoints + 1, 0)
    , Uses(2 * segments.size())
    , AreTaken(segments.size(), 0)
  {
    for (const auto& segment : segments)
    {
      ++this->Starts[segment.Points[0] + 1];
      ++this->Starts[segment.Points[1] + 1];
    }
    for (vtkIdType point = 0; point < numberOfPoints; ++point)
    {
      this->Starts[point + 1] += this->Starts[point];
    }
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      this->Uses[next[segments[s].Points[0]]++] = s;
      this->Uses[next[segments[s].Points[1]]++] = s;
    }
  }

  std::vector<JoinedLine> Join()
  {
    std::vector<JoinedLine> lines;
    // Segments that remain after the open lines form closed lines.
    for (const bool isClosed : { false, true })
    {
      for (std::size_t s = 0; s < this->Segments.size(); ++s)
      {
        for (vtkIdType end : this->Segments[s].Points)
        {
          if (this->AreTaken[s] == 0 && (isClosed || !this->IsPassed(end)))
          {
            lines.push_back(this->Follow(end, s));
          }
        }
      }
    }
    return lines;
  }

private:
  bool IsPassed(vtkIdType point) const
  {
    return this->Starts[point + 1] - this->Starts[point] == 2;
  }

  JoinedLine Follow(vtkIdType start, std::size_t segment)
  {
    JoinedLine line;
    line.Points.push_back(start);
    vtkIdType end = start;
    do
    {
      this->AreTaken[segment] = 1;
      line.Segments.push_back(segment);
      const auto& ends = this->Segments[segment].Points;
      end = ends[0] == end ? ends[1] : ends[0];
      line.Points.push_back(end);
      const std::size_t first = this->Starts[end];
      if (!this->IsPassed(end))
      {
        break;
      }
      segment = this->Uses[first] == segment ? this->Uses[first + 1] : this->Uses[first];
    } while (this->AreTaken[segment] == 0);
    return line;
  }

  const std::vector<CurveSegments::Segment>& Segments;
  std::vector<std::size_t> Starts; // index into Uses for each point
  std::vector<std::size_t> Uses;   // segments
  std::vector<unsigned char> AreTaken;
};
}

std::vector<JoinedLine> JoinSegments(
  const std::vector<CurveSegments::Segment>& segments, vtkIdType numberOfPoints)
{
  return Joiner(segments, numberOfPoints).Join();
}

std::vector<vtkIdType> FindComponents(
  const std::vector<JoinedLine>& lines, vtkIdType numberOfPoints)
{
  DisjointSets sets(numberOfPoints);
  for (const JoinedLine& line : lines)
  {
    for (vtkIdType point : line.Points)
    {
      sets.Unite(line.Points.front(), point);
    }
  }
  std::unordered_map<vtkIdType, vtkIdType> numbers;
  std::vector<vtkIdType> components;
  for (const JoinedLine& line : lines)
  {
    const vtkIdType set = sets.Find(line.Points.front());
    components.push_back(
      numbers.emplace(set, static_cast<vtkIdType>(numbers.size())).first->second);
  }
  return components;
}
}
