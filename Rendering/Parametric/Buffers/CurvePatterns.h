// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvePatterns
 * @brief   how the vertices of curves of a number of segments are joined, on the GPU
 *
 * A curve of n segments has n + 1 rings of as many vertices as it has sides: 1 for a line, 2 for a
 * ribbon, 3 or more for a tube. Vertices are nothing but their numbers, ring after ring; patterns
 * are appended when they are first needed. Private to the module.
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
  /// What primitives are made of the vertices.
  enum Primitives
  {
    POINTS,
    LINES, // of a ribbon or tube the edges of its triangles
    TRIANGLES
  };

  /// What all patterns have in common. Those of others are forgotten.
  void SetShape(Primitives primitives, int sides);

  /// Of a curve of so many segments.
  const PatternRange& GetRange(int segments);
  static const void* GetOffset(const PatternRange& range) { return Patterns::GetOffset(range); }

  /// Upload what has been added, and bind the indices, unsigned shorts.
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
