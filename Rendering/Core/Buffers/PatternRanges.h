// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternRanges
 * @brief   the indices of all patterns in one buffer on the GPU, and the range of each pattern
 *
 * Patterns are appended when they are first needed. Small ones are repeated, so that one instance
 * draws several faces or curves, because instances of few vertices are slow. Private to the
 * modules.
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

/// Return the number of copies of a pattern that make an instance large enough.
inline int CountPatternCopies(int numberOfVertices)
{
  constexpr int verticesPerInstance = 512;
  return std::max(1, verticesPerInstance / numberOfVertices);
}

/// The number of instances for a number of faces or curves, and the copies of the pattern in each.
struct InstanceCounts
{
  int Instances;
  int Copies;
};

/// Return as few instances as possible, and then as few copies, of which the pattern has `copies`.
inline InstanceCounts CountInstances(int members, int copies)
{
  const int instances = (members + copies - 1) / copies;
  return { instances, (members + instances - 1) / instances };
}

template <typename Key, typename Index>
class PatternRanges
{
public:
  using Ranges = std::map<Key, PatternRange>;

  PatternRanges() { this->Buffer->SetType(vtkOpenGLBufferObject::ElementArrayBuffer); }

  /**
   * Return the range of a pattern. For a new pattern, append(indices, vertex) is called for each
   * copy; `vertex` is the copy's first vertex, counted from the first of the range.
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

  /// Return the ranges by key.
  const Ranges& GetRanges() const { return this->All; }
  bool IsEmpty() const { return this->All.empty(); }

  /// Return the offset of a range's indices in the buffer, as an argument of OpenGL's draw calls.
  static const void* GetOffset(const PatternRange& range)
  {
    return reinterpret_cast<const void*>(static_cast<size_t>(range.FirstIndex) * sizeof(Index));
  }

  /// Return whether all indices have been uploaded.
  bool IsUploaded() const { return this->NumberUploaded == this->Indices.size(); }
  /// Upload the indices appended since the last upload. Return false if OpenGL lacks memory.
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

  /// Release the buffer. The ranges stay, and the next upload contains all of them.
  void ReleaseGraphicsResources()
  {
    this->Buffer->ReleaseGraphicsResources();
    this->NumberUploaded = 0;
  }

  /// Remove all patterns.
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
