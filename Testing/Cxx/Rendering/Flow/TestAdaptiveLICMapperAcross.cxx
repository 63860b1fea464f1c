// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveLICMapper promises: vectors perpendicular to the surface have no streaks at any pixel,
// and tilted vectors have them at all pixels, with and without normals.
#include "RelevoSurfaceFields.h"

#include "vtkPointData.h"

#include <iostream>

namespace
{
std::size_t CountRed(const RelevoLICPicture& picture)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.Depths.size(); ++i)
  {
    count += picture.Depths[i] < 1.0f && picture.Grey.Values[i] > 1.0 ? 1 : 0;
  }
  return count;
}

// The plane is seen at an angle, from `distance` times its size.
RelevoLICPicture Look(vtkPolyData* plane, double lean, double distance)
{
  RelevoLICScene scene(400, 300);
  scene.Add(WithField(plane,
    [lean](const std::array<double, 3>&) {
      return std::array<double, 3>{ { lean, 0.0, -5.0 } };
    }));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double* center = plane->GetCenter();
  camera->SetFocalPoint(center);
  camera->SetPosition(
    center[0] + 0.3 * distance, center[1] - 0.5 * distance, center[2] + 0.8 * distance);
  camera->SetViewAngle(60.0 / distance);
  scene.Renderer->ResetCameraClippingRange();
  return scene.Render();
}
}

int TestAdaptiveLICMapperAcross(int, char*[])
{
  RelevoCheck check;
  const auto bare = RelevoMeshes::Moved(RelevoMeshes::Plane(97, 83), 1.0,
    std::array<double, 3>{ { 3.3, 1.7, 0.9 } }.data(), VTK_DOUBLE);
  bare->GetPointData()->Initialize();
  const auto withNormals = WithNormals(bare,
    [](const std::array<double, 3>&) {
      return std::array<double, 3>{ { 0.0, 0.0, 1.0 } };
    });
  for (vtkPolyData* plane : { bare.Get(), withNormals.Get() })
  {
    for (double distance : { 2.0, 20.0 })
    {
      CHECK_CASE(distance);
      const RelevoLICPicture across = Look(plane, 0.0, distance);
      std::cout << "across: " << across.CountLIC() << " of " << CountRed(across) << " pixels\n";
      CHECK_GREATER(CountRed(across), 5000);
      CHECK_EQUAL(across.CountLIC(), 0);
      const RelevoLICPicture leaning = Look(plane, 0.5, distance);
      std::cout << "leaning: " << leaning.CountLIC() << ", without " << CountRed(leaning) << "\n";
      CHECK_GREATER(leaning.CountLIC(), 5000);
      CHECK_EQUAL(CountRed(leaning), 0);
    }
  }
  return check.GetResult();
}
