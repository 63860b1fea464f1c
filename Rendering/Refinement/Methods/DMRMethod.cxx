// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/DMRMethod.h"

#include "OpenGL/RelevoOpenGL.h"

#include "relevoStreamVS.h"

#include "OpenGL/VertexAttribute.h"
#include "Patterns/PatternFamily.h"
#include "Shaders/RefinementShader.h"
#include "State/ViewSelection.h"

#include <cstddef>

namespace relevo
{
std::string DMRMethod::FindError(const PatternFamily& family) const
{
  return family.AreWholeNumbers() ? "it halves edges, but SegmentPolicy is WHOLE_NUMBERS" : "";
}

bool DMRMethod::CanDraw(Primitives primitives) const
{
  return primitives == Primitives::TRIANGLES;
}

bool DMRMethod::Upload(const RefinementDrawing& drawing)
{
  Slot& slot = this->Slots[drawing.Slot];
  if (slot.GroupsTime != drawing.Selection->GetGroupsTime())
  {
    slot.GroupsTime = 0;
    if (!slot.Stream.Refine(drawing.Window, *drawing.Mesh, drawing.Selection->GetSelection(),
          this->Program, this->Error))
    {
      return false;
    }
    slot.GroupsTime = drawing.Selection->GetGroupsTime();
  }
  return true;
}

void DMRMethod::FillOptions(const RefinementDrawing&, RefinementShaderOptions& options) const
{
  options.PlacementSource = relevoStreamVS;
}

int DMRMethod::Draw(const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives)
{
  const RefinementStream& stream = this->Slots.at(drawing.Slot).Stream;
  VertexAttribute::Layout layout;
  layout.Components = 3;
  layout.Stride = static_cast<int>(sizeof(RefinementStreamVertex));
  const VertexAttribute weights(program, "relevoStreamWeights", stream.GetHandle(), layout);
  layout.Type = VertexAttribute::UNSIGNED_INT;
  layout.Components = 1;
  layout.Offset = offsetof(RefinementStreamVertex, Face);
  const VertexAttribute faces(program, "relevoStreamFace", stream.GetHandle(), layout);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * stream.GetNumberOfTriangles()));
  return 1;
}

bool DMRMethod::CountTriangles(const RefinementDrawing& drawing, FaceSums& sums) const
{
  sums = RefinementStream::CountTriangles(*drawing.Mesh, *drawing.Selection);
  return true;
}

vtkTypeInt64 DMRMethod::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const auto& slot : this->Slots)
  {
    size += slot.second.Stream.GetMemorySize();
  }
  return size;
}

void DMRMethod::ReleaseGraphicsResources(vtkWindow*)
{
  for (auto& slot : this->Slots)
  {
    slot.second.Stream.ReleaseGraphicsResources();
  }
  this->Slots.clear();
  this->Program.ReleaseGraphicsResources();
}
}
