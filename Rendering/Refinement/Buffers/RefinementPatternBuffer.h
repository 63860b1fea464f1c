// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementPatternBuffer
 * @brief   the patterns in use, on the GPU
 *
 * Three buffers contain the vertices, the triangles of both windings and the lines of all patterns
 * that selections have used. Patterns are appended when they are first needed. Private to the
 * module and its tests.
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

  /// The range of a pattern in the buffers. Small patterns are repeated, so that one instance draws
  /// several faces, because instances of few vertices are slow.
  struct Range
  {
    int Copies = 1;
    int FirstVertex = 0;
    int NumberOfVertices = 0; // of one copy, like the numbers below
    int FirstIndex = 0;       // triangles of all copies, followed by those of all mirrored copies
    int NumberOfIndices = 0;
    int FirstLineVertex = 0;
    int NumberOfLineVertices = 0;
  };

  /**
   * Upload all patterns of these groups from a library, with their lines on request.
   */
  void Load(const PatternLibrary& library, const std::vector<PatternGroup>& groups, bool withLines);

  const Range& GetRange(const PatternGroup& group) const;

  /// Return the patterns on the GPU, by number; there are at most 65536.
  const RefinementPatterns& GetPatterns() const { return this->Patterns; }

  /// Return the buffer of vertices: (u, v, w, index of the copy + number of the pattern / 65536).
  vtkOpenGLBufferObject* GetVertices() { return this->VertexBuffer; }
  /// Return the buffer of unsigned short indices relative to a pattern's first vertex.
  vtkOpenGLBufferObject* GetTriangles() { return this->TriangleBuffer; }
  /// Return the buffer of line ends: (u, v, w, e + number of the pattern / 65536), where e is 1, 2
  /// or 3 for lines on the pattern's edge e, otherwise 0.
  vtkOpenGLBufferObject* GetLines() { return this->LineBuffer; }

  /// Return when the buffers last changed.
  vtkMTimeType GetUploadTime() const { return this->UploadTime; }

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();

private:
  //@{
  /// Append a pattern with this number, divided by 65536, to the buffers, and set its range.
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
