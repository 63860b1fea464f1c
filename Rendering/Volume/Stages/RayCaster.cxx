// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/RayCaster.h"

#include "Passes/ScreenPass.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/FeatureSelector.h"
#include "Stages/MeshLoader.h"
#include "Stages/VisibleCells.h"
#include "Stages/VolumeFrame.h"

#include "vtkShaderProgram.h"

namespace relevo
{
namespace
{
// Passes of depth peeling have the same entries.
Dependencies FindEntries(const VolumeFrame& frame, const std::array<int, 2>& size)
{
  VolumeMeshBuffers& mesh = frame.Mesh.Buffers;
  Dependencies now = Dependencies::On(size[0], size[1]);
  now.AddObject(&mesh, mesh.GetNumberOfUploads());
  const dmat4& view = frame.View.GetMeshToClip();
  for (int i = 0; i < 16; ++i)
  {
    now.Add(view[i / 4][i % 4]);
  }
  return now;
}
}

// Return whether the entries are known: the whole mesh must be in front of the eye.
bool RayCaster::RenderRayEntries(const VolumeFrame& frame, const std::array<int, 2>& size)
{
  const RayView view = frame.GetView({ { 0, 0, size[0], size[1] } });
  const bool isInFront = view.IsInFront(frame.Mesh.Layout.HalfSize);
  if (!this->Known.Update(FindEntries(frame, size)))
  {
    return isInFront;
  }
  vtkShaderProgram* program =
    frame.Programs.Ready(frame.Window, VolumeShader::Entries, frame.Features.Options);
  if (!program || !this->Entries.Begin(frame.Window, size[0], size[1]))
  {
    this->Known.Clear();
    return false;
  }
  view.SetUniforms(program);
  view.SetOutlineUniforms(program);
  frame.Mesh.Buffers.Activate(program);
  this->Entries.Draw(isInFront ? frame.Mesh.Buffers.GetNumberOfBorderFaces() : 0);
  frame.Mesh.Buffers.Deactivate();
  return isInFront;
}

vtkShaderProgram* RayCaster::Begin(
  const VolumeFrame& frame, const std::array<int, 4>& viewport, VisibleCells* visible)
{
  const bool areEntriesKnown = this->RenderRayEntries(frame, { { viewport[2], viewport[3] } });
  VolumeShaderOptions options = frame.Features.Options;
  options.HasVisibleCells =
    visible && areEntriesKnown && visible->Find(frame, { { viewport[2], viewport[3] } });
  vtkShaderProgram* program = frame.Programs.ReadyRays(frame.Window, options, frame.Passes);
  if (!program)
  {
    return nullptr;
  }
  frame.GetView(viewport).SetUniforms(program);
  frame.Activate(program);
  this->Entries.Activate(frame.Window, program);
  if (options.HasVisibleCells)
  {
    visible->Activate(frame, program);
  }
  program->SetUniformi("areEntriesKnown", areEntriesKnown ? 1 : 0);
  if (program->IsUniformUsed("in_inverseWindowSize"))
  {
    const float inverse[2] = { 1.0f / viewport[2], 1.0f / viewport[3] };
    program->SetUniform2f("in_inverseWindowSize", inverse);
  }
  frame.Passes.SetShaderParameters(program, frame.Screen.GetVertices());
  return program;
}

std::string RayCaster::Draw(
  const VolumeFrame& frame, const std::array<int, 2>& size, VisibleCells* visible)
{
  const bool isSampled = size[0] != frame.Viewport[2] || size[1] != frame.Viewport[3];
  const std::array<int, 4> sampled = { { 0, 0, size[0], size[1] } };
  if (!this->Begin(frame, isSampled ? sampled : frame.Viewport, visible))
  {
    return VolumePrograms::Error;
  }
  std::string error;
  if (!isSampled)
  {
    frame.Passes.IsEmpty() ? frame.Screen.DrawOver(frame.Window) : frame.Screen.Draw();
  }
  else if (frame.Target.Begin(frame.Window, size[0], size[1], { {} }))
  {
    frame.Target.Draw(BlendOperation::Over, &ScreenPass::DrawTriangle);
    frame.Target.End();
  }
  else
  {
    error = VolumeFrame::DescribeTooLarge(size);
  }
  this->End(frame);
  if (visible)
  {
    visible->Deactivate();
  }
  return error;
}

void RayCaster::End(const VolumeFrame& frame)
{
  this->Entries.Deactivate();
  frame.Deactivate();
}

int RayCaster::CountLayers(const VolumeFrame& frame)
{
  const std::array<int, 2> size = { { frame.Viewport[2], frame.Viewport[3] } };
  if (!this->RenderRayEntries(frame, size))
  {
    this->Known.Clear();
    vtkShaderProgram* program =
      frame.Programs.Ready(frame.Window, VolumeShader::EntryCounts, frame.Features.Options);
    if (!program || !this->Entries.Begin(frame.Window, size[0], size[1]))
    {
      return 0;
    }
    frame.GetView({ { 0, 0, size[0], size[1] } }).SetUniforms(program);
    frame.Mesh.Buffers.Activate(program);
    this->Entries.DrawCounts();
    frame.Mesh.Buffers.Deactivate();
  }
  return this->Entries.ReadMaximum();
}

void RayCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Entries.ReleaseGraphicsResources(window);
  this->Known.Clear();
}
}
