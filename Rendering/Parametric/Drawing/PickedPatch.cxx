// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PickedPatch.h"

#include "Mesh/PatchArrays.h"
#include "Patches/NearestPatchPoint.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <functional>
#include <string>

namespace relevo
{
namespace
{
using LocateOnPatch = std::function<vec2(const PatchArrays&)>;

vtkIdType FindPatchCell(
  vtkPolyData* mesh, vtkIdType triangle, double pcoords[3], const LocateOnPatch& locate)
{
  PatchArrays patches;
  std::string error;
  const vtkIdType first = mesh ? mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() : 0;
  vtkIdTypeArray* cells = mesh
    ? vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("vtkOriginalCellIds"))
    : nullptr;
  if (!cells || triangle < first || triangle >= cells->GetNumberOfTuples() ||
    triangle >= mesh->GetNumberOfCells() || !patches.Take(mesh, error))
  {
    return -1;
  }
  const vec2 uv = locate(patches);
  pcoords[0] = uv.x;
  pcoords[1] = uv.y;
  pcoords[2] = 0.0;
  return cells->GetValue(triangle);
}
}

vtkIdType FindPickedPatch(
  vtkPolyData* mesh, vtkIdType triangle, const double place[2], double pcoords[3])
{
  return FindPatchCell(mesh, triangle, pcoords,
    [triangle, place](const PatchArrays& patches)
    {
      const vec2 corner = patches.GetCoordinates(triangle, 0);
      const vec2 r = patches.GetCoordinates(triangle, 1) - corner;
      const vec2 s = patches.GetCoordinates(triangle, 2) - corner;
      return corner + r * static_cast<float>(place[0]) + s * static_cast<float>(place[1]);
    });
}

vtkIdType FindNearestPatch(
  vtkPolyData* mesh, vtkIdType triangle, const double position[3], double pcoords[3])
{
  const dvec3 place(position[0], position[1], position[2]);
  return FindPatchCell(mesh, triangle, pcoords,
    [triangle, &place](const PatchArrays& patches)
    { return FindNearestPatchPoint(patches, patches.GetPatchId(triangle), place); });
}
}
