// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/ARKFPIMethod.h"

#include "relevoInstancedVS.h"
#include "relevoPatternVS.h"
#include "relevoPermutedVS.h"

#include "Buffers/InstanceBuffers.h"
#include "Shaders/RefinementShader.h"
#include "State/ViewSelection.h"
#include "vtkShaderProgram.h"

namespace relevo
{
bool ARKFPIMethod::Upload(const RefinementDrawing& drawing)
{
  if (drawing.ComputeView)
  {
    return true; // everything is uploaded
  }
  drawing.Patterns->Load(
    *drawing.Library, drawing.Selection->GetSelection().Groups, drawing.HasLines);
  return UploadInstances(drawing) || this->FailForSize();
}

void ARKFPIMethod::FillOptions(
  const RefinementDrawing& drawing, RefinementShaderOptions& options) const
{
  options.IsIndirect = drawing.ComputeView != nullptr;
  options.IsMorphing = drawing.Instances->IsMorphing();
  options.PlacementSource = std::string(relevoPatternVS) + relevoInstancedVS + relevoPermutedVS;
}

int ARKFPIMethod::Draw(
  const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives)
{
  drawing.Instances->Activate(program);
  const BoundPatterns patterns(drawing, program, primitives);
  int calls = 1;
  if (drawing.ComputeView)
  {
    VertexAttribute::Layout layout;
    layout.Type = VertexAttribute::UNSIGNED_INT;
    layout.Components = 2;
    layout.IsPerInstance = true;
    const VertexAttribute members(
      program, "relevoMembers", drawing.ComputeView->GetMembers(primitives), layout);
    drawing.ComputeView->Draw(primitives);
  }
  else
  {
    calls = DrawGroups(drawing, program, primitives, drawing.Selection->GetSelection().Groups);
  }
  drawing.Instances->Deactivate();
  return calls;
}
}
