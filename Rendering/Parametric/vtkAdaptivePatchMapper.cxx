// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptivePatchMapperInternals.h"

#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Mesh/PatchArrays.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDataArray.h"
#include "vtkDepthTagMetric.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkAdaptivePatchMapper);

namespace
{
constexpr double LargestLength = VTK_FLOAT_MAX; // shaders take floats
}

vtkAdaptivePatchMapper::vtkAdaptivePatchMapper()
  : Patches(new vtkInternals)
{
  vtkNew<vtkPatchSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  vtkNew<vtkPatchErrorDepthTagMetric> metric;
  recipe->SetSurface(surface);
  recipe->SetMetric(metric);
  recipe->SetLevelRule(vtkDepthTagMetric::PER_EDGE);
  recipe->SetSegmentPolicy(vtkAdaptiveRefinement::WHOLE_NUMBERS);
  recipe->SetMaximumLevel(7);
  this->SetRefinement(recipe);
}

vtkAdaptivePatchMapper::~vtkAdaptivePatchMapper()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
// Settings

void vtkAdaptivePatchMapper::SetExactScalars(bool exact)
{
  this->SetLive(this->ExactScalars, exact);
}

void vtkAdaptivePatchMapper::SetIsolineSpacing(double spacing)
{
  if (relevo::CheckRange(this, "IsolineSpacing", spacing, 0.0, LargestLength))
  {
    this->SetLive(this->IsolineSpacing, spacing);
  }
}

void vtkAdaptivePatchMapper::SetIsolineWidth(double pixels)
{
  if (relevo::CheckRange(this, "IsolineWidth", pixels, 0.0, LargestLength))
  {
    this->SetLive(this->IsolineWidth, pixels);
  }
}

void vtkAdaptivePatchMapper::SetIsolineColor(double red, double green, double blue)
{
  if (relevo::CheckVector<3>(this, "IsolineColor", { red, green, blue }, 0.0, 1.0))
  {
    this->SetLive(this->IsolineColor[0], red);
    this->SetLive(this->IsolineColor[1], green);
    this->SetLive(this->IsolineColor[2], blue);
  }
}

void vtkAdaptivePatchMapper::SetPatchEdges(bool edges)
{
  this->SetLive(this->PatchEdges, edges);
}

void vtkAdaptivePatchMapper::CopyPatchSettings(vtkAdaptivePatchMapper* other)
{
  this->SetExactScalars(other->ExactScalars);
  this->SetIsolineSpacing(other->IsolineSpacing);
  this->SetIsolineWidth(other->IsolineWidth);
  this->SetIsolineColor(other->IsolineColor);
  this->SetPatchEdges(other->PatchEdges);
}

void vtkAdaptivePatchMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (vtkAdaptivePatchMapper* other = vtkAdaptivePatchMapper::SafeDownCast(mapper))
  {
    this->CopyPatchSettings(other);
  }
}

void vtkAdaptivePatchMapper::UpdateBlocks()
{
  this->Superclass::UpdateBlocks();
  this->ForEachBlock([this](vtkAdaptiveRefinementMapper* block)
    { vtkAdaptivePatchMapper::SafeDownCast(block)->CopyPatchSettings(this); });
}

//------------------------------------------------------------------------------
// The field on the GPU

vtkDataArray* vtkAdaptivePatchMapper::vtkInternals::GetScalars(vtkAdaptivePatchMapper* mapper)
{
  vtkPolyData* input = mapper->GetInput();
  const bool areMapped =
    mapper->VBOs->GetNumberOfComponents("scalarColor") != 0 || mapper->ColorCoordinates;
  int cellFlag = 0;
  vtkAbstractArray* scalars = input && areMapped
    ? vtkAbstractMapper::GetAbstractScalars(input, mapper->ScalarMode, mapper->ArrayAccessMode,
        mapper->ArrayId, mapper->ArrayName, cellFlag)
    : nullptr;
  return cellFlag == 0 ? vtkDataArray::SafeDownCast(scalars) : nullptr;
}

bool vtkAdaptivePatchMapper::vtkInternals::AreColors(
  vtkAdaptivePatchMapper* mapper, vtkDataArray* scalars)
{
  return mapper->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mapper->ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars));
}

std::string vtkAdaptivePatchMapper::vtkInternals::DescribeMisfit(
  vtkAdaptivePatchMapper* mapper, vtkDataArray* scalars)
{
  vtkPolyData* mesh = mapper->GetInput();
  const std::string name =
    std::string(relevo::PatchNodesPrefix) + (scalars->GetName() ? scalars->GetName() : "");
  vtkAbstractArray* nodes = mesh->GetFieldData()->GetAbstractArray(name.c_str());
  vtkAbstractArray* points = mesh->GetFieldData()->GetAbstractArray(relevo::PatchPointsName);
  std::ostringstream text;
  if (nodes && !relevo::PatchArrays::FindNodes(mesh, scalars))
  {
    text << "Cannot evaluate scalars at every pixel: the array " << name << " has "
         << nodes->GetNumberOfTuples() << " tuples of " << nodes->GetNumberOfComponents()
         << " components, not " << (points ? points->GetNumberOfTuples() : 0) << " of "
         << scalars->GetNumberOfComponents() << " numbers. They are interpolated.";
  }
  return text.str();
}

void vtkAdaptivePatchMapper::UploadField(vtkRenderer* ren)
{
  vtkInternals& data = *this->Patches;
  data.Scalars.ReleaseGraphicsResources(ren->GetRenderWindow());
  vtkDataArray* scalars = vtkInternals::GetScalars(this);
  std::string problem;
  if (scalars && this->ExactScalars)
  {
    const relevo::PatchScalars::Source source = { this->GetInput(), scalars,
      vtkInternals::AreColors(this, scalars), this->GetLookupTable(), this->ArrayComponent,
      this->ColorCoordinates != nullptr, this->GetRefinement()->GetNoDataMagnitude() };
    problem = data.DescribeMisfit(this, scalars);
    if (!data.Scalars.Upload(vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), source))
    {
      problem = "Cannot evaluate scalars at every pixel: " + relevo::BufferTexture::GetTooLarge() +
        ". They are interpolated.";
      data.Scalars.ReleaseGraphicsResources(ren->GetRenderWindow());
    }
  }
  if (relevo::ShouldReport(data.FieldProblem, problem))
  {
    vtkErrorMacro(<< problem);
  }
}

std::string vtkAdaptivePatchMapper::vtkInternals::DescribeMissingIsolines(
  vtkAdaptivePatchMapper* mapper)
{
  vtkPolyData* input = mapper->GetInput();
  int cellFlag = 0;
  vtkAbstractArray* scalars = input && mapper->ScalarVisibility && mapper->IsolineSpacing > 0.0
    ? vtkAbstractMapper::GetAbstractScalars(input, mapper->ScalarMode, mapper->ArrayAccessMode,
        mapper->ArrayId, mapper->ArrayName, cellFlag)
    : nullptr;
  if (!scalars)
  {
    return "";
  }
  std::ostringstream text;
  text << "There are no isolines of \"" << (scalars->GetName() ? scalars->GetName() : "") << "\": ";
  if (cellFlag != 0)
  {
    text << "its values belong to cells, and are constant in each. Convert them with "
            "vtkCellDataToPointData.";
    return text.str();
  }
  // Coefficients enclose the values, but not those of lengths.
  vtkDataArray* nodes = relevo::PatchArrays::FindNodes(input, scalars);
  if (!nodes || !mapper->ExactScalars || nodes->GetNumberOfComponents() != 1)
  {
    return "";
  }
  double range[2];
  nodes->GetRange(range);
  const double first = std::ceil(range[0] / mapper->IsolineSpacing) * mapper->IsolineSpacing;
  if (!(range[0] <= range[1] && first > range[1]))
  {
    return "";
  }
  text << "no multiple of IsolineSpacing, which is " << mapper->IsolineSpacing
       << ", lies among its values from " << range[0] << " to " << range[1] << ".";
  return text.str();
}

void vtkAdaptivePatchMapper::UpdateField(vtkRenderer* ren)
{
  vtkInternals& data = *this->Patches;
  if (!this->IsDrawable() || !vtkPatchSurface::SafeDownCast(this->GetRefinement()->GetSurface()))
  {
    data.FieldDependencies.Clear();
    data.Scalars.ReleaseGraphicsResources(ren->GetRenderWindow());
    return;
  }
  relevo::Dependencies dependencies =
    relevo::Dependencies::On(this->GetBuildMTime(), this->ColorCoordinates != nullptr,
      this->GetRefinement()->GetNoDataMagnitude(), this->ExactScalars);
  dependencies.AddObject(this->GetInput());
  if (data.FieldDependencies.Update(dependencies))
  {
    this->UploadField(ren);
  }
}

//------------------------------------------------------------------------------
// Rendering

void vtkAdaptivePatchMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceStart(ren, act);
  vtkInternals& data = *this->Patches;
  data.IsSurface = act->GetProperty()->GetRepresentation() == VTK_SURFACE;
  this->UpdateField(ren);
  if (relevo::ShouldReport(data.LineProblem, vtkInternals::DescribeMissingIsolines(this)))
  {
    vtkWarningMacro(<< data.LineProblem);
  }
}

void vtkAdaptivePatchMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->Patches->Scalars.Deactivate();
  this->Superclass::RenderPieceFinish(ren, act);
}

void vtkAdaptivePatchMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Patches->Scalars.ReleaseGraphicsResources(window);
  this->Patches->FieldDependencies.Clear();
}

vtkTypeInt64 vtkAdaptivePatchMapper::GetGraphicsMemorySize()
{
  return this->Superclass::GetGraphicsMemorySize() + this->Patches->Scalars.GetMemorySize();
}

void vtkAdaptivePatchMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ExactScalars: " << (this->ExactScalars ? "On\n" : "Off\n");
  os << indent << "IsolineSpacing: " << this->IsolineSpacing << "\n";
  os << indent << "IsolineWidth: " << this->IsolineWidth << "\n";
  os << indent << "IsolineColor: " << this->IsolineColor[0] << " " << this->IsolineColor[1] << " "
     << this->IsolineColor[2] << "\n";
  os << indent << "PatchEdges: " << (this->PatchEdges ? "On\n" : "Off\n");
}
