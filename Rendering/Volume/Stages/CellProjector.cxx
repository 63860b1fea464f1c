// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/CellProjector.h"

#include "Passes/ScreenPass.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/FeatureSelector.h"
#include "Stages/MeshLoader.h"
#include "Stages/VolumeFrame.h"
#include "View/OpaqueDepth.h"

#include "vtkShaderProgram.h"

#include <vector>

namespace relevo
{
namespace
{
constexpr const char* NoRoom =
  "There is not enough graphics memory for cell projection: call SetMethodToRayCasting().";

// Sums do not need an order, and neither do extremes of one scalar.
bool NeedsOrder(const VolumeShaderOptions& options)
{
  switch (options.Blending)
  {
    case BlendMode::Average:
    case BlendMode::Additive:
      return false;
    case BlendMode::Maximum:
    case BlendMode::Minimum:
      return options.HasTables || options.NumberOfComponents > 1;
    default:
      return true;
  }
}

BlendOperation FindOperation(BlendMode blending)
{
  switch (blending)
  {
    case BlendMode::Average:
    case BlendMode::Additive:
      return BlendOperation::Add;
    case BlendMode::Maximum:
      return BlendOperation::Maximum;
    case BlendMode::Minimum:
      return BlendOperation::Minimum;
    default:
      return BlendOperation::Over;
  }
}

// The formats are those of relevoVolumeStore.glsl.
std::vector<RenderTarget::Format> FindFormats(const VolumeShaderOptions& options)
{
  const size_t table = options.HasTables ? 1 : 0;
  const size_t count = options.Blending == BlendMode::Average ? 2 + table
    : IsExtremum(FindOperation(options.Blending))             ? 1 + table
                                                              : 1;
  return std::vector<RenderTarget::Format>(count);
}

// Each independent component has its own extreme.
bool HasManyExtremes(const VolumeShaderOptions& options)
{
  return IsExtremum(FindOperation(options.Blending)) && options.NumberOfComponents > 1 &&
    options.NumberOfCurves == options.NumberOfComponents && !options.AreDependent;
}
}

std::string CellProjector::RenderRayLimits(const VolumeFrame& frame)
{
  vtkShaderProgram* program =
    frame.Programs.Ready(frame.Window, VolumeShader::RayLimits, frame.Features.Options);
  if (!program)
  {
    return VolumePrograms::Error;
  }
  const int width = frame.Viewport[2];
  const int height = frame.Viewport[3];
  if (!this->Limits.Begin(frame.Window, width, height, { {} }))
  {
    return NoRoom;
  }
  frame.GetView({ { 0, 0, width, height } }).SetUniforms(program);
  frame.Features.Planes.SetUniforms(program);
  frame.Depth.Activate(program);
  this->Limits.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
  this->Limits.End();
  frame.Depth.Deactivate();
  return "";
}

std::string CellProjector::Draw(const VolumeFrame& frame)
{
  VolumeShaderOptions options = frame.Features.Options;
  ProjectedCells& cells = frame.Mesh.Cells;
  const bool isSorted = cells.HasOrder() && !NeedsOrder(options);
  if (!isSorted && !cells.Sort(frame.Window, frame.View.GetEye()))
  {
    return NoRoom;
  }
  const std::string error = this->RenderRayLimits(frame);
  if (!error.empty())
  {
    return error;
  }
  const RayView view = frame.GetView({ { 0, 0, frame.Viewport[2], frame.Viewport[3] } });
  const bool isCut = !view.IsBeyondNear(frame.Mesh.Layout.HalfSize);
  // Both programs are built at once, so that moving cameras build none.
  vtkShaderProgram* program = nullptr;
  for (const bool isOther : { true, false })
  {
    options.IsCutByNear = isCut != isOther;
    program = frame.Programs.Ready(frame.Window, VolumeShader::Projection, options);
  }
  if (!program)
  {
    return VolumePrograms::Error;
  }
  view.SetUniforms(program);
  view.SetOutlineUniforms(program);
  frame.Activate(program);
  cells.Activate(program);
  this->Limits.Activate(program, "rayLimits");
  const bool isDrawn = this->DrawCells(frame, program);
  this->Limits.Deactivate();
  cells.Deactivate();
  frame.Deactivate();
  return isDrawn ? "" : NoRoom;
}

// Draw the cells with the current program; several extremes are drawn one after the other.
bool CellProjector::DrawCells(const VolumeFrame& frame, vtkShaderProgram* program)
{
  const VolumeShaderOptions& options = frame.Features.Options;
  const BlendOperation operation = FindOperation(options.Blending);
  const bool hasMany = HasManyExtremes(options);
  for (int i = 0; i < (hasMany ? options.NumberOfComponents : 1); ++i)
  {
    if (!frame.Target.Begin(frame.Window, frame.Viewport[2], frame.Viewport[3],
          FindFormats(options), IsExtremum(operation)))
    {
      return false;
    }
    if (program->IsUniformUsed("decidingComponent"))
    {
      program->SetUniformi("decidingComponent", hasMany ? i : options.NumberOfComponents - 1);
    }
    frame.Target.Draw(
      operation, [&]() { this->Quads.Draw(frame.Mesh.Cells.GetNumberOfCells()); },
      hasMany ? i : -1);
    frame.Target.End();
  }
  return true;
}

void CellProjector::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Limits.ReleaseGraphicsResources(window);
  this->Quads.ReleaseGraphicsResources();
}
}
