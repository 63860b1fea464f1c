// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ReliefCaptures.h"

#include "Options/ViewerOptions.h"
#include "Scene/ReliefActor.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkReliefCapture.h"
#include "vtkReliefDatabaseWriter.h"
#include "vtkRenderer.h"

namespace
{
void SetCameras(vtkReliefCapture* capture, vtkRenderer* renderer, const ViewerOptions& options)
{
  using Type = ViewerOptions::ReliefType;
  switch (options.Relief.value_or(Type::Box))
  {
    case Type::Box:
      capture->SetCamerasToBox();
      break;
    case Type::Sphere:
      capture->SetCamerasToSphere(0);
      break;
    case Type::View:
      capture->SetResolution(options.Size[0], options.Size[1]);
      capture->AddCamera(renderer->GetActiveCamera());
      break;
  }
}

void Write(vtkMultiBlockDataSet* reliefs, const std::string& folder, ViewerMessages& messages)
{
  vtkNew<vtkReliefDatabaseWriter> writer;
  messages.Observe(writer);
  writer->SetFileName(folder.c_str());
  writer->SetInputData(reliefs);
  writer->Write();
  messages.Check();
}
}

//------------------------------------------------------------------------------
void ShowReliefs(vtkRenderer* renderer, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages)
{
  if (!options.Relief && options.Capture.empty())
  {
    return;
  }
  vtkNew<vtkReliefCapture> capture;
  messages.Observe(capture);
  capture->SetRenderer(renderer);
  SetCameras(capture, renderer, options);
  capture->Update();
  messages.Check();
  if (!options.Capture.empty())
  {
    Write(capture->GetOutput(), options.Capture, messages);
  }
  if (options.Relief)
  {
    vtkActorCollection* actors = renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->VisibilityOff();
    }
    const auto actor = MakeReliefActor(capture->GetOutput(), options, messages);
    renderer->AddActor(actor);
    DrawReliefs(actor, renderer, window, options, messages);
  }
}
