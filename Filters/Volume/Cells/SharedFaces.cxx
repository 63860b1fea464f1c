// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SharedFaces.h"

#include "Cells/CellShape.h"
#include "Cells/MergedCellPoints.h"
#include "Cells/VolumeCells.h"
#include "Mesh/FaceNeighbors.h"

#include <algorithm>
#include <array>
#include <vector>

namespace relevo
{
namespace
{
using Face = std::array<int, 4>;

// The cells by their corners.
class CornerCells
{
public:
  void BeginCell() { this->Firsts.push_back(this->Corners.size()); }
  void AddCorner(vtkIdType point) { this->Corners.push_back(static_cast<int>(point)); }
  // The corners of the last cell at these positions in its list. The last two may be the same.
  void AddFace(int a, int b, int c, int d)
  {
    const int* corners = &this->Corners[this->Firsts.back()];
    this->Faces.push_back({ { corners[a], corners[b], corners[c], d == c ? -1 : corners[d] } });
    this->Cells.push_back(this->Firsts.size() - 1);
  }
  // Replaces points by the first ones at their places, and sorts the corners of cells.
  void Merge(const std::vector<vtkIdType>& places)
  {
    const auto move = [&](int& corner)
    { corner = corner < 0 ? corner : static_cast<int>(places[static_cast<size_t>(corner)]); };
    for (Face& face : this->Faces)
    {
      std::for_each(face.begin(), face.end(), move);
    }
    std::for_each(this->Corners.begin(), this->Corners.end(), move);
    this->Firsts.push_back(this->Corners.size());
    for (size_t cell = 0; cell + 1 < this->Firsts.size(); ++cell)
    {
      std::sort(this->GetCorner(cell), this->GetCorner(cell + 1));
    }
  }
  // Whether two faces belong to different cells with the same corners.
  bool AreOfDuplicates(size_t a, size_t b) const
  {
    const size_t here = this->Cells[a];
    const size_t there = this->Cells[b];
    return here != there &&
      std::equal(this->GetCorner(here), this->GetCorner(here + 1), this->GetCorner(there),
        this->GetCorner(there + 1));
  }
  const std::vector<Face>& GetFaces() const { return this->Faces; }

private:
  int* GetCorner(size_t cell) { return this->Corners.data() + this->Firsts[cell]; }
  const int* GetCorner(size_t cell) const { return this->Corners.data() + this->Firsts[cell]; }

  std::vector<Face> Faces;
  std::vector<size_t> Cells; // of faces
  std::vector<int> Corners;  // of all cells
  std::vector<size_t> Firsts;
};

void AddCell(const VolumeCells& cells, const VolumeCells::Cell& cell, CornerCells& all)
{
  const bool isQuadratic = cell.Shape && !cell.Shape->QuadraticFaces.empty();
  const int count = isQuadratic ? 4 : cells.GetNumberOfCorners(cell);
  all.BeginCell();
  for (int i = 0; i < count; ++i)
  {
    all.AddCorner(cells.GetCornerId(cell, i));
  }
  if (count == 4)
  {
    for (int i = 0; i < 4; ++i)
    {
      all.AddFace(i, (i + 1) % 4, (i + 2) % 4, (i + 2) % 4);
    }
    return;
  }
  for (const auto& face : cell.Shape->Faces)
  {
    all.AddFace(face[0], face[1], face[2], face[3]);
  }
}

void AddPart(const BezierHexahedron& shape, std::vector<dvec3>& points, CornerCells& all)
{
  const ivec3 last = shape.GetDegrees();
  all.BeginCell();
  for (int i = 0; i < 8; ++i)
  {
    const int index = shape.GetIndex(i & 1 ? last.x : 0, i & 2 ? last.y : 0, i & 4 ? last.z : 0);
    const double* coefficient = shape.GetCoefficient(index);
    all.AddCorner(static_cast<vtkIdType>(points.size()));
    points.push_back(dvec3(coefficient[0], coefficient[1], coefficient[2]) / coefficient[3]);
  }
  constexpr int faces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  for (const auto& face : faces)
  {
    all.AddFace(face[0], face[1], face[2], face[3]);
  }
}
}

size_t CountSharedFaces(const VolumeCells& cells)
{
  CornerCells all;
  std::vector<dvec3> points = cells.GetPoints();
  for (const VolumeCells::Cell& cell : cells.GetCells())
  {
    AddCell(cells, cell, all);
  }
  for (const CurvedPart& part : cells.GetCurvedParts())
  {
    if (!part.IsGhost)
    {
      AddPart(part.Shape, points, all);
    }
  }
  all.Merge(FindPlaces(points));
  const FaceMatch match = MatchFaces(all.GetFaces(), static_cast<int>(points.size()));
  size_t number = match.NumberOfSharedByMore;
  for (size_t face = 0; face < match.Others.size(); ++face)
  {
    const int other = match.Others[face];
    const bool isPair = other > static_cast<int>(face);
    number += isPair && all.AreOfDuplicates(face, static_cast<size_t>(other)) ? 1 : 0;
  }
  return number;
}

std::string DescribeSharedFaces(size_t number)
{
  return (number == 1 ? std::string("1 face has") : std::to_string(number) + " faces have") +
    " several cells on the same side. Where these cells overlap, values are ambiguous.";
}
}
