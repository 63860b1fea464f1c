// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ActorPair.h"

#include "Core/ErrorCollector.h"
#include "Scene/SceneActor.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"

#include <utility>

namespace relevo
{
ActorPair::ActorPair()
{
  this->Filter->AddObserver(vtkCommand::ErrorEvent, NewErrorCollector(this->Errors));
  this->Filter->AddObserver(vtkCommand::WarningEvent, NewErrorCollector(this->Warnings));
  // That of the filter says why.
  this->Filter->GetExecutive()->AddObserver(
    vtkCommand::ErrorEvent, NewErrorCollector(this->Ignored));
}

bool ActorPair::Update(const SceneActor& first, const SceneActor& second)
{
  const SceneActor* const actors[2] = { &first, &second };
  Dependencies now;
  for (const SceneActor* actor : actors)
  {
    now.AddObject(actor->GetSurface());
    now.AddObject(actor->GetMatrix());
  }
  if (!this->Inputs.Update(now))
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    this->Filter->SetInputData(i, actors[i]->GetSurface());
    this->Filter->SetMatrix(i, actors[i]->GetMatrix());
  }
  const std::string errors = std::exchange(this->Errors, "");
  const std::string warnings = std::exchange(this->Warnings, "");
  this->Ignored.clear();
  this->Filter->Update();
  this->NewErrors = this->Errors == errors ? "" : this->Errors;
  this->NewWarnings = this->Warnings == warnings ? "" : this->Warnings;
  this->Curves = nullptr;
  if (this->Filter->GetOutput()->GetNumberOfCells() > 0)
  {
    this->Curves = vtkSmartPointer<vtkPolyData>::New();
    this->Curves->ShallowCopy(this->Filter->GetOutput());
  }
  return true;
}
}
