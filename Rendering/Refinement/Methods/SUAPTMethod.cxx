// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/SUAPTMethod.h"

#include "relevoEdgeSegments.h"
#include "relevoInstancedVS.h"
#include "relevoPatternVS.h"
#include "relevoSnappedVS.h"

#include "Patterns/RefinementPattern.h"
#include "Shaders/RefinementShader.h"
#include "State/ViewSelection.h"

#include <algorithm>

namespace relevo
{
int SUAPTMethod::GetSegments(const PatternSelection& selection, int face, int) const
{
  const int* segments = selection.GetFacePattern(face).Pattern->Segments;
  return *std::max_element(segments, segments + 3);
}

bool SUAPTMethod::Upload(const RefinementDrawing& drawing)
{
  return this->UniformMethod::Upload(drawing) &&
    (this->Edges.Upload(drawing.Window, drawing.Slot, *drawing.Mesh, *drawing.Selection) ||
      this->FailForSize());
}

void SUAPTMethod::FillOptions(const RefinementDrawing&, RefinementShaderOptions& options) const
{
  options.PlacementSource =
    std::string(relevoPatternVS) + relevoInstancedVS + relevoEdgeSegments + relevoSnappedVS;
}

int SUAPTMethod::Draw(
  const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives)
{
  this->Edges.Activate(program);
  const int calls = this->UniformMethod::Draw(drawing, program, primitives);
  this->Edges.Deactivate();
  return calls;
}

vtkTypeInt64 SUAPTMethod::GetMemorySize() const
{
  return this->UniformMethod::GetMemorySize() + this->Edges.GetMemorySize();
}

void SUAPTMethod::ReleaseGraphicsResources(vtkWindow* window)
{
  this->UniformMethod::ReleaseGraphicsResources(window);
  this->Edges.ReleaseGraphicsResources(window);
}
}
