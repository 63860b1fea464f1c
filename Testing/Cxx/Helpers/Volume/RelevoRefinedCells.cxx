// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRefinedCells.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <map>

namespace
{
using Steps = std::array<int, 3>;

struct Cube
{
  Steps Low;
  int Size; // of Finest steps
};

constexpr int Finest = 256; // steps of the unit cube
constexpr int Middle = 8;   // of a cube, after its corners

RelevoPoint GetPlace(const Steps& steps)
{
  return { { static_cast<double>(steps[0]) / Finest, static_cast<double>(steps[1]) / Finest,
    static_cast<double>(steps[2]) / Finest } };
}

bool TouchesSphere(const Cube& cube)
{
  double nearest = 0.0;
  double farthest = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double low = static_cast<double>(cube.Low[c]) / Finest - 0.2;
    const double high = low + static_cast<double>(cube.Size) / Finest;
    nearest += low > 0.0 ? low * low : high < 0.0 ? high * high : 0.0;
    farthest += std::max(low * low, high * high);
  }
  return nearest < 0.45 * 0.45 && farthest > 0.45 * 0.45;
}

void Refine(const Cube& cube, int levels, std::vector<Cube>& all)
{
  if (levels == 0 || !TouchesSphere(cube))
  {
    all.push_back(cube);
    return;
  }
  const int half = cube.Size / 2;
  for (int i = 0; i < 8; ++i)
  {
    Refine({ { { cube.Low[0] + half * (i & 1), cube.Low[1] + half * (i >> 1 & 1),
               cube.Low[2] + half * (i >> 2) } },
             half },
      levels - 1, all);
  }
}

// The cells of a cube, by its corners in the order of x, y and z, and its middle. Diagonals of
// opposite faces are parallel.
std::vector<std::vector<int>> GetCells(int type)
{
  switch (type)
  {
    case VTK_VOXEL:
      return { { 0, 1, 2, 3, 4, 5, 6, 7 } };
    case VTK_WEDGE:
      return { { 0, 1, 3, 4, 5, 7 }, { 0, 3, 2, 4, 7, 6 } };
    case VTK_PYRAMID:
      return { { 0, 1, 3, 2, 8 }, { 5, 4, 6, 7, 8 }, { 1, 0, 4, 5, 8 }, { 2, 3, 7, 6, 8 },
        { 0, 2, 6, 4, 8 }, { 3, 1, 5, 7, 8 } };
    case VTK_TETRA:
      return { { 0, 1, 3, 7 }, { 0, 1, 7, 5 }, { 0, 2, 7, 3 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 },
        { 0, 4, 7, 6 } };
    default:
      return { { 0, 1, 3, 2, 4, 5, 7, 6 } };
  }
}
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoRefinedCells::Make(int type, int refinedType) const
{
  std::vector<Cube> cubes;
  const int size = Finest >> this->Coarse;
  const int count = 1 << this->Coarse;
  for (int i = 0; i < count * count * count; ++i)
  {
    Refine(
      { { { size * (i % count), size * (i / count % count), size * (i / count / count) } }, size },
      this->Levels, cubes);
  }
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> field;
  field->SetName("field");
  std::map<Steps, vtkIdType> known;
  for (const Cube& cube : cubes)
  {
    const int own = refinedType != 0 && cube.Size < size ? refinedType : type;
    for (const std::vector<int>& cell : GetCells(own))
    {
      std::vector<vtkIdType> ids;
      for (int corner : cell)
      {
        Steps steps;
        for (int c = 0; c < 3; ++c)
        {
          const int half = corner == Middle ? 1 : 2 * (corner >> c & 1);
          steps[c] = cube.Low[c] + cube.Size * half / 2;
        }
        const auto [found, isNew] = known.insert({ steps, points->GetNumberOfPoints() });
        if (isNew)
        {
          RelevoPoint at = this->Move(GetPlace(steps));
          for (double& x : at)
          {
            x = this->IsFloat ? static_cast<double>(static_cast<float>(x)) : x;
          }
          points->InsertNextPoint(at.data());
          field->InsertNextValue(this->Field(GetPlace(steps)));
        }
        ids.push_back(found->second);
      }
      mesh->InsertNextCell(own, static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(field);
  return mesh;
}
