// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/BoundaryFaces.h"

#include "Cells/CellReader.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace relevo
{
namespace
{
// The lowest three and the highest of the distinct corners.
using FaceKey = std::array<vtkIdType, 4>;

FaceKey GetKey(std::vector<vtkIdType> corners)
{
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  FaceKey key{ -1, -1, -1, corners.back() };
  std::copy_n(corners.begin(), std::min<std::size_t>(corners.size(), 3), key.begin());
  return key;
}

struct KeyedFace
{
  FaceKey Key;
  CellFace Face;

  bool operator<(const KeyedFace& other) const
  {
    return this->Key < other.Key ||
      (this->Key == other.Key &&
        (this->Face.Cell < other.Face.Cell ||
          (this->Face.Cell == other.Face.Cell && this->Face.Face < other.Face.Face)));
  }
};

// Calls function(face) for each face of cells with the given use.
template <typename Function>
void ForEachFace(vtkUnstructuredGrid* grid, const std::vector<CellUse>& uses, CellUse use,
  const Function& function)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(uses.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      CellReader cell(grid);
      for (vtkIdType i = first; i < end; ++i)
      {
        if (uses[i] != use)
        {
          continue;
        }
        cell.Read(i);
        for (int face = 0; face < cell.GetNumberOfFaces(); ++face)
        {
          function(cell, face);
        }
      }
    });
}

// The faces of 3D cells, grouped by lowest corner.
class FaceTable
{
public:
  FaceTable(vtkUnstructuredGrid* grid, const std::vector<CellUse>& uses)
    : Ends(grid->GetNumberOfPoints() + 1)
  {
    const auto getLowest = [](const CellReader& cell, int face)
    { return *std::min_element(cell.GetCorners(face).begin(), cell.GetCorners(face).end()); };
    ForEachFace(grid, uses, CellUse::Solid,
      [&](const CellReader& cell, int face)
      { this->Ends[getLowest(cell, face) + 1].fetch_add(1, std::memory_order_relaxed); });
    for (std::size_t i = 1; i < this->Ends.size(); ++i)
    {
      this->Ends[i] += this->Ends[i - 1];
    }
    // Ends[i] is the start of the faces of point i. Adding faces moves it to their end.
    this->Faces.resize(this->Ends.back());
    ForEachFace(grid, uses, CellUse::Solid,
      [&](const CellReader& cell, int face)
      {
        const vtkIdType place =
          this->Ends[getLowest(cell, face)].fetch_add(1, std::memory_order_relaxed);
        this->Faces[place] = { GetKey(cell.GetCorners(face)), { cell.GetCell(), face } };
      });
  }

  // Calls function(face) for each face that occurs once.
  template <typename Function>
  void ForEachSingle(const Function& function)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Ends.size()) - 1,
      [&](vtkIdType firstPoint, vtkIdType endPoint)
      {
        for (vtkIdType point = firstPoint; point < endPoint; ++point)
        {
          const auto begin = this->Faces.begin() + (point ? this->Ends[point - 1].load() : 0);
          const auto end = this->Faces.begin() + this->Ends[point].load();
          std::sort(begin, end);
          for (auto face = begin; face != end; ++face)
          {
            const bool isSingle = (face == begin || (face - 1)->Key != face->Key) &&
              (face + 1 == end || (face + 1)->Key != face->Key);
            if (isSingle)
            {
              function(face->Face);
            }
          }
        }
      });
  }

private:
  std::vector<std::atomic<vtkIdType>> Ends;
  std::vector<KeyedFace> Faces;
};
}

std::vector<CellFace> FindBoundaryFaces(vtkUnstructuredGrid* grid, const std::vector<CellUse>& uses)
{
  vtkSMPThreadLocal<std::vector<CellFace>> found;
  ForEachFace(grid, uses, CellUse::Surface,
    [&](const CellReader& cell, int face) {
      found.Local().push_back({ cell.GetCell(), face });
    });
  if (std::find(uses.begin(), uses.end(), CellUse::Solid) != uses.end())
  {
    FaceTable(grid, uses)
      .ForEachSingle([&](const CellFace& face) { found.Local().push_back(face); });
  }
  std::vector<CellFace> faces;
  for (const std::vector<CellFace>& part : found)
  {
    faces.insert(faces.end(), part.begin(), part.end());
  }
  vtkSMPTools::Sort(faces.begin(), faces.end(),
    [](const CellFace& a, const CellFace& b)
    { return a.Cell < b.Cell || (a.Cell == b.Cell && a.Face < b.Face); });
  return faces;
}
}
