// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainPatterns
 * @brief   the indices of the uniform pattern of terrain faces, on the GPU
 *
 * The index of vertex (a, b) is a + 16 * b, plus 256 for each further copy. Private to the module.
 */
#ifndef TerrainPatterns_h
#define TerrainPatterns_h

#include "Buffers/PatternRanges.h"
#include "vtkType.h" // for numbers of bytes

#include <utility> // for keys
#include <vector>  // for indices

namespace relevo
{
class TerrainPatterns
{
public:
  enum Primitives
  {
    POINTS,
    LINES, // the edges of the triangles
    TRIANGLES
  };

  /// Return the pattern; a mirrored one has triangles of the other orientation.
  const PatternRange& GetRange(Primitives primitives, bool isMirrored);
  static const void* GetOffset(const PatternRange& range) { return Patterns::GetOffset(range); }

  /// Upload the patterns and bind the indices (unsigned shorts). Return false if OpenGL lacks
  /// memory.
  bool Bind();
  void Release() { this->Ranges.Release(); }

  vtkTypeInt64 GetMemorySize() const { return this->Ranges.GetMemorySize(); }
  void ReleaseGraphicsResources() { this->Ranges.ReleaseGraphicsResources(); }

private:
  using Patterns = PatternRanges<std::pair<Primitives, bool>, unsigned short>;

  Patterns Ranges;
};
}

#endif
