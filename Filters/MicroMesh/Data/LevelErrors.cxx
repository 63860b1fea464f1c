// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/LevelErrors.h"

#include "Data/MicroMeshArrays.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
dvec3 Interpolate(const std::vector<dvec3>& positions, int n, const GridPoint& point, int stride)
{
  const GridCell cell = FindGridCell(point, stride);
  dvec3 sum(0.0);
  for (int c = 0; c < 3; ++c)
  {
    if (cell.Shares[c] > 0)
    {
      GridPoint corner = cell.Corners[c];
      for (int& number : corner)
      {
        number *= stride;
      }
      sum += double(cell.Shares[c]) / double(stride) *
        positions[static_cast<std::size_t>(GetGridIndex(n, corner))];
    }
  }
  return sum;
}
}

std::array<double, LargestMicroLevel + 1> FindLevelErrors(
  const MicroMesh& mesh, const MicroMesh::Face& face)
{
  std::array<double, LargestMicroLevel + 1> errors{};
  const std::vector<dvec3> positions = mesh.GetPositions(face);
  const int n = 1 << face.Level;
  for (int level = 0; level < face.Level; ++level)
  {
    std::size_t i = 0;
    ForEachGridPoint(n,
      [&](const GridPoint& point)
      {
        const dvec3 offset = positions[i++] - Interpolate(positions, n, point, n >> level);
        errors[level] = std::max(errors[level], length(offset));
      });
  }
  return errors;
}

bool TakeLevelErrors(
  vtkPolyData* mesh, std::vector<std::array<float, LargestMicroLevel + 1>>& errors)
{
  auto array =
    vtkFloatArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(MicroLevelErrorsName));
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const auto number = static_cast<vtkIdType>(errors.size());
  if (!array || array->GetNumberOfTuples() < first + number ||
    array->GetNumberOfComponents() > LargestMicroLevel + 1)
  {
    return false;
  }
  for (vtkIdType f = 0; f < number; ++f)
  {
    std::array<float, LargestMicroLevel + 1>& ofFace = errors[static_cast<std::size_t>(f)];
    ofFace.fill(0.0f);
    for (int level = 0; level < array->GetNumberOfComponents(); ++level)
    {
      ofFace[level] = array->GetTypedComponent(first + f, level);
      if (!(ofFace[level] >= 0.0f))
      {
        return false;
      }
    }
  }
  return true;
}

vtkSmartPointer<vtkFloatArray> MakeLevelErrors(const MicroMesh& mesh)
{
  int highest = 1;
  for (const MicroMesh::Face& face : mesh.Faces)
  {
    highest = std::max(highest, face.Level);
  }
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(MicroLevelErrorsName);
  array->SetNumberOfComponents(highest); // at the highest level, all errors are 0
  array->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Faces.size()));
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const auto errors = FindLevelErrors(mesh, mesh.Faces[static_cast<std::size_t>(f)]);
        for (int level = 0; level < highest; ++level)
        {
          const auto error = static_cast<float>(errors[level]);
          array->SetTypedComponent(f, level,
            error > 0.0f ? std::nextafter(error, std::numeric_limits<float>::infinity()) : 0.0f);
        }
      }
    });
  return array;
}
}
