// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MeshReader.h"

#include "Files/MergedBlocks.h"
#include "Files/MeshPoints.h"
#include "Files/ResultFile.h"
#include "Files/StepFilter.h"
#include "Text/ViewerMessages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

bool HasCurvedCells(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    if ((type >= VTK_QUADRATIC_EDGE && type <= VTK_TRIQUADRATIC_PYRAMID) ||
      type >= VTK_HIGHER_ORDER_EDGE)
    {
      return true;
    }
  }
  return false;
}

// The patches of a grid.
Mesh TakePatches(vtkUnstructuredGrid* grid, ViewerMessages& messages)
{
  vtkNew<vtkPatchSurfaceFilter> surface;
  messages.Observe(surface, "extracting the surface");
  surface->SetInputData(grid);
  surface->Update();
  return surface->GetOutput();
}

// Returns the surface of a data set, which may itself be one.
Mesh TakeSurface(
  vtkDataSet* data, MeshCells cells, SurfaceExtractor& extractor, ViewerMessages& messages)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  const bool hasPatches =
    grid && (cells == MeshCells::Patches || (cells == MeshCells::Curved && HasCurvedCells(grid)));
  return hasPatches ? TakePatches(grid, messages) : extractor.Extract(data, messages);
}

void CheckPoints(vtkPolyData* mesh, const std::string& fileName)
{
  vtkIdType number = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    number +=
      vtkMath::IsFinite(point[0]) && vtkMath::IsFinite(point[1]) && vtkMath::IsFinite(point[2]) ? 0
                                                                                                : 1;
  }
  if (number > 0)
  {
    throw ViewerError(fileName + ": " + std::to_string(number) + " of " +
      std::to_string(mesh->GetNumberOfPoints()) + " points are not finite");
  }
}
}

//------------------------------------------------------------------------------
MeshReader::MeshReader(ResultFile& file, ViewerMessages& messages)
  : File(file)
  , Messages(messages)
{
}

//------------------------------------------------------------------------------
SurfaceMesh MeshReader::Read(int step, StepFilter& filter, MeshCells cells)
{
  ViewerMessages& messages = this->Messages;
  SurfaceMesh surface;
  Mesh& mesh = surface.Data;
  const std::string& fileName = this->File.GetFileName();
  this->File.Read(step,
    [&](vtkDataObject* data)
    {
      const auto changed = filter.Apply(data, messages);
      const auto merged = changed ? MergeBlocks(changed, messages) : nullptr;
      surface.IsOfCells = !vtkPolyData::SafeDownCast(merged);
      surface.Cells = merged;
      mesh = merged ? TakeSurface(merged, cells, this->Extractor, messages) : nullptr;
      if (mesh)
      {
        CheckCorners(mesh);
      }
    });
  filter.Check(fileName);
  if (!mesh || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    throw ViewerError(fileName + " has no polygons to draw");
  }
  mesh = DropUnusedPoints(mesh);
  CheckPoints(mesh, fileName);
  return surface;
}
