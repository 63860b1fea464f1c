// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveLICRepresentation.h"

#include "ReducedProjection.h"
#include "ViewRanks.h"
#include "vtkAdaptiveLICMapper.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkAdaptiveLICRepresentation);

vtkAdaptiveLICRepresentation::vtkAdaptiveLICRepresentation()
{
  vtkNew<vtkAdaptiveLICMapper> mapper;
  this->SetMapper(mapper);
}

vtkAdaptiveLICRepresentation::~vtkAdaptiveLICRepresentation() = default;

bool vtkAdaptiveLICRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  this->RenderView = vtkPVRenderView::SafeDownCast(view);
  // The observer runs after ParaView has sent the camera to all processes, and before any of them
  // draws, because IceT does not call processes with nothing in view. It also runs before that of
  // the base class, which updates meshes: after that, the streaks are missing.
  constexpr float beforeAgreement = -0.5f;
  this->StartTag = this->RenderView->GetRenderer()->AddObserver(vtkCommand::StartEvent, this,
    &vtkAdaptiveLICRepresentation::PrepareParallelFrame, beforeAgreement);
  this->EndTag = this->RenderView->GetRenderWindow()->AddObserver(
    vtkCommand::EndEvent, this, &vtkAdaptiveLICRepresentation::EndPicture);
  return true;
}

bool vtkAdaptiveLICRepresentation::RemoveFromView(vtkView* view)
{
  // The view may be in its destructor, or be another one.
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView && renderView == this->RenderView)
  {
    this->RenderView->GetRenderer()->RemoveObserver(this->StartTag);
    this->RenderView->GetRenderWindow()->RemoveObserver(this->EndTag);
  }
  this->RenderView = nullptr;
  return this->Superclass::RemoveFromView(view);
}

int vtkAdaptiveLICRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  auto mapper = vtkAdaptiveLICMapper::SafeDownCast(this->GetMapper());
  if (request == vtkPVView::REQUEST_RENDER() && this->RenderView && mapper)
  {
    vtkPVRenderView* view = this->RenderView;
    this->IsTogether = relevo::IsDrawnByRanks(view, inInfo) && !view->InTileDisplayMode() &&
      !view->InCaveDisplayMode();
    mapper->SetController(
      this->IsTogether ? vtkMultiProcessController::GetGlobalController() : nullptr);
  }
  return 1;
}

void vtkAdaptiveLICRepresentation::PrepareParallelFrame()
{
  vtkRenderer* ren = this->RenderView->GetRenderer();
  auto mapper = vtkAdaptiveLICMapper::SafeDownCast(this->GetMapper());
  if (!this->IsTogether || !mapper || ren->GetSelector())
  {
    return;
  }
  const relevo::ReducedProjection reduced(this->RenderView);
  for (vtkActor* actor :
    { static_cast<vtkActor*>(this->Actor), static_cast<vtkActor*>(this->BackfaceActor) })
  {
    if (actor->GetVisibility())
    {
      mapper->PrepareParallelFrame(ren, actor);
    }
  }
}

void vtkAdaptiveLICRepresentation::EndPicture()
{
  this->IsTogether = false;
}

void vtkAdaptiveLICRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsTogether: " << this->IsTogether << "\n";
}
