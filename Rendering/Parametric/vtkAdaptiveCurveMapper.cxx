// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveCurveMapperInternals.h"

#include "Checks/MemoryGuard.h"
#include "Checks/ShouldReport.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkCompositeDataSet.h"
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
#include <utility>

namespace
{
// A data set of an input, and where it is.
struct Leaf
{
  unsigned int Index = 0; // flat
  vtkDataObject* Data = nullptr;
  std::string Name; // empty where there are no others
};

std::vector<Leaf> FindLeaves(vtkDataObject* input)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return input ? std::vector<Leaf>(1, { 0, input, "" }) : std::vector<Leaf>();
  }
  std::vector<Leaf> leaves;
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    const unsigned int index = leaf->GetCurrentFlatIndex();
    leaves.push_back({ index, leaf->GetCurrentDataObject(), "Block " + std::to_string(index) });
  }
  return leaves;
}

vtkPointSet* GetCurves(vtkDataObject* data)
{
  return vtkUnstructuredGrid::SafeDownCast(data) || vtkPolyData::SafeDownCast(data)
    ? static_cast<vtkPointSet*>(data)
    : nullptr;
}

std::string FindCellProblem(vtkPointSet* input, const relevo::CurveMesh& mesh)
{
  const bool hasNone = input->GetNumberOfCells() > 0 && mesh.GetNumberOfCurves() == 0 &&
    mesh.GetError().empty() && mesh.GetWarning().empty();
  return hasNone ? "None of the input's cells is a curve." : mesh.GetError();
}

// Beside those of all mappers.
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
  // While virtual calls still reach this class, and in the context of the window.
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
// Input

void vtkAdaptiveCurveMapper::UpdateBlocks()
{
  vtkInternals& data = *this->Internals;
  relevo::CurvePainter::Shape shape;
  shape.Sides = this->Representation == LINES ? 1
    : this->Representation == RIBBONS         ? 2
                                              : this->NumberOfSides;
  shape.Radius = this->Radius;
  shape.RadiusArrayName = this->RadiusArrayName;
  std::map<unsigned int, vtkBlock> blocks;
  for (const Leaf& leaf :
    FindLeaves(this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr))
  {
    const auto last = data.Blocks.find(leaf.Index);
    vtkBlock& block = blocks[leaf.Index];
    if (last != data.Blocks.end())
    {
      block = last->second;
    }
    block.Prefix = leaf.Name.empty() ? "" : leaf.Name + ": ";
    vtkPointSet* curves = GetCurves(leaf.Data);
    if (!curves)
    {
      this->Say(block, vtkBlock::CELLS,
        std::string("A ") + leaf.Data->GetClassName() +
          " has no curves: a vtkUnstructuredGrid or a vtkPolyData is needed.");
      block.Painter = nullptr;
      block.IsDrawn = false;
      continue;
    }
    if (!block.Painter)
    {
      block.Painter = vtkSmartPointer<relevo::CurvePainter>::New();
    }
    if (block.Painter->SetCurves(curves))
    {
      this->Say(block, vtkBlock::CELLS, FindCellProblem(curves, block.Painter->GetMesh()));
      if (relevo::ShouldReport(block.Warning, block.Painter->GetMesh().GetWarning()))
      {
        vtkWarningMacro(<< block.Prefix << block.Warning);
      }
    }
    this->Say(block, vtkBlock::RADII, block.Painter->SetShape(shape));
  }
  for (auto& last : data.Blocks)
  {
    const auto next = blocks.find(last.first);
    if (last.second.Painter &&
      (next == blocks.end() || next->second.Painter != last.second.Painter))
    {
      data.AddCounts(*last.second.Painter);
      last.second.Painter->ReleaseGraphicsResources(data.Context->GetContext());
    }
  }
  data.Blocks.swap(blocks);
}

void vtkAdaptiveCurveMapper::vtkInternals::AddCounts(const relevo::CurvePainter& painter)
{
  this->NumberOfSelections += painter.GetCurveSelection().GetNumberOfEvaluations();
  this->NumberOfBufferBuilds += painter.GetNumberOfBufferBuilds();
  this->NumberOfShaderBuilds += painter.GetNumberOfShaderBuilds();
}

void vtkAdaptiveCurveMapper::Say(vtkBlock& block, int kind, const std::string& problem)
{
  if (relevo::ShouldReport(block.Problems[kind], problem))
  {
    vtkErrorMacro(<< block.Prefix << problem);
  }
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
  this->UpdateBlocks();
  vtkBoundingBox box;
  for (const auto& block : this->Internals->Blocks)
  {
    double bounds[6];
    vtkMath::UninitializeBounds(bounds);
    if (block.second.Painter)
    {
      block.second.Painter->GetCurveBounds(bounds);
    }
    box.AddBounds(bounds); // which must be initialized to count
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
  for (const Leaf& leaf : FindLeaves(this->GetInputDataObject(0, 0)))
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
  for (auto& block : data.Blocks)
  {
    block.second.IsDrawn = false;
  }
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("There is no input.");
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  const std::string problem =
    this->Refinement ? "" : "No recipe: call SetRefinement() with a vtkAdaptiveRefinement.";
  if (relevo::ShouldReport(data.Problem, problem))
  {
    vtkErrorMacro(<< problem);
  }
  if (problem.empty())
  {
    // Releases what is in the context of another window.
    data.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
    relevo::RunWithinMemory(this, "the curves",
      [&]
      {
        this->UpdateBlocks();
        this->RenderBlocks(renderer, actor);
        return true;
      });
  }
  this->UpdateProgress(1.0);
}

void vtkAdaptiveCurveMapper::RenderBlocks(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector)
  {
    selector->BeginRenderProp();
  }
  relevo::CurvePainter::Settings settings;
  settings.Recipe = this->Refinement;
  settings.Scalars = this;
  settings.IsTessellated = this->Method == METHOD_HARDWARE_TESSELLATION;
  settings.IsCulled = this->FrustumCulling;
  std::string tessellationProblem;
  for (auto& entry : data.Blocks)
  {
    vtkBlock& block = entry.second;
    if (!block.Painter || !block.Problems[vtkBlock::RADII].empty())
    {
      continue;
    }
    block.Painter->SetClippingPlanes(this->ClippingPlanes);
    CopyCoincidentOffsets(this, block.Painter);
    const std::string problem = block.Painter->Prepare(renderer, actor, settings);
    this->Say(block, vtkBlock::INPUT, problem);
    this->Say(block, vtkBlock::COLORS, block.Painter->GetColorProblem());
    if (!problem.empty())
    {
      continue;
    }
    if (selector)
    {
      block.Painter->AnnounceIds(selector);
      if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
      {
        selector->RenderCompositeIndex(std::max(entry.first, 1u));
      }
    }
    block.Painter->RenderPiece(renderer, actor);
    block.IsDrawn = true;
    this->Say(block, vtkBlock::SHADERS, block.Painter->GetShaderProblem());
    if (!block.Painter->GetTessellationProblem().empty())
    {
      tessellationProblem = "The method HARDWARE_TESSELLATION cannot be used: " +
        block.Painter->GetTessellationProblem() + ". The method INSTANCING is used instead.";
    }
    data.MethodInUse =
      block.Painter->IsTessellated() ? METHOD_HARDWARE_TESSELLATION : METHOD_INSTANCING;
  }
  if (relevo::ShouldReport(data.TessellationProblem, tessellationProblem))
  {
    vtkErrorMacro(<< tessellationProblem);
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
}

void vtkAdaptiveCurveMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // came back to this method, from within the context that the resources belong to
  }
  this->Superclass::ReleaseGraphicsResources(window);
  for (auto& block : data.Blocks)
  {
    if (block.second.Painter)
    {
      block.second.Painter->ReleaseGraphicsResources(window);
    }
  }
}
