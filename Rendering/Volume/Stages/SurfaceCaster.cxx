// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/SurfaceCaster.h"

#include "Shaders/VolumePrograms.h"
#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"
#include "Stages/VolumeFrame.h"
#include "Targets/RenderTarget.h"
#include "View/OpaqueDepth.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Scalars are from 0 to 1. This is more than the rounding errors inside a cell.
constexpr float IsoMargin = 1e-5f;
}

bool SurfaceCaster::IsReady(const VolumeFrame& frame)
{
  const VolumeShaderOptions& options = frame.Features.Options;
  // Rays in tangled quadratic cells depend on where they come from.
  const bool isTangled = options.HasQuadraticCells && options.HasFoldedFaces;
  this->CanDraw = options.Blending == BlendMode::IsoSurface && !options.HasCellScalars &&
    !isTangled && !options.HasTables && frame.Functions.Surfaces.AreOpaque() &&
    frame.Passes.IsEmpty() && frame.View.IsInFront(frame.Mesh.Layout.HalfSize) &&
    frame.Mesh.Buffers.AddCorners(frame.Window) && this->FindRanges(frame) &&
    this->MarkCells(frame);
  return this->CanDraw;
}

bool SurfaceCaster::FindRanges(const VolumeFrame& frame)
{
  VolumeMeshBuffers& mesh = frame.Mesh.Buffers;
  SurfaceBuffer& surfaces = frame.Functions.Surfaces;
  if (!this->Ranged.Update(Dependencies::On(mesh.GetNumberOfUploads(), surfaces.GetComponent())))
  {
    return this->HasRanges;
  }
  vtkShaderProgram* program =
    frame.Programs.Ready(frame.Window, VolumeShader::Ranges, frame.Features.Options);
  this->HasRanges = program != nullptr;
  if (program)
  {
    mesh.Activate(program);
    surfaces.Activate(program);
    this->HasRanges = this->Cells.FindRanges(frame.Window, program, mesh.GetNumberOfCells());
    surfaces.Deactivate();
    mesh.Deactivate();
  }
  return this->HasRanges;
}

bool SurfaceCaster::MarkCells(const VolumeFrame& frame)
{
  VolumeMeshBuffers& mesh = frame.Mesh.Buffers;
  const SurfaceBuffer& surfaces = frame.Functions.Surfaces;
  if (!this->Marked.Update(Dependencies::On(mesh.GetNumberOfUploads(), frame.Functions.Version)))
  {
    return this->AreMarked;
  }
  vtkShaderProgram* program =
    frame.Programs.Ready(frame.Window, VolumeShader::Active, frame.Features.Options);
  this->AreMarked = program != nullptr;
  if (program)
  {
    const float margin = std::max(IsoMargin, 2.0f * surfaces.GetSame());
    mesh.Activate(program);
    this->AreMarked = this->Cells.Mark(frame.Window, program, surfaces.GetScaledValues(), margin);
    mesh.Deactivate();
  }
  return this->AreMarked;
}

std::string SurfaceCaster::Draw(const VolumeFrame& frame, const std::array<int, 2>& size)
{
  VolumeShaderOptions options = frame.Features.Options;
  options.HasActiveCells = true;
  vtkShaderProgram* program = frame.Programs.Ready(frame.Window, VolumeShader::Nearest, options);
  if (!program)
  {
    return VolumePrograms::Error;
  }
  if (!this->Cells.Sort(frame.Window, frame.View, frame.Mesh.Layout.HalfSize))
  {
    return "The faces of cells with isosurfaces do not fit into a buffer texture.";
  }
  const RayView view = frame.GetView({ { 0, 0, size[0], size[1] } });
  view.SetUniforms(program);
  view.SetOutlineUniforms(program);
  frame.Activate(program);
  this->Cells.Activate(program);
  program->SetUniformf(
    "depthScale", static_cast<float>(view.GetDepthScale(frame.Mesh.Layout.HalfSize)));
  const bool isDrawn = frame.Target.Begin(frame.Window, size[0], size[1], { {} }, true);
  if (isDrawn)
  {
    frame.Target.Draw(
      BlendOperation::Nearest, [this] { this->Faces.Draw(this->Cells.GetNumberOfFaces()); });
    frame.Target.End();
  }
  this->Cells.Deactivate();
  frame.Deactivate();
  return isDrawn ? "" : VolumeFrame::DescribeTooLarge(size);
}

void SurfaceCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cells.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources();
  this->Ranged.Clear();
  this->Marked.Clear();
}
}
