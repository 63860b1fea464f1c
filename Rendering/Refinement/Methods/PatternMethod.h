// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternMethod
 * @brief   the base of methods whose vertices are those of patterns (RefinementPatternBuffer)
 */
#ifndef PatternMethod_h
#define PatternMethod_h

#include "Buffers/RefinementPatternBuffer.h" // for Range
#include "Methods/RefinementMethod.h"
#include "OpenGL/VertexAttribute.h" // for BoundPatterns

#include <vector> // for groups

namespace relevo
{
class PatternMethod : public RefinementMethod
{
protected:
  /**
   * Binds the patterns' vertices and triangles to the current vertex array, as long as the object
   * lives.
   */
  class BoundPatterns
  {
  public:
    BoundPatterns(
      const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives);
    ~BoundPatterns();

  private:
    RefinementPatternBuffer& Patterns;
    VertexAttribute Vertices;
  };

  /**
   * Draw instances of a pattern. Triangles are those of this number of copies.
   */
  static void DrawPattern(const RefinementPatternBuffer::Range& range, bool mirrored,
    Primitives primitives, int copies, int instances);

  /**
   * Draw groups of instances, with one call each.
   */
  static int DrawGroups(const RefinementDrawing& drawing, vtkShaderProgram* program,
    Primitives primitives, const std::vector<PatternGroup>& groups);
};
}

#endif
