// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeThickness.h"

#include "vtkBoundingBox.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
const vtkIdType SampleSize = 20000;

using Faces = std::vector<std::vector<int>>;
using Vector = std::array<double, 3>;

// The faces of a cell by its corners, which are its first points. Empty for other types.
const Faces& GetFaces(int type)
{
  static const Faces none;
  static const Faces tetrahedron = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };
  static const Faces hexahedron = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
    { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  static const Faces voxel = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  static const Faces wedge = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 },
    { 2, 5, 3, 0 } };
  static const Faces pyramid = { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 },
    { 3, 0, 4 } };
  switch (type)
  {
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return tetrahedron;
    case VTK_HEXAHEDRON:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return hexahedron;
    case VTK_VOXEL:
      return voxel;
    case VTK_WEDGE:
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return wedge;
    case VTK_PYRAMID:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
    case VTK_BEZIER_PYRAMID:
      return pyramid;
    default:
      return none;
  }
}

bool IsSolid(int type)
{
  return !GetFaces(type).empty() || type == VTK_POLYHEDRON || type == VTK_CONVEX_POINT_SET ||
    type == VTK_PENTAGONAL_PRISM || type == VTK_HEXAGONAL_PRISM;
}

Vector Subtract(const Vector& a, const Vector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

Vector GetMean(const std::vector<Vector>& points)
{
  Vector mean{};
  for (const Vector& point : points)
  {
    for (int i = 0; i < 3; ++i)
    {
      mean[i] += point[i] / points.size();
    }
  }
  return mean;
}

struct Sums
{
  double Volume = 0.0;
  double Surface = 0.0;
};

// Faces that belong to a single 3D cell add to the surface.
void AddCell(vtkUnstructuredGrid* grid, vtkIdType cell, double weight, Sums& sums)
{
  const Faces& faces = GetFaces(grid->GetCellType(cell));
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  int corners = 0;
  for (const std::vector<int>& face : faces)
  {
    corners = std::max(corners, *std::max_element(face.begin(), face.end()) + 1);
  }
  if (corners == 0 || ids->GetNumberOfIds() < corners)
  {
    return;
  }
  std::vector<Vector> points(corners);
  for (int i = 0; i < corners; ++i)
  {
    grid->GetPoint(ids->GetId(i), points[i].data());
  }
  const Vector centre = GetMean(points);
  vtkNew<vtkIdList> ofFace;
  vtkNew<vtkIdList> neighbours;
  for (const std::vector<int>& face : faces)
  {
    std::vector<Vector> outline;
    ofFace->Reset();
    for (int corner : face)
    {
      outline.push_back(points[corner]);
      ofFace->InsertNextId(ids->GetId(corner));
    }
    const Vector middle = GetMean(outline);
    double area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Vector a = Subtract(outline[i], middle);
      const Vector b = Subtract(outline[(i + 1) % outline.size()], middle);
      double normal[3];
      vtkMath::Cross(a.data(), b.data(), normal);
      area += 0.5 * vtkMath::Norm(normal);
      const Vector height = Subtract(middle, centre);
      sums.Volume += weight * std::abs(vtkMath::Dot(height.data(), normal)) / 6.0;
    }
    grid->GetCellNeighbors(cell, ofFace, neighbours);
    bool isInside = false;
    for (vtkIdType i = 0; i < neighbours->GetNumberOfIds(); ++i)
    {
      isInside = isInside || IsSolid(grid->GetCellType(neighbours->GetId(i)));
    }
    sums.Surface += isInside ? 0.0 : weight * area;
  }
}

// Samples at random, because cells may be numbered along rows.
void AddSample(vtkUnstructuredGrid* grid, vtkIdType numberOfAllCells, Sums& sums)
{
  const vtkIdType number = grid->GetNumberOfCells();
  vtkNew<vtkUnstructuredGrid> linked;
  linked->CopyStructure(grid);
  linked->BuildLinks();
  if (numberOfAllCells <= SampleSize)
  {
    for (vtkIdType cell = 0; cell < number; ++cell)
    {
      AddCell(linked, cell, 1.0, sums);
    }
    return;
  }
  const double share = static_cast<double>(number) / numberOfAllCells;
  const auto picks = static_cast<vtkIdType>(std::ceil(share * SampleSize));
  std::mt19937_64 random;
  for (vtkIdType i = 0; i < picks; ++i)
  {
    const auto cell = static_cast<vtkIdType>(random() % static_cast<std::uint64_t>(number));
    AddCell(linked, cell, static_cast<double>(number) / picks, sums);
  }
}
}

//------------------------------------------------------------------------------
double GetMeanChord(vtkDataObject* data)
{
  const vtkIdType number = data->GetNumberOfElements(vtkDataObject::CELL);
  Sums sums;
  vtkBoundingBox box;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(block);
    if (grid && grid->GetNumberOfCells() > 0)
    {
      box.AddBounds(grid->GetBounds());
      AddSample(grid, number, sums);
    }
  }
  // The sum includes faces between blocks, so the surface of the bounding box limits it.
  double lengths[3] = { 0.0, 0.0, 0.0 };
  if (box.IsValid())
  {
    box.GetLengths(lengths);
  }
  const double ofBox =
    2.0 * (lengths[0] * lengths[1] + lengths[1] * lengths[2] + lengths[2] * lengths[0]);
  const double surface = std::min(sums.Surface, ofBox);
  const double chord = 4.0 * sums.Volume / surface;
  return surface > 0.0 && std::isfinite(chord) ? chord : 0.0;
}
