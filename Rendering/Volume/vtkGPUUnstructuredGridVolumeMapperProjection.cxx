// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "Mesh/CameraEye.h"
#include "relevoViewportVS.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>

// What projection cannot do rays are cast for; it is said when settings have changed.
bool vtkGPUUnstructuredGridVolumeMapper::FindProjected()
{
  vtkInternals& data = *this->Internals;
  const relevo::VolumeShaderOptions& options = data.Options;
  const bool isPossible = this->BlendMode == COMPOSITE_BLEND && !options.HasSurfaces &&
    !options.HasTables && !options.HasGradientOpacity && options.NumberOfMaterials == 0;
  if (this->Method != CELL_PROJECTION || isPossible)
  {
    return this->Method == CELL_PROJECTION;
  }
  const vtkMTimeType time = std::max(data.FunctionsTime, this->GetMTime());
  if (data.MethodWarningTime != time)
  {
    data.MethodWarningTime = time;
    vtkWarningMacro("Cells are projected with composite blending, without gradients, shading and "
                    "isosurfaces; rays are cast instead.");
  }
  return false;
}

bool vtkGPUUnstructuredGridVolumeMapper::SortCells(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
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
bool vtkGPUUnstructuredGridVolumeMapper::FindLimits(int width, int height)
{
  vtkInternals& data = *this->Internals;
  vtkShaderProgram* program =
    this->ReadyProgram(relevoViewportVS, relevo::MakeLimitsShader(this->GetShaderOptions()));
  if (!program || !data.Limits.Begin(data.GetWindow(), width, height, 4))
  {
    return false;
  }
  data.View.SetUniforms(program);
  data.Planes.SetUniforms(program);
  data.Depth.Activate(program);
  data.Limits.Draw(3, false);
  data.Depth.Deactivate();
  return true;
}

// All cells, by themselves.
bool vtkGPUUnstructuredGridVolumeMapper::ProjectCells(int width, int height)
{
  vtkInternals& data = *this->Internals;
  data.View.SetViewport(relevo::dvec4(0.0, 0.0, width, height));
  if (!this->FindLimits(width, height))
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
  if (!program || !data.Projection.Begin(data.GetWindow(), width, height, 4))
  {
    return false;
  }
  data.View.SetUniforms(program);
  data.View.SetProjectionUniforms(program);
  data.ActivateTextures(program);
  data.Projected.Activate(program);
  data.Limits.Activate(program, "rayLimits");
  data.Projection.DrawQuads(data.Projected.GetNumberOfCells(), true);
  data.Limits.Deactivate();
  data.Projected.Deactivate();
  data.DeactivateTextures();
  return true;
}

void vtkGPUUnstructuredGridVolumeMapper::DrawProjected(
  vtkRenderer* renderer, vtkVolume* volume, const int viewport[4])
{
  if (!this->SortCells(renderer, volume) || !this->ProjectCells(viewport[2], viewport[3]))
  {
    vtkErrorMacro("This OpenGL has no room for what cell projection draws.");
    return;
  }
  this->BlendProjection(viewport);
}
