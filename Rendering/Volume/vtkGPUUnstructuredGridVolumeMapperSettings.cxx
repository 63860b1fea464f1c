// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "Checks/SettingChecks.h"
#include "vtkDataSet.h"
#include "vtkUnstructuredGridBase.h"

void vtkGPUUnstructuredGridVolumeMapper::SetInputData(vtkUnstructuredGridBase* mesh)
{
  this->SetInputDataInternal(0, mesh);
}

void vtkGPUUnstructuredGridVolumeMapper::SetInputData(vtkDataSet* mesh)
{
  this->SetInputDataInternal(0, mesh);
}

void vtkGPUUnstructuredGridVolumeMapper::SetVectorMode(int mode)
{
  relevo::SetInRange(this, "VectorMode", this->VectorMode, mode, static_cast<int>(DISABLED),
    static_cast<int>(COMPONENT));
}

void vtkGPUUnstructuredGridVolumeMapper::SetVectorComponent(int component)
{
  relevo::SetInRange(
    this, "VectorComponent", this->VectorComponent, component, 0, relevo::MostComponents - 1);
}

void vtkGPUUnstructuredGridVolumeMapper::SetMethod(int method)
{
  relevo::SetChoice(this, "Method", this->Method, method, { "RAY_CASTING", "CELL_PROJECTION" });
}

void vtkGPUUnstructuredGridVolumeMapper::SetBlendMode(int mode)
{
  relevo::SetChoice(this, "BlendMode", this->BlendMode, mode,
    { "COMPOSITE_BLEND", "MAXIMUM_INTENSITY_BLEND", "MINIMUM_INTENSITY_BLEND",
      "AVERAGE_INTENSITY_BLEND", "ADDITIVE_BLEND", "ISOSURFACE_BLEND" });
}

void vtkGPUUnstructuredGridVolumeMapper::SetIntegration(int integration)
{
  relevo::SetChoice(this, "Integration", this->Integration, integration,
    { "EXACT", "PRE_INTEGRATED", "PRE_INTEGRATED_2D" });
}

// OpenGL has 3D textures of 256 each way at least.
void vtkGPUUnstructuredGridVolumeMapper::SetTableSize(int size)
{
  relevo::SetInRange(this, "TableSize", this->TableSize, size, 2, 256);
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfDrawnCells()
{
  return this->Internals->NumberOfDrawnCells;
}

vtkTypeInt64 vtkGPUUnstructuredGridVolumeMapper::GetGraphicsMemorySize()
{
  const vtkInternals& data = *this->Internals;
  return data.MeshBuffers.GetMemorySize() + data.Projected.GetMemorySize() +
    data.FunctionBuffers.GetMemorySize() + data.Surfaces.GetMemorySize() +
    data.Integrals.GetMemorySize();
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfBufferBuilds()
{
  return this->Internals->NumberOfBufferBuilds;
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfShaderBuilds()
{
  return this->Internals->NumberOfShaderBuilds;
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfTableBuilds()
{
  return this->Internals->NumberOfTableBuilds;
}
