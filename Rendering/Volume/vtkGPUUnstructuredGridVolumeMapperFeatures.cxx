// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "Checks/ShouldReport.h"
#include "Rays/IsoSurfaces.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
using Curve = relevo::TransferFunctions::Curve;

void FindFunctions(const relevo::TransferFunctions& functions, relevo::VolumeShaderOptions& options)
{
  const std::vector<Curve>& curves = functions.GetCurves();
  options.NumberOfComponents = functions.GetNumberOfComponents();
  options.NumberOfCurves = static_cast<int>(curves.size());
  options.FirstComponent = curves.empty() ? 0 : curves.front().Component;
  options.AreDependent = functions.AreDependent();
  options.HasTables = !curves.empty() && !curves.front().Table.IsEmpty();
  // Where a scalar is mapped, gradient opacities have no effect.
  const bool isIntegrated = options.Blending == relevo::BlendMode::Composite ||
    options.Blending == relevo::BlendMode::Additive;
  options.HasGradientOpacity = isIntegrated && !options.HasTables && functions.NeedSteepness();
}

void FindMaterials(vtkVolumeProperty* property, const relevo::TransferFunctions& functions,
  relevo::VolumeShaderOptions& options)
{
  const int count = functions.AreIndependent() ? options.NumberOfCurves : 1;
  bool isShaded = false;
  for (int i = 0; i < count; ++i)
  {
    isShaded = isShaded || property->GetShade(i) != 0;
  }
  options.NumberOfMaterials = isShaded ? count : 0;
  options.FirstMaterial = isShaded ? functions.GetShadedComponent(0) : 0;
}

// Of the planes and their list.
vtkMTimeType GetTime(vtkPlaneCollection* planes)
{
  vtkMTimeType time = planes->GetMTime();
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItemAsObject(i)->GetMTime());
  }
  return time;
}
}

void vtkGPUUnstructuredGridVolumeMapper::ReportMissingSurfaces(vtkVolumeProperty* property)
{
  vtkInternals& data = *this->Internals;
  const bool areWanted = this->BlendMode == ISOSURFACE_BLEND ||
    (this->BlendMode == COMPOSITE_BLEND && this->IsoSurfaces);
  const int component = data.Surfaces.GetComponent();
  const std::string missing = areWanted
    ? relevo::IsoSurfaces::DescribeMissing(property,
        { data.HasCellScalars, data.Mesh.ScalarLow[component], data.Mesh.ScalarHigh[component] })
    : "";
  if (relevo::ShouldReport(data.MissingSurfaces, missing))
  {
    vtkWarningMacro(<< missing);
  }
}

// Only what has an effect counts, so that no two shaders are the same.
void vtkGPUUnstructuredGridVolumeMapper::UpdateFeatures(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  vtkVolumeProperty* property = volume->GetProperty();
  relevo::VolumeShaderOptions& options = data.Options;
  options = {};
  options.Blending = static_cast<relevo::BlendMode>(this->BlendMode);
  options.HasCellScalars = data.HasCellScalars;
  FindFunctions(data.Functions, options);
  const bool isComposite = this->BlendMode == COMPOSITE_BLEND;
  const bool isSurface = this->BlendMode == ISOSURFACE_BLEND;
  options.HasSurfaces = isSurface || (isComposite && this->IsoSurfaces && !data.HasCellScalars);
  this->ReportMissingSurfaces(property);
  if ((isComposite || isSurface) && !data.HasCellScalars)
  {
    FindMaterials(property, data.Functions, options);
  }

  const relevo::dmat4& meshToWorld = data.View.GetMeshToWorld();
  if (!data.Planes.Compute(this->ClippingPlanes, meshToWorld) &&
    data.PlanesTime != GetTime(this->ClippingPlanes))
  {
    data.PlanesTime = GetTime(this->ClippingPlanes);
    vtkErrorMacro("There are " << this->ClippingPlanes->GetNumberOfItems()
                               << " clipping planes; the first " << relevo::MeshPlanes::Most
                               << " are used.");
  }
  options.IsClipped = !data.Planes.IsEmpty();
  if (options.NumberOfMaterials > 0)
  {
    data.Lights.ReadMaterials(property, options.NumberOfMaterials);
    data.Lights.ReadLights(renderer, meshToWorld);
    options.NumberOfLights = data.Lights.GetNumberOfLights();
  }
}
