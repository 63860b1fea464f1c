// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveCurveFilter.h"

#include "Changes/LatestTime.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Curves/CurveMesh.h"
#include "Curves/CurvePolyDataBuilder.h"
#include "Curves/CurveRadii.h"
#include "Curves/CurveTags.h"
#include "Metrics/ViewTime.h"
#include "View/CameraEye.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

vtkStandardNewMacro(vtkAdaptiveCurveFilter);

vtkAdaptiveCurveFilter::vtkAdaptiveCurveFilter() = default;
vtkAdaptiveCurveFilter::~vtkAdaptiveCurveFilter() = default;

vtkCxxSetSmartPointerMacro(vtkAdaptiveCurveFilter, Refinement, vtkAdaptiveRefinement);

vtkAdaptiveRefinement* vtkAdaptiveCurveFilter::GetRefinement()
{
  return this->Refinement;
}

void vtkAdaptiveCurveFilter::SetRepresentation(int representation)
{
  relevo::SetChoice(
    this, "Representation", this->Representation, representation, { "LINES", "RIBBONS", "TUBES" });
}

void vtkAdaptiveCurveFilter::SetRadius(double radius)
{
  relevo::SetInRange(
    this, "Radius", this->Radius, radius, this->GetRadiusMinValue(), this->GetRadiusMaxValue());
}

void vtkAdaptiveCurveFilter::SetRadiusArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->RadiusArrayName != text)
  {
    this->RadiusArrayName = text;
    this->Modified();
  }
}

const char* vtkAdaptiveCurveFilter::GetRadiusArrayName()
{
  return this->RadiusArrayName.c_str();
}

void vtkAdaptiveCurveFilter::SetNumberOfSides(int sides)
{
  relevo::SetInRange(this, "NumberOfSides", this->NumberOfSides, sides,
    this->GetNumberOfSidesMinValue(), this->GetNumberOfSidesMaxValue());
}

vtkMTimeType vtkAdaptiveCurveFilter::GetMTime()
{
  const vtkMTimeType own = this->Representation == RIBBONS
    ? relevo::GetLatestTime(this->Superclass::GetMTime(), { this->Camera, this->ModelToWorld })
    : this->Superclass::GetMTime();
  return this->Refinement
    ? std::max({ own, this->Refinement->GetMTime(),
        relevo::GetViewTime(this->Refinement->GetMetric(), this->MakeView()) })
    : own;
}

int vtkAdaptiveCurveFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

bool vtkAdaptiveCurveFilter::MakeStyle(vtkPointSet* input, relevo::CurveStyle& style)
{
  style.Shape = static_cast<relevo::CurveShape>(this->Representation);
  style.Radius = this->Radius;
  style.NumberOfSides = this->NumberOfSides;
  if (this->Representation == RIBBONS)
  {
    if (!this->Camera)
    {
      vtkErrorMacro("Ribbons need a camera to face: call SetCamera().");
      return false;
    }
    vtkNew<vtkMatrix4x4> worldToModel;
    if (this->ModelToWorld)
    {
      vtkMatrix4x4::Invert(this->ModelToWorld, worldToModel);
    }
    const relevo::dvec4 eye = relevo::GetEye(this->Camera, worldToModel);
    style.Eye = eye.w == 0.0 ? eye : eye / eye.w;
  }
  if (this->Representation == LINES || this->RadiusArrayName.empty())
  {
    return true;
  }
  std::string error;
  style.RadiusArray = relevo::FindCurveRadii(input, this->RadiusArrayName, error);
  if (!style.RadiusArray)
  {
    vtkErrorMacro(<< error);
  }
  return style.RadiusArray != nullptr;
}

// Reports invalid cells. Returns false after an error if no curve is left.
bool vtkAdaptiveCurveFilter::Check(vtkPointSet* input, const relevo::CurveMesh& mesh)
{
  if (!mesh.GetError().empty())
  {
    vtkErrorMacro(<< mesh.GetError());
  }
  if (!mesh.GetWarning().empty())
  {
    vtkWarningMacro(<< mesh.GetWarning());
  }
  if (mesh.GetNumberOfCurves() > 0)
  {
    return true;
  }
  if (input->GetNumberOfCells() == 0)
  {
    vtkErrorMacro("The input has no cells: there is nothing to refine.");
  }
  else if (mesh.GetError().empty() && mesh.GetWarning().empty())
  {
    vtkErrorMacro("None of the input's cells is a curve.");
  }
  return !mesh.GetWarning().empty();
}

bool vtkAdaptiveCurveFilter::Build(vtkPointSet* input, const relevo::CurveMesh& mesh,
  const relevo::CurveTags& tags, const relevo::CurveStyle& style, vtkPolyData* output)
{
  const std::vector<int>& segments = tags.GetSegments();
  const auto build = [&]
  {
    relevo::CurvePolyDataBuilder builder(input, mesh, segments, style);
    builder.Build(this->Refinement->GetNoDataMagnitude(), output);
    for (const std::string& name : builder.GetShortArrays())
    {
      vtkWarningMacro("Array \"" << name << "\" has too few tuples and is left out.");
    }
  };
  if (!relevo::FitsMemory(build))
  {
    output->Initialize();
    vtkErrorMacro("Not enough memory for "
      << std::accumulate(segments.begin(), segments.end(), vtkIdType(0)) << " segments.");
    return false;
  }
  return true;
}

int vtkAdaptiveCurveFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  if (!this->Refinement)
  {
    vtkErrorMacro("There is no recipe: call SetRefinement() with a vtkAdaptiveRefinement.");
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the curves of the input",
    [&] {
      return this->Cut(vtkPointSet::GetData(inputVector[0]), vtkPolyData::GetData(outputVector));
    });
}

int vtkAdaptiveCurveFilter::Cut(vtkPointSet* input, vtkPolyData* output)
{
  relevo::CurveMesh mesh;
  mesh.Build(input);
  relevo::CurveTags tags;
  relevo::CurveStyle style;
  std::string error;
  if (!this->Check(input, mesh) || !this->MakeStyle(input, style))
  {
    return 0;
  }
  if (!tags.Compute(this->Refinement, input, mesh, this->MakeView(), error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  return mesh.GetNumberOfCurves() == 0 || this->Build(input, mesh, tags, style, output) ? 1 : 0;
}

void vtkAdaptiveCurveFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "Representation: " << this->Representation << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "NumberOfSides: " << this->NumberOfSides << "\n";
}
