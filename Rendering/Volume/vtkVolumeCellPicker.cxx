// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeCellPicker.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Probe/ProbeRequest.h"
#include "Probe/ProbedVolumes.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkLODProp3D.h"
#include "vtkObjectFactory.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
vtkVolumeProperty* FindProperty(vtkProp3D* prop)
{
  if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    return volume->GetProperty();
  }
  vtkVolumeProperty* property = nullptr;
  if (auto* levels = vtkLODProp3D::SafeDownCast(prop))
  {
    levels->GetLODProperty(levels->GetPickLODID(), &property);
  }
  return property;
}
}

struct vtkVolumeCellPicker::vtkInternals
{
  relevo::ProbedVolumes Volumes;
};

vtkStandardNewMacro(vtkVolumeCellPicker);

vtkVolumeCellPicker::vtkVolumeCellPicker()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkVolumeCellPicker::~vtkVolumeCellPicker() = default;

double vtkVolumeCellPicker::IntersectVolumeWithLine(const double p1[3], const double p2[3],
  double t1, double t2, vtkProp3D* prop, vtkAbstractVolumeMapper* volumeMapper)
{
  auto* mapper = vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volumeMapper);
  if (!mapper)
  {
    return this->Superclass::IntersectVolumeWithLine(p1, p2, t1, t2, prop, volumeMapper);
  }
  vtkVolumeProperty* property = FindProperty(prop);
  relevo::dvec3 begin;
  relevo::dvec3 end;
  this->Transform->TransformPoint(p1, &begin.x);
  this->Transform->TransformPoint(p2, &end.x);
  const double size = distance(begin, end);
  if (!property || !(size > 0.0))
  {
    return VTK_DOUBLE_MAX;
  }
  const relevo::Ray ray = { mix(begin, end, t1), (end - begin) / size, (t2 - t1) * size };
  relevo::ProbedVolume& probed = this->Internals->Volumes.Get(mapper);
  relevo::StageReport report;
  relevo::VolumeHit hit;
  const bool isHit = relevo::RunWithinMemory(this, "the mesh",
    [&]
    {
      const relevo::ProbeRequest request = mapper->MakeProbeRequest(property);
      return probed.Update(request, report) &&
        probed.Find(request, this->Transform->GetMatrix(), ray, this->OpacityThreshold, hit);
    });
  report.InvokeEvents(this);
  if (!isHit)
  {
    return VTK_DOUBLE_MAX;
  }
  const double t = t1 + hit.Distance / size;
  if (t < this->GlobalTMin)
  {
    const double towardsCamera[3] = { p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2] };
    this->Store(mapper, hit, towardsCamera);
  }
  return t;
}

void vtkVolumeCellPicker::Store(vtkGPUUnstructuredGridVolumeMapper* mapper,
  const relevo::VolumeHit& hit, const double towardsCamera[3])
{
  this->ResetPickInfo();
  this->Mapper = mapper;
  this->DataSet = hit.Mesh;
  this->CompositeDataSet = vtkCompositeDataSet::SafeDownCast(mapper->GetDataObjectInput());
  this->FlatBlockIndex = hit.FlatIndex;
  this->CellId = hit.Cell.Id;
  this->SubId = hit.Cell.SubId;
  this->PointId = hit.Cell.NearestPoint;
  std::copy(&hit.Cell.Parameters.x, &hit.Cell.Parameters.x + 3, this->PCoords);
  std::copy(&hit.MeshPosition.x, &hit.MeshPosition.x + 3, this->MapperPosition);
  const relevo::dvec3 back =
    normalize(relevo::dvec3(towardsCamera[0], towardsCamera[1], towardsCamera[2]));
  const double size = length(hit.Gradient);
  const relevo::dvec3 normal = size > 0.0 ? hit.Gradient / size : back;
  std::copy(&normal.x, &normal.x + 3, this->MapperNormal);
}

void vtkVolumeCellPicker::SetOpacityThreshold(double opacity)
{
  relevo::SetInRange(this, "OpacityThreshold", this->OpacityThreshold, opacity, 1e-6, 1.0);
}

void vtkVolumeCellPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OpacityThreshold: " << this->OpacityThreshold << "\n";
}
