// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ActorPair.h"

#include "Checks/ErrorCollector.h"
#include "Scene/SceneActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCommand.h"
#include "vtkDisplacement.h"
#include "vtkExecutive.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRefinementSurface.h"

#include <utility>

namespace relevo
{
namespace
{
// Return nullptr if the input itself is the surface.
vtkAdaptiveRefinement* FindCurvedRecipe(const SceneActor& actor)
{
  vtkAdaptiveRefinement* recipe = FindRecipe(actor.GetActor());
  return recipe && (recipe->GetSurface() || recipe->GetDisplacement()) ? recipe : nullptr;
}
}

ActorPair::ActorPair()
{
  this->Filter->AddObserver(vtkCommand::ErrorEvent, NewErrorCollector(this->Errors));
  this->Filter->AddObserver(vtkCommand::WarningEvent, NewErrorCollector(this->Warnings));
  // The filter's own error reports the reason.
  this->Filter->GetExecutive()->AddObserver(
    vtkCommand::ErrorEvent, NewErrorCollector(this->Ignored));
}

bool ActorPair::Update(
  const SceneActor& first, const SceneActor& second, bool isRefined, double tolerance)
{
  const SceneActor* const actors[2] = { &first, &second };
  auto now = Dependencies::On(isRefined, tolerance);
  vtkAdaptiveRefinement* recipes[2] = { nullptr, nullptr };
  for (int i = 0; i < 2; ++i)
  {
    now.AddObject(actors[i]->GetSurface());
    now.AddObject(actors[i]->GetMatrix());
    recipes[i] = isRefined ? FindCurvedRecipe(*actors[i]) : nullptr;
    if (recipes[i])
    {
      // The metric is excluded, because it changes with every motion.
      now.AddObject(recipes[i]->GetSurface());
      now.AddObject(recipes[i]->GetDisplacement());
      now.AddObject(recipes[i]->GetPatternTable());
      now.Add(recipes[i]->GetMaximumLevel());
      now.Add(recipes[i]->GetSegmentPolicy());
    }
  }
  if (!this->Inputs.Update(now))
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    this->Filter->SetInputData(i, actors[i]->GetSurface());
    this->Filter->SetMatrix(i, actors[i]->GetMatrix());
    this->Filter->SetRefinement(i, recipes[i]);
    this->Filter->ShareSurface(i, actors[i]->GetTriangles());
  }
  this->Filter->SetTolerance(tolerance);
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
