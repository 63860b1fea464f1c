// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthTagFilter.h"

#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/MisplacedArray.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Levels/EdgeLevels.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/DepthTags.h"
#include "Metrics/MetricCache.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/PieceAgreement.h"
#include "Metrics/ViewTime.h"
#include "Points/MergedPoints.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <string>

namespace
{
const char* const DepthTagName = "DepthTag";
const char* const EdgeLevelsName = "EdgeLevels";

// Sets the levels of triangles, three per cell, to f(a, b) for the points of their edges.
template <typename Function>
void SetEdgeLevels(vtkPolyData* mesh, vtkIntArray* edgeLevels, Function&& f)
{
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  int* levels = edgeLevels->GetPointer(0) +
    3 * (mesh->GetVerts()->GetNumberOfCells() + mesh->GetLines()->GetNumberOfCells());
  auto polygon = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* points;
    polygon->GetCurrentCell(size, points);
    const bool valid = std::all_of(
      points, points + size, [=](vtkIdType point) { return point >= 0 && point < numberOfPoints; });
    if (size == 3 && valid)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        levels[edge] = f(points[edge], points[(edge + 1) % 3]);
      }
    }
    levels += 3;
  }
}
}

vtkStandardNewMacro(vtkDepthTagFilter);

vtkDepthTagFilter::vtkDepthTagFilter()
  : Sources(new relevo::TagSources)
{
}

vtkDepthTagFilter::~vtkDepthTagFilter() = default;

void vtkDepthTagFilter::SetMetric(vtkDepthTagMetric* metric)
{
  if (this->Metric != metric)
  {
    this->Metric = metric;
    if (!metric)
    {
      this->Sources->Clear();
    }
    this->Modified();
  }
}

vtkDepthTagMetric* vtkDepthTagFilter::GetMetric()
{
  return this->Metric;
}

vtkCxxSetSmartPointerMacro(vtkDepthTagFilter, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkDepthTagFilter::GetController()
{
  return this->Controller;
}

void vtkDepthTagFilter::SetMaximumLevel(int level)
{
  relevo::SetInRange(
    this, "MaximumLevel", this->MaximumLevel, level, 0, vtkRefinementPatternTable::HighestLevel);
}

void vtkDepthTagFilter::SetLevelRule(int rule)
{
  relevo::SetChoice(this, "LevelRule", this->LevelRule, rule, { "PER_VERTEX", "PER_EDGE" });
}

vtkMTimeType vtkDepthTagFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Metric ? std::max({ own, this->Metric->GetMTime(),
                          relevo::GetViewTime(this->Metric, this->MakeView()) })
                      : own;
}

int vtkDepthTagFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto add = [&] {
    return this->AddTags(vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(outputVector));
  };
  return relevo::CheckInputTypes(this, inputVector) &&
      relevo::RequestWithinMemory(this, outputVector, "the levels of the mesh", add)
    ? 1
    : 0;
}

bool vtkDepthTagFilter::AddTags(vtkPolyData* input, vtkPolyData* output)
{
  output->Initialize();
  relevo::AgreeOnPiece(this->Controller, input, *this->Sources->Find(this, input), this->Metric,
    this->MakeView(), [](relevo::GlobalSurfaceInfo*) { return true; });

  vtkNew<vtkFloatArray> tags;
  tags->SetName(DepthTagName);
  if (!(this->Metric ? this->ComputeTags(input, tags) : this->TakeTags(input, tags)))
  {
    return false;
  }
  this->UpdateProgress(0.5);
  relevo::UniteTags(relevo::ComputeMergedPoints(input->GetPoints()), tags->GetPointer(0));
  this->UpdateProgress(0.7);
  if (relevo::IsAborted(this))
  {
    return true;
  }

  vtkNew<vtkIntArray> edgeLevels;
  edgeLevels->SetName(EdgeLevelsName);
  if (!this->ComputeEdgeLevels(input, tags->GetPointer(0), edgeLevels))
  {
    return false;
  }

  output->ShallowCopy(input);
  output->GetPointData()->AddArray(tags);
  output->GetCellData()->AddArray(edgeLevels);
  return true;
}

bool vtkDepthTagFilter::ComputeTags(vtkPolyData* input, vtkFloatArray* tags)
{
  if (this->Metric->IsViewDependent() && !this->Camera)
  {
    vtkErrorMacro(
      "The metric " << this->Metric->GetClassName()
                    << " depends on the view, but there is no camera: call SetCamera().");
    return false;
  }
  return this->AskMetric(input, false, tags);
}

bool vtkDepthTagFilter::AskMetric(vtkPolyData* input, bool perEdge, vtkFloatArray* tags)
{
  relevo::MetricCache& source = *this->Sources->Find(this, input);
  std::string error;
  if (!relevo::ComputeDepthTags(source.GetEvaluator(this->Metric, input), this->MakeView(),
        this->MaximumLevel, perEdge, tags, error))
  {
    vtkErrorMacro("The metric " << error << ".");
    return false;
  }
  return true;
}

bool vtkDepthTagFilter::TakeTags(vtkPolyData* input, vtkFloatArray* tags)
{
  vtkDataArray* own = input->GetPointData()->GetArray(DepthTagName);
  if (!own)
  {
    const std::string misplaced =
      relevo::DescribeMisplacedArray(input, DepthTagName, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    if (misplaced.empty())
    {
      vtkErrorMacro("There is no metric, and the input has no point array \""
        << DepthTagName << "\" to use instead: call SetMetric().");
    }
    else
    {
      vtkErrorMacro("There is no metric, and the input has " << misplaced << ".");
    }
    return false;
  }
  std::string error;
  tags->SetNumberOfTuples(input->GetNumberOfPoints());
  if (!relevo::TakeDepthTags(own, input->GetNumberOfPoints(), tags->GetPointer(0), error))
  {
    vtkErrorMacro("The input's " << error << ".");
    return false;
  }
  return true;
}

bool vtkDepthTagFilter::ComputeEdgeLevels(
  vtkPolyData* input, const float* tags, vtkIntArray* edgeLevels)
{
  edgeLevels->SetNumberOfComponents(3);
  edgeLevels->SetNumberOfTuples(input->GetNumberOfCells());
  edgeLevels->FillValue(-1);
  if (!this->Metric || this->LevelRule == vtkDepthTagMetric::PER_VERTEX)
  {
    SetEdgeLevels(input, edgeLevels,
      [=](vtkIdType a, vtkIdType b)
      { return relevo::edgeLevel(tags[a], tags[b], this->MaximumLevel); });
    return true;
  }
  vtkNew<vtkFloatArray> edgeTags;
  if (!this->AskMetric(input, true, edgeTags))
  {
    return false;
  }
  const relevo::SurfaceEdges& edges = *this->Sources->Find(this, input)->GetMesh(input).GetEdges();
  SetEdgeLevels(input, edgeLevels,
    [&](vtkIdType a, vtkIdType b)
    {
      const relevo::SurfaceTriangles& surface = edges.GetTriangles();
      const int edge = edges.FindEdge(surface.GetMergedPoint(a), surface.GetMergedPoint(b));
      const float tag = edge < 0 ? 0.0f : edgeTags->GetValue(edge);
      return relevo::edgeLevel(tag, tag, this->MaximumLevel);
    });
  return true;
}

void vtkDepthTagFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metric: " << this->Metric.Get() << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent
     << "LevelRule: " << (this->LevelRule == vtkDepthTagMetric::PER_EDGE ? "PerEdge" : "PerVertex")
     << "\n";
}
