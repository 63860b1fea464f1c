// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefInteraction.h"

#include "CompositedPass.h"
#include "MapperMessages.h"
#include "RepresentationReports.h"
#include "SceneBounds.h"
#include "ViewRanks.h"
#include "vtkCommand.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkProcessModule.h"
#include "vtkReliefPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucentPass.h"
#include "vtkWeakPointer.h"

#include <string>

struct vtkReliefInteraction::vtkInternals
{
  explicit vtkInternals(vtkReliefInteraction* self)
    : Messages([self](bool isError, const std::string& message)
        { relevo::Report(self, isError, message); })
  {
  }

  vtkNew<vtkReliefPass> Pass;
  relevo::MapperMessages Messages;
  vtkWeakPointer<vtkRenderer> Renderer; // with the observers
  unsigned long BeginTag = 0;
  unsigned long EndTag = 0;
  vtkNew<vtkRenderStepsPass> Steps; // in a frame on one process
  vtkNew<vtkTranslucentPass> Translucent;
  vtkNew<vtkDualDepthPeelingPass> Peeling;
  vtkNew<relevo::SceneBounds> Bounds;
  std::unique_ptr<relevo::CompositedPass> Composited; // in a frame on several ranks
  bool IsInFrame = false;
  vtkSmartPointer<vtkRenderPass> ViewPass; // of the renderer, during a frame with reliefs
  double LevelOfDetail = -1.0;             // threshold of the view in megabytes; -1 while unchanged
  std::string Warning;                     // as reported
};

namespace
{
constexpr double NoLevelOfDetail = VTK_DOUBLE_MAX;
}

vtkStandardNewMacro(vtkReliefInteraction);

vtkReliefInteraction::vtkReliefInteraction()
  : Internals(new vtkInternals(this))
{
  this->SetNumberOfInputPorts(0);
  this->Internals->Peeling->SetTranslucentPass(this->Internals->Translucent);
  this->Internals->Messages.Observe(this->Internals->Pass);
}

vtkReliefInteraction::~vtkReliefInteraction()
{
  this->RemoveObservers();
}

void vtkReliefInteraction::SetShowReliefsWhileMoving(bool show)
{
  if (this->ShowReliefsWhileMoving != show)
  {
    this->ShowReliefsWhileMoving = show;
    this->MarkModified();
  }
}

void vtkReliefInteraction::SetMaximumHoleShare(double share)
{
  this->Internals->Pass->SetMaximumHoleShare(share);
}

double vtkReliefInteraction::GetMaximumHoleShare()
{
  return this->Internals->Pass->GetMaximumHoleShare();
}

void vtkReliefInteraction::SetMaximumAngle(double angle)
{
  this->Internals->Pass->SetMaximumAngle(angle);
}

double vtkReliefInteraction::GetMaximumAngle()
{
  return this->Internals->Pass->GetMaximumAngle();
}

bool vtkReliefInteraction::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView || !this->Superclass::AddToView(view))
  {
    return false;
  }
  vtkInternals& data = *this->Internals;
  data.Renderer = renderView->GetRenderer();
  data.Renderer->AddViewProp(data.Bounds);
  // These run after the processes have received the camera, and before they send the picture.
  constexpr float afterSynchronization = -1.0f;
  constexpr float beforeSynchronization = 1.0f;
  data.BeginTag = data.Renderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkReliefInteraction::BeginFrame, afterSynchronization);
  data.EndTag = data.Renderer->AddObserver(
    vtkCommand::EndEvent, this, &vtkReliefInteraction::EndFrame, beforeSynchronization);
  return true;
}

bool vtkReliefInteraction::RemoveFromView(vtkView* view)
{
  this->RemoveObservers();
  return this->Superclass::RemoveFromView(view);
}

void vtkReliefInteraction::RemoveObservers()
{
  vtkInternals& data = *this->Internals;
  if (data.Renderer)
  {
    data.Renderer->RemoveObserver(data.BeginTag);
    data.Renderer->RemoveObserver(data.EndTag);
    data.Renderer->RemoveViewProp(data.Bounds);
  }
  data.Renderer = nullptr;
}

// There are no data to update, so the base class is not called.
int vtkReliefInteraction::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation*, vtkInformation*)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->UpdateLevelOfDetail();
  }
  return 1;
}

// A user may change the threshold in the meantime.
void vtkReliefInteraction::UpdateLevelOfDetail()
{
  vtkInternals& data = *this->Internals;
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!view)
  {
    return;
  }
  const double threshold = view->GetLODRenderingThreshold();
  if (this->ShowReliefsWhileMoving && threshold != NoLevelOfDetail)
  {
    data.LevelOfDetail = threshold;
    view->SetLODRenderingThreshold(NoLevelOfDetail);
  }
  else if (!this->ShowReliefsWhileMoving && data.LevelOfDetail >= 0.0)
  {
    view->SetLODRenderingThreshold(threshold == NoLevelOfDetail ? data.LevelOfDetail : threshold);
    data.LevelOfDetail = -1.0;
  }
}

bool vtkReliefInteraction::CanShowReliefs(vtkPVRenderView* view, bool areSeveral)
{
  std::string warning;
  if (view->InTileDisplayMode() || view->InCaveDisplayMode())
  {
    warning = "in tiled displays and caves";
  }
  else if (view->GetEnableOSPRay())
  {
    warning = "with ray tracing";
  }
  else if (areSeveral && view->GetUseOrderedCompositing())
  {
    warning = "for translucent objects and volumes on several ranks";
  }
  else if (areSeveral && !relevo::CompositedPass(this->Internals->Renderer->GetPass()).IsFound())
  {
    warning = "on several ranks without IceT";
  }
  const bool isAvailable = warning.empty();
  relevo::ReportWarning(this, this->Internals->Warning,
    isAvailable
      ? ""
      : "Reliefs while moving are not available " + warning + ". The view shows the data.");
  return isAvailable;
}

void vtkReliefInteraction::BeginFrame()
{
  vtkInternals& data = *this->Internals;
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!view || !this->ShowReliefsWhileMoving || data.Renderer->GetSelector())
  {
    return;
  }
  if (data.Renderer->GetRenderWindow()->GetDesiredUpdateRate() < 1.0)
  {
    data.Pass->StopMotion();
    return;
  }
  const bool isDistributed = relevo::IsDrawnByRanks(view);
  if (isDistributed && vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_CLIENT)
  {
    return; // the server draws, and the client shows the picture
  }
  vtkMultiProcessController* ranks =
    isDistributed ? vtkMultiProcessController::GetGlobalController() : nullptr;
  const bool areSeveral = ranks && ranks->GetNumberOfProcesses() > 1;
  if (!this->CanShowReliefs(view, areSeveral))
  {
    return;
  }
  data.IsInFrame = true;
  data.ViewPass = data.Renderer->GetPass();
  data.Pass->SetController(areSeveral ? ranks : nullptr);
  if (areSeveral)
  {
    data.Bounds->Set(data.Renderer, ranks);
    data.Composited.reset(new relevo::CompositedPass(data.ViewPass));
  }
  // ParaView's own pass on one process draws the props of the renderer, not those of its state.
  vtkRenderPass* const steps = data.Steps;
  vtkRenderPass* const peeling = data.Peeling;
  vtkRenderPass* const translucent = data.Translucent;
  data.Steps->SetTranslucentPass(data.Renderer->GetUseDepthPeeling() ? peeling : translucent);
  data.Pass->SetDelegatePass(areSeveral ? data.ViewPass.Get() : steps);
  data.Renderer->SetPass(data.Pass);
}

void vtkReliefInteraction::EndFrame()
{
  vtkInternals& data = *this->Internals;
  if (data.IsInFrame)
  {
    data.IsInFrame = false;
    data.Renderer->SetPass(data.ViewPass);
    data.Pass->SetDelegatePass(nullptr);
    data.Composited = nullptr;
    data.Bounds->Clear();
    data.ViewPass = nullptr;
  }
}

void vtkReliefInteraction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowReliefsWhileMoving: " << this->ShowReliefsWhileMoving << "\n";
  os << indent << "Pass:\n";
  this->Internals->Pass->PrintSelf(os, indent.GetNextIndent());
}
