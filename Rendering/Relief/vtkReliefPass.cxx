// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefPass.h"

#include "Capture/CaptureAhead.h"
#include "Capture/CaptureRanks.h"
#include "Capture/FittedCamera.h"
#include "Capture/ReliefGaps.h"
#include "Capture/ReliefSkirts.h"
#include "Capture/SceneCapture.h"
#include "Capture/SceneProps.h"
#include "Capture/SceneTime.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Data/Relief.h"
#include "Data/ReliefSides.h"
#include "View/WorldView.h"
#include "vtkReliefMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace
{
constexpr size_t MaximumReliefs = 4;
constexpr int MaximumSteps = 8;     // steps by which captures are ahead of the view
constexpr double WidestTexel = 2.0; // pixels

// A renderer's view, with its size in pixels.
struct View
{
  explicit View(const vtkRenderState* state)
    : Camera(state->GetRenderer()->GetActiveCamera())
  {
    if (vtkFrameBufferObjectBase* framebuffer = state->GetFrameBuffer())
    {
      int size[2];
      framebuffer->GetLastSize(size);
      this->Width = size[0];
      this->Height = size[1];
    }
    else
    {
      int origin[2];
      state->GetRenderer()->GetTiledSizeAndOrigin(
        &this->Width, &this->Height, &origin[0], &origin[1]);
    }
    if (this->Width > 0 && this->Height > 0)
    {
      const double aspect = state->GetRenderer()->GetTiledAspectRatio();
      this->WorldToClip =
        relevo::MakeMatrix(this->Camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0)) *
        relevo::MakeMatrix(this->Camera->GetModelViewTransformMatrix());
    }
    this->Camera->GetDirectionOfProjection(&this->Direction[0]);
  }

  vtkCamera* Camera;
  int Width = 0;
  int Height = 0;
  relevo::dmat4 WorldToClip{ 1.0 };
  relevo::dvec3 Direction;
};

// Return the angle between unit vectors, in degrees.
double GetAngle(const relevo::dvec3& a, const relevo::dvec3& b)
{
  return vtkMath::DegreesFromRadians(2.0 * std::asin(std::min(0.5 * distance(a, b), 1.0)));
}

// A capture, and its mapper and actor.
struct ShownRelief
{
  // This method needs no preparation or measurement for each capture.
  ShownRelief()
  {
    this->Mapper->SetMethodToRayMarch();
    this->Mapper->FillCracksOff(); // skirts fill them
    this->Actor->SetMapper(this->Mapper);
  }

  bool IsThere() const { return this->Gaps != nullptr; }

  void Set(vtkImageData* image, const relevo::dvec3& direction)
  {
    relevo::Relief relief;
    this->Gaps = nullptr;
    if (relief.Read(image).empty())
    {
      const std::vector<unsigned char> sides =
        relevo::FindReliefSides(relief, this->Mapper->GetMaximumStretch());
      this->Gaps.reset(new relevo::ReliefGaps(relief, sides));
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, image);
      blocks->SetBlock(1, relevo::MakeReliefSkirts(relief, sides));
      this->Mapper->SetInputDataObject(blocks);
      this->Direction = direction;
    }
  }

  vtkNew<vtkReliefMapper> Mapper;
  vtkNew<vtkActor> Actor;
  std::unique_ptr<relevo::ReliefGaps> Gaps;
  relevo::dvec3 Direction{ 0.0 };
};
}

class vtkReliefPass::vtkInternals
{
public:
  std::array<ShownRelief, MaximumReliefs> Reliefs;
  size_t Next = 0; // index of the next capture to replace
  relevo::CaptureRanks Ranks;
  relevo::SceneCapture Capture;
  relevo::SceneTime Scene;
  vtkMTimeType CapturedTime = 0;
  vtkNew<vtkRenderStepsPass> Steps;
  relevo::CaptureAhead Ahead;
  bool IsAhead = false; // whether the last capture is ahead of the view for which it was made
  vtkIdType NumberOfCaptures = 0;
  vtkIdType NumberOfReliefFrames = 0;
  double HoleShare = 0.0; // in the last frame with reliefs
  std::string Error;      // error of the last capture

  void DropAll()
  {
    for (ShownRelief& relief : this->Reliefs)
    {
      relief.Gaps = nullptr;
      relief.Mapper->SetInputDataObject(nullptr);
    }
  }

  // Return whether the captures show a view well enough, and compute the fraction of holes. Rank 0
  // decides.
  bool Suffices(
    const View& view, double maximumAngle, double maximumHoleShare, double& holeShare) const
  {
    const bool suffices = this->FindHoles(view, maximumAngle, maximumHoleShare, holeShare);
    const std::vector<double> first = this->Ranks.GetFirst({ suffices ? 1.0 : 0.0, holeShare });
    holeShare = first[1];
    return first[0] > 0.0;
  }

  bool FindHoles(
    const View& view, double maximumAngle, double maximumHoleShare, double& holeShare) const
  {
    double angle = 180.0;
    double texel = VTK_DOUBLE_MAX;
    std::vector<relevo::GapMap> maps;
    for (const ShownRelief& relief : this->Reliefs)
    {
      if (relief.IsThere())
      {
        angle = std::min(angle, GetAngle(relief.Direction, view.Direction));
        maps.push_back(relief.Gaps->Find(view.WorldToClip, view.Width, view.Height));
        texel = std::min(texel, maps.back().TexelWidth);
      }
    }
    holeShare = relevo::FindHoleShare(maps);
    return !maps.empty() && angle <= maximumAngle && holeShare <= maximumHoleShare &&
      texel <= WidestTexel;
  }

  // Capture the view, or the view that is expected next. Return the error, or "".
  std::string CaptureView(vtkRenderer* renderer, const View& view, double maximumAngle)
  {
    const relevo::ivec2 margin(view.Width / 8 + 1, view.Height / 8 + 1);
    const std::string error = this->Capture.Begin(renderer, relevo::SceneParts::Surfaces,
      view.Width + 2 * margin.x, view.Height + 2 * margin.y);
    if (!this->Ranks.IsAny(!error.empty()))
    {
      auto camera = relevo::WidenCamera(view.Camera, view.Width, view.Height, margin);
      relevo::dvec3 direction = view.Direction;
      // Views up to 10 degrees apart leave few holes between them.
      this->IsAhead = this->Ahead.Advance(camera);
      camera->GetDirectionOfProjection(&direction[0]);
      const double angle = GetAngle(direction, view.Direction);
      for (int i = 2; angle > 0.0 && i * angle <= maximumAngle / 3.0 && i <= MaximumSteps; ++i)
      {
        this->Ahead.Advance(camera);
      }
      camera->GetDirectionOfProjection(&direction[0]);
      if (this->IsAhead && GetAngle(direction, view.Direction) > maximumAngle)
      {
        this->IsAhead = false;
        camera = relevo::WidenCamera(view.Camera, view.Width, view.Height, margin);
        direction = view.Direction;
      }
      const auto image = this->Capture.CaptureFrom(camera, false, false);
      this->CapturedTime = this->Scene.Find(renderer);
      if (image)
      {
        this->Reliefs[this->Next].Set(image, direction);
      }
      if (this->Ranks.GetFirst({ image ? 1.0 : 0.0 })[0] > 0.0)
      {
        this->Next = (this->Next + 1) % MaximumReliefs;
        ++this->NumberOfCaptures;
        this->Ahead.AddCapture();
      }
    }
    this->Capture.End();
    return error;
  }
};

vtkStandardNewMacro(vtkReliefPass);

vtkReliefPass::vtkReliefPass()
  : Internals(new vtkInternals)
{
  this->Internals->Capture.SetRanks(&this->Internals->Ranks);
}

vtkReliefPass::~vtkReliefPass()
{
  this->SetDelegatePass(nullptr);
}

vtkCxxSetObjectMacro(vtkReliefPass, DelegatePass, vtkRenderPass);

void vtkReliefPass::SetController(vtkMultiProcessController* controller)
{
  vtkInternals& data = *this->Internals;
  if (data.Ranks.GetController() != controller)
  {
    data.Ranks.SetController(controller);
    data.DropAll(); // the captures are those of other processes
    this->Modified();
  }
}

vtkMultiProcessController* vtkReliefPass::GetController()
{
  return this->Internals->Ranks.GetController();
}

void vtkReliefPass::SetMaximumHoleShare(double share)
{
  relevo::SetInRange(this, "MaximumHoleShare", this->MaximumHoleShare, share, 0.0, 1.0);
}

void vtkReliefPass::SetMaximumAngle(double angle)
{
  relevo::SetInRange(this, "MaximumAngle", this->MaximumAngle, angle, 0.0, 180.0);
}

void vtkReliefPass::StopMotion()
{
  this->Internals->Ahead.Stop();
}

vtkIdType vtkReliefPass::GetNumberOfCaptures()
{
  return this->Internals->NumberOfCaptures;
}

vtkIdType vtkReliefPass::GetNumberOfReliefFrames()
{
  return this->Internals->NumberOfReliefFrames;
}

double vtkReliefPass::GetHoleShare()
{
  return this->Internals->HoleShare;
}

void vtkReliefPass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = state->GetRenderer();
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    // Renderers without a pass select like this; those with a pass leave selection to it.
    renderer->GetActiveCamera()->Render(renderer);
    selector->Render(renderer, state->GetPropArray(), state->GetPropArrayCount());
    return;
  }
  std::set<vtkProp*> opaque;
  const bool isMoving = renderer->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0;
  if (isMoving)
  {
    const std::vector<vtkProp*> all =
      relevo::FindSceneProps(renderer, relevo::SceneParts::Surfaces).Opaque;
    opaque.insert(all.begin(), all.end());
  }
  else
  {
    this->StopMotion();
  }
  const auto update = [&] { return this->UpdateReliefs(state); };
  const bool hasOpaque = isMoving && this->Internals->Ranks.IsAny(!opaque.empty());
  if (!hasOpaque || !relevo::RunWithinMemory(this, "the reliefs", update))
  {
    this->RenderDelegate(state);
    return;
  }
  std::vector<vtkProp*> props;
  for (ShownRelief& relief : this->Internals->Reliefs)
  {
    if (relief.IsThere())
    {
      props.push_back(relief.Actor);
    }
  }
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    if (!opaque.count(prop) || prop->HasTranslucentPolygonalGeometry())
    {
      props.push_back(prop);
    }
  }
  vtkRenderState own(renderer);
  own.SetFrameBuffer(state->GetFrameBuffer());
  own.SetRequiredKeys(state->GetRequiredKeys());
  own.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  this->RenderDelegate(&own);
}

void vtkReliefPass::RenderDelegate(const vtkRenderState* state)
{
  vtkRenderPass* pass = this->DelegatePass ? this->DelegatePass : this->Internals->Steps;
  pass->Render(state);
  this->NumberOfRenderedProps = pass->GetNumberOfRenderedProps();
}

// Return whether there are reliefs of the view without too many holes.
bool vtkReliefPass::UpdateReliefs(const vtkRenderState* state)
{
  vtkInternals& data = *this->Internals;
  View view(state);
  const std::vector<double> size =
    data.Ranks.GetFirst({ static_cast<double>(view.Width), static_cast<double>(view.Height) });
  view.Width = static_cast<int>(size[0]);
  view.Height = static_cast<int>(size[1]);
  if (view.Width < 1 || view.Height < 1)
  {
    return false;
  }
  if (data.Ranks.IsAny(data.Scene.Find(state->GetRenderer()) > data.CapturedTime))
  {
    data.DropAll();
  }
  data.Ahead.MoveTo(view.Camera);
  // Make a new capture. Return whether there is one.
  const auto capture = [&]
  {
    const vtkIdType before = data.NumberOfCaptures;
    const std::string error = data.CaptureView(state->GetRenderer(), view, this->MaximumAngle);
    if (relevo::ShouldReport(data.Error, error))
    {
      vtkErrorMacro(<< error);
    }
    return data.NumberOfCaptures > before;
  };
  double holeShare;
  bool suffice = data.Suffices(view, this->MaximumAngle, this->MaximumHoleShare, holeShare);
  if (!suffice && data.Ahead.IsWorthwhile() && capture())
  {
    suffice =
      data.Suffices(view, this->MaximumAngle, this->MaximumHoleShare, holeShare) || !data.IsAhead;
  }
  if (suffice)
  {
    data.HoleShare = holeShare;
    data.Ahead.AddShownFrame();
    ++data.NumberOfReliefFrames;
  }
  return suffice;
}

void vtkReliefPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Steps->ReleaseGraphicsResources(window);
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  for (ShownRelief& relief : this->Internals->Reliefs)
  {
    relief.Actor->ReleaseGraphicsResources(window);
  }
}

void vtkReliefPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: " << this->DelegatePass << "\n";
  os << indent << "MaximumHoleShare: " << this->MaximumHoleShare << "\n";
  os << indent << "MaximumAngle: " << this->MaximumAngle << "\n";
  os << indent << "NumberOfCaptures: " << this->GetNumberOfCaptures() << "\n";
  os << indent << "NumberOfReliefFrames: " << this->GetNumberOfReliefFrames() << "\n";
  os << indent << "HoleShare: " << this->GetHoleShare() << "\n";
}
