// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/LatestTime.h"
#include "Checks/SettingChecks.h"
#include "Integral/TransferFunctions.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlanes.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRayCastFilter.h"

#include <algorithm>

vtkCxxSetSmartPointerMacro(vtkVolumeRayCastFilter, Camera, vtkCamera);

vtkCamera* vtkVolumeRayCastFilter::GetCamera()
{
  return this->Camera;
}

vtkCxxSetSmartPointerMacro(vtkVolumeRayCastFilter, VolumeProperty, vtkVolumeProperty);

vtkVolumeProperty* vtkVolumeRayCastFilter::GetVolumeProperty()
{
  return this->VolumeProperty;
}

void vtkVolumeRayCastFilter::SetViewportSize(int width, int height)
{
  relevo::SetPixelSize(this, "ViewportSize", this->ViewportSize, width, height);
}

void vtkVolumeRayCastFilter::SetVectorMode(int mode)
{
  relevo::SetInRange(this, "VectorMode", this->VectorMode, mode, static_cast<int>(DISABLED),
    static_cast<int>(COMPONENT));
}

void vtkVolumeRayCastFilter::SetVectorComponent(int component)
{
  relevo::SetInRange(
    this, "VectorComponent", this->VectorComponent, component, 0, relevo::MostComponents - 1);
}

void vtkVolumeRayCastFilter::SetBlendMode(int mode)
{
  relevo::SetChoice(this, "BlendMode", this->BlendMode, mode,
    { "COMPOSITE_BLEND", "MAXIMUM_INTENSITY_BLEND", "MINIMUM_INTENSITY_BLEND",
      "AVERAGE_INTENSITY_BLEND", "ADDITIVE_BLEND", "ISOSURFACE_BLEND" });
}

void vtkVolumeRayCastFilter::AddClippingPlane(vtkPlane* plane)
{
  if (!plane)
  {
    vtkErrorMacro("There is no plane to add.");
    return;
  }
  if (!this->ClippingPlanes)
  {
    this->ClippingPlanes = vtkSmartPointer<vtkPlaneCollection>::New();
  }
  this->ClippingPlanes->AddItem(plane);
  this->Modified();
}

void vtkVolumeRayCastFilter::RemoveClippingPlane(vtkPlane* plane)
{
  if (!this->ClippingPlanes || this->ClippingPlanes->IsItemPresent(plane) == 0)
  {
    vtkErrorMacro("The plane to remove is none of the clipping planes.");
    return;
  }
  this->ClippingPlanes->RemoveItem(plane);
  this->Modified();
}

void vtkVolumeRayCastFilter::RemoveAllClippingPlanes()
{
  if (this->ClippingPlanes && this->ClippingPlanes->GetNumberOfItems() > 0)
  {
    this->ClippingPlanes->RemoveAllItems();
    this->Modified();
  }
}

vtkCxxSetSmartPointerMacro(vtkVolumeRayCastFilter, ClippingPlanes, vtkPlaneCollection);

void vtkVolumeRayCastFilter::SetClippingPlanes(vtkPlanes* planes)
{
  constexpr int most = 6;
  if (!planes)
  {
    return;
  }
  this->RemoveAllClippingPlanes();
  for (int i = 0; i < std::min(planes->GetNumberOfPlanes(), most); ++i)
  {
    vtkNew<vtkPlane> plane;
    planes->GetPlane(i, plane);
    this->AddClippingPlane(plane);
  }
}

vtkPlaneCollection* vtkVolumeRayCastFilter::GetClippingPlanes()
{
  return this->ClippingPlanes;
}

vtkMTimeType vtkVolumeRayCastFilter::GetMTime()
{
  vtkMTimeType time = relevo::GetLatestTime(
    this->Superclass::GetMTime(), { this->Camera, this->VolumeProperty, this->ClippingPlanes });
  for (int i = 0; this->ClippingPlanes && i < this->ClippingPlanes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, this->ClippingPlanes->GetItemAsObject(i)->GetMTime());
  }
  return time;
}

void vtkVolumeRayCastFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " " << this->ViewportSize[1] << "\n";
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "IsoSurfaces: " << (this->IsoSurfaces ? "On" : "Off") << "\n";
  os << indent << "ClippingPlanes: " << this->ClippingPlanes << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "VolumeProperty: " << this->VolumeProperty << "\n";
}
