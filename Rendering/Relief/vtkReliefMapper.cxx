// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefMapper.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Drawing/ReliefLeaves.h"
#include "Mathematics/SameNumber.h"
#include "OpenGL/ContextWatch.h"
#include "Picking/PickedInputPipeline.h"
#include "Picking/PickerDetector.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <limits>

namespace
{
// Private code uses the mapper's numbers of methods and searches.
using Mapper = vtkReliefMapper;
using Options = relevo::ReliefShaderOptions;

// With more triangles per pixel, tracing rays is faster.
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
}

struct vtkReliefMapper::vtkInternals
{
  relevo::ReliefLeaves Reliefs;
  vtkNew<relevo::ContextWatch> Context;
  relevo::PickerDetector Questions;
  int MethodInUse = METHOD_RAY_MARCH;
};

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
  // The resources are released here, while virtual calls still reach this class, in the context of
  // the window.
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
// Settings

void vtkReliefMapper::SetMethod(int method)
{
  relevo::SetChoice(
    this, "Method", this->Method, method, { "WARP", "RAY_MARCH", "REFINEMENT", "AUTOMATIC" });
}

void vtkReliefMapper::SetSearch(int search)
{
  relevo::SetChoice(this, "Search", this->Search, search,
    { "LINEAR_BINARY", "LINEAR_SECANT", "RELAXED_CONES", "MAXIMUM_MIPMAP" });
}

void vtkReliefMapper::SetShading(int shading)
{
  relevo::SetChoice(this, "Shading", this->Shading, shading, { "CAPTURED", "LIT" });
}

void vtkReliefMapper::SetSelfShadow(bool on)
{
  if (this->SelfShadow != on)
  {
    this->SelfShadow = on;
    this->Modified();
  }
}

void vtkReliefMapper::SetMaximumStretch(double stretch)
{
  relevo::SetInRange(
    this, "MaximumStretch", this->MaximumStretch, stretch, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
// Input

void vtkReliefMapper::UpdateReliefs(vtkDataObject* input)
{
  this->Internals->Reliefs.Update(input, { this->MaximumStretch, this->FillCracks },
    this->Internals->Context->GetContext(),
    [this](const std::string& error) { vtkErrorMacro(<< error); });
}

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
  this->UpdateReliefs(this->GetInputDataObject(0, 0));
  vtkBoundingBox box;
  this->Internals->Reliefs.AddBounds(box);
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
  this->GetBounds(); // updates the bounds from the input
  return this->Internals->Reliefs.AreTranslucent();
}

bool vtkReliefMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
// Picking

vtkDataObject* vtkReliefMapper::GetInputDataObject(int port, int connection)
{
  this->Internals->Questions.AskOther();
  return this->Superclass::GetInputDataObject(port, connection);
}

vtkDataObject* vtkReliefMapper::ReplaceInput(vtkDataObject* input)
{
  const bool isComposite = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  if (this->Internals->Questions.AskInput(isComposite) == relevo::PickerDetector::NO_PICKER)
  {
    return input;
  }
  this->UpdateReliefs(input);
  return this->Internals->Reliefs.GetPicked(input);
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
    vtkErrorMacro("There is no input: call SetInputConnection() or SetInputData().");
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  // This releases resources in the context of another window.
  this->Internals->Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  relevo::RunWithinMemory(this, "the reliefs",
    [&]
    {
      this->UpdateReliefs(this->GetInputDataObject(0, 0));
      this->RenderReliefs(renderer, actor);
      return true;
    });
  this->UpdateProgress(1.0);
}

// The choice depends on counts alone, so that an unchanged scene is drawn the same in all frames,
// passes and processes.
int vtkReliefMapper::ChooseMethod(vtkRenderer* renderer)
{
  if (this->Method != METHOD_AUTOMATIC)
  {
    return this->Method;
  }
  const int* size = renderer->GetSize();
  const double pixels = static_cast<double>(size[0]) * size[1];
  return this->Internals->Reliefs.CountTriangles() <= TrianglesPerPixel * pixels ? METHOD_REFINEMENT
                                                                                 : METHOD_RAY_MARCH;
}

void vtkReliefMapper::RenderReliefs(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  relevo::ReliefPainter::Settings settings;
  settings.Method = static_cast<Options::Methods>(this->ChooseMethod(renderer));
  settings.Search = this->Search;
  settings.IsLit = this->Shading == LIT;
  settings.IsShadowed = this->SelfShadow && settings.IsLit;
  settings.Yields = data.Reliefs.GetLeaves().size() > 1;
  relevo::ReliefPainter::Settings rims = settings;
  rims.IsRim = true;
  rims.IsShadowed = false; // only the block's own surface could cast shadows
  rims.Method = settings.Method == Options::WARP ? Options::RAY_MARCH : settings.Method;
  const auto draw = [&](relevo::ReliefPainter* painter, std::string& lastError)
  {
    painter->SetClippingPlanes(this->ClippingPlanes);
    painter->RenderPiece(renderer, actor);
    if (relevo::ShouldReport(lastError, painter->GetShaderError()))
    {
      vtkErrorMacro(<< lastError);
    }
  };
  data.Reliefs.Render(renderer,
    [&](relevo::ReliefLeaf& leaf)
    {
      if (!leaf.Relief.Error.empty())
      {
        return;
      }
      const std::string error = leaf.Surface->Prepare(renderer, actor, settings);
      if (relevo::ShouldReport(leaf.Error, error))
      {
        vtkErrorMacro(<< leaf.Relief.Describe(error));
      }
      if (!error.empty())
      {
        return;
      }
      if (vtkHardwareSelector* selector = renderer->GetSelector())
      {
        leaf.Surface->AnnounceIds(selector);
      }
      draw(leaf.Surface, leaf.ShaderError);
      data.MethodInUse = leaf.Surface->GetMethod();
      // Behind translucent surfaces, rims would be visible.
      if (leaf.Rims && !actor->IsRenderingTranslucentPolygonalGeometry() &&
        leaf.Rims->Prepare(renderer, actor, rims).empty())
      {
        draw(leaf.Rims, leaf.ShaderError);
      }
    });
}

void vtkReliefMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // a recursive call, in the context that owns the resources
  }
  this->Superclass::ReleaseGraphicsResources(window);
  data.Reliefs.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
// Counts

vtkTypeInt64 vtkReliefMapper::GetGraphicsMemorySize()
{
  return this->Internals->Reliefs.GetMemorySize();
}

int vtkReliefMapper::GetMethodInUse()
{
  return this->Internals->MethodInUse;
}

vtkIdType vtkReliefMapper::GetNumberOfWarps()
{
  return this->Internals->Reliefs.GetCounts().Warps;
}

vtkIdType vtkReliefMapper::GetNumberOfBufferBuilds()
{
  return this->Internals->Reliefs.GetCounts().BufferBuilds;
}

vtkIdType vtkReliefMapper::GetNumberOfShaderBuilds()
{
  return this->Internals->Reliefs.GetCounts().ShaderBuilds;
}

//------------------------------------------------------------------------------

void vtkReliefMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkReliefMapper* other = vtkReliefMapper::SafeDownCast(mapper))
  {
    this->SetMethod(other->Method);
    this->SetSearch(other->Search);
    this->SetShading(other->Shading);
    this->SetSelfShadow(other->SelfShadow);
    this->SetMaximumStretch(other->MaximumStretch);
    this->SetFillCracks(other->FillCracks);
    this->SetInputConnection(other->GetInputConnection(0, 0));
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkReliefMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Search: " << this->Search << "\n";
  os << indent << "Shading: " << this->Shading << "\n";
  os << indent << "SelfShadow: " << this->SelfShadow << "\n";
  os << indent << "MaximumStretch: " << this->MaximumStretch << "\n";
  os << indent << "FillCracks: " << this->FillCracks << "\n";
  os << indent << "MethodInUse: " << this->GetMethodInUse() << "\n";
  os << indent << "NumberOfBufferBuilds: " << this->GetNumberOfBufferBuilds() << "\n";
  os << indent << "NumberOfShaderBuilds: " << this->GetNumberOfShaderBuilds() << "\n";
}
