// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternRanges
 * @brief   the indices of patterns in one buffer on the GPU, and where each pattern lies in it
 *
 * Patterns are appended when they are first needed. Small ones are repeated, so that one instance
 * can draw several faces or curves: instances of few vertices cost more than their vertices.
 * Private to the modules.
 */
#ifndef PatternRanges_h
#define PatternRanges_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace relevo
{
struct PatternRange
{
  int Copies = 1;
  int FirstVertex = 0;
  int NumberOfVertices = 0; // of one copy
  int FirstIndex = 0;
  int NumberOfIndices = 0; // of one copy
};

/// Copies of a pattern that make an instance large enough.
inline int CountPatternCopies(int numberOfVertices)
{
  constexpr int verticesPerInstance = 512;
  return std::max(1, verticesPerInstance / numberOfVertices);
}

template <typename Key, typename Index>
class PatternRanges
{
public:
  using Ranges = std::map<Key, PatternRange>;

  PatternRanges() { this->Buffer->SetType(vtkOpenGLBufferObject::ElementArrayBuffer); }

  /**
   * The range of a pattern. That of a new one is made by calling append(indices, vertex) for each
   * copy, whose first vertex is `vertex`, counted from the range's first.
   */
  template <typename Append>
  const PatternRange& Require(
    const Key& key, int numberOfVertices, int copies, const Append& append)
  {
    const auto found = this->All.find(key);
    if (found != this->All.end())
    {
      return found->second;
    }
    PatternRange range;
    range.Copies = copies;
    range.FirstVertex = this->NumberOfVertices;
    range.NumberOfVertices = numberOfVertices;
    range.FirstIndex = static_cast<int>(this->Indices.size());
    for (int copy = 0; copy < copies; ++copy)
    {
      append(this->Indices, copy * numberOfVertices);
    }
    const int end = static_cast<int>(this->Indices.size());
    range.NumberOfIndices = (end - range.FirstIndex) / copies;
    this->NumberOfVertices += copies * numberOfVertices;
    return this->All[key] = range;
  }

  /// By key.
  const Ranges& GetRanges() const { return this->All; }
  bool IsEmpty() const { return this->All.empty(); }

  /// Where a range's indices start in the buffer, as OpenGL's draw calls take it.
  static const void* GetOffset(const PatternRange& range)
  {
    return reinterpret_cast<const void*>(static_cast<size_t>(range.FirstIndex) * sizeof(Index));
  }

  /// Whether the GPU has all indices.
  bool IsUploaded() const { return this->NumberUploaded == this->Indices.size(); }
  /// Upload what has been appended. False where OpenGL has no room for it.
  bool Upload()
  {
    if (!this->IsUploaded())
    {
      if (!this->Buffer->Upload(this->Indices, vtkOpenGLBufferObject::ElementArrayBuffer))
      {
        return false;
      }
      this->NumberUploaded = this->Indices.size();
    }
    return true;
  }
  void Bind() { this->Buffer->Bind(); }
  void Release() { this->Buffer->Release(); }

  vtkTypeInt64 GetMemorySize() const
  {
    return static_cast<vtkTypeInt64>(this->NumberUploaded * sizeof(Index));
  }

  /// The ranges stay; the next upload is of all of them.
  void ReleaseGraphicsResources()
  {
    this->Buffer->ReleaseGraphicsResources();
    this->NumberUploaded = 0;
  }

  /// Forget all patterns.
  void Clear()
  {
    this->All.clear();
    this->Indices.clear();
    this->NumberOfVertices = 0;
    this->NumberUploaded = 0;
  }

private:
  Ranges All;
  std::vector<Index> Indices;
  int NumberOfVertices = 0; // of all ranges
  size_t NumberUploaded = 0;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};
}

#endif
