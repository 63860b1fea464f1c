// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameAgreement.h"

#include "ReducedProjection.h"
#include "ViewRanks.h"
#include "vtkCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

#include <utility>

namespace relevo
{
FrameAgreement::FrameAgreement(vtkPVDataRepresentation* representation, Function agree)
  : Representation(representation)
  , AgreeWithRanks(std::move(agree))
{
}

FrameAgreement::~FrameAgreement()
{
  this->Stop();
}

void FrameAgreement::Start(vtkView* view)
{
  this->Stop();
  constexpr float afterSynchronization = -1.0f;
  this->Renderer = vtkPVRenderView::SafeDownCast(view)->GetRenderer();
  this->Tag = this->Renderer->AddObserver(
    vtkCommand::StartEvent, this, &FrameAgreement::Agree, afterSynchronization);
}

void FrameAgreement::Stop()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Tag);
  }
  this->Renderer = nullptr;
}

void FrameAgreement::Agree()
{
  auto view = vtkPVRenderView::SafeDownCast(this->Representation->GetView());
  if (!view || !this->Representation->GetVisibility())
  {
    return;
  }
  if (!IsDrawnByRanks(view))
  {
    this->AgreeWithRanks(nullptr, view->GetRenderer());
    return;
  }
  const ReducedProjection reduced(view);
  this->AgreeWithRanks(vtkMultiProcessController::GetGlobalController(), view->GetRenderer());
}
}
