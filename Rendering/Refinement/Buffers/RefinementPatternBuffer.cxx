// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementPatternBuffer.h"

#include "Evaluation/PatternSelection.h"
#include "Patterns/PatternLibrary.h"
#include "Patterns/RefinementPattern.h"
#include "vtkOpenGLBufferObject.h"

#include <algorithm>

namespace relevo
{
namespace
{
// The minimum number of vertices per instance.
constexpr int VerticesPerInstance = 512;
}

RefinementPatternBuffer::RefinementPatternBuffer()
{
  this->VertexBuffer->SetType(vtkOpenGLBufferObject::ArrayBuffer);
  this->TriangleBuffer->SetType(vtkOpenGLBufferObject::ElementArrayBuffer);
  this->LineBuffer->SetType(vtkOpenGLBufferObject::ArrayBuffer);
}

RefinementPatternBuffer::~RefinementPatternBuffer() = default;

const RefinementPatternBuffer::Range& RefinementPatternBuffer::GetRange(
  const PatternGroup& group) const
{
  return this->Ranges.at(group.Pattern.get());
}

void RefinementPatternBuffer::AppendVertices(
  const RefinementPattern& pattern, float number, Range& range)
{
  range.NumberOfVertices = pattern.GetNumberOfVertices();
  range.Copies = std::max(1, VerticesPerInstance / range.NumberOfVertices);
  range.FirstVertex = static_cast<int>(this->Vertices.size() / 4);
  for (int copy = 0; copy < range.Copies; ++copy)
  {
    for (size_t v = 0; v < pattern.Vertices.size(); v += 3)
    {
      this->Vertices.insert(this->Vertices.end(),
        { pattern.Vertices[v], pattern.Vertices[v + 1], pattern.Vertices[v + 2],
          static_cast<float>(copy) + number });
    }
  }
}

void RefinementPatternBuffer::AppendTriangles(const RefinementPattern& pattern, Range& range)
{
  range.NumberOfIndices = static_cast<int>(pattern.Triangles.size());
  range.FirstIndex = static_cast<int>(this->Triangles.size());
  for (bool mirrored : { false, true })
  {
    for (int copy = 0; copy < range.Copies; ++copy)
    {
      const unsigned int first = static_cast<unsigned int>(copy * range.NumberOfVertices);
      for (size_t i = 0; i < pattern.Triangles.size(); i += 3)
      {
        const unsigned int* v = &pattern.Triangles[i];
        for (unsigned int vertex : { v[0], v[mirrored ? 2 : 1], v[mirrored ? 1 : 2] })
        {
          this->Triangles.push_back(static_cast<unsigned short>(first + vertex));
        }
      }
    }
  }
}

void RefinementPatternBuffer::AppendLines(
  const RefinementPattern& pattern, float number, Range& range)
{
  range.FirstLineVertex = static_cast<int>(this->Lines.size() / 4);
  range.NumberOfLineVertices = static_cast<int>(pattern.Lines.size());
  // The segments of edges 1, 2 and 3 come first.
  int ends[3];
  for (int e = 0, end = 0; e < 3; ++e)
  {
    end += 2 * pattern.Segments[e];
    ends[e] = end;
  }
  for (int i = 0; i < range.NumberOfLineVertices; ++i)
  {
    const int edge = i < ends[0] ? 1 : (i < ends[1] ? 2 : (i < ends[2] ? 3 : 0));
    const float* vertex = &pattern.Vertices[3 * static_cast<size_t>(pattern.Lines[i])];
    this->Lines.insert(
      this->Lines.end(), { vertex[0], vertex[1], vertex[2], static_cast<float>(edge) + number });
  }
}

void RefinementPatternBuffer::Load(
  const PatternLibrary& library, const std::vector<PatternGroup>& groups, bool withLines)
{
  bool changed = false;
  if ((withLines && !this->HasLines) || this->LibraryTime != library.GetMTime())
  {
    this->HasLines = withLines || this->HasLines;
    this->LibraryTime = library.GetMTime();
    this->Ranges.clear();
    this->Patterns.clear();
    this->Vertices.clear();
    this->Triangles.clear();
    this->Lines.clear();
  }
  for (const PatternGroup& group : groups)
  {
    if (this->Ranges.count(group.Pattern.get()))
    {
      continue;
    }
    changed = true;
    const RefinementPattern& pattern = *group.Pattern;
    // A float represents both parts exactly.
    const float number = static_cast<float>(this->Patterns.size()) / 65536.0f;
    this->Patterns.push_back(group.Pattern);
    Range range;
    this->AppendVertices(pattern, number, range);
    this->AppendTriangles(pattern, range);
    if (this->HasLines)
    {
      this->AppendLines(pattern, number, range);
    }
    this->Ranges[group.Pattern.get()] = range;
  }
  if (changed)
  {
    this->VertexBuffer->Upload(this->Vertices, vtkOpenGLBufferObject::ArrayBuffer);
    this->TriangleBuffer->Upload(this->Triangles, vtkOpenGLBufferObject::ElementArrayBuffer);
    if (this->HasLines)
    {
      this->LineBuffer->Upload(this->Lines, vtkOpenGLBufferObject::ArrayBuffer);
    }
    this->UploadTime.Modified();
  }
}

vtkTypeInt64 RefinementPatternBuffer::GetMemorySize() const
{
  return static_cast<vtkTypeInt64>(this->Vertices.size() * sizeof(float) +
    this->Triangles.size() * sizeof(unsigned short) + this->Lines.size() * sizeof(float));
}

void RefinementPatternBuffer::ReleaseGraphicsResources()
{
  this->VertexBuffer->ReleaseGraphicsResources();
  this->TriangleBuffer->ReleaseGraphicsResources();
  this->LineBuffer->ReleaseGraphicsResources();
  this->Ranges.clear();
  this->Patterns.clear();
  this->Vertices.clear();
  this->Triangles.clear();
  this->Lines.clear();
  this->HasLines = false;
}
}
