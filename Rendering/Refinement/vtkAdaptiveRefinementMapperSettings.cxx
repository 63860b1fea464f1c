// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings that need no new buffers, and statistics of the last render.
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "Checks/SettingChecks.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

#include <algorithm>

vtkMTimeType vtkAdaptiveRefinementMapper::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part : { static_cast<vtkObject*>(this->Refinement.Get()),
         static_cast<vtkObject*>(this->LevelLookupTable.Get()) })
  {
    time = part && !this->IsAskedByVTK() ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

void vtkAdaptiveRefinementMapper::CopySettings(vtkAdaptiveRefinementMapper* other)
{
  this->SetRefinement(other->GetRefinement());
  this->SetTargetNumberOfTriangles(other->GetTargetNumberOfTriangles());
  this->SetUseAllocatedRenderTime(other->GetUseAllocatedRenderTime());
  this->SetFrustumCulling(other->GetFrustumCulling());
  this->SetBackFaceCulling(other->GetBackFaceCulling());
  this->SetMethod(other->GetMethod());
  this->SetSelectionDevice(other->GetSelectionDevice());
  this->SetLevelLookupTable(other->LevelLookupTable);
  this->SetRefinementColorMode(other->RefinementColorMode);
}

void vtkAdaptiveRefinementMapper::SetFrustumCulling(bool culling)
{
  this->SetLive(this->FrustumCulling, culling);
}

void vtkAdaptiveRefinementMapper::SetBackFaceCulling(bool culling)
{
  this->SetLive(this->BackFaceCulling, culling);
}

void vtkAdaptiveRefinementMapper::SetMethod(int method)
{
  if (!relevo::CheckChoice(this, "Method", method,
        { "METHOD_ARKFPI", "METHOD_ARK", "METHOD_DMR", "METHOD_SUAPT",
          "METHOD_HARDWARE_TESSELLATION", "METHOD_UNIFORM" }))
  {
    return;
  }
  if (this->Method != method)
  {
    this->Internals->Methods.ForgetProblem();
    this->Internals->Programs.ForgetFailures();
  }
  this->SetLive(this->Method, method);
}

void vtkAdaptiveRefinementMapper::SetColorMode(int mode)
{
  this->SetColorModeToScalars();
  this->Superclass::SetColorMode(mode);
}

void vtkAdaptiveRefinementMapper::SetRefinementColorMode(RefinementColorModes mode)
{
  this->SetLive(this->RefinementColorMode, mode);
}

void vtkAdaptiveRefinementMapper::SetLevelLookupTable(vtkScalarsToColors* table)
{
  this->SetLive(this->LevelLookupTable, vtkSmartPointer<vtkScalarsToColors>(table));
}

vtkScalarsToColors* vtkAdaptiveRefinementMapper::GetLevelLookupTable()
{
  if (this->LevelLookupTable)
  {
    return this->LevelLookupTable;
  }
  return this->Internals->FaceColors.GetDefaultTable(this->RefinementColorMode, this->Refinement);
}

void vtkAdaptiveRefinementMapper::SetTargetNumberOfTriangles(vtkIdType triangles)
{
  if (relevo::CheckRange<vtkIdType>(this, "TargetNumberOfTriangles", triangles, 0, VTK_ID_MAX))
  {
    this->SetLive(this->Internals->Budget.Target, triangles);
  }
}

vtkIdType vtkAdaptiveRefinementMapper::GetTargetNumberOfTriangles()
{
  return this->Internals->Budget.Target;
}

void vtkAdaptiveRefinementMapper::SetUseAllocatedRenderTime(bool use)
{
  this->SetLive(this->UseAllocatedRenderTime, use);
}

double vtkAdaptiveRefinementMapper::GetLevelOffset()
{
  return this->Internals->State.LevelOffset;
}

void vtkAdaptiveRefinementMapper::SetSelectionDevice(int device)
{
  if (relevo::CheckChoice(this, "SelectionDevice", device,
        { "SELECTION_DEVICE_AUTOMATIC", "SELECTION_DEVICE_CPU", "SELECTION_DEVICE_GPU" }) &&
    this->SelectionDevice != device)
  {
    this->Internals->ContextChecked = false;
    this->SetLive(this->SelectionDevice, device);
  }
}

int vtkAdaptiveRefinementMapper::GetSelectionDeviceInUse()
{
  bool onGPU = false;
  this->ForEachPart(
    [&onGPU](vtkAdaptiveRefinementMapper* part) { onGPU = onGPU || part->Internals->OnGPU; });
  return onGPU ? SELECTION_DEVICE_GPU : SELECTION_DEVICE_CPU;
}

//------------------------------------------------------------------------------
// Statistics of the last render

relevo::FaceSums vtkAdaptiveRefinementMapper::vtkInternals::CountTriangles()
{
  relevo::FaceSums sums;
  if (this->Drawable)
  {
    // For the last frame: the recipe and the input may have changed since.
    const bool isCounted = this->Methods.Get().CountTriangles(this->GetDrawing(nullptr), sums);
    sums = isCounted ? sums : this->State.CountTriangles();
  }
  return sums;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfDrawnTriangles()
{
  vtkIdType sum = 0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part)
    {
      part->ReadSelection();
      sum += part->Internals->CountTriangles().Drawn;
    });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCulledTriangles()
{
  vtkIdType sum = 0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part)
    {
      part->ReadSelection();
      sum += part->Internals->CountTriangles().Culled;
    });
  return sum;
}

int vtkAdaptiveRefinementMapper::GetNumberOfDrawCalls()
{
  int sum = 0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part) { sum += part->Internals->NumberOfDrawCalls; });
  return sum;
}

int vtkAdaptiveRefinementMapper::vtkInternals::CountUsedPatterns() const
{
  if (!this->Drawable)
  {
    return 0;
  }
  if (this->OnGPU)
  {
    return this->NumberOfUsedPatterns;
  }
  int count = 0;
  const auto& groups = this->State.GetSelection().GetSelection().Groups;
  for (size_t i = 0; i < groups.size(); ++i)
  {
    count += i == 0 || groups[i].Pattern != groups[i - 1].Pattern;
  }
  return count;
}

int vtkAdaptiveRefinementMapper::GetNumberOfUsedPatterns()
{
  int sum = 0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part)
    {
      part->ReadSelection();
      sum += part->Internals->CountUsedPatterns();
    });
  return sum;
}

double vtkAdaptiveRefinementMapper::GetSelectionTime()
{
  double sum = 0.0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part)
    {
      const vtkInternals& data = *part->Internals;
      sum += data.State.GetSelection().GetSeconds() + (data.OnGPU ? data.ComputeSeconds : 0.0);
    });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::vtkInternals::CountCoarseFaces() const
{
  return this->Drawable ? static_cast<vtkIdType>(this->State.GetSelection().GetMesh().Faces.size())
                        : 0;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCoarseFaces()
{
  vtkIdType sum = 0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part) { sum += part->Internals->CountCoarseFaces(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::vtkInternals::CountCulledFaces() const
{
  return this->Drawable ? this->State.GetSelection().GetNumberOfHiddenFaces() : 0;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCulledFaces()
{
  vtkIdType sum = 0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part)
    {
      part->ReadSelection();
      sum += part->Internals->CountCulledFaces();
    });
  return sum;
}

//------------------------------------------------------------------------------
// Statistics since the mapper was made

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfSelections()
{
  vtkIdType sum = this->Internals->State.GetNumberOfSelections();
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfSelections(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfBufferBuilds()
{
  vtkIdType sum =
    this->Internals->NumberOfBufferBuilds + this->Internals->Upload.GetNumberOfBuilds();
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfBufferBuilds(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfShaderBuilds()
{
  vtkIdType sum =
    this->Internals->NumberOfShaderBuilds + this->Internals->Programs.GetNumberOfBuilds();
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfShaderBuilds(); });
  return sum;
}

//------------------------------------------------------------------------------

vtkTypeInt64 vtkAdaptiveRefinementMapper::GetGraphicsMemorySize()
{
  vtkInternals& data = *this->Internals;
  vtkTypeInt64 sum = data.Upload.GetMemorySize() + data.FaceColors.GetMemorySize() +
    data.Compute.GetMemorySize() + data.Methods.GetMemorySize();
  for (const char* name :
    { "vertexMC", "normalMC", "scalarColor", "tcoord", "colorTCoord", "tangentMC" })
  {
    if (vtkOpenGLVertexBufferObject* vbo = this->VBOs->GetVBO(name))
    {
      sum += static_cast<vtkTypeInt64>(vbo->GetNumberOfTuples()) * vbo->GetStride();
    }
  }
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetGraphicsMemorySize(); });
  return sum;
}

void vtkAdaptiveRefinementMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "FrustumCulling: " << (this->FrustumCulling ? "On\n" : "Off\n");
  os << indent << "BackFaceCulling: " << (this->BackFaceCulling ? "On\n" : "Off\n");
  os << indent << "Method: " << relevo::RefinementMethod::GetName(this->Method) << "\n";
  os << indent << "SelectionDevice: " << this->SelectionDevice << "\n";
  os << indent << "RefinementColorMode: " << this->RefinementColorMode << "\n";
  os << indent << "LevelLookupTable: " << this->LevelLookupTable.Get() << "\n";
  os << indent << "TargetNumberOfTriangles: " << this->GetTargetNumberOfTriangles() << "\n";
  os << indent << "UseAllocatedRenderTime: " << (this->UseAllocatedRenderTime ? "On\n" : "Off\n");
  os << indent << "LevelOffset: " << this->GetLevelOffset() << "\n";
  os << indent << "NumberOfCoarseFaces: " << this->GetNumberOfCoarseFaces() << "\n";
  os << indent << "NumberOfDrawnTriangles: " << this->GetNumberOfDrawnTriangles() << "\n";
  os << indent << "NumberOfCulledTriangles: " << this->GetNumberOfCulledTriangles() << "\n";
  os << indent << "NumberOfDrawCalls: " << this->GetNumberOfDrawCalls() << "\n";
  os << indent << "NumberOfSelections: " << this->GetNumberOfSelections() << "\n";
  os << indent << "NumberOfBufferBuilds: " << this->GetNumberOfBufferBuilds() << "\n";
  os << indent << "NumberOfShaderBuilds: " << this->GetNumberOfShaderBuilds() << "\n";
}
