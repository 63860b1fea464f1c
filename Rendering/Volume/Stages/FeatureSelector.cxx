// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/FeatureSelector.h"

#include "Checks/ShouldReport.h"
#include "Rays/IsoSurfaces.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"

#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

namespace relevo
{
namespace
{
void FindMesh(const VolumeMesh& mesh, VolumeShaderOptions& options)
{
  options.HasCellScalars = mesh.HasCellScalars;
  options.HasTetrahedra = mesh.HasTetrahedra;
  options.HasCurvedCells = mesh.HasCurvedCells;
  options.HasQuadraticCells = mesh.Layout.HasQuadraticCells;
  options.HasPyramids = mesh.Layout.HasPyramids;
  options.HasFoldedFaces = mesh.Layout.HasFoldedFaces;
  options.IsDiscontinuous = mesh.Layout.IsDiscontinuous;
  options.HasCornerScalars = mesh.Layout.HasCornerScalars;
  options.HasHangingFaces = mesh.Layout.HasHangingFaces;
}

void FindFunctions(const TransferFunctions& functions, VolumeShaderOptions& options)
{
  const std::vector<TransferFunctions::Curve>& curves = functions.GetCurves();
  options.NumberOfComponents = functions.GetNumberOfComponents();
  options.NumberOfCurves = static_cast<int>(curves.size());
  options.FirstComponent = curves.empty() ? 0 : curves.front().Component;
  options.AreDependent = functions.AreDependent();
  options.HasTables = !curves.empty() && !curves.front().Table.IsEmpty();
  // If a scalar of the whole ray is mapped, gradient opacities have no effect.
  const bool isIntegrated =
    options.Blending == BlendMode::Composite || options.Blending == BlendMode::Additive;
  options.HasGradientOpacity = isIntegrated && !options.HasTables && functions.NeedSteepness();
}

void FindMaterials(
  vtkVolumeProperty* property, const TransferFunctions& functions, VolumeShaderOptions& options)
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
}

// Options without effect are not set, so that no two shaders are the same.
void FeatureSelector::Update(const FeatureRequest& request, StageReport& report)
{
  VolumeShaderOptions& options = this->Features.Options;
  options = {};
  options.Blending = request.Blending;
  options.Segments = request.Segments;
  FindMesh(request.Mesh, options);
  FindFunctions(request.Functions.Functions, options);
  this->FindSurfaces(request, report);
  const bool isLit =
    request.Blending == BlendMode::Composite || request.Blending == BlendMode::IsoSurface;
  if (isLit && !options.HasCellScalars)
  {
    FindMaterials(request.Property, request.Functions.Functions, options);
  }
  this->FindPlanes(request, report);
  if (options.NumberOfMaterials > 0)
  {
    VolumeLights& lights = this->Features.Lights;
    lights.ReadMaterials(request.Property, options.NumberOfMaterials);
    lights.ReadLights(request.Renderer, request.MeshToWorld);
    options.NumberOfLights = lights.GetNumberOfLights();
  }
  this->FindTable(request, report);
}

void FeatureSelector::FindSurfaces(const FeatureRequest& request, StageReport& report)
{
  const bool isInside = request.Blending == BlendMode::Composite && request.HasSurfaces;
  const bool isAlone = request.Blending == BlendMode::IsoSurface;
  this->Features.Options.HasSurfaces = isAlone || isInside;
  const RayCastMesh& layout = request.Mesh.Layout;
  const int component = request.Functions.Surfaces.GetComponent();
  const std::string missing = isInside || isAlone
    ? IsoSurfaces::DescribeMissing(
        request.Property, { layout.ScalarLow[component], layout.ScalarHigh[component] })
    : "";
  if (ShouldReport(this->MissingSurfaces, missing))
  {
    report.Warnings.push_back(missing);
  }
}

void FeatureSelector::FindPlanes(const FeatureRequest& request, StageReport& report)
{
  MeshPlanes& planes = this->Features.Planes;
  const std::string error = planes.Compute(request.Planes, request.MeshToWorld)
    ? ""
    : "There are " + std::to_string(request.Planes->GetNumberOfItems()) +
      " clipping planes; the first " + std::to_string(MeshPlanes::MaximumPlanes) + " are used.";
  if (ShouldReport(this->PlaneError, error))
  {
    report.Errors.push_back(error);
  }
  this->Features.Options.IsClipped = !planes.IsEmpty();
}

// If the table does not support the options, the integration is exact.
void FeatureSelector::FindTable(const FeatureRequest& request, StageReport& report)
{
  VolumeShaderOptions& options = this->Features.Options;
  const bool isWanted = request.Blending == BlendMode::Composite && request.TableDimensions > 0;
  const bool isPossible = request.Functions.Functions.DependOnOneScalar() && !options.HasSurfaces &&
    options.NumberOfMaterials == 0;
  options.PreIntegrated = isWanted && isPossible ? request.TableDimensions : 0;
  const std::string error = isWanted && !isPossible
    ? "Pre-integration supports only one component, without gradients, shading and isosurfaces; "
      "exact integration is used instead."
    : "";
  if (ShouldReport(this->TableError, error))
  {
    report.Warnings.push_back(error);
  }
}
}
