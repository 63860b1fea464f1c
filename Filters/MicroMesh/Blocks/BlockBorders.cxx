// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockBorders.h"

#include "Blocks/ContourSettings.h"
#include "Data/MicroMeshArrays.h"
#include "Dense/DenseMesh.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>

namespace relevo
{
namespace
{
// Calls f(id, point) for fixed points.
template <typename Function>
void ForEachFixedPoint(vtkPolyData* mesh, const Function& f)
{
  vtkDataArray* marks = mesh->GetPointData()->GetArray(FixedPointsName);
  for (vtkIdType i = 0; marks && i < mesh->GetNumberOfPoints(); ++i)
  {
    if (marks->GetComponent(i, 0) != 0.0)
    {
      std::array<double, 3> point{};
      mesh->GetPoint(i, point.data());
      f(i, point);
    }
  }
}
}

void BlockBorders::SetFixedPoints(vtkPolyData* surface)
{
  vtkDataArray* interpolated = surface->GetPointData()->GetArray(FixedPointsName);
  constexpr double least = IsShared - 0.1;
  vtkNew<vtkFloatArray> marks;
  marks->SetName(FixedPointsName);
  marks->SetNumberOfComponents(4);
  marks->SetNumberOfTuples(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
  {
    unsigned char mark = 0;
    if (interpolated && interpolated->GetComponent(i, 0) > least)
    {
      mark =
        interpolated->GetComponent(i, 1) > least ? DenseMesh::FixedMark : DenseMesh::RemovableMark;
    }
    marks->SetTuple4(i, mark, 0.0, 0.0, 0.0);
  }
  surface->GetPointData()->AddArray(marks);
}

void BlockBorders::Keep(vtkPolyData* surface) const
{
  vtkDataArray* marks = surface->GetPointData()->GetArray(FixedPointsName);
  ForEachFixedPoint(surface,
    [&](vtkIdType id, const Point& point)
    {
      const auto found = this->Kept.find(point);
      if (found != this->Kept.end())
      {
        const std::array<float, 3>& direction = found->second;
        marks->SetTuple4(id, DenseMesh::FixedMark, direction[0], direction[1], direction[2]);
      }
    });
}

void BlockBorders::Take(std::size_t block, vtkPolyData* surface, vtkPolyData* micro)
{
  auto directions =
    vtkFloatArray::SafeDownCast(micro->GetPointData()->GetAbstractArray(MicroDirectionsName));
  std::set<Point> kept;
  ForEachFixedPoint(micro,
    [&](vtkIdType id, const Point& point)
    {
      std::array<float, 3> direction{};
      directions->GetTypedTuple(id, direction.data());
      kept.insert(point);
      this->Kept.emplace(point, direction);
    });
  std::vector<Point>& removed = this->Removed[block];
  removed.clear();
  ForEachFixedPoint(surface,
    [&](vtkIdType, const Point& point)
    {
      if (kept.count(point) == 0)
      {
        removed.push_back(point);
      }
    });
}

std::vector<std::size_t> BlockBorders::FindUnmatched() const
{
  std::vector<std::size_t> blocks;
  for (std::size_t block = 0; block < this->Removed.size(); ++block)
  {
    const std::vector<Point>& removed = this->Removed[block];
    if (std::any_of(removed.begin(), removed.end(),
          [this](const Point& point) { return this->Kept.count(point) > 0; }))
    {
      blocks.push_back(block);
    }
  }
  return blocks;
}
}
