// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MetricMesh.h"

#include "Changes/Dependencies.h"
#include "Metrics/SurfaceShape.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <utility>

namespace relevo
{
MetricMesh::MetricMesh()
  : ShapeDependencies(new Dependencies)
{
}

MetricMesh::MetricMesh(vtkPolyData* mesh)
  : MetricMesh()
{
  this->Update(mesh);
}

MetricMesh::~MetricMesh() = default;

void MetricMesh::Update(vtkPolyData* mesh)
{
  this->Mesh = mesh;
  Dependencies dependencies;
  dependencies.AddObject(mesh->GetPoints());
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    dependencies.AddObject(cells);
  }
  if (this->ShapeDependencies->Update(dependencies))
  {
    this->Shape = std::make_unique<SurfaceShape>(mesh);
    this->Shape->SetWhole(this->Whole);
    this->ShapeTime.Modified();
  }
}

void MetricMesh::SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole)
{
  if (this->Whole == whole)
  {
    return;
  }
  this->Whole = std::move(whole);
  this->ShapeTime.Modified();
  if (this->Shape)
  {
    this->Shape->SetWhole(this->Whole);
  }
}

const std::shared_ptr<const SurfaceTriangles>& MetricMesh::GetTriangles()
{
  return this->Shape->GetTriangles();
}

const std::shared_ptr<const SurfaceEdges>& MetricMesh::GetEdges()
{
  return this->Shape->GetEdges();
}

SurfaceShape& GetShape(MetricMesh& mesh)
{
  return *mesh.Shape;
}
}
