// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvePatterns
 * @brief   the indices of curves by their number of segments, on the GPU
 *
 * A curve of n segments has n + 1 rings of vertices, with one vertex per side: 1 for a line, 2 for
 * a ribbon, 3 or more for a tube. A vertex is an index, counted ring by ring. Patterns are appended
 * when they are first needed. Private to the module.
 */
#ifndef CurvePatterns_h
#define CurvePatterns_h

#include "Buffers/PatternRanges.h"
#include "vtkType.h" // for vtkTypeInt64

#include <vector> // for indices

namespace relevo
{
class CurvePatterns
{
  using Patterns = PatternRanges<int, unsigned short>;

public:
  /// The primitives of the vertices.
  enum Primitives
  {
    POINTS,
    LINES, // of a ribbon or tube the edges of its triangles
    TRIANGLES
  };

  /// Set the properties of all patterns; patterns with other properties are removed.
  void SetShape(Primitives primitives, int sides);

  /// Return the range of a curve with this number of segments.
  const PatternRange& GetRange(int segments);
  static const void* GetOffset(const PatternRange& range) { return Patterns::GetOffset(range); }

  /// Upload the appended patterns, and bind the indices (unsigned shorts).
  void Bind();
  void Release() { this->Ranges.Release(); }

  int GetSides() const { return this->Sides; }
  vtkTypeInt64 GetMemorySize() const { return this->Ranges.GetMemorySize(); }
  void ReleaseGraphicsResources();

private:
  void Append(std::vector<unsigned short>& indices, int segments, int firstVertex) const;

  Primitives Shape = LINES;
  int Sides = 1;
  Patterns Ranges; // by the number of segments
};
}

#endif
