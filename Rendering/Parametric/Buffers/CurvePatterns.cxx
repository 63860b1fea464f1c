// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/CurvePatterns.h"

#include <initializer_list>

namespace relevo
{
void CurvePatterns::SetShape(Primitives primitives, int sides)
{
  if (this->Shape != primitives || this->Sides != sides)
  {
    this->Shape = primitives;
    this->Sides = sides;
    this->Ranges.Clear();
  }
}

const PatternRange& CurvePatterns::GetRange(int segments)
{
  const int vertices = this->Sides * (segments + 1);
  return this->Ranges.Require(segments, vertices, CountPatternCopies(vertices),
    [this, segments](std::vector<unsigned short>& indices, int firstVertex)
    { this->Append(indices, segments, firstVertex); });
}

void CurvePatterns::Append(
  std::vector<unsigned short>& indices, int segments, int firstVertex) const
{
  const auto add = [&](std::initializer_list<int> vertices)
  {
    for (int vertex : vertices)
    {
      indices.push_back(static_cast<unsigned short>(firstVertex + vertex));
    }
  };
  // A tube's last side is adjacent to its first.
  const int strips = this->Sides > 2 ? this->Sides : this->Sides - 1;
  // The centres of a tube's caps are not drawn as points.
  const int skipped = this->Sides > 2 && this->Shape != TRIANGLES ? 1 : 0;
  const int last = segments - skipped;
  for (int ring = skipped; ring <= last; ++ring)
  {
    const int first = ring * this->Sides;
    for (int side = 0; side < this->Sides; ++side)
    {
      const int a = first + side;
      const int b = first + (side + 1) % this->Sides;
      if (this->Shape == POINTS)
      {
        add({ a });
      }
      else if (this->Shape == LINES)
      {
        if (ring < last)
        {
          add({ a, a + this->Sides });
        }
        if (side < strips)
        {
          add({ a, b });
        }
        if (ring < last && side < strips)
        {
          add({ a, b + this->Sides });
        }
      }
      else if (ring < last && side < strips)
      {
        add({ a, b, b + this->Sides, a, b + this->Sides, a + this->Sides });
      }
    }
  }
}

void CurvePatterns::Bind()
{
  this->Ranges.Upload();
  this->Ranges.Bind();
}

void CurvePatterns::ReleaseGraphicsResources()
{
  this->Ranges.ReleaseGraphicsResources();
  this->Ranges.Clear();
}
}
