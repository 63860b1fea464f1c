// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementFilter.h"

#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternChoice.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/RefinedPolyDataBuilder.h"
#include "Evaluation/SampledSurface.h"
#include "Mesh/RefinementMesh.h"
#include "Metrics/MetricCache.h"
#include "Metrics/PieceAgreement.h"
#include "Metrics/ViewTime.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <new>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkAdaptiveRefinementFilter);

vtkAdaptiveRefinementFilter::vtkAdaptiveRefinementFilter()
  : Sources(new relevo::TagSources)
{
}

vtkAdaptiveRefinementFilter::~vtkAdaptiveRefinementFilter() = default;

vtkCxxSetSmartPointerMacro(vtkAdaptiveRefinementFilter, Refinement, vtkAdaptiveRefinement);

vtkAdaptiveRefinement* vtkAdaptiveRefinementFilter::GetRefinement()
{
  return this->Refinement;
}

vtkCxxSetSmartPointerMacro(vtkAdaptiveRefinementFilter, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkAdaptiveRefinementFilter::GetController()
{
  return this->Controller;
}

vtkMTimeType vtkAdaptiveRefinementFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Refinement
    ? std::max({ own, this->Refinement->GetMTime(),
        relevo::GetViewTime(this->Refinement->GetMetric(), this->MakeView()) })
    : own;
}

bool vtkAdaptiveRefinementFilter::Prepare(
  vtkPolyData* input, relevo::RefinementMesh& mesh, relevo::PatternSelection& selection)
{
  const std::shared_ptr<relevo::MetricCache> source = this->Sources->Find(this, input);
  relevo::RefinementView view = this->MakeView();
  view.Displaced = relevo::SampledSurface::Make(this->Refinement);
  std::string error;
  std::string warning;
  const bool prepared = relevo::AgreeOnPiece(this->Controller, input, *source,
    this->Refinement ? this->Refinement->GetMetric() : nullptr, view,
    [&](relevo::GlobalSurfaceInfo* whole)
    {
      if (!relevo::PrepareMesh(input, this->Refinement, whole, mesh, error, warning))
      {
        return false;
      }
      if (whole)
      {
        whole->HasDirections = !mesh.Directions.empty();
      }
      return true;
    });
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  if (!prepared ||
    !relevo::SelectPatterns(input, this->Refinement, view, mesh, source, selection, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  const std::string patternWarning = relevo::FindNewWarning(this->Refinement, this->Warning);
  if (!patternWarning.empty())
  {
    vtkWarningMacro(<< patternWarning);
  }
  return true;
}

int vtkAdaptiveRefinementFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto refine = [&] {
    return this->Refine(vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(outputVector));
  };
  return relevo::CheckInputTypes(this, inputVector) &&
      relevo::RequestWithinMemory(this, outputVector, "the coarse mesh", refine)
    ? 1
    : 0;
}

bool vtkAdaptiveRefinementFilter::Refine(vtkPolyData* input, vtkPolyData* output)
{
  relevo::RefinementMesh mesh;
  relevo::PatternSelection selection;
  if (!this->Prepare(input, mesh, selection))
  {
    return false;
  }
  // Process the faces in parallel, in parts, so that progress is reported and the filter can be
  // aborted.
  double progress = 0.1;
  const vtkIdType numberOfFaces = static_cast<vtkIdType>(mesh.Faces.size());
  const relevo::FaceLoop forFaces =
    [&](double share, const std::function<void(vtkIdType, vtkIdType)>& work)
  {
    constexpr int parts = 10;
    for (int part = 0; part < parts; ++part)
    {
      this->UpdateProgress(progress);
      if (relevo::IsAborted(this))
      {
        return false;
      }
      vtkSMPTools::For(part * numberOfFaces / parts, (part + 1) * numberOfFaces / parts, work);
      progress += share / parts;
    }
    return true;
  };
  try
  {
    relevo::RefinedPolyDataBuilder builder(input, mesh, selection, this->Refinement, forFaces);
    if (!builder.Build(output))
    {
      output->Initialize();
      return true;
    }
    for (const std::string& name : builder.GetShortArrays())
    {
      vtkWarningMacro("Array \"" << name << "\" has too few tuples and is left out.");
    }
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    vtkErrorMacro("Not enough memory for " << selection.GetNumberOfTriangles() << " triangles.");
    return false;
  }
  this->UpdateProgress(1.0);
  return true;
}

void vtkAdaptiveRefinementFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
