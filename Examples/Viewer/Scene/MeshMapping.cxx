// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshMapping.h"

#include "Options/ViewerOptions.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
using Mapping = ViewerOptions::MappingType;

struct Box
{
  explicit Box(vtkPolyData* mesh)
  {
    mesh->GetBounds(this->Bounds);
    mesh->GetCenter(this->Centre);
    for (int i = 0; i < 3; ++i)
    {
      this->Size[i] = this->Bounds[2 * i + 1] - this->Bounds[2 * i];
    }
  }

  double GetShare(const double point[3], int axis) const
  {
    return this->Size[axis] > 0.0 ? (point[axis] - this->Bounds[2 * axis]) / this->Size[axis] : 0.5;
  }

  double Bounds[6];
  double Centre[3];
  double Size[3];
};

void MapToSphere(const Box& box, const double point[3], int up, double uv[2])
{
  const double z = point[up] - box.Centre[up];
  const double x = point[(up + 1) % 3] - box.Centre[(up + 1) % 3];
  const double y = point[(up + 2) % 3] - box.Centre[(up + 2) % 3];
  const double radius = std::sqrt(x * x + y * y + z * z);
  uv[0] = std::abs(std::atan2(y, x)) / vtkMath::Pi();
  uv[1] = radius > 0.0 ? 1.0 - std::acos(z / radius) / vtkMath::Pi() : 0.5;
}

void MapToPlane(const Box& box, const double point[3], int thinnest, double uv[2])
{
  // The first of the two other axes, in the order x, y, z, points to the right.
  const int right = thinnest == 0 ? 1 : 0;
  uv[0] = box.GetShare(point, right);
  uv[1] = box.GetShare(point, 3 - thinnest - right);
}
}

//------------------------------------------------------------------------------
void AddTextureCoordinates(vtkPolyData* mesh, const ViewerOptions& options)
{
  const Box box(mesh);
  const auto range = std::minmax_element(box.Size, box.Size + 3);
  const int thinnest = static_cast<int>(range.first - box.Size);
  const bool isFlat = *range.first < 0.1 * *range.second;
  const bool isPlane =
    options.Mapping == Mapping::Plane || (options.Mapping == Mapping::Automatic && isFlat);

  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    double uv[2];
    mesh->GetPoint(i, point);
    isPlane ? MapToPlane(box, point, thinnest, uv) : MapToSphere(box, point, options.UpAxis, uv);
    coordinates->InsertNextTuple(uv);
  }
  mesh->GetPointData()->SetTCoords(coordinates);
}
