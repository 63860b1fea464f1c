// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/CellRanges.h"

#include "Buffers/CellPass.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"
#include "Stages/VolumeFrame.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace relevo
{
bool CellRanges::Update(const VolumeFrame& frame)
{
  const VolumeMeshBuffers& mesh = frame.Mesh.Buffers;
  const int component = frame.Functions.Surfaces.GetComponent();
  if (this->Known.Update(Dependencies::On(mesh.GetNumberOfUploads(), component)))
  {
    this->AreFound = this->Find(frame);
  }
  return this->AreFound;
}

bool CellRanges::Find(const VolumeFrame& frame)
{
  VolumeMeshBuffers& mesh = frame.Mesh.Buffers;
  SurfaceBuffer& surfaces = frame.Functions.Surfaces;
  vtkShaderProgram* program = mesh.AddCorners(frame.Window)
    ? frame.Programs.Ready(frame.Window, VolumeShader::Ranges, frame.Features.Options)
    : nullptr;
  if (!program)
  {
    return false;
  }
  mesh.Activate(program);
  surfaces.Activate(program);
  CellPass pass;
  const bool isDrawn =
    pass.Draw(frame.Window, program, mesh.GetNumberOfCells(), { { 2, VTK_FLOAT } });
  surfaces.Deactivate();
  mesh.Deactivate();
  this->Ranges.clear();
  if (isDrawn)
  {
    this->Ranges = pass.Read<ActiveCells::Interval>(VTK_FLOAT);
  }
  pass.ReleaseGraphicsResources(frame.Window);
  return isDrawn;
}

bool CellRanges::Mark(const VolumeFrame& frame, const std::vector<ActiveCells::Interval>& intervals,
  float margin, ActiveCells& cells) const
{
  VolumeMeshBuffers& mesh = frame.Mesh.Buffers;
  vtkShaderProgram* program =
    frame.Programs.Ready(frame.Window, VolumeShader::Active, frame.Features.Options);
  if (!program)
  {
    return false;
  }
  cells.Select(this->Ranges, intervals, margin);
  mesh.Activate(program);
  const bool areMarked = cells.Mark(frame.Window, program);
  mesh.Deactivate();
  return areMarked;
}

void CellRanges::Clear()
{
  this->Ranges = {};
  this->Known.Clear();
}
}
