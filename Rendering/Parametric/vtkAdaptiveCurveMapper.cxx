// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveCurveMapper.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Composite/DataLeaves.h"
#include "Composite/LeafMapper.h"
#include "Drawing/CurvePainter.h"
#include "OpenGL/ContextWatch.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
// A data set of the input, with its painter.
struct CurveLeaf
{
  using Painter = relevo::CurvePainter;
  std::vector<relevo::CurvePainter*> GetPainters() const
  {
    return std::vector<relevo::CurvePainter*>(this->Curves ? 1 : 0, this->Curves.Get());
  }

  // The kinds of errors of a data set.
  enum Kinds
  {
    CELLS,
    RADII,
    INPUT,
    COLORS,
    SHADERS,
    NUMBER_OF_KINDS
  };
  vtkSmartPointer<relevo::CurvePainter> Curves; // nullptr if the input has no curves
  std::string Prefix;                           // of messages
  std::string Errors[NUMBER_OF_KINDS];          // reported last
  std::string Warning;                          // reported last
  bool IsDrawn = false;                         // in the last render
};

// Report an error, unless the last one of that kind is the same.
void ReportLeaf(
  vtkAdaptiveCurveMapper* self, CurveLeaf& leaf, CurveLeaf::Kinds kind, const std::string& error)
{
  if (relevo::ShouldReport(leaf.Errors[kind], error))
  {
    vtkErrorWithObjectMacro(self, << leaf.Prefix << error);
  }
}

vtkPointSet* GetCurves(vtkDataObject* data)
{
  return vtkUnstructuredGrid::SafeDownCast(data) || vtkPolyData::SafeDownCast(data)
    ? static_cast<vtkPointSet*>(data)
    : nullptr;
}

std::string FindCellError(vtkPointSet* input, const relevo::CurveMesh& mesh)
{
  const bool hasNone = input->GetNumberOfCells() > 0 && mesh.GetNumberOfCurves() == 0 &&
    mesh.GetError().empty() && mesh.GetWarning().empty();
  return hasNone ? "None of the input's cells is a curve." : mesh.GetError();
}

// Copy the offsets of this mapper, in addition to those of all mappers.
void CopyCoincidentOffsets(vtkMapper* from, vtkMapper* to)
{
  double factor = 0.0;
  double units = 0.0;
  from->GetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  to->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  from->GetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
  to->SetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
  from->GetRelativeCoincidentTopologyPointOffsetParameter(units);
  to->SetRelativeCoincidentTopologyPointOffsetParameter(units);
}
}

struct vtkAdaptiveCurveMapper::vtkInternals
{
  relevo::LeafMapper<CurveLeaf> Leaves;
  vtkNew<relevo::ContextWatch> Context;
  std::string Error; // error of all leaves, reported last
  std::string TessellationError;
  int MethodInUse = METHOD_INSTANCING;

  // Return the sum of getNumber(painter) over the leaves that the last render drew.
  template <typename Number>
  vtkIdType SumOfFrame(const Number& getNumber) const
  {
    return this->Leaves.Sum([&getNumber](const CurveLeaf& leaf)
      { return leaf.IsDrawn ? static_cast<vtkIdType>(getNumber(*leaf.Curves)) : 0; });
  }
};

vtkStandardNewMacro(vtkAdaptiveCurveMapper);

vtkAdaptiveCurveMapper::vtkAdaptiveCurveMapper()
  : Internals(new vtkInternals)
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
  vtkNew<vtkCompositeDataPipeline> pipeline;
  this->SetExecutive(pipeline);
}

vtkAdaptiveCurveMapper::~vtkAdaptiveCurveMapper()
{
  // The resources are released here, while virtual calls still reach this class, in the context of
  // the window.
  this->ReleaseGraphicsResources(nullptr);
}

vtkCxxSetSmartPointerMacro(vtkAdaptiveCurveMapper, Refinement, vtkAdaptiveRefinement);

vtkAdaptiveRefinement* vtkAdaptiveCurveMapper::GetRefinement()
{
  return this->Refinement;
}

int vtkAdaptiveCurveMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* type : { "vtkUnstructuredGrid", "vtkPolyData", "vtkCompositeDataSet" })
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
  return 1;
}

void vtkAdaptiveCurveMapper::SetInputData(vtkPointSet* curves)
{
  this->SetInputDataInternal(0, curves);
}

//------------------------------------------------------------------------------
// Settings

void vtkAdaptiveCurveMapper::SetMethod(int method)
{
  relevo::SetChoice(
    this, "Method", this->Method, method, { "INSTANCING", "HARDWARE_TESSELLATION" });
}

void vtkAdaptiveCurveMapper::SetRepresentation(int representation)
{
  relevo::SetChoice(
    this, "Representation", this->Representation, representation, { "LINES", "RIBBONS", "TUBES" });
}

void vtkAdaptiveCurveMapper::SetRadius(double radius)
{
  relevo::SetInRange(this, "Radius", this->Radius, radius, 0.0, relevo::LargestDouble);
}

void vtkAdaptiveCurveMapper::SetRadiusArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->RadiusArrayName != text)
  {
    this->RadiusArrayName = text;
    this->Modified();
  }
}

void vtkAdaptiveCurveMapper::SetNumberOfSides(int sides)
{
  relevo::SetInRange(this, "NumberOfSides", this->NumberOfSides, sides, 3, 64);
}

void vtkAdaptiveCurveMapper::SetFrustumCulling(bool culling)
{
  if (this->FrustumCulling != culling)
  {
    this->FrustumCulling = culling;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// Input

void vtkAdaptiveCurveMapper::UpdateCurves()
{
  vtkInternals& data = *this->Internals;
  relevo::CurveGeometry::Shape shape;
  shape.Sides = this->Representation == LINES ? 1
    : this->Representation == RIBBONS         ? 2
                                              : this->NumberOfSides;
  shape.Radius = this->Radius;
  shape.RadiusArrayName = this->RadiusArrayName;
  data.Leaves.Update(relevo::FindDataLeaves(this->GetInputDataObject(0, 0)),
    data.Context->GetContext(),
    [&](const relevo::DataLeaf& input, CurveLeaf& leaf)
    {
      leaf.Prefix = input.GetPrefix();
      vtkPointSet* curves = GetCurves(input.Data);
      if (!curves)
      {
        ReportLeaf(this, leaf, CurveLeaf::CELLS,
          std::string("A ") + input.Data->GetClassName() +
            " has no curves: a vtkUnstructuredGrid or a vtkPolyData is needed.");
        leaf.Curves = nullptr;
        leaf.IsDrawn = false;
        return;
      }
      leaf.Curves = leaf.Curves ? leaf.Curves : vtkSmartPointer<relevo::CurvePainter>::New();
      if (leaf.Curves->SetCurves(curves))
      {
        const relevo::CurveMesh& mesh = leaf.Curves->GetMesh();
        ReportLeaf(this, leaf, CurveLeaf::CELLS, FindCellError(curves, mesh));
        if (relevo::ShouldReport(leaf.Warning, mesh.GetWarning()))
        {
          vtkWarningMacro(<< leaf.Prefix << leaf.Warning);
        }
      }
      ReportLeaf(this, leaf, CurveLeaf::RADII, leaf.Curves->SetShape(shape));
    });
}

double* vtkAdaptiveCurveMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return this->Bounds;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->UpdateCurves();
  vtkBoundingBox box;
  for (relevo::CurvePainter* painter : this->Internals->Leaves.GetPainters())
  {
    double bounds[6];
    painter->GetCurveBounds(bounds);
    box.AddBounds(bounds); // ignored if not initialized
  }
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
  return this->Bounds;
}

bool vtkAdaptiveCurveMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry();
}

bool vtkAdaptiveCurveMapper::HasTranslucentPolygonalGeometry()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  for (const relevo::DataLeaf& leaf : relevo::FindDataLeaves(this->GetInputDataObject(0, 0)))
  {
    int cellFlag = 0;
    vtkPointSet* curves = GetCurves(leaf.Data);
    vtkAbstractArray* scalars = curves && this->ScalarVisibility
      ? this->GetAbstractScalars(
          curves, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag)
      : nullptr;
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(scalars);
    vtkScalarsToColors* table = numbers ? numbers->GetLookupTable() : nullptr;
    table = table ? table : this->GetLookupTable();
    if (scalars && !table->IsOpaque(scalars, this->ColorMode, this->ArrayComponent))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Rendering

void vtkAdaptiveCurveMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (window->CheckAbortStatus())
  {
    return;
  }
  for (auto& entry : data.Leaves.GetLeaves())
  {
    entry.second.IsDrawn = false;
  }
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("There is no input: call SetInputConnection() or SetInputData().");
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  const std::string error = this->Refinement
    ? ""
    : "There is no recipe: call SetRefinement() with a vtkAdaptiveRefinement.";
  if (relevo::ShouldReport(data.Error, error))
  {
    vtkErrorMacro(<< error);
  }
  if (error.empty())
  {
    // This releases resources in the context of another window.
    data.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
    relevo::RunWithinMemory(this, "the curves",
      [&]
      {
        this->UpdateCurves();
        this->RenderCurves(renderer, actor);
        return true;
      });
  }
  this->UpdateProgress(1.0);
}

void vtkAdaptiveCurveMapper::RenderCurves(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  relevo::CurvePainter::Settings settings;
  settings.Recipe = this->Refinement;
  settings.Scalars = this;
  settings.IsTessellated = this->Method == METHOD_HARDWARE_TESSELLATION;
  settings.IsCulled = this->FrustumCulling;
  std::string tessellationError;
  data.Leaves.Render(renderer,
    [&](CurveLeaf& leaf)
    {
      if (!leaf.Curves || !leaf.Errors[CurveLeaf::RADII].empty())
      {
        return;
      }
      leaf.Curves->SetClippingPlanes(this->ClippingPlanes);
      CopyCoincidentOffsets(this, leaf.Curves);
      const std::string error = leaf.Curves->Prepare(renderer, actor, settings);
      ReportLeaf(this, leaf, CurveLeaf::INPUT, error);
      ReportLeaf(this, leaf, CurveLeaf::COLORS, leaf.Curves->GetColorError());
      if (!error.empty())
      {
        return;
      }
      if (vtkHardwareSelector* selector = renderer->GetSelector())
      {
        leaf.Curves->AnnounceIds(selector);
      }
      leaf.Curves->RenderPiece(renderer, actor);
      leaf.IsDrawn = true;
      ReportLeaf(this, leaf, CurveLeaf::SHADERS, leaf.Curves->GetShaderError());
      if (!leaf.Curves->GetTessellationError().empty())
      {
        tessellationError = "The method HARDWARE_TESSELLATION cannot be used: " +
          leaf.Curves->GetTessellationError() + ". The method INSTANCING is used instead.";
      }
      data.MethodInUse =
        leaf.Curves->IsTessellated() ? METHOD_HARDWARE_TESSELLATION : METHOD_INSTANCING;
    });
  if (relevo::ShouldReport(data.TessellationError, tessellationError))
  {
    vtkErrorMacro(<< tessellationError);
  }
}

void vtkAdaptiveCurveMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // a recursive call, in the context that owns the resources
  }
  this->Superclass::ReleaseGraphicsResources(window);
  data.Leaves.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
// Counts

int vtkAdaptiveCurveMapper::GetMethodInUse()
{
  return this->Internals->MethodInUse;
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfDrawnSegments()
{
  return this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.CountDrawnSegments(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfCulledSegments()
{
  return this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.CountHiddenSegments(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfCurves()
{
  return this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.GetMesh().GetNumberOfCurves(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfCulledCurves()
{
  return this->Internals->SumOfFrame([](const relevo::CurvePainter& painter)
    { return painter.GetCurveSelection().GetNumberOfHiddenCurves(); });
}

int vtkAdaptiveCurveMapper::GetNumberOfDrawCalls()
{
  return static_cast<int>(this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.GetNumberOfDrawCalls(); }));
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfSelections()
{
  return this->Internals->Leaves.GetCounts().Selections;
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfBufferBuilds()
{
  return this->Internals->Leaves.GetCounts().BufferBuilds;
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfShaderBuilds()
{
  return this->Internals->Leaves.GetCounts().ShaderBuilds;
}

vtkTypeInt64 vtkAdaptiveCurveMapper::GetGraphicsMemorySize()
{
  return this->Internals->Leaves.GetMemorySize();
}

vtkMTimeType vtkAdaptiveCurveMapper::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Refinement ? std::max(time, this->Refinement->GetMTime()) : time;
}

void vtkAdaptiveCurveMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkAdaptiveCurveMapper* other = vtkAdaptiveCurveMapper::SafeDownCast(mapper))
  {
    this->SetRefinement(other->Refinement);
    this->SetMethod(other->Method);
    this->SetRepresentation(other->Representation);
    this->SetRadius(other->Radius);
    this->SetRadiusArrayName(other->GetRadiusArrayName());
    this->SetNumberOfSides(other->NumberOfSides);
    this->SetFrustumCulling(other->FrustumCulling);
    this->SetInputConnection(other->GetInputConnection(0, 0));
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkAdaptiveCurveMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Representation: " << this->Representation << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "NumberOfSides: " << this->NumberOfSides << "\n";
  os << indent << "FrustumCulling: " << this->FrustumCulling << "\n";
}
