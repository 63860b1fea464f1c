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

#include "vtkNew.h"  // for Buffer
#include "vtkType.h" // for vtkTypeInt64

#include <map>    // for members
#include <vector> // for members

class vtkOpenGLBufferObject;

namespace relevo
{
class CurvePatterns
{
public:
  CurvePatterns();
  ~CurvePatterns();
  CurvePatterns(const CurvePatterns&) = delete;
  void operator=(const CurvePatterns&) = delete;

  /// What primitives are made of the vertices.
  enum Primitives
  {
    POINTS,
    LINES, // of a ribbon or tube the edges of its triangles
    TRIANGLES
  };

  /// What all patterns have in common. Those of others are forgotten.
  void SetShape(Primitives primitives, int sides);

  /// Where a pattern lies in the buffer. Small patterns are repeated, so that one instance can draw
  /// several curves: instances of few vertices cost more than their vertices.
  struct Range
  {
    int Copies = 1;
    int FirstIndex = 0;
    int NumberOfIndices = 0; // of one copy
  };
  const Range& GetRange(int segments);

  /// Upload what has been added, and bind the indices, unsigned shorts.
  void Bind();
  void Release();

  int GetSides() const { return this->Sides; }
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();

private:
  void Append(int segments, int firstVertex);

  Primitives Shape = LINES;
  int Sides = 1;
  std::map<int, Range> Ranges; // by the number of segments
  std::vector<unsigned short> Indices;
  size_t NumberUploaded = 0;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};
}

#endif
