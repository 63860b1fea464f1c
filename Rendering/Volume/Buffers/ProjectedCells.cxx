// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ProjectedCells.h"

#include "Mesh/RayCastMesh.h"
#include "Points/MergedPoints.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace relevo
{
namespace
{
// Coincident points with different scalars are merged for the order.
void BuildOrder(const RayCastMesh& mesh, VisibilityOrder& order)
{
  const vtkIdType numberOfPoints = static_cast<vtkIdType>(mesh.GetNumberOfPoints());
  std::vector<dvec3> points(mesh.GetNumberOfPoints());
  vtkNew<vtkPoints> all;
  all->SetNumberOfPoints(numberOfPoints);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    const float* point = &mesh.Points[4 * i];
    points[i] = dvec3(point[0], point[1], point[2]);
    all->SetPoint(i, point);
  }
  CellFaces faces(ComputeMergedPoints(all));
  faces.Reserve(mesh.GetNumberOfTetrahedra());
  for (size_t i = 0; i < mesh.Corners.size(); i += 4)
  {
    vtkIdType corners[4];
    for (size_t corner = 0; corner < 4; ++corner)
    {
      corners[corner] = static_cast<vtkIdType>(mesh.Corners[i + corner]);
    }
    faces.Add(VTK_TETRA, corners);
  }
  order.Build(points, std::move(faces));
}
}

bool ProjectedCells::Upload(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh)
{
  this->NumberOfCells = static_cast<int>(mesh.Corners.size() / 4);
  this->Eye = dvec4(0.0);
  BuildOrder(mesh, this->Visibility);
  return this->Corners.Upload(window, mesh.Corners, 4);
}

bool ProjectedCells::Sort(vtkOpenGLRenderWindow* window, const dvec4& eye)
{
  if (this->Eye == eye)
  {
    return true;
  }
  this->Eye = eye;
  return this->Order.Upload(window, this->Visibility.Sort(eye), 1);
}

void ProjectedCells::Activate(vtkShaderProgram* program)
{
  this->Corners.Activate(program, "cellCorners");
  this->Order.Activate(program, "cellOrder");
}

void ProjectedCells::Deactivate()
{
  this->Corners.Deactivate();
  this->Order.Deactivate();
}

void ProjectedCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Corners.ReleaseGraphicsResources(window);
  this->Order.ReleaseGraphicsResources(window);
  this->Eye = dvec4(0.0);
}
}
