// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MetricMesh.h"

#include "Core/LocalPoints.h"
#include "Mesh/SurfaceDiagonal.h"
#include "Mesh/SurfaceEdges.h"
#include "Mesh/SurfaceNormals.h"
#include "Mesh/SurfaceTriangles.h"
#include "Metrics/DiscreteCurvature.h"
#include "vtkPolyData.h"
#include "vtkTimeStamp.h"

namespace relevo
{
struct MetricMesh::Shape
{
  GeometryStamp Of{};
  vtkTimeStamp Time;
  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::shared_ptr<const SurfaceEdges> Edges;
  std::unique_ptr<LocalPoints> Points;
  std::unique_ptr<SurfaceNormals> Normals;
  std::unique_ptr<SurfaceDiagonal> Diagonal;
  std::unique_ptr<DiscreteCurvature> Curvature;
};

MetricMesh::MetricMesh()
  : Known(new Shape)
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
  const GeometryStamp stamp = MakeGeometryStamp(mesh);
  if (this->Known->Of != stamp)
  {
    this->Known.reset(new Shape);
    this->Known->Of = stamp;
    this->Known->Time.Modified();
  }
}

vtkMTimeType MetricMesh::GetTime() const
{
  return this->Known->Time;
}

const std::shared_ptr<const SurfaceTriangles>& MetricMesh::GetTriangles()
{
  if (!this->Known->Triangles)
  {
    this->Known->Triangles = std::make_shared<SurfaceTriangles>(this->Mesh);
  }
  return this->Known->Triangles;
}

const std::shared_ptr<const SurfaceEdges>& MetricMesh::GetEdges()
{
  if (!this->Known->Edges)
  {
    this->Known->Edges = std::make_shared<SurfaceEdges>(this->GetTriangles());
  }
  return this->Known->Edges;
}

const LocalPoints& MetricMesh::GetPoints()
{
  if (!this->Known->Points)
  {
    this->Known->Points = std::make_unique<LocalPoints>();
    this->Known->Points->Build(this->Mesh->GetPoints());
  }
  return *this->Known->Points;
}

const SurfaceNormals& MetricMesh::GetNormals()
{
  if (!this->Known->Normals)
  {
    this->Known->Normals = std::make_unique<SurfaceNormals>(this->GetTriangles());
  }
  return *this->Known->Normals;
}

const SurfaceDiagonal& MetricMesh::GetDiagonal()
{
  if (!this->Known->Diagonal)
  {
    this->Known->Diagonal = std::make_unique<SurfaceDiagonal>(this->Mesh, *this->GetTriangles());
  }
  return *this->Known->Diagonal;
}

const DiscreteCurvature& MetricMesh::GetCurvature()
{
  if (!this->Known->Curvature)
  {
    this->Known->Curvature =
      std::make_unique<DiscreteCurvature>(ComputeDiscreteCurvature(*this->GetTriangles()));
  }
  return *this->Known->Curvature;
}
}
