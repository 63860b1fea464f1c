// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPixelMesh.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
constexpr double MaximumStretch = 8.0;
}

vtkSmartPointer<vtkPolyData> MakePixelMesh(
  const std::vector<vtkSmartPointer<vtkImageData>>& reliefs)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  for (const auto& image : reliefs)
  {
    relevo::Relief relief;
    relief.Read(image);
    const int width = relief.GetWidth();
    std::vector<vtkIdType> ids(relief.GetNumberOfTexels(), -1);
    for (vtkIdType texel = 0; texel < relief.GetNumberOfTexels(); ++texel)
    {
      const int column = static_cast<int>(texel % width);
      const int row = static_cast<int>(texel / width);
      const double height = relief.GetTexelHeight(column, row);
      if (std::isfinite(height))
      {
        const relevo::dvec3 point = relief.GetWorldPoint(column, row, height);
        ids[texel] = points->InsertNextPoint(point.x, point.y, point.z);
        colors->InsertNextTypedTuple(
          relief.GetColors() + texel * relief.GetNumberOfColorComponents());
      }
    }
    const auto sides = relevo::FindReliefSides(relief, MaximumStretch);
    for (vtkIdType texel = 0; texel < relief.GetNumberOfTexels(); ++texel)
    {
      if (sides[texel] & relevo::Quad)
      {
        const vtkIdType above = texel + width;
        triangles->InsertNextCell({ ids[texel], ids[texel + 1], ids[above + 1] });
        triangles->InsertNextCell({ ids[texel], ids[above + 1], ids[above] });
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  mesh->GetPointData()->SetScalars(colors);
  return mesh;
}

vtkSmartPointer<vtkActor> MakePixelMeshActor(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}
