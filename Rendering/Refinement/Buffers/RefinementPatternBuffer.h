// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementPatternBuffer
 * @brief   the patterns in use, on the GPU
 *
 * Vertices, triangles of both windings and lines of every pattern a selection has needed so far,
 * in three buffers; patterns are appended when they are first needed. Private to the module and its
 * tests.
 */
#ifndef RefinementPatternBuffer_h
#define RefinementPatternBuffer_h

#include "Patterns/RefinementPattern.h"      // for RefinementPatterns
#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkNew.h"                          // for buffers
#include "vtkTimeStamp.h"                    // for UploadTime
#include "vtkType.h"                         // for vtkTypeInt64

#include <map>    // for members
#include <vector> // for members

class vtkOpenGLBufferObject;

namespace relevo
{
class PatternLibrary;
struct PatternGroup;

class RELEVORENDERINGREFINEMENT_EXPORT RefinementPatternBuffer
{
public:
  RefinementPatternBuffer();
  ~RefinementPatternBuffer();
  RefinementPatternBuffer(const RefinementPatternBuffer&) = delete;
  void operator=(const RefinementPatternBuffer&) = delete;

  /// Where a pattern lies in the buffers. Small patterns are repeated, so that one instance can
  /// draw several faces: instances of few vertices cost more than their vertices.
  struct Range
  {
    int Copies = 1;
    int FirstVertex = 0;
    int NumberOfVertices = 0; // of one copy, as all numbers here
    int FirstIndex = 0;       // triangles of all copies; those of all mirrored copies follow
    int NumberOfIndices = 0;
    int FirstLineVertex = 0;
    int NumberOfLineVertices = 0;
  };

  /**
   * Have all patterns of these groups, which are of a library, and their lines if asked for, on the
   * GPU.
   */
  void Load(const PatternLibrary& library, const std::vector<PatternGroup>& groups, bool withLines);

  const Range& GetRange(const PatternGroup& group) const;

  /// The patterns on the GPU, by number, at most 65536.
  const RefinementPatterns& GetPatterns() const { return this->Patterns; }

  /// (u, v, w, number of the copy + number of the pattern / 65536) of each vertex.
  vtkOpenGLBufferObject* GetVertices() { return this->VertexBuffer; }
  /// Unsigned short indices relative to a pattern's first vertex.
  vtkOpenGLBufferObject* GetTriangles() { return this->TriangleBuffer; }
  /// (u, v, w, e + number of the pattern / 65536) of each line's ends: e = 1, 2, 3 for lines on the
  /// pattern's edge e, else 0.
  vtkOpenGLBufferObject* GetLines() { return this->LineBuffer; }

  /// When the buffers last changed.
  vtkMTimeType GetUploadTime() const { return this->UploadTime; }

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();

private:
  //@{
  /// Add a pattern of that number, over 65536, to the buffers, and to its range where it lies.
  void AppendVertices(const RefinementPattern& pattern, float number, Range& range);
  void AppendTriangles(const RefinementPattern& pattern, Range& range);
  void AppendLines(const RefinementPattern& pattern, float number, Range& range);
  //@}

  std::map<const RefinementPattern*, Range> Ranges; // of Patterns
  RefinementPatterns Patterns;
  bool HasLines = false;
  vtkMTimeType LibraryTime = 0;
  std::vector<float> Vertices;
  std::vector<unsigned short> Triangles;
  std::vector<float> Lines;
  vtkNew<vtkOpenGLBufferObject> VertexBuffer;
  vtkNew<vtkOpenGLBufferObject> TriangleBuffer;
  vtkNew<vtkOpenGLBufferObject> LineBuffer;
  vtkTimeStamp UploadTime;
};
}

#endif
