// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/RefinementState.h"

#include "Actors/UsableArrays.h"
#include "Arrays/GhostCells.h"
#include "Checks/ShouldReport.h"
#include "Evaluation/MeshPreparation.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/GivenNormals.h"
#include "Metrics/MetricCache.h"
#include "Parallel/GlobalSurfaceInfo.h"

#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkHeightField.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
std::string Take(std::string& text)
{
  std::string taken;
  taken.swap(text);
  return taken;
}

void SetNormals(vtkPolyData* mesh, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
  std::copy(values.begin(), values.end(), normals->GetPointer(0));
  mesh->GetPointData()->SetNormals(normals);
}
}

RefinementState::RefinementState()
{
  this->Clear();
}

RefinementState::~RefinementState() = default;

std::string RefinementState::TakeError()
{
  return Take(this->Error);
}

std::string RefinementState::TakeWarning()
{
  return Take(this->Warning);
}

bool RefinementState::Check(vtkAdaptiveRefinement* recipe)
{
  const std::string error = FindError(recipe);
  if (error != this->RecipeError)
  {
    this->RecipeError = error;
    this->Error = MakeError(error);
  }
  if (!error.empty())
  {
    return false;
  }
  this->Warn(FindNewWarning(recipe, this->PatternError));
  return true;
}

void RefinementState::Warn(const std::string& warning)
{
  this->Warning += (this->Warning.empty() || warning.empty() ? "" : " ") + warning;
}

void RefinementState::SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole)
{
  const bool isSame = whole == this->Whole || (whole && this->Whole && *whole == *this->Whole);
  if (!isSame)
  {
    this->Whole = std::move(whole);
    this->WholeTime.Modified();
    this->Cache->SetWhole(this->Whole);
  }
}

bool RefinementState::BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
{
  // The dependencies of the prepared mesh do not include displacement values that change without a
  // rebuild.
  Dependencies dependencies;
  dependencies.AddObject(input);
  dependencies.AddObject(recipe, 0);
  dependencies.Add(this->Whole && this->Whole->HasDirections);
  for (int axis = 0; this->Whole && axis < 3; ++axis)
  {
    dependencies.Add(this->Whole->PointBox.Low[axis]);
    dependencies.Add(this->Whole->PointBox.High[axis]);
  }
  vtkDisplacement* displacement = recipe ? recipe->GetDisplacement() : nullptr;
  if (recipe)
  {
    vtkRefinementSurface* surface = recipe->GetSurface();
    dependencies.AddObject(surface, surface ? surface->GetPreparationMTime() : 0);
    dependencies.AddObject(displacement, displacement && displacement->IsAlongNormal() ? 1 : 0);
    dependencies.AddObject(displacement ? displacement->GetHeightMap() : nullptr);
    dependencies.Add(recipe->GetNoDataMagnitude()); // affects the colours of its points
  }
  // Refined meshes get the normals that the filter would compute.
  const bool refines = recipe && recipe->GetMaximumLevel() > 0;
  const auto withNormals = [&]
  {
    Dependencies all = dependencies;
    all.Add(refines && this->NeedsUnitNormals);
    return all;
  };
  if (withNormals() == this->MeshDependencies)
  {
    return this->MeshValid;
  }
  this->NeedsUnitNormals = relevo::NeedsUnitNormals(input);
  this->MeshDependencies = withNormals();
  this->MeshValid = false;
  this->MeshTime.Modified();
  const auto mesh = std::make_shared<RefinementMesh>();
  this->Mesh = mesh;
  // The cells are removed, because VTK's mapper does not check their point ids.
  this->PreparedInput->Initialize();
  this->PreparedInput->SetPoints(input->GetPoints());
  if (!relevo::BuildMesh(input, recipe, refines && this->NeedsUnitNormals, this->Whole.get(), *mesh,
        this->Error, this->Warning))
  {
    return false;
  }
  this->PreparedInput->ShallowCopy(input);
  const std::string unusable = RemoveUnusableArrays(this->PreparedInput);
  // reported once, although the mesh may change in each frame
  if (ShouldReport(this->ArrayError, unusable))
  {
    this->Warn(unusable);
  }
  EmptyGhosts(input, this->PreparedInput);
  vtkDataArray* given = input->GetPointData()->GetNormals();
  if (!mesh->Normals.empty() &&
    (!given || given->GetNumberOfComponents() != 3 || (refines && this->NeedsUnitNormals)))
  {
    SetNormals(this->PreparedInput, mesh->Normals);
  }
  this->MeshValid = true;
  return true;
}

void RefinementState::GetBounds(vtkAdaptiveRefinement* recipe, double bounds[6])
{
  vtkPolyData* input = this->PreparedInput; // without ghost vertices and lines
  Dependencies dependencies;
  dependencies.AddObject(recipe->GetDisplacement());
  dependencies.AddObject(recipe->GetSurface());
  dependencies.Add(this->MeshTime);
  if (this->BoundsDependencies.Update(dependencies))
  {
    ComputeBounds(*this->Mesh, recipe->GetSurface(), recipe->GetDisplacement(), this->Bounds);
    vtkBoundingBox box;
    if (vtkMath::AreBoundsInitialized(this->Bounds))
    {
      box.AddBounds(this->Bounds);
    }
    for (vtkCellArray* cells : { input->GetVerts(), input->GetLines() })
    {
      auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
      for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
      {
        vtkIdType size;
        const vtkIdType* ids;
        iterator->GetCurrentCell(size, ids);
        for (vtkIdType i = 0; i < size; ++i)
        {
          double x[3];
          input->GetPoint(ids[i], x);
          if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]))
          {
            box.AddPoint(x);
          }
        }
      }
    }
    vtkMath::UninitializeBounds(this->Bounds);
    if (box.IsValid())
    {
      box.GetBounds(this->Bounds);
    }
  }
  std::copy_n(this->Bounds, 6, bounds);
}

SelectionInput RefinementState::GetSelectionInput(
  vtkPolyData* input, vtkAdaptiveRefinement* recipe) const
{
  return { input, recipe, this->Mesh, this->MeshTime, this->WholeTime,
    GetHighestTag(recipe, this->IsBudgeted) };
}

ViewSelection& RefinementState::FindView(
  vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view)
{
  // A budget depends on the view.
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  const bool seesCamera = this->IsBudgeted || (metric && metric->IsViewDependent());
  const bool seesPlacement = this->IsBudgeted || (metric && metric->IsPlacementDependent());
  const vtkCamera* camera = seesCamera ? view.Camera : nullptr;
  const vtkMatrix4x4* placement = seesPlacement ? view.ModelToWorld : nullptr;
  size_t oldest = 0;
  size_t slot = 0;
  while (slot < this->ViewUses.size() &&
    (this->ViewUses[slot].LastUse == 0 || this->ViewUses[slot].Camera != camera ||
      this->ViewUses[slot].ModelToWorld != placement))
  {
    oldest = this->ViewUses[slot].LastUse < this->ViewUses[oldest].LastUse ? slot : oldest;
    ++slot;
  }
  slot = slot < this->ViewUses.size() ? slot : oldest;
  this->ViewUses[slot] = { camera, placement, ++this->NumberOfUses };
  return this->Views[slot];
}

const FaceCulling& RefinementState::GetCulling(vtkAdaptiveRefinement* recipe)
{
  Dependencies dependencies;
  dependencies.AddObject(recipe->GetDisplacement());
  dependencies.AddObject(recipe->GetSurface());
  dependencies.Add(this->MeshTime);
  if (this->CullingDependencies.Update(dependencies))
  {
    this->Culling.Build(*this->Mesh, recipe);
    this->CullingTime.Modified();
  }
  return this->Culling;
}

void RefinementState::UpdateHoles(vtkAdaptiveRefinement* recipe)
{
  vtkDisplacement* displacement = recipe->GetDisplacement();
  Dependencies dependencies;
  if (displacement && displacement->HasHoles())
  {
    dependencies.AddObject(
      displacement->GetHeightMap(), displacement->GetHeightMap()->GetSamplesMTime());
  }
  if (this->HolesDependencies.Update(dependencies))
  {
    this->Holes = GetHoles(recipe->GetDisplacement());
    this->HolesTime.Modified();
  }
  this->Current->SetHoles(this->Holes, this->HolesTime);
}

bool RefinementState::UpdateTags(
  vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view, bool onGPU)
{
  this->Current = &this->FindView(input, recipe, view);
  std::string error;
  const bool valid =
    this->Current->UpdateTags(this->GetSelectionInput(input, recipe), view, onGPU, error);
  if (!error.empty())
  {
    this->Error = MakeError(error);
  }
  return valid;
}

CullingInput RefinementState::GetCullingInput(
  vtkAdaptiveRefinement* recipe, const CullingView* culling, bool hideBackFaces)
{
  const FaceCulling* faces = culling ? &this->GetCulling(recipe) : nullptr;
  return { faces, this->CullingTime, culling, hideBackFaces };
}

void RefinementState::UpdateSight(
  vtkAdaptiveRefinement* recipe, const CullingView* culling, bool hideBackFaces)
{
  this->Current->UpdateSight(this->GetCullingInput(recipe, culling, hideBackFaces));
}

bool RefinementState::UpdateSelection(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  const RefinementView& view, const CullingView* culling, bool hideBackFaces, bool onGPU)
{
  if (!this->UpdateTags(input, recipe, view, onGPU))
  {
    return false;
  }
  const bool changed =
    this->Current->UpdateLevels(this->GetSelectionInput(input, recipe), this->LevelOffset, onGPU);
  this->NumberOfSelections += changed ? 1 : 0;
  this->UpdateHoles(recipe);
  if (!onGPU)
  {
    this->Current->UpdateGroups(this->GetCullingInput(recipe, culling, hideBackFaces));
  }
  return true;
}

void RefinementState::Clear()
{
  this->Mesh = std::make_shared<RefinementMesh>();
  this->MeshDependencies.Clear();
  this->MeshValid = false;
  this->PreparedInput->Initialize();
  this->Cache = std::make_shared<MetricCache>();
  this->Cache->SetWhole(this->Whole);
  this->Views = std::vector<ViewSelection>(MaximumViews);
  for (ViewSelection& view : this->Views)
  {
    view.SetMetricCache(this->Cache);
  }
  this->ViewUses = {};
  this->Current = this->Views.data();
}

void RefinementState::ForgetLevels()
{
  for (ViewSelection& view : this->Views)
  {
    view.Forget();
  }
}
}
