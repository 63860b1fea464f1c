// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveLICRepresentation.h"

#include "vtkAdaptiveLICMapper.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkAdaptiveLICRepresentation);

namespace
{
// ParaView draws smaller pictures while the view moves: IceT has the camera project to a corner of
// the window, and so must what is prepared for it.
class ReducedProjection
{
public:
  ReducedProjection(vtkRenderer* ren, int factor)
    : Camera(factor > 1 ? ren->GetActiveCamera() : nullptr)
  {
    if (!this->Camera)
    {
      return;
    }
    vtkNew<vtkMatrix4x4> toCorner;
    for (int i = 0; i < 2; ++i)
    {
      const int size = ren->GetRenderWindow()->GetActualSize()[i];
      const double share = static_cast<double>(size / factor) / size;
      toCorner->SetElement(i, i, share);
      toCorner->SetElement(i, 3, share - 1.0);
    }
    vtkNew<vtkMatrix4x4> projection;
    vtkMatrix4x4::Multiply4x4(toCorner,
      this->Camera->GetProjectionTransformMatrix(ren->GetTiledAspectRatio(), -1, 1), projection);
    this->Camera->SetExplicitProjectionTransformMatrix(projection);
    this->Camera->UseExplicitProjectionTransformMatrixOn();
  }
  ~ReducedProjection()
  {
    if (this->Camera)
    {
      this->Camera->UseExplicitProjectionTransformMatrixOff();
      this->Camera->SetExplicitProjectionTransformMatrix(nullptr);
    }
  }
  ReducedProjection(const ReducedProjection&) = delete;
  void operator=(const ReducedProjection&) = delete;

private:
  vtkCamera* Camera;
};
}

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
  // After ParaView has given all processes the camera, and before any draws: IceT leaves out those
  // that have nothing in view.
  this->StartTag = this->RenderView->GetRenderer()->AddObserver(
    vtkCommand::StartEvent, this, &vtkAdaptiveLICRepresentation::PrepareTogether, -1.0f);
  this->EndTag = this->RenderView->GetRenderWindow()->AddObserver(
    vtkCommand::EndEvent, this, &vtkAdaptiveLICRepresentation::EndPicture);
  return true;
}

bool vtkAdaptiveLICRepresentation::RemoveFromView(vtkView* view)
{
  if (vtkPVRenderView::SafeDownCast(view)) // and not only what is left in its destructor
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
    const bool isDistributed = inInfo->Has(vtkPVRenderView::USE_LOD())
      ? view->GetUseDistributedRenderingForLODRender()
      : view->GetUseDistributedRenderingForRender();
    this->IsTogether = isDistributed && !view->InTileDisplayMode() && !view->InCaveDisplayMode();
    mapper->SetController(
      this->IsTogether ? vtkMultiProcessController::GetGlobalController() : nullptr);
  }
  return 1;
}

void vtkAdaptiveLICRepresentation::PrepareTogether()
{
  vtkRenderer* ren = this->RenderView->GetRenderer();
  auto mapper = vtkAdaptiveLICMapper::SafeDownCast(this->GetMapper());
  if (!this->IsTogether || !mapper || ren->GetSelector())
  {
    return;
  }
  const bool isInteractive = ren->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0;
  ReducedProjection reduced(ren,
    isInteractive ? this->RenderView->GetInteractiveRenderImageReductionFactor()
                  : this->RenderView->GetStillRenderImageReductionFactor());
  for (vtkActor* actor :
    { static_cast<vtkActor*>(this->Actor), static_cast<vtkActor*>(this->BackfaceActor) })
  {
    if (actor->GetVisibility())
    {
      mapper->PrepareTogether(ren, actor);
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
