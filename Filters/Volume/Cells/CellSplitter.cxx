// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellSplitter.h"

#include "Mesh/FaceTable.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

#include <algorithm>
#include <tuple>

namespace relevo
{
CellSplitter::CellSplitter() = default;
CellSplitter::~CellSplitter() = default;

const std::vector<vtkIdType>& CellSplitter::Split(vtkGenericCell* cell, const dvec3* points)
{
  this->Tetrahedra.clear();
  vtkIdList* all = cell->GetPointIds();
  const std::vector<vtkIdType> ids(all->begin(), all->end());
  if (FindFaceTable(cell->GetCellType()).Faces && cell->IsLinear())
  {
    return this->Split(cell->GetCellType(), ids, points);
  }
  if (cell->IsLinear() && cell->GetCellType() != VTK_CONVEX_POINT_SET)
  {
    const auto findFace = [&](int face)
    {
      vtkIdList* corners = cell->GetFace(face)->GetPointIds();
      this->Face.assign(corners->begin(), corners->end());
    };
    this->SplitLinear(ids, cell->GetNumberOfFaces(), findFace, points);
  }
  else
  {
    cell->Triangulate(0, this->Ids, this->Points);
    this->Tetrahedra.assign(this->Ids->begin(), this->Ids->end());
  }
  return this->Tetrahedra;
}

const std::vector<vtkIdType>& CellSplitter::Split(
  int type, const std::vector<vtkIdType>& ids, const dvec3* points)
{
  this->Tetrahedra.clear();
  const FaceTable table = FindFaceTable(type);
  const auto findFace = [&](int face)
  {
    this->Face.clear();
    for (int corner : table.Faces[face])
    {
      if (corner >= 0)
      {
        this->Face.push_back(ids[static_cast<size_t>(corner)]);
      }
    }
  };
  this->SplitLinear(ids, table.NumberOfFaces, findFace, points);
  return this->Tetrahedra;
}

// Coincident points are ordered by their ids.
void CellSplitter::SplitLinear(const std::vector<vtkIdType>& ids, int numberOfFaces,
  const FaceFinder& findFace, const dvec3* points)
{
  const auto isLower = [points](vtkIdType a, vtkIdType b)
  {
    const auto getKey = [points](vtkIdType id)
    { return std::make_tuple(points[id].x, points[id].y, points[id].z, id); };
    return getKey(a) < getKey(b);
  };
  const vtkIdType lowest = *std::min_element(ids.begin(), ids.end(), isLower);
  for (int i = 0; i < numberOfFaces; ++i)
  {
    findFace(i);
    std::vector<vtkIdType>& face = this->Face;
    if (std::find(face.begin(), face.end(), lowest) != face.end())
    {
      continue;
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end(), isLower), face.end());
    for (size_t last = 2; last < face.size(); ++last)
    {
      for (vtkIdType id : { lowest, face[0], face[last - 1], face[last] })
      {
        this->Tetrahedra.push_back(id);
      }
    }
  }
}
}
