// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/CurvePatterns.h"

#include "vtkOpenGLBufferObject.h"

#include <algorithm>

namespace relevo
{
namespace
{
// How many vertices an instance should have at least.
constexpr int VerticesPerInstance = 512;
}

CurvePatterns::CurvePatterns()
{
  this->Buffer->SetType(vtkOpenGLBufferObject::ElementArrayBuffer);
}

CurvePatterns::~CurvePatterns() = default;

void CurvePatterns::SetShape(Primitives primitives, int sides)
{
  if (this->Shape != primitives || this->Sides != sides)
  {
    this->Shape = primitives;
    this->Sides = sides;
    this->Ranges.clear();
    this->Indices.clear();
    this->NumberUploaded = 0;
  }
}

const CurvePatterns::Range& CurvePatterns::GetRange(int segments)
{
  const auto found = this->Ranges.find(segments);
  if (found != this->Ranges.end())
  {
    return found->second;
  }
  Range& range = this->Ranges[segments];
  const int vertices = this->Sides * (segments + 1);
  range.Copies = std::max(1, VerticesPerInstance / vertices);
  range.FirstIndex = static_cast<int>(this->Indices.size());
  for (int copy = 0; copy < range.Copies; ++copy)
  {
    this->Append(segments, copy * vertices);
  }
  const int end = static_cast<int>(this->Indices.size());
  range.NumberOfIndices = (end - range.FirstIndex) / range.Copies;
  return range;
}

void CurvePatterns::Append(int segments, int firstVertex)
{
  const auto add = [&](std::initializer_list<int> vertices)
  {
    for (int vertex : vertices)
    {
      this->Indices.push_back(static_cast<unsigned short>(firstVertex + vertex));
    }
  };
  // A tube's last side is next to its first one.
  const int strips = this->Sides > 2 ? this->Sides : this->Sides - 1;
  // The middles of a tube's caps are nothing to be seen by themselves.
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
  if (this->NumberUploaded != this->Indices.size())
  {
    this->Buffer->Upload(this->Indices, vtkOpenGLBufferObject::ElementArrayBuffer);
    this->NumberUploaded = this->Indices.size();
  }
  this->Buffer->Bind();
}

void CurvePatterns::Release()
{
  this->Buffer->Release();
}

vtkTypeInt64 CurvePatterns::GetMemorySize() const
{
  return static_cast<vtkTypeInt64>(this->Indices.size() * sizeof(unsigned short));
}

void CurvePatterns::ReleaseGraphicsResources()
{
  this->Buffer->ReleaseGraphicsResources();
  this->Ranges.clear();
  this->Indices.clear();
  this->NumberUploaded = 0;
}
}
