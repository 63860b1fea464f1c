// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/SurfaceShape.h"

namespace relevo
{
SurfaceShape::SurfaceShape(vtkPolyData* mesh)
{
  this->Mesh->CopyStructure(mesh);
}

const std::shared_ptr<const SurfaceTriangles>& SurfaceShape::GetTriangles()
{
  if (!this->Triangles)
  {
    this->Triangles = std::make_shared<SurfaceTriangles>(this->Mesh);
  }
  return this->Triangles;
}

const std::shared_ptr<const SurfaceEdges>& SurfaceShape::GetEdges()
{
  if (!this->Edges)
  {
    this->Edges = std::make_shared<SurfaceEdges>(this->GetTriangles());
  }
  return this->Edges;
}

const LocalPoints& SurfaceShape::GetPoints()
{
  if (!this->Points)
  {
    this->Points = std::make_unique<LocalPoints>();
    this->Points->Build(this->Mesh->GetPoints());
  }
  return *this->Points;
}

const SurfaceNormals& SurfaceShape::GetNormals()
{
  if (!this->Normals)
  {
    this->Normals = std::make_unique<SurfaceNormals>(this->GetTriangles());
  }
  return *this->Normals;
}

const SurfaceDiagonal& SurfaceShape::GetDiagonal()
{
  if (!this->Diagonal)
  {
    this->Diagonal = std::make_unique<SurfaceDiagonal>(this->Mesh, *this->GetTriangles());
  }
  return *this->Diagonal;
}

const DiscreteCurvature& SurfaceShape::GetCurvature()
{
  if (!this->Curvature)
  {
    this->Curvature =
      std::make_unique<DiscreteCurvature>(ComputeDiscreteCurvature(*this->GetTriangles()));
  }
  return *this->Curvature;
}
}
