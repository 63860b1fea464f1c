// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshValues.h"

#include "Cells/MergedCellPoints.h"
#include "Cells/MeshScalars.h"
#include "Cells/PointGradients.h"
#include "Cells/VolumeCells.h"
#include "Mesh/MeshExtent.h"
#include "Mesh/RayCastMesh.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace relevo
{
MeshValues::MeshValues() = default;
MeshValues::~MeshValues() = default;
MeshValues::MeshValues(MeshValues&& other) = default;
MeshValues& MeshValues::operator=(MeshValues&& other) = default;

void MeshValues::Keep(VolumeCells& cells, RayCastMesh& mesh)
{
  this->Clear();
  if (!cells.GetPointScalars().AreFinite() || !cells.GetCellScalars().AreFinite())
  {
    return; // cells have been left out
  }
  if (cells.HasCellScalars())
  {
    this->CellIds = std::move(mesh.CellIds);
  }
  this->NumberOfTuples =
    cells.HasCellScalars() ? cells.GetCellScalars().size() : cells.GetPointScalars().size();
  this->PointIds = std::move(mesh.PointIds);
  this->CornerIds = std::move(mesh.CornerIds);
  if (!mesh.PointGradients.empty())
  {
    this->AreMerged = !mesh.IsDiscontinuous && !mesh.HasCornerScalars;
    this->Merged = this->AreMerged ? MergeCellPoints(cells) : MergedCellPoints();
    this->Cells = std::make_unique<VolumeCells>(std::move(cells));
  }
}

// Return the tuple of each point, cell or corner of the mesh, or nothing if merged points now
// differ.
std::vector<vtkIdType> MeshValues::FindTuples(const ScalarTable& all) const
{
  if (!this->CellIds.empty())
  {
    return this->CellIds;
  }
  if (!this->CornerIds.empty())
  {
    return { this->CornerIds.begin(), this->CornerIds.end() };
  }
  std::vector<vtkIdType> tuples;
  for (size_t i = 0; i < this->PointIds.size(); ++i)
  {
    const size_t point = this->PointIds[i];
    if (point == RayCastMesh::UnusedPoint)
    {
      continue;
    }
    if (point >= tuples.size())
    {
      tuples.resize(point + 1, -1);
    }
    if (tuples[point] >= 0 && all[static_cast<size_t>(tuples[point])] != all[i])
    {
      return {};
    }
    tuples[point] = static_cast<vtkIdType>(i);
  }
  return tuples;
}

std::vector<dvec3> MeshValues::GetPoints(const std::vector<MeshScalars>& sets) const
{
  std::vector<dvec3> points;
  size_t i = 0;
  for (const MeshScalars& set : sets)
  {
    for (vtkIdType id = 0; id < set.Mesh->GetNumberOfPoints(); ++id, ++i)
    {
      const size_t point = this->PointIds[i];
      if (point != RayCastMesh::UnusedPoint)
      {
        points.resize(std::max(points.size(), point + 1));
        set.Mesh->GetPoint(id, &points[point].x);
      }
    }
  }
  return points;
}

bool MeshValues::Replace(const std::vector<MeshScalars>& sets,
  const std::vector<ScalarChoice>& choices, int numberOfComponents, RayCastMesh& mesh)
{
  ScalarTable all;
  for (size_t i = 0; i < sets.size(); ++i)
  {
    AddScalars(sets[i].Array, choices[i], all);
  }
  const std::vector<vtkIdType> tuples = all.size() == this->NumberOfTuples && all.AreFinite()
    ? this->FindTuples(all)
    : std::vector<vtkIdType>();
  if (tuples.empty())
  {
    return false;
  }
  MeshExtent extent;
  for (const vtkIdType tuple : tuples)
  {
    const Scalars scalars = all[static_cast<size_t>(tuple)];
    for (size_t c = 0; c < scalars.size(); ++c)
    {
      extent.ScalarLow[c] = std::min(extent.ScalarLow[c], scalars[c]);
      extent.ScalarHigh[c] = std::max(extent.ScalarHigh[c], scalars[c]);
    }
  }
  const std::vector<dvec3> points = this->GetPoints(sets);
  mesh.SetPoints(points.size(), [&](size_t i) { return points[i]; });
  mesh.SetScalars(
    tuples.size(), [&](size_t i) { return all[static_cast<size_t>(tuples[i])]; },
    numberOfComponents,
    !this->CellIds.empty()       ? RayCastMesh::ScalarOwner::Cells
      : !this->CornerIds.empty() ? RayCastMesh::ScalarOwner::Corners
                                 : RayCastMesh::ScalarOwner::Points,
    extent);
  if (this->Cells)
  {
    this->Cells->SetPointScalars(std::move(all));
    // Points of discontinuous scalars may have the same scalars now.
    const std::vector<dvec3> gradients = ComputePointGradients(*this->Cells,
      this->AreMerged ? this->Merged : MergeCellPoints(*this->Cells), numberOfComponents);
    mesh.SetGradients(
      tuples.size(),
      [&](size_t i) {
        return &gradients[static_cast<size_t>(numberOfComponents) * static_cast<size_t>(tuples[i])];
      },
      numberOfComponents);
  }
  return true;
}
}
