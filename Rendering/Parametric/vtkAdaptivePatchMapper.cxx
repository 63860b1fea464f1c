// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptivePatchMapper.h"

#include "Actors/ShaderVariantKey.h"
#include "Buffers/PatchScalars.h"
#include "Changes/Dependencies.h"
#include "Checks/ErrorCollector.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Drawing/PickedPatch.h"
#include "Mesh/PatchArrays.h"
#include "Shaders/PatchShader.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellPicker.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDepthTagMetric.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkAdaptivePatchMapper);

namespace
{
constexpr double LargestLength = VTK_FLOAT_MAX; // shaders use floats

// Return why an input has no isolines; empty if it has some, or has no such scalars.
std::string DescribeMissingIsolines(
  vtkPolyData* input, vtkAbstractArray* scalars, bool areOfCells, double spacing, bool areExact)
{
  std::ostringstream text;
  text << "There are no isolines of \"" << (scalars->GetName() ? scalars->GetName() : "") << "\": ";
  if (areOfCells)
  {
    text << "a cell array is constant in each cell. Convert it with vtkCellDataToPointData.";
    return text.str();
  }
  // The range of coefficients contains that of the values, but not for the lengths of vectors.
  vtkDataArray* nodes = relevo::PatchArrays::FindNodes(input, scalars);
  if (!nodes || !areExact || nodes->GetNumberOfComponents() != 1)
  {
    return "";
  }
  double range[2];
  nodes->GetRange(range);
  const double first = std::ceil(range[0] / spacing) * spacing;
  if (!(range[0] <= range[1] && first > range[1]))
  {
    return "";
  }
  text << "no multiple of IsolineSpacing, which is " << spacing
       << ", is in the range of its values, " << range[0] << " to " << range[1] << ".";
  return text.str();
}
}

struct vtkAdaptivePatchMapper::vtkInternals
{
  relevo::PatchScalars Scalars;
  relevo::Dependencies FieldDependencies;
  std::string FieldError;   // reported last
  std::string IsolineError; // reported last

  // Used if the input is a grid.
  vtkNew<vtkPatchSurfaceFilter> Filter;
  relevo::Dependencies GridDependencies;

  bool IsSurface = false;             // whether the drawn actor is shown as a surface
  relevo::PatchShaderOptions Options; // of the shaders being built
};

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
// Input

int vtkAdaptivePatchMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  const int valid = this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return valid;
}

void vtkAdaptivePatchMapper::SetInputData(vtkUnstructuredGrid* grid)
{
  this->SetInputDataInternal(0, grid);
}

void vtkAdaptivePatchMapper::SetInputData(vtkPolyData* patches)
{
  this->SetInputDataInternal(0, patches);
}

vtkDataObject* vtkAdaptivePatchMapper::ConvertInput(vtkDataObject* input)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!grid)
  {
    return this->Superclass::ConvertInput(input);
  }
  vtkInternals& data = *this->Patches;
  relevo::Dependencies dependencies;
  dependencies.AddObject(grid);
  if (data.GridDependencies.Update(dependencies))
  {
    std::string errors;
    const unsigned long observer =
      data.Filter->AddObserver(vtkCommand::ErrorEvent, relevo::NewErrorCollector(errors));
    data.Filter->SetInputDataObject(grid);
    data.Filter->Update();
    data.Filter->RemoveObserver(observer);
    if (!errors.empty())
    {
      vtkErrorMacro("Not all of the grid can be drawn: " << errors);
    }
  }
  return data.Filter->GetOutput();
}

//------------------------------------------------------------------------------
// The field on the GPU

vtkDataArray* vtkAdaptivePatchMapper::FindMappedScalars()
{
  vtkPolyData* input = this->GetInput();
  const bool areMapped =
    this->VBOs->GetNumberOfComponents("scalarColor") != 0 || this->ColorCoordinates;
  int cellFlag = 0;
  vtkAbstractArray* scalars = input && areMapped
    ? vtkAbstractMapper::GetAbstractScalars(
        input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag)
    : nullptr;
  return cellFlag == 0 ? vtkDataArray::SafeDownCast(scalars) : nullptr;
}

void vtkAdaptivePatchMapper::UploadField(vtkRenderer* ren)
{
  vtkInternals& data = *this->Patches;
  vtkDataArray* scalars = this->FindMappedScalars();
  std::string error;
  if (scalars && this->ExactScalars)
  {
    const bool areColors = this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
      (this->ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars));
    const relevo::FieldScalars field = { scalars, areColors, this->GetLookupTable(),
      this->ArrayComponent, this->ColorCoordinates != nullptr,
      this->GetRefinement()->GetNoDataMagnitude() };
    error = relevo::PatchScalars::DescribeMisfit(this->GetInput(), scalars);
    if (!data.Scalars.Upload(
          vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), this->GetInput(), field))
    {
      error = "Cannot evaluate scalars at every pixel: " + relevo::BufferTexture::GetTooLarge() +
        ". The scalars are interpolated.";
      data.Scalars.ReleaseGraphicsResources(ren->GetRenderWindow());
    }
  }
  else
  {
    data.Scalars.ReleaseGraphicsResources(ren->GetRenderWindow());
  }
  if (relevo::ShouldReport(data.FieldError, error))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkAdaptivePatchMapper::ReportMissingIsolines()
{
  vtkPolyData* input = this->GetInput();
  int cellFlag = 0;
  vtkAbstractArray* scalars = input && this->ScalarVisibility && this->IsolineSpacing > 0.0
    ? vtkAbstractMapper::GetAbstractScalars(
        input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag)
    : nullptr;
  const std::string error = scalars ? DescribeMissingIsolines(input, scalars, cellFlag != 0,
                                        this->IsolineSpacing, this->ExactScalars)
                                    : "";
  if (relevo::ShouldReport(this->Patches->IsolineError, error))
  {
    vtkWarningMacro(<< error);
  }
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
  this->ReportMissingIsolines();
}

void vtkAdaptivePatchMapper::ExtendShaders(
  const vtkOpenGLHelper*, relevo::ShaderExtension& extension)
{
  vtkInternals& data = *this->Patches;
  relevo::PatchShaderOptions options;
  if (vtkPatchSurface::SafeDownCast(this->GetRefinement()->GetSurface()) && !this->DrawingVertices)
  {
    if (this->ExactScalars && this->GetRefinementColorMode() == COLOR_BY_SCALARS)
    {
      options.Coloring = data.Scalars.GetColoring();
      options.IsRational = data.Scalars.IsRational();
      options.IsNumber = data.Scalars.IsNumber();
    }
    options.HasIsolines = options.HasColors() &&
      options.Coloring != relevo::FieldColoring::COLORS && data.IsSurface &&
      static_cast<float>(this->IsolineSpacing) > 0.0f;
    options.HasEdges = data.IsSurface && this->PatchEdges;
  }
  data.Options = options;
  if (!options.IsEmpty())
  {
    relevo::ExtendPatchShaders(options, extension);
  }
}

void vtkAdaptivePatchMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  const relevo::PatchShaderOptions options =
    this->IsFaceHelper(this->LastBoundBO) ? this->Patches->Options : relevo::PatchShaderOptions();
  relevo::PreparePatchShaders(options, relevo::HasOwnFragments(act), shaders, this->MissingAnchors);
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  relevo::FinishPatchShaders(options, shaders, this->MissingAnchors);
}

void vtkAdaptivePatchMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  vtkShaderProgram* program = cellBO.Program;
  if (!this->IsFaceHelper(&cellBO) || !program->IsUniformUsed("relevoTablePoints"))
  {
    return;
  }
  vtkInternals& data = *this->Patches;
  data.Scalars.Activate(program);
  if (program->IsUniformUsed("relevoIsolines"))
  {
    // The bias is subtracted from the values. Its remainder keeps multiples of the spacing exact
    // far from zero.
    const float isolines[3] = { static_cast<float>(this->IsolineSpacing),
      static_cast<float>(std::fmod(data.Scalars.GetBias(), this->IsolineSpacing)),
      static_cast<float>(this->IsolineWidth) };
    program->SetUniform3f("relevoIsolines", isolines);
    program->SetUniform3f("relevoIsolineColor", this->IsolineColor);
  }
  if (program->IsUniformUsed("relevoPatchEdgeWidth"))
  {
    program->SetUniformf("relevoPatchEdgeWidth", act->GetProperty()->GetLineWidth());
    program->SetUniform3f("relevoPatchEdgeColor", act->GetProperty()->GetEdgeColor());
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

//------------------------------------------------------------------------------

vtkIdType vtkAdaptivePatchMapper::GetPickedCell(vtkCellPicker* picker, double pcoords[3])
{
  return picker && picker->GetMapper() == this
    ? relevo::FindPickedPatch(vtkPolyData::SafeDownCast(picker->GetDataSet()), picker->GetCellId(),
        picker->GetPCoords(), pcoords)
    : -1;
}

vtkIdType vtkAdaptivePatchMapper::GetPickedCell(
  vtkIdType cellId, const double position[3], double pcoords[3], vtkPolyData* patches)
{
  return relevo::FindNearestPatch(patches ? patches : this->GetInput(), cellId, position, pcoords);
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
