// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/SurfaceShape.h"

#include <utility>

namespace relevo
{
SurfaceShape::SurfaceShape(vtkPolyData* mesh)
{
  this->Mesh->CopyStructure(mesh);
}

void SurfaceShape::SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole)
{
  this->Whole = std::move(whole);
  this->Points.reset();
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
    this->Points->Build(this->Mesh->GetPoints(), this->Whole ? &this->Whole->PointBox : nullptr);
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

const GlobalSurfaceInfo& SurfaceShape::GetOwnBoxes()
{
  if (!this->Boxes)
  {
    this->Boxes = std::make_unique<GlobalSurfaceInfo>();
    this->Boxes->PointBox = MeasurePoints(this->Mesh->GetPoints());
    const SurfaceTriangles& surface = *this->GetTriangles();
    for (const SurfaceTriangles::Triangle& triangle : surface.GetTriangles())
    {
      for (vtkIdType corner : triangle)
      {
        double point[3];
        surface.GetPoint(corner, point);
        this->Boxes->CornerBox.Add(point);
      }
    }
    if (surface.GetTriangles().empty())
    {
      this->Boxes->CornerBox = this->Boxes->PointBox;
    }
  }
  return *this->Boxes;
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
