// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinedCellLocator.h"

#include "Changes/Dependencies.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternChoice.h"
#include "Evaluation/PatternSelection.h"
#include "Intersection/CoarseCell.h"
#include "Intersection/RefinedSurface.h"
#include "Mesh/RefinementMesh.h"
#include "Metrics/MetricCache.h"
#include "Metrics/ViewTime.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRefinedCellLocator);

struct vtkRefinedCellLocator::vtkInternals
{
  relevo::RefinementMesh Mesh;
  vtkTimeStamp MeshTime;
  relevo::PatternSelection Selection;
  std::shared_ptr<relevo::MetricCache> Tags = std::make_shared<relevo::MetricCache>();
  relevo::RefinedSurface Surface;
  relevo::Dependencies MeshDependencies;
  bool Valid = false;
  std::string Warning; // the last warning, to report each one once

  // The state that the surface was built from. Queries in several threads compare it and must not
  // write it.
  const vtkDataSet* Input = nullptr; // only compared, never read
  vtkMTimeType InputTime = 0;
  vtkMTimeType SettingsTime = 0;

  vtkIdType CountOtherCells(vtkPolyData* input) const
  {
    return input->GetNumberOfVerts() + input->GetNumberOfLines();
  }

  vtkBoundingBox GetBox(vtkPolyData* input, vtkIdType cellId) const
  {
    vtkNew<vtkIdList> points;
    relevo::GetCellPoints(input, cellId, points);
    vtkBoundingBox box;
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      double point[3]; // GetPoint(id) returns a buffer that all threads share
      input->GetPoint(points->GetId(i), point);
      box.AddPoint(point);
    }
    return box;
  }

  // Appends each cell of the visited faces once.
  template <typename VisitFaces>
  void AppendCells(vtkIdList* cells, const VisitFaces& visitFaces) const
  {
    std::vector<int> ids;
    visitFaces([&](int face) { ids.push_back(this->Mesh.Faces[face].Cell); });
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    for (int id : ids)
    {
      cells->InsertNextId(id);
    }
  }
};

vtkRefinedCellLocator::vtkRefinedCellLocator()
  : Internals(new vtkInternals)
{
}

vtkRefinedCellLocator::~vtkRefinedCellLocator() = default;

vtkCxxSetSmartPointerMacro(vtkRefinedCellLocator, Refinement, vtkAdaptiveRefinement);

vtkAdaptiveRefinement* vtkRefinedCellLocator::GetRefinement()
{
  return this->Refinement;
}

vtkCxxSetSmartPointerMacro(vtkRefinedCellLocator, Camera, vtkCamera);

vtkCamera* vtkRefinedCellLocator::GetCamera()
{
  return this->Camera;
}

vtkCxxSetSmartPointerMacro(vtkRefinedCellLocator, ModelToWorld, vtkMatrix4x4);

vtkMatrix4x4* vtkRefinedCellLocator::GetModelToWorld()
{
  return this->ModelToWorld;
}

void vtkRefinedCellLocator::SetViewportSize(int width, int height)
{
  relevo::SetPixelSize(this, "ViewportSize", this->ViewportSize, width, height);
}

vtkMTimeType vtkRefinedCellLocator::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Refinement
    ? std::max({ own, this->Refinement->GetMTime(),
        relevo::GetViewTime(this->Refinement->GetMetric(), this->MakeView()) })
    : own;
}

relevo::RefinementView vtkRefinedCellLocator::MakeView() const
{
  return { this->Camera, this->ModelToWorld, { this->ViewportSize[0], this->ViewportSize[1] } };
}

//------------------------------------------------------------------------------
// The search structure

bool vtkRefinedCellLocator::UpdateSurface()
{
  vtkInternals& data = *this->Internals;
  const vtkMTimeType settingsTime = this->GetMTime();
  const vtkMTimeType inputTime = this->DataSet ? this->DataSet->GetMTime() : 0;
  if (data.SettingsTime == settingsTime && data.Input == this->DataSet &&
    data.InputTime == inputTime)
  {
    return data.Valid;
  }
  data.SettingsTime = settingsTime;
  data.Input = this->DataSet;
  data.InputTime = inputTime;
  vtkPolyData* input = vtkPolyData::SafeDownCast(this->DataSet);
  data.Valid = false;
  if (!input)
  {
    vtkErrorMacro("The locator needs a vtkPolyData: call SetDataSet() with the coarse mesh"
      << (this->DataSet ? std::string(", not with a ") + this->DataSet->GetClassName()
                        : std::string())
      << ".");
  }
  else
  {
    const auto prepare = [&] { return this->Prepare(input); };
    data.Valid = relevo::RunWithinMemory(this, "the surface of the mesh", prepare);
    if (!data.Valid) // incomplete; try again next time
    {
      data.Mesh = relevo::RefinementMesh();
      data.MeshDependencies.Clear();
    }
  }
  this->BuildTime.Modified();
  return data.Valid;
}

bool vtkRefinedCellLocator::Prepare(vtkPolyData* input)
{
  vtkInternals& data = *this->Internals;
  std::string error;
  std::string warning;
  bool valid = true;
  relevo::Dependencies dependencies;
  dependencies.AddObject(input);
  dependencies.AddObject(this->Refinement.Get());
  if (data.MeshDependencies.Update(dependencies))
  {
    valid = relevo::PrepareMesh(input, this->Refinement, nullptr, data.Mesh, error, warning);
    if (!valid)
    {
      data.Mesh = relevo::RefinementMesh(); // incomplete; try again next time
      data.MeshDependencies.Clear();
    }
    data.MeshTime.Modified();
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  valid = valid &&
    relevo::SelectPatterns(
      input, this->Refinement, this->MakeView(), data.Mesh, data.Tags, data.Selection, error);
  if (!valid)
  {
    vtkErrorMacro(<< error);
    return false;
  }
  const std::string patternWarning = relevo::FindNewWarning(this->Refinement, data.Warning);
  if (!patternWarning.empty())
  {
    vtkWarningMacro(<< patternWarning);
  }
  data.Surface.Update(
    data.Mesh, data.MeshTime, this->Refinement, input->GetPointData()->GetNormals());
  return true;
}

void vtkRefinedCellLocator::BuildLocator()
{
  this->UpdateSurface();
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
void vtkRefinedCellLocator::ForceBuildLocator()
{
  this->FreeSearchStructure();
  this->UpdateSurface();
}
#endif

void vtkRefinedCellLocator::FreeSearchStructure()
{
  this->Internals.reset(new vtkInternals);
}

void vtkRefinedCellLocator::GenerateRepresentation(int, vtkPolyData* pd)
{
  pd->Initialize();
  if (!this->UpdateSurface())
  {
    return;
  }
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputDataObject(this->DataSet);
  filter->SetRefinement(this->Refinement);
  filter->SetCamera(this->Camera);
  filter->SetModelToWorld(this->ModelToWorld);
  filter->SetViewportSize(this->ViewportSize);
  filter->Update();
  pd->ShallowCopy(filter->GetOutput());
}

//------------------------------------------------------------------------------
// Queries

int vtkRefinedCellLocator::IntersectWithLine(const double p1[3], const double p2[3], double tol,
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell)
{
  cellId = -1;
  if (!this->UpdateSurface())
  {
    return 0;
  }
  vtkInternals& data = *this->Internals;
  const int others = this->IntersectOtherCells(p1, p2, tol, t, x, pcoords, subId, cellId, cell);
  relevo::SurfaceHit hit;
  if (!data.Surface.Intersect(data.Selection, p1, p2, tol, hit) || (others && t < hit.T))
  {
    return others;
  }
  const relevo::CoarseCell coarse(static_cast<vtkPolyData*>(this->DataSet), data.Mesh, hit, cell);
  relevo::TurnCell(cell, hit.Normal);
  t = hit.T;
  std::copy_n(hit.Position, 3, x);
  std::copy_n(coarse.PCoords, 3, pcoords);
  subId = coarse.SubId;
  cellId = coarse.CellId;
  return 1;
}

int vtkRefinedCellLocator::IntersectWithLine(const double p1[3], const double p2[3], double tol,
  vtkPoints* points, vtkIdList* cellIds, vtkGenericCell*)
{
  return this->FindHits(p1, p2, tol, points, cellIds) != 0 ? 1 : 0;
}

int vtkRefinedCellLocator::IntersectWithLine(
  const double p1[3], const double p2[3], double tol, vtkPoints* points, vtkIdList* cellIds)
{
  return this->IntersectWithLine(p1, p2, tol, points, cellIds, nullptr);
}

int vtkRefinedCellLocator::IntersectWithLine(
  const double p1[3], const double p2[3], vtkPoints* points, vtkIdList* cellIds)
{
  return this->FindHits(p1, p2, 0.0, points, cellIds);
}

int vtkRefinedCellLocator::FindHits(
  const double p1[3], const double p2[3], double tol, vtkPoints* points, vtkIdList* cellIds)
{
  if (points)
  {
    points->Reset();
  }
  if (cellIds)
  {
    cellIds->Reset();
  }
  if (!this->UpdateSurface())
  {
    return 0;
  }
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = static_cast<vtkPolyData*>(this->DataSet);
  std::vector<relevo::SurfaceHit> hits;
  data.Surface.IntersectAll(data.Selection, p1, p2, hits);
  relevo::SurfaceHit near;
  if (hits.empty() && tol > 0.0 && data.Surface.Intersect(data.Selection, p1, p2, tol, near))
  {
    hits.push_back(near);
  }
  std::multimap<double, std::pair<const double*, vtkIdType>> found; // by parameter on the line
  for (const relevo::SurfaceHit& hit : hits)
  {
    found.insert({ hit.T, { hit.Position, data.Mesh.Faces[hit.Face].Cell } });
  }
  vtkNew<vtkGenericCell> cell;
  std::list<std::array<double, 3>> others;
  for (vtkIdType id = 0; id < data.CountOtherCells(input); ++id)
  {
    double t;
    double pcoords[3];
    int subId;
    others.emplace_back();
    relevo::GetCell(input, id, cell);
    if (cell->IntersectWithLine(p1, p2, tol, t, others.back().data(), pcoords, subId))
    {
      found.insert({ t, { others.back().data(), id } });
    }
  }
  for (const auto& hit : found)
  {
    if (points)
    {
      points->InsertNextPoint(hit.second.first);
    }
    if (cellIds)
    {
      cellIds->InsertNextId(hit.second.second);
    }
  }
  double along[3];
  vtkMath::Subtract(p2, p1, along);
  return found.empty() ? 0 : !hits.empty() && vtkMath::Dot(along, hits[0].Normal) > 0.0 ? -1 : 1;
}

int vtkRefinedCellLocator::IntersectOtherCells(const double p1[3], const double p2[3], double tol,
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell)
{
  vtkPolyData* input = static_cast<vtkPolyData*>(this->DataSet);
  t = std::numeric_limits<double>::max();
  for (vtkIdType id = 0; id < this->Internals->CountOtherCells(input); ++id)
  {
    double here;
    double point[3];
    double coordinates[3];
    int sub;
    relevo::GetCell(input, id, cell);
    if (cell->IntersectWithLine(p1, p2, tol, here, point, coordinates, sub) && here < t)
    {
      t = here;
      std::copy_n(point, 3, x);
      std::copy_n(coordinates, 3, pcoords);
      subId = sub;
      cellId = id;
    }
  }
  if (cellId >= 0)
  {
    relevo::GetCell(input, cellId, cell);
  }
  return cellId >= 0 ? 1 : 0;
}

void vtkRefinedCellLocator::FindClosestPoint(const double x[3], double closestPoint[3],
  vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2)
{
  double place[3] = { x[0], x[1], x[2] };
  int inside;
  this->FindClosestPointWithinRadius(place, std::numeric_limits<double>::infinity(), closestPoint,
    cell, cellId, subId, dist2, inside);
}

vtkIdType vtkRefinedCellLocator::FindClosestPointWithinRadius(double x[3], double radius,
  double closestPoint[3], vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2,
  int& inside)
{
  cellId = -1;
  inside = 0;
  if (!this->UpdateSurface())
  {
    return 0;
  }
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = static_cast<vtkPolyData*>(this->DataSet);
  relevo::SurfaceHit hit;
  if (data.Surface.FindClosest(data.Selection, x, radius, hit, dist2))
  {
    const relevo::CoarseCell coarse(input, data.Mesh, hit, cell);
    std::copy_n(hit.Position, 3, closestPoint);
    subId = coarse.SubId;
    cellId = coarse.CellId;
    inside = std::all_of(hit.Weights, hit.Weights + 3, [](double weight) { return weight > 0.0; });
  }
  for (vtkIdType id = 0; id < data.CountOtherCells(input); ++id)
  {
    vtkNew<vtkGenericCell> other;
    relevo::GetCell(input, id, other);
    std::vector<double> weights(static_cast<size_t>(other->GetNumberOfPoints()));
    double point[3] = { 0.0, 0.0, 0.0 };
    double pcoords[3];
    double here = std::numeric_limits<double>::infinity();
    int sub = 0;
    const int status = other->EvaluatePosition(x, point, sub, pcoords, here, weights.data());
    const bool isPlace = std::all_of(point, point + 3, [](double c) { return std::isfinite(c); });
    if (status >= 0 && isPlace && here >= 0.0 && here < dist2)
    {
      dist2 = here;
      std::copy_n(point, 3, closestPoint);
      subId = sub;
      cellId = id;
      inside = status;
      cell->SetCellType(other->GetCellType());
      cell->DeepCopy(other);
    }
  }
  return cellId >= 0 ? 1 : 0;
}

void vtkRefinedCellLocator::FindCellsWithinBounds(double* bbox, vtkIdList* cells)
{
  cells->Reset();
  if (!this->UpdateSurface())
  {
    return;
  }
  vtkPolyData* input = static_cast<vtkPolyData*>(this->DataSet);
  for (vtkIdType id = 0; id < this->Internals->CountOtherCells(input); ++id)
  {
    if (vtkBoundingBox(bbox).Intersects(this->Internals->GetBox(input, id)))
    {
      cells->InsertNextId(id);
    }
  }
  this->Internals->AppendCells(
    cells, [&](const auto& visit) { this->Internals->Surface.ForEachFaceInBounds(bbox, visit); });
}

void vtkRefinedCellLocator::FindCellsAlongLine(
  const double p1[3], const double p2[3], double tolerance, vtkIdList* cells)
{
  cells->Reset();
  if (!this->UpdateSurface())
  {
    return;
  }
  vtkPolyData* input = static_cast<vtkPolyData*>(this->DataSet);
  for (vtkIdType id = 0; id < this->Internals->CountOtherCells(input); ++id)
  {
    vtkBoundingBox box = this->Internals->GetBox(input, id);
    box.Inflate(tolerance);
    if (box.IntersectsLine(p1, p2))
    {
      cells->InsertNextId(id);
    }
  }
  this->Internals->AppendCells(cells,
    [&](const auto& visit)
    { this->Internals->Surface.ForEachFaceOnLine(p1, p2, tolerance, visit); });
}

void vtkRefinedCellLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ModelToWorld: " << this->ModelToWorld.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
}
