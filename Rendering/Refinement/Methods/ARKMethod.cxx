// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/ARKMethod.h"

#include "OpenGL/RelevoOpenGL.h"

#include "relevoElementVS.h"
#include "relevoPatternVS.h"
#include "relevoPermutedVS.h"

#include "Shaders/RefinementShader.h"
#include "State/ViewSelection.h"
#include "vtkShaderProgram.h"

namespace relevo
{
bool ARKMethod::Upload(const RefinementDrawing& drawing)
{
  drawing.Patterns->Load(
    *drawing.Library, drawing.Selection->GetSelection().Groups, drawing.HasLines);
  return true;
}

void ARKMethod::FillOptions(
  const RefinementDrawing& drawing, RefinementShaderOptions& options) const
{
  options.IsMorphing = !drawing.Selection->GetSelection().GetMorphTags().empty();
  options.PlacementSource = std::string(relevoPatternVS) + relevoElementVS + relevoPermutedVS;
}

int ARKMethod::Draw(
  const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives)
{
  const PatternSelection& selection = drawing.Selection->GetSelection();
  const std::vector<float>& tags = selection.GetMorphTags();
  // The locations are looked up once, because one draw call per face is slow enough.
  const GLuint handle = static_cast<GLuint>(program->GetHandle());
  const GLint element = glGetUniformLocation(handle, "relevoElement");
  const GLint elementTags = glGetUniformLocation(handle, "relevoElementTags");
  const BoundPatterns patterns(drawing, program, primitives);
  int calls = 0;
  for (const PatternGroup& group : selection.Groups)
  {
    const auto& range = drawing.Patterns->GetRange(group);
    for (int i = group.Offset; i < group.Offset + group.Count; ++i)
    {
      const unsigned int instance = selection.Instances[static_cast<size_t>(i)];
      glUniform1i(element, static_cast<GLint>(instance));
      if (!tags.empty())
      {
        glUniform3fv(elementTags, 1, &tags[3 * static_cast<size_t>(instance >> 3)]);
      }
      DrawPattern(range, group.Mirrored, primitives, 1, 1);
      ++calls;
    }
  }
  return calls;
}
}
