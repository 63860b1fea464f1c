// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CompositedPass.h"

#include "vtkCameraPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"

#if __has_include("vtkIceTCompositePass.h") // not in ParaView without MPI
#include "vtkIceTCompositePass.h"

namespace relevo
{
namespace
{
vtkIceTCompositePass* FindIceT(vtkRenderPass* pass)
{
  if (auto* processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return FindIceT(processing->GetDelegatePass());
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return FindIceT(camera->GetDelegatePass());
  }
  return vtkIceTCompositePass::SafeDownCast(pass);
}
}

CompositedPass::CompositedPass(vtkRenderPass* outermost)
  : IceT(FindIceT(outermost))
{
  if (this->IceT)
  {
    vtkNew<vtkRenderPassCollection> passes;
    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkOpaquePass> opaque;
    vtkNew<vtkOverlayPass> overlay;
    passes->AddItem(lights);
    passes->AddItem(opaque);
    passes->AddItem(overlay);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    this->Previous = this->IceT->GetRenderPass();
    this->IceT->SetRenderPass(sequence);
    this->Reduction = this->IceT->GetImageReductionFactor();
    this->IceT->SetImageReductionFactor(1);
  }
}

CompositedPass::~CompositedPass()
{
  if (this->IceT)
  {
    this->IceT->SetRenderPass(this->Previous);
    this->IceT->SetImageReductionFactor(this->Reduction);
  }
}
}
#else
namespace relevo
{
CompositedPass::CompositedPass(vtkRenderPass*)
{
}

CompositedPass::~CompositedPass() = default;
}
#endif
