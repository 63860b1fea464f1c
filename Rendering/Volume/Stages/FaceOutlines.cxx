// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/FaceOutlines.h"

#include "Buffers/ActiveCells.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/MeshLoader.h"
#include "Stages/VolumeFrame.h"

#include "vtkShaderProgram.h"

namespace relevo
{
bool FaceOutlines::Find(const VolumeFrame& frame, const VolumeShaderOptions& options,
  const RayView& view, ActiveCells& cells)
{
  vtkShaderProgram* program = frame.Programs.Ready(frame.Window, VolumeShader::Outlines, options);
  if (!program || cells.GetNumberOfFaces() == 0)
  {
    return program != nullptr;
  }
  view.SetOutlineUniforms(program);
  view.SetUniforms(program);
  program->SetUniformf(
    "depthScale", static_cast<float>(view.GetDepthScale(frame.Mesh.Layout.HalfSize)));
  frame.Mesh.Buffers.Activate(program);
  cells.Activate(program);
  const bool isDrawn = this->Pass.Draw(
    frame.Window, program, static_cast<size_t>(cells.GetNumberOfFaces()), { {}, {}, {} });
  cells.Deactivate();
  frame.Mesh.Buffers.Deactivate();
  return isDrawn;
}

void FaceOutlines::Activate(vtkShaderProgram* program)
{
  this->Pass.Activate(program, "outlineBegins", 0);
  this->Pass.Activate(program, "outlineEnds", 1);
  this->Pass.Activate(program, "outlinePlanes", 2);
}
}
