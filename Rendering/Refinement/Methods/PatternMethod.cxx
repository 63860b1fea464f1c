// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/PatternMethod.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Buffers/PatternRanges.h"
#include "Evaluation/PatternSelection.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkShaderProgram.h"

namespace relevo
{
PatternMethod::BoundPatterns::BoundPatterns(
  const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives)
  : Patterns(*drawing.Patterns)
  , Vertices(program, "relevoPatternVertex",
      static_cast<unsigned int>(
        (primitives == Primitives::LINES ? Patterns.GetLines() : Patterns.GetVertices())
          ->GetHandle()),
      VertexAttribute::Layout())
{
  this->Patterns.GetTriangles()->Bind();
}

PatternMethod::BoundPatterns::~BoundPatterns()
{
  this->Patterns.GetTriangles()->Release();
}

void PatternMethod::DrawPattern(const RefinementPatternBuffer::Range& range, bool mirrored,
  Primitives primitives, int copies, int instances)
{
  if (primitives == Primitives::TRIANGLES)
  {
    const size_t first = static_cast<size_t>(range.FirstIndex) +
      (mirrored ? static_cast<size_t>(range.NumberOfIndices) * range.Copies : 0);
    glDrawElementsInstancedBaseVertex(GL_TRIANGLES, copies * range.NumberOfIndices,
      GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(first * sizeof(unsigned short)), instances,
      range.FirstVertex);
  }
  else if (primitives == Primitives::LINES)
  {
    glDrawArraysInstanced(GL_LINES, range.FirstLineVertex, range.NumberOfLineVertices, instances);
  }
  else
  {
    // Picking needs the coarse points only: a pattern's corners come first.
    glDrawArraysInstanced(GL_POINTS, range.FirstVertex,
      primitives == Primitives::CORNERS ? 3 : range.NumberOfVertices, instances);
  }
}

int PatternMethod::DrawGroups(const RefinementDrawing& drawing, vtkShaderProgram* program,
  Primitives primitives, const std::vector<PatternGroup>& groups)
{
  // The location is cached, because its lookup takes longer than drawing small groups.
  const GLint location =
    glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "relevoGroup");
  for (const PatternGroup& group : groups)
  {
    const auto& range = drawing.Patterns->GetRange(group);
    const auto [instances, copies] =
      CountInstances(group.Count, primitives == Primitives::TRIANGLES ? range.Copies : 1);
    glUniform3i(location, group.Offset, group.Count, copies);
    DrawPattern(range, group.Mirrored, primitives, copies, instances);
  }
  return static_cast<int>(groups.size());
}
}
