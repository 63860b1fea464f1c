// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementState.h"

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
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementEvaluator.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRefinementSurface.h"
#include "vtkRefinementView.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cstring>
#include <functional>

namespace relevo
{
namespace
{
void Append(std::vector<vtkMTimeType>& dependencies, const void* object, vtkMTimeType time)
{
  dependencies.push_back(static_cast<vtkMTimeType>(reinterpret_cast<size_t>(object)));
  dependencies.push_back(time);
}

template <typename T>
void AppendObject(std::vector<vtkMTimeType>& dependencies, T* object)
{
  Append(dependencies, object, object ? object->GetMTime() : 0);
}

void AppendMatrix(std::vector<vtkMTimeType>& dependencies, vtkMatrix4x4* matrix)
{
  static_assert(sizeof(vtkMTimeType) == sizeof(double), "a double's bits fit a time stamp");
  for (int i = 0; matrix && i < 16; ++i)
  {
    vtkMTimeType bits;
    std::memcpy(&bits, matrix->GetData() + i, sizeof(bits));
    dependencies.push_back(bits);
  }
}

std::string Take(std::string& text)
{
  std::string taken;
  taken.swap(text);
  return taken;
}
}

RefinementState::RefinementState() = default;
RefinementState::~RefinementState() = default;

std::string RefinementState::TakeError()
{
  return Take(this->Error);
}

std::string RefinementState::TakeWarning()
{
  return Take(this->Warning);
}

bool RefinementState::UpdateMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
{
  // Only what the prepared mesh depends on: not the displacement's live values.
  Dependencies dependencies;
  AppendObject(dependencies, input);
  Append(dependencies, recipe, 0);
  vtkDisplacement* displacement = recipe ? recipe->GetDisplacement() : nullptr;
  if (recipe)
  {
    AppendObject(dependencies, recipe->GetSurface());
    Append(dependencies, displacement, displacement && displacement->IsAlongNormal() ? 1 : 0);
    AppendObject(dependencies, displacement ? displacement->GetHeightMap() : nullptr);
  }
  if (dependencies == this->MeshDependencies)
  {
    return this->MeshValid;
  }
  this->MeshDependencies = dependencies;
  this->MeshValid = false;
  this->MeshTime.Modified();
  this->Mesh = RefinementMesh();
  if (!recipe)
  {
    this->Error = "No recipe: call SetRefinement() with a vtkAdaptiveRefinement.";
    return false;
  }
  if (displacement && !displacement->Update())
  {
    this->Error = "The displacement's height map could not be read.";
    return false;
  }
  if (!this->Mesh.Build(input, recipe))
  {
    this->Error = "Cannot refine the input: " + this->Mesh.GetError() + ".";
    return false;
  }
  if (this->Mesh.GetNumberOfDroppedTriangles() > 0)
  {
    this->Warning = std::to_string(this->Mesh.GetNumberOfDroppedTriangles()) +
      " degenerate cells or triangles dropped (two corners at one place, fewer than three points, "
      "or non-finite coordinates).";
  }
  this->PreparedInput->ShallowCopy(input);
  if (!this->Mesh.Normals.empty() && !input->GetPointData()->GetNormals())
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(input->GetNumberOfPoints());
    std::copy(this->Mesh.Normals.begin(), this->Mesh.Normals.end(), normals->GetPointer(0));
    this->PreparedInput->GetPointData()->SetNormals(normals);
  }
  this->MeshValid = true;
  return true;
}

void RefinementState::GetBounds(vtkPolyData* input, vtkAdaptiveRefinement* recipe, double bounds[6])
{
  Dependencies dependencies;
  AppendObject(dependencies, recipe->GetDisplacement());
  dependencies.push_back(this->MeshTime);
  if (dependencies != this->BoundsDependencies)
  {
    this->BoundsDependencies = dependencies;
    this->Mesh.GetBounds(recipe, this->Bounds);
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
          box.AddPoint(input->GetPoint(ids[i]));
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

bool RefinementState::UpdateSelection(
  vtkPolyData* input, vtkAdaptiveRefinement* recipe, const vtkRefinementView& view)
{
  Dependencies dependencies;
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  AppendObject(dependencies, metric);
  AppendObject(dependencies, recipe->GetPatternTable()); // and with it MaximumLevel
  dependencies.push_back(this->MeshTime);
  dependencies.push_back(std::hash<std::string>()(recipe->GetDepthTagArrayName()));
  if (metric && metric->IsPlacementDependent())
  {
    AppendMatrix(dependencies, view.ModelToWorld);
  }
  if (metric && metric->IsViewDependent())
  {
    AppendObject(dependencies, view.Camera);
    for (int length : view.ViewportSize)
    {
      dependencies.push_back(static_cast<vtkMTimeType>(length));
    }
  }
  if (dependencies == this->SelectionDependencies)
  {
    return this->SelectionValid;
  }
  this->SelectionDependencies = dependencies;
  this->SelectionValid = false;
  this->SelectionTime.Modified();
  this->NumberOfTriangles = -1;

  const double start = vtkTimerLog::GetUniversalTime();
  std::vector<float> tags;
  std::string error;
  if (!ComputeDepthTags(recipe, input, this->Mesh, view, tags, error))
  {
    this->Error = "Cannot refine the input: " + error + ".";
    return false;
  }
  this->Selection.Select(this->Mesh, tags, recipe->GetMaximumLevel());
  this->SelectionSeconds = vtkTimerLog::GetUniversalTime() - start;
  ++this->NumberOfSelections;
  this->SelectionValid = true;
  return true;
}

vtkIdType RefinementState::GetNumberOfTriangles(vtkAdaptiveRefinement* recipe)
{
  if (this->NumberOfTriangles < 0 && this->SelectionValid)
  {
    // Fragments over no-data are discarded; what the filter leaves out is counted when asked for.
    this->NumberOfTriangles = this->Selection.GetNumberOfTriangles(recipe->GetPatternTable()) -
      CountHoles(this->Mesh, this->Selection, recipe);
  }
  return std::max<vtkIdType>(this->NumberOfTriangles, 0);
}
}
