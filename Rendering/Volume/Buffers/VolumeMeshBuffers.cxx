// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/VolumeMeshBuffers.h"

#include "Mesh/RayCastMesh.h"
#include "Mesh/TetrahedronCorners.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace relevo
{
bool VolumeMeshBuffers::Upload(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh)
{
  const size_t cells = mesh.GetNumberOfTetrahedra() + mesh.GetNumberOfCurvedCells();
  this->NumberOfCells = cells;
  this->TreeSize = static_cast<int>(mesh.BorderTree.size() / 8);
  this->NumberOfTetrahedra = static_cast<int>(mesh.GetNumberOfTetrahedra());
  this->NumberOfBorderFaces = static_cast<int>(mesh.BorderFaces.size() / 4);
  // Pyramids, and cells that a ray crosses repeatedly, need several steps.
  constexpr size_t stepsOfCell = 32;
  this->MaximumSteps = static_cast<int>(
    std::min<size_t>(mesh.GetNumberOfCurvedCells() > 0 ? stepsOfCell * cells : cells, 1 << 30) + 1);
  this->HasCorners = mesh.IsDiscontinuous || mesh.GetNumberOfTetrahedra() == 0
    ? CornerState::Uploaded
    : CornerState::Unknown;
  return this->UploadScalars(window, mesh) &&
    this->Buffers[PointSums].Upload(window, mesh.PointSums, 1) &&
    this->Buffers[Corners].Upload(
      window, mesh.IsDiscontinuous ? mesh.Corners : std::vector<std::uint32_t>(), 4) &&
    this->Buffers[Neighbors].Upload(window, mesh.Neighbors, 4) &&
    this->Buffers[CurvedCells].Upload(window, mesh.CurvedCells, 4) &&
    this->Buffers[BorderFaces].Upload(window, mesh.BorderFaces, 4) &&
    this->Buffers[BorderTree].Upload(window, mesh.BorderTree, 4);
}

bool VolumeMeshBuffers::UploadScalars(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh)
{
  ++this->NumberOfUploads;
  return this->Buffers[PointGradients].Upload(window, mesh.PointGradients, 4) &&
    this->Buffers[Points].Upload(window, mesh.Points, 4) &&
    this->Buffers[PointScalars].Upload(window, mesh.PointScalars, 4) &&
    this->Buffers[CellScalars].Upload(
      window, mesh.CellScalars, mesh.CellScalars.size() > this->NumberOfCells ? 4 : 1) &&
    this->Buffers[CornerScalars].Upload(window, mesh.CornerScalars, 4);
}

// Empty buffers have one texel.
void VolumeMeshBuffers::Download(RayCastMesh& mesh)
{
  if (this->NumberOfTetrahedra > 0)
  {
    this->Buffers[PointSums].Download(mesh.PointSums);
    this->Buffers[Neighbors].Download(mesh.Neighbors);
  }
  if (this->NumberOfCells > static_cast<size_t>(this->NumberOfTetrahedra))
  {
    this->Buffers[CurvedCells].Download(mesh.CurvedCells);
  }
  this->Buffers[BorderFaces].Download(mesh.BorderFaces);
}

bool VolumeMeshBuffers::AddCorners(vtkOpenGLRenderWindow* window)
{
  if (this->HasCorners == CornerState::Unknown)
  {
    this->HasCorners = this->FindCorners(window) ? CornerState::Uploaded : CornerState::Missing;
  }
  return this->HasCorners == CornerState::Uploaded;
}

bool VolumeMeshBuffers::FindCorners(vtkOpenGLRenderWindow* window)
{
  RayCastMesh mesh;
  this->Download(mesh);
  return FindTetrahedronCorners(mesh) && this->Buffers[Corners].Upload(window, mesh.Corners, 4);
}

void VolumeMeshBuffers::Activate(vtkShaderProgram* program)
{
  const char* samplers[NumberOfKinds] = { "meshPoints", "pointScalars", "cellScalars",
    "cornerScalars", "pointGradients", "pointSums", "tetrahedronCorners", "neighbors",
    "curvedCells", "borderFaces", "borderTree" };
  for (int kind = 0; kind < NumberOfKinds; ++kind)
  {
    this->Buffers[kind].Activate(program, samplers[kind]);
  }
  const auto set = [program](const char* name, int value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformi(name, value);
    }
  };
  set("treeSize", this->TreeSize);
  set("maximumSteps", this->MaximumSteps);
  set("numberOfTetrahedra", this->NumberOfTetrahedra);
  set("numberOfBorderFaces", this->NumberOfBorderFaces);
}

void VolumeMeshBuffers::Deactivate()
{
  for (BufferTexture& buffer : this->Buffers)
  {
    buffer.Deactivate();
  }
}

void VolumeMeshBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (BufferTexture& buffer : this->Buffers)
  {
    buffer.ReleaseGraphicsResources(window);
  }
}

vtkTypeInt64 VolumeMeshBuffers::GetMemorySize() const
{
  vtkTypeInt64 sum = 0;
  for (const BufferTexture& buffer : this->Buffers)
  {
    sum += buffer.GetMemorySize();
  }
  return sum;
}
}
