// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptivePatchRepresentation.h"

#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "CurvedFaceGeometry.h"
#include "InputCells.h"
#include "MapperMessage.h"
#include "PatchTree.h"
#include "RepresentationReports.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPatchErrorDepthTagMetric.h"

#include <string>

struct vtkAdaptivePatchRepresentation::vtkPatchData
{
  relevo::PatchTree Patches;
  // Messages that were reported last.
  std::string Errors;
  std::string Warnings;
  std::string PatchWarnings;
  std::string EmptyWarning;
  std::string IsolineWarning;
};

vtkStandardNewMacro(vtkAdaptivePatchRepresentation);

vtkAdaptivePatchRepresentation::vtkAdaptivePatchRepresentation()
  : PatchData(new vtkPatchData)
{
  auto* geometry = relevo::CurvedFaceGeometry::New();
  this->GeometryFilter->Delete();
  this->GeometryFilter = geometry;
  this->MultiBlockMaker->SetInputConnection(geometry->GetOutputPort());
  this->UseCurvedFaces();
  vtkNew<vtkAdaptivePatchMapper> mapper;
  this->SetMapper(mapper);
}

vtkAdaptivePatchRepresentation::~vtkAdaptivePatchRepresentation() = default;

void vtkAdaptivePatchRepresentation::SetMapper(vtkAdaptivePatchMapper* mapper)
{
  this->Superclass::SetMapper(mapper);
}

void vtkAdaptivePatchRepresentation::SetScreenSpaceError(double pixels)
{
  // The range of vtkPatchErrorDepthTagMetric.
  relevo::SetInRange(this, "ScreenSpaceError", this->ScreenSpaceError, pixels, 0.001, 1e6);
}

void vtkAdaptivePatchRepresentation::Update()
{
  this->Superclass::Update();
  vtkPatchData& data = *this->PatchData;
  auto geometry = static_cast<relevo::CurvedFaceGeometry*>(this->GeometryFilter);
  if (relevo::ShouldReport(data.Errors, geometry->GetErrors()))
  {
    vtkErrorMacro(<< relevo::NameOwnRank(data.Errors));
  }
  if (relevo::ShouldReport(data.Warnings, geometry->GetWarnings()))
  {
    vtkWarningMacro(<< relevo::NameOwnRank(data.Warnings));
  }
  const bool hasNone = relevo::HasCellsButNone(
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr,
    relevo::CountFaces(this->MultiBlockMaker->GetOutputDataObject(0)),
    vtkMultiProcessController::GetGlobalController());
  const std::string warning =
    hasNone ? "The data have no 2D or 3D cells, so Adaptive Patches draws nothing." : "";
  relevo::ReportWarning(this, data.EmptyWarning, warning);
}

vtkDataObject* vtkAdaptivePatchRepresentation::ConvertPieces(vtkDataObject* pieces)
{
  vtkPatchData& data = *this->PatchData;
  auto patchMapper = static_cast<vtkAdaptivePatchMapper*>(this->GetMapper());
  vtkAdaptiveRefinement* recipe = patchMapper->GetRefinement();
  if (auto metric = vtkPatchErrorDepthTagMetric::SafeDownCast(recipe->GetMetric()))
  {
    metric->SetScreenSpaceError(this->ScreenSpaceError);
  }
  const char* name = this->GetColorArrayName();
  const bool lacksArray = patchMapper->GetIsolineSpacing() > 0.0 && !(name && name[0]);
  const std::string warning =
    lacksArray ? "There are no isolines without an array. Select a point array in Coloring." : "";
  relevo::ReportWarning(this, data.IsolineWarning, warning);
  vtkDataObject* patches = data.Patches.Make(pieces);
  if (relevo::ShouldReport(data.PatchWarnings, data.Patches.GetWarnings()))
  {
    vtkWarningMacro(<< relevo::NameOwnRank(data.PatchWarnings));
  }
  return patches;
}

void vtkAdaptivePatchRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
}
