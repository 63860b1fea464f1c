// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefMapperInternals.h"

#include "Checks/MemoryGuard.h"
#include "Data/ReliefSides.h"
#include "Drawing/PickedRelief.h"
#include "Drawing/ReliefRims.h"
#include "Mathematics/SameNumber.h"
#include "Picking/PickedInputPipeline.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
// Private code numbers methods and searches as the mapper does.
using Mapper = vtkReliefMapper;
using Options = relevo::ReliefShaderOptions;

// With more triangles to a pixel following rays is the faster method.
constexpr double TrianglesPerPixel = 2.0;

static_assert(relevo::HaveSameNumber(Mapper::METHOD_WARP, Options::WARP), "warp");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_RAY_MARCH, Options::RAY_MARCH), "ray march");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_REFINEMENT, Options::REFINEMENT), "refinement");
static_assert(
  relevo::HaveSameNumber(Mapper::SEARCH_LINEAR_BINARY, Options::LINEAR_BINARY), "linear, binary");
static_assert(
  relevo::HaveSameNumber(Mapper::SEARCH_LINEAR_SECANT, Options::LINEAR_SECANT), "linear, secant");
static_assert(
  relevo::HaveSameNumber(Mapper::SEARCH_RELAXED_CONES, Options::RELAXED_CONES), "cones");
static_assert(
  relevo::HaveSameNumber(Mapper::SEARCH_MAXIMUM_MIPMAP, Options::MAXIMUM_MIPMAP), "mipmap");

// What the reliefs of an input were made from.
relevo::Dependencies GetSource(vtkDataObject* input)
{
  relevo::Dependencies source;
  source.AddObject(input, input ? input->GetMTime() : 0);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      source.AddObject(leaf->GetCurrentDataObject());
    }
  }
  return source;
}
}

vtkStandardNewMacro(vtkReliefMapper);

vtkReliefMapper::vtkReliefMapper()
  : Internals(new vtkInternals)
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
  vtkNew<relevo::PickedInputPipeline> pipeline;
  pipeline->Replace = [this](vtkDataObject* input) { return this->ReplaceInput(input); };
  this->SetExecutive(pipeline);
}

vtkReliefMapper::~vtkReliefMapper()
{
  // While virtual calls still reach this class, and in the context of the window.
  this->ReleaseGraphicsResources(nullptr);
}

int vtkReliefMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkReliefMapper::SetInputData(vtkImageData* relief)
{
  this->SetInputDataInternal(0, relief);
}

//------------------------------------------------------------------------------
// Input

void vtkReliefMapper::UpdateBlocks()
{
  this->UpdateBlocks(
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr);
}

void vtkReliefMapper::UpdateBlocks(vtkDataObject* input)
{
  vtkInternals& data = *this->Internals;
  relevo::Dependencies source = GetSource(input);
  source.Add(this->MaximumStretch);
  source.Add(this->FillCracks);
  if (!data.Source.Update(source))
  {
    return;
  }
  std::map<unsigned int, vtkInternals::Block> blocks;
  for (relevo::ReliefBlock& relief :
    input ? relevo::ReadReliefs(input) : std::vector<relevo::ReliefBlock>())
  {
    const unsigned int index = relief.FlatIndex;
    vtkInternals::Block& block = blocks[index];
    const auto last = data.Blocks.find(index);
    if (last != data.Blocks.end())
    {
      block = last->second;
    }
    relevo::Dependencies own;
    own.AddObject(relief.Data.GetImage());
    own.Add(this->MaximumStretch);
    block.Relief = relief;
    if (!relief.Fault.empty())
    {
      if (relief.Fault != block.Problem)
      {
        vtkErrorMacro(<< relief.Fault);
      }
      block.Problem = relief.Fault;
      block.Source.Clear();
      continue;
    }
    block.Problem.clear();
    block.Painter = block.Painter ? block.Painter : vtkSmartPointer<relevo::ReliefPainter>::New();
    if (block.Source.Update(own))
    {
      block.Painter->SetRelief(relief.Data, this->MaximumStretch);
      block.Picked = nullptr;
    }
  }
  for (auto& last : data.Blocks)
  {
    if (!blocks.count(last.first))
    {
      data.Retire(last.second.Painter);
      data.Retire(last.second.Rims);
    }
  }
  data.Blocks.swap(blocks);
  data.UpdateRims(this->FillCracks, this->MaximumStretch);
}

void vtkReliefMapper::vtkInternals::Retire(relevo::ReliefPainter* painter)
{
  if (painter)
  {
    this->NumberOfBufferBuilds += painter->GetNumberOfBufferBuilds();
    this->NumberOfShaderBuilds += painter->GetNumberOfShaderBuilds();
    this->NumberOfWarps += painter->GetNumberOfWarps();
    painter->ReleaseGraphicsResources(this->Context->GetContext());
  }
}

std::vector<relevo::ReliefPainter*> vtkReliefMapper::vtkInternals::GetPainters() const
{
  std::vector<relevo::ReliefPainter*> painters;
  for (const auto& block : this->Blocks)
  {
    for (relevo::ReliefPainter* painter : { block.second.Painter.Get(), block.second.Rims.Get() })
    {
      if (painter)
      {
        painters.push_back(painter);
      }
    }
  }
  return painters;
}

void vtkReliefMapper::vtkInternals::UpdateRims(bool areWanted, double maximumStretch)
{
  std::vector<Block*> wanted;
  relevo::Dependencies source;
  source.Add(maximumStretch);
  for (auto& entry : this->Blocks)
  {
    if (areWanted && entry.second.Relief.Fault.empty())
    {
      wanted.push_back(&entry.second);
      source.AddObject(entry.second.Relief.Data.GetImage());
    }
  }
  if (!this->RimSource.Update(source))
  {
    return;
  }
  std::vector<relevo::RimSource> reliefs;
  if (wanted.size() > 1)
  {
    for (Block* block : wanted)
    {
      const double stretch = std::min(maximumStretch, relevo::RimStretch);
      reliefs.push_back(
        { &block->Relief.Data, relevo::FindReliefSides(block->Relief.Data, stretch) });
    }
  }
  for (auto& entry : this->Blocks)
  {
    Block& block = entry.second;
    const auto place = std::find(wanted.begin(), wanted.end(), &block);
    vtkSmartPointer<vtkImageData> image;
    if (place != wanted.end() && !reliefs.empty())
    {
      image = relevo::MakeReliefRims(reliefs, place - wanted.begin());
    }
    relevo::Relief rims;
    if (!image || !rims.Read(image).empty())
    {
      this->Retire(block.Rims);
      block.Rims = nullptr;
      continue;
    }
    block.Rims = block.Rims ? block.Rims : vtkSmartPointer<relevo::ReliefPainter>::New();
    block.Rims->SetRelief(rims, maximumStretch);
  }
}

//------------------------------------------------------------------------------
// Bounds

double* vtkReliefMapper::GetBounds()
{
  const relevo::OwnBoundsQuestion question(this->Internals->Questions);
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
    if (block.second.Problem.empty() &&
      vtkMath::AreBoundsInitialized(block.second.Painter->GetSurfaceBounds()))
    {
      box.AddBounds(block.second.Painter->GetSurfaceBounds());
    }
  }
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkReliefMapper::GetBounds(double bounds[6])
{
  this->Superclass::GetBounds(bounds);
  this->Internals->Questions.AskBounds();
}

bool vtkReliefMapper::HasTranslucentPolygonalGeometry()
{
  this->GetBounds(); // which reads the input
  for (const auto& block : this->Internals->Blocks)
  {
    if (block.second.Problem.empty() && block.second.Painter->IsTranslucent())
    {
      return true;
    }
  }
  return false;
}

bool vtkReliefMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
// What VTK's pickers find

vtkDataObject* vtkReliefMapper::GetInputDataObject(int port, int connection)
{
  this->Internals->Questions.AskOther();
  return this->Superclass::GetInputDataObject(port, connection);
}

vtkStructuredGrid* vtkReliefMapper::vtkInternals::GetPicked(
  unsigned int index, double maximumStretch)
{
  const auto found = this->Blocks.find(index);
  if (found == this->Blocks.end() || !found->second.Problem.empty())
  {
    return this->Nothing;
  }
  Block& block = found->second;
  if (!block.Picked)
  {
    block.Picked = relevo::MakePickedRelief(block.Relief.Data, maximumStretch);
  }
  return block.Picked;
}

vtkDataObject* vtkReliefMapper::ReplaceInput(vtkDataObject* input)
{
  vtkInternals& data = *this->Internals;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (data.Questions.AskInput(composite != nullptr) == relevo::PickerDetector::NO_PICKER)
  {
    return input;
  }
  this->UpdateBlocks(input);
  if (!composite)
  {
    return data.GetPicked(0, this->MaximumStretch);
  }
  data.PickedBlocks.TakeReference(composite->NewInstance());
  data.PickedBlocks->CopyStructure(composite);
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    data.PickedBlocks->SetDataSet(
      leaf, data.GetPicked(leaf->GetCurrentFlatIndex(), this->MaximumStretch));
  }
  return data.PickedBlocks;
}

//------------------------------------------------------------------------------
// Rendering

void vtkReliefMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (window->CheckAbortStatus())
  {
    return;
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
  // Releases what is in the context of another window.
  this->Internals->Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  relevo::RunWithinMemory(this, "the reliefs",
    [&]
    {
      this->UpdateBlocks();
      this->RenderBlocks(renderer, actor);
      return true;
    });
  this->UpdateProgress(1.0);
}

// By counts alone: an unchanged scene is drawn alike in all frames, passes and programs.
int vtkReliefMapper::ChooseMethod(vtkRenderer* renderer)
{
  if (this->Method != METHOD_AUTOMATIC)
  {
    return this->Method;
  }
  double triangles = 0.0;
  for (const auto& block : this->Internals->Blocks)
  {
    triangles += block.second.Painter ? block.second.Painter->GetNumberOfTriangles() : 0.0;
  }
  const int* size = renderer->GetSize();
  const double pixels = static_cast<double>(size[0]) * size[1];
  return triangles <= TrianglesPerPixel * pixels ? METHOD_REFINEMENT : METHOD_RAY_MARCH;
}

void vtkReliefMapper::RenderBlocks(vtkRenderer* renderer, vtkActor* actor)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector)
  {
    selector->BeginRenderProp();
  }
  relevo::ReliefPainter::Settings settings;
  settings.Method = static_cast<Options::Methods>(this->ChooseMethod(renderer));
  settings.Search = this->Search;
  settings.IsLit = this->Shading == LIT;
  settings.IsShadowed = this->SelfShadow && settings.IsLit;
  settings.Yields = this->Internals->Blocks.size() > 1;
  for (auto& entry : this->Internals->Blocks)
  {
    vtkInternals::Block& block = entry.second;
    if (!block.Relief.Fault.empty())
    {
      continue;
    }
    const std::string problem = block.Painter->Prepare(renderer, actor, settings);
    if (problem != block.Problem)
    {
      block.Problem = problem;
      if (!problem.empty())
      {
        vtkErrorMacro(<< block.Relief.Describe(problem));
      }
    }
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
    this->RenderBlock(renderer, actor, *block.Painter, block.ShaderProblem);
    this->Internals->MethodInUse = block.Painter->GetMethod();
    // Behind what is translucent nothing hides them.
    if (block.Rims && !actor->IsRenderingTranslucentPolygonalGeometry())
    {
      relevo::ReliefPainter::Settings rims = settings;
      rims.IsRim = true;
      rims.IsShadowed = false; // only the block's own surface could
      rims.Method = settings.Method == Options::WARP ? Options::RAY_MARCH : settings.Method;
      if (block.Rims->Prepare(renderer, actor, rims).empty())
      {
        this->RenderBlock(renderer, actor, *block.Rims, block.ShaderProblem);
      }
    }
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
}

void vtkReliefMapper::RenderBlock(
  vtkRenderer* renderer, vtkActor* actor, relevo::ReliefPainter& painter, std::string& problem)
{
  painter.SetClippingPlanes(this->ClippingPlanes);
  painter.RenderPiece(renderer, actor);
  if (painter.GetShaderProblem() != problem)
  {
    problem = painter.GetShaderProblem();
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem);
    }
  }
}

void vtkReliefMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // came back to this method, from within the context that the resources belong to
  }
  this->Superclass::ReleaseGraphicsResources(window);
  for (relevo::ReliefPainter* painter : data.GetPainters())
  {
    painter->ReleaseGraphicsResources(window);
  }
}
