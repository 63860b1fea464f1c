// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeProp.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkObjectFactory.h"

namespace relevo
{
vtkStandardNewMacro(VolumeProp);

void VolumeProp::SetMapper(vtkAbstractVolumeMapper* mapper)
{
  this->vtkVolume::SetMapper(mapper);
}

vtkAbstractVolumeMapper* VolumeProp::GetMapper()
{
  return this->Mapper;
}

void VolumeProp::SetProperty(vtkVolumeProperty* property)
{
  this->vtkVolume::SetProperty(property);
}

double* VolumeProp::GetBounds()
{
  return this->vtkVolume::GetBounds();
}

int VolumeProp::RenderOpaqueGeometry(vtkViewport*)
{
  return 0;
}

int VolumeProp::RenderTranslucentPolygonalGeometry(vtkViewport*)
{
  return 0;
}

int VolumeProp::HasTranslucentPolygonalGeometry()
{
  return 0;
}

int VolumeProp::RenderVolumetricGeometry(vtkViewport* viewport)
{
  return this->Composited ? 0 : this->vtkVolume::RenderVolumetricGeometry(viewport);
}

void VolumeProp::SetAllocatedRenderTime(double time, vtkViewport* viewport)
{
  this->vtkVolume::SetAllocatedRenderTime(time, viewport);
}

void VolumeProp::ReleaseGraphicsResources(vtkWindow* window)
{
  this->vtkVolume::ReleaseGraphicsResources(window);
}
}
