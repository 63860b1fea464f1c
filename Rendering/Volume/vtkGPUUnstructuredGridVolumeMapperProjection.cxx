// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "View/CameraEye.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

namespace
{
using relevo::BlendOperation;

// Sums have none; of one scalar, neither have extremes.
bool NeedsOrder(const relevo::VolumeShaderOptions& options)
{
  switch (options.Blending)
  {
    case relevo::BlendMode::Average:
    case relevo::BlendMode::Additive:
      return false;
    case relevo::BlendMode::Maximum:
    case relevo::BlendMode::Minimum:
      return options.HasTables || options.NumberOfComponents > 1;
    default:
      return true;
  }
}

BlendOperation FindOperation(relevo::BlendMode blending)
{
  switch (blending)
  {
    case relevo::BlendMode::Average:
    case relevo::BlendMode::Additive:
      return BlendOperation::Add;
    case relevo::BlendMode::Maximum:
      return BlendOperation::Maximum;
    case relevo::BlendMode::Minimum:
      return BlendOperation::Minimum;
    default:
      return BlendOperation::Over;
  }
}

// As relevoVolumeStore.glsl has them.
int CountTextures(const relevo::VolumeShaderOptions& options)
{
  const int table = options.HasTables ? 1 : 0;
  return options.Blending == relevo::BlendMode::Average   ? 2 + table
    : relevo::IsExtremum(FindOperation(options.Blending)) ? 1 + table
                                                          : 1;
}

// Independent components have an extreme each.
bool HasManyExtremes(const relevo::VolumeShaderOptions& options)
{
  return options.NumberOfComponents > 1 && options.NumberOfCurves == options.NumberOfComponents &&
    !options.AreDependent;
}
}

bool vtkGPUUnstructuredGridVolumeMapper::SortCells(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  if (data.Projected.HasOrder() && !NeedsOrder(data.Options))
  {
    return true;
  }
  vtkNew<vtkMatrix4x4> meshToWorld;
  for (int i = 0; i < 3; ++i)
  {
    meshToWorld->SetElement(i, i, data.Mesh.Radius);
    meshToWorld->SetElement(i, 3, data.Mesh.Center[i]);
  }
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), meshToWorld, meshToWorld);
  vtkNew<vtkMatrix4x4> worldToMesh;
  vtkMatrix4x4::Invert(meshToWorld, worldToMesh);
  return data.Projected.Sort(
    data.GetWindow(), relevo::GetEye(renderer->GetActiveCamera(), worldToMesh));
}

// Where each ray is seen, once for all cells.
bool vtkGPUUnstructuredGridVolumeMapper::RenderRayLimits(int width, int height)
{
  vtkInternals& data = *this->Internals;
  vtkShaderProgram* program = this->ReadyProgram(
    relevo::ScreenPass::GetVertexShader(), relevo::MakeLimitsShader(this->GetShaderOptions()));
  if (!program || !data.Limits.Begin(data.GetWindow(), width, height, { {} }))
  {
    return false;
  }
  data.View.SetUniforms(program);
  data.Planes.SetUniforms(program);
  data.Depth.Activate(program);
  data.Limits.Draw(BlendOperation::Add, &relevo::ScreenPass::DrawTriangle);
  data.Limits.End();
  data.Depth.Deactivate();
  return true;
}

// All cells, by themselves.
bool vtkGPUUnstructuredGridVolumeMapper::ProjectCells(int width, int height)
{
  vtkInternals& data = *this->Internals;
  data.View.SetViewport(relevo::dvec4(0.0, 0.0, width, height));
  if (!this->RenderRayLimits(width, height))
  {
    return false;
  }
  relevo::VolumeShaderOptions options = this->GetShaderOptions();
  const bool isCut = !data.View.IsBeyondNear(data.Mesh.HalfSize);
  // Both at once, as cameras shall build nothing.
  vtkShaderProgram* program = nullptr;
  for (const bool isOther : { true, false })
  {
    options.IsCutByNear = isCut != isOther;
    program = this->ReadyProgram(
      relevo::MakeProjectionVertexShader(options), relevo::MakeProjectionShader(options));
  }
  if (!program)
  {
    return false;
  }
  data.View.SetUniforms(program);
  data.View.SetOutlineUniforms(program);
  data.Planes.SetUniforms(program);
  data.Lights.SetUniforms(program);
  data.ActivateTextures(program);
  data.Projected.Activate(program);
  data.Limits.Activate(program, "rayLimits");
  const bool isDrawn = this->DrawCells(program, width, height);
  data.Limits.Deactivate();
  data.Projected.Deactivate();
  data.DeactivateTextures();
  return isDrawn;
}

// By a program that is in use; of several extremes one after the other.
bool vtkGPUUnstructuredGridVolumeMapper::DrawCells(vtkShaderProgram* program, int width, int height)
{
  vtkInternals& data = *this->Internals;
  const relevo::VolumeShaderOptions& options = data.Options;
  const BlendOperation operation = FindOperation(options.Blending);
  const int components = options.NumberOfComponents;
  const bool hasMany = relevo::IsExtremum(operation) && HasManyExtremes(options);
  for (int i = 0; i < (hasMany ? components : 1); ++i)
  {
    const std::vector<relevo::RenderTarget::Format> formats(CountTextures(options));
    if (!data.Projection.Begin(
          data.GetWindow(), width, height, formats, relevo::IsExtremum(operation)))
    {
      return false;
    }
    if (program->IsUniformUsed("decidingComponent"))
    {
      program->SetUniformi("decidingComponent", hasMany ? i : components - 1);
    }
    data.Projection.Draw(
      operation, [&]() { data.Quads.Draw(data.Projected.GetNumberOfCells()); }, hasMany ? i : -1);
    data.Projection.End();
  }
  return true;
}

void vtkGPUUnstructuredGridVolumeMapper::DrawProjected(
  vtkRenderer* renderer, vtkVolume* volume, const int viewport[4])
{
  const vtkInternals& data = *this->Internals;
  if (!this->SortCells(renderer, volume) || !this->ProjectCells(viewport[2], viewport[3]))
  {
    vtkErrorMacro("This OpenGL has no room for what cell projection draws.");
    return;
  }
  this->BlendProjection(viewport,
    relevo::IsStored(data.Options) ? relevo::MakeFinishShader(this->GetShaderOptions())
                                   : relevo::MakeProjectedShader());
}
