// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeProbe.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Probe/OpaqueSurfaces.h"
#include "Probe/ProbeRequest.h"
#include "Probe/ProbedVolumes.h"
#include "Rays/PixelRays.h"

#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDataSet.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace
{
using VisitVolume =
  std::function<void(vtkVolume*, vtkMatrix4x4*, vtkGPUUnstructuredGridVolumeMapper*)>;

void ForEachVolume(vtkRenderer* renderer, const VisitVolume& visit)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetVisibility() ? prop->GetNextPath() : nullptr)
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto* volume = vtkVolume::SafeDownCast(node->GetViewProp());
      auto* mapper =
        volume ? vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
      if (mapper && volume->GetVisibility() && volume->GetPickable())
      {
        visit(volume, node->GetMatrix(), mapper);
      }
    }
  }
}
}

struct vtkVolumeProbe::vtkInternals
{
  relevo::ProbedVolumes Volumes;
  relevo::OpaqueSurfaces Surfaces;
};

vtkStandardNewMacro(vtkVolumeProbe);

vtkVolumeProbe::vtkVolumeProbe()
  : Internals(std::make_unique<vtkInternals>())
{
  this->Clear();
}

vtkVolumeProbe::~vtkVolumeProbe() = default;

void vtkVolumeProbe::Clear()
{
  this->Volume = nullptr;
  this->DataSet = nullptr;
  this->CellId = -1;
  this->FlatBlockIndex = -1;
  this->NumberOfComponents = 1;
  this->Values.fill(std::numeric_limits<double>::quiet_NaN());
}

bool vtkVolumeProbe::Probe(double x, double y)
{
  this->Clear();
  if (!this->Renderer)
  {
    vtkErrorMacro("There is no renderer: call SetRenderer().");
    return false;
  }
  int width;
  int height;
  int left;
  int bottom;
  this->Renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const double column = x - left;
  const double row = y - bottom;
  if (!(column >= -0.5 && row >= -0.5 && column < width - 0.5 && row < height - 0.5))
  {
    return false;
  }
  relevo::Ray ray =
    relevo::PixelRays(this->Renderer->GetActiveCamera(), width, height).Make(column, row);
  ray.Length = this->Internals->Surfaces.FindNearest(this->Renderer, ray);
  ForEachVolume(this->Renderer,
    [&](vtkVolume* volume, vtkMatrix4x4* matrix, vtkGPUUnstructuredGridVolumeMapper* mapper)
    {
      if (mapper->GetBlendMode() == vtkGPUUnstructuredGridVolumeMapper::AVERAGE_INTENSITY_BLEND)
      {
        vtkErrorMacro("Average blending has no position along the ray: choose another blend mode.");
        return;
      }
      relevo::ProbedVolume& probed = this->Internals->Volumes.Get(mapper);
      relevo::StageReport report;
      relevo::VolumeHit hit;
      const bool isHit = relevo::RunWithinMemory(this, "the mesh",
        [&]
        {
          const relevo::ProbeRequest request = mapper->MakeProbeRequest(volume->GetProperty());
          return probed.Update(request, report) &&
            probed.Find(request, matrix, ray, this->OpacityThreshold, hit);
        });
      report.InvokeEvents(this);
      if (!isHit)
      {
        return;
      }
      ray.Length = hit.Distance;
      this->Volume = volume;
      this->DataSet = hit.Mesh;
      this->FlatBlockIndex = hit.FlatIndex;
      this->CellId = hit.Cell.Id;
      this->NumberOfComponents = probed.GetNumberOfComponents();
      this->Values = hit.Values;
      std::copy(&hit.Position.x, &hit.Position.x + 3, this->Position);
      std::copy(&hit.Cell.Parameters.x, &hit.Cell.Parameters.x + 3, this->ParametricCoordinates);
    });
  return this->CellId >= 0;
}

double vtkVolumeProbe::GetValue(int component)
{
  if (component < 0 || component >= this->NumberOfComponents)
  {
    vtkErrorMacro(
      "There is no component " << component << ": " << this->NumberOfComponents << " are drawn.");
    return std::numeric_limits<double>::quiet_NaN();
  }
  return this->Values[static_cast<size_t>(component)];
}

void vtkVolumeProbe::SetOpacityThreshold(double opacity)
{
  relevo::SetInRange(this, "OpacityThreshold", this->OpacityThreshold, opacity, 1e-6, 1.0);
}

vtkCxxSetSmartPointerMacro(vtkVolumeProbe, Renderer, vtkRenderer);

vtkRenderer* vtkVolumeProbe::GetRenderer()
{
  return this->Renderer;
}

vtkVolume* vtkVolumeProbe::GetVolume()
{
  return this->Volume;
}

vtkDataSet* vtkVolumeProbe::GetDataSet()
{
  return this->DataSet;
}

void vtkVolumeProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "OpacityThreshold: " << this->OpacityThreshold << "\n";
  os << indent << "CellId: " << this->CellId << "\n";
  os << indent << "FlatBlockIndex: " << this->FlatBlockIndex << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "DataSet: " << this->DataSet << "\n";
  os << indent << "Position: " << this->Position[0] << " " << this->Position[1] << " "
     << this->Position[2] << "\n";
  os << indent << "ParametricCoordinates: " << this->ParametricCoordinates[0] << " "
     << this->ParametricCoordinates[1] << " " << this->ParametricCoordinates[2] << "\n";
  os << indent << "NumberOfComponents: " << this->NumberOfComponents << "\n";
}
