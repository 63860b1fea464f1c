// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoLeaks.h"

#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkMath.h"
#include "vtkProperty.h"

#include <cmath>
#include <random>
#include <vector>

namespace RelevoLeaks
{
bool IsClosed(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(mesh);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(clean->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells() == 0;
}

size_t CountLeaks(RelevoScene& scene, int views, size_t& covered)
{
  std::mt19937 random(11);
  auto uniform = [&random]() { return random() / 2147483648.0 - 1.0; };
  double bounds[6];
  scene.Renderer->ComputeVisiblePropBounds(bounds);
  const double center[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double radius = 0.5 *
    std::sqrt(std::pow(bounds[1] - bounds[0], 2) + std::pow(bounds[3] - bounds[2], 2) +
      std::pow(bounds[5] - bounds[4], 2));
  size_t leaks = 0;
  for (int view = 0; view < views; ++view)
  {
    double out[3] = { uniform(), uniform(), uniform() };
    double side[3] = { uniform(), uniform(), uniform() };
    vtkMath::Normalize(out);
    double across[3];
    vtkMath::Cross(out, side, across);
    vtkMath::Normalize(across);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    // Looks beside the centre, where the surface bends away.
    const double aside = view % 2 ? 0.6 : 0.0;
    for (int i = 0; i < 3; ++i)
    {
      out[i] = center[i] + 3.0 * radius * out[i];
      across[i] = center[i] + aside * radius * across[i];
    }
    camera->SetPosition(out);
    camera->SetFocalPoint(across);
    camera->SetViewUp(side);
    camera->SetViewAngle(view % 2 ? 8.0 : 40.0);
    scene.Renderer->ResetCameraClippingRange();

    std::vector<bool> seen[2];
    for (int back = 0; back < 2; ++back)
    {
      for (size_t i = 0; i < scene.GetNumberOfActors(); ++i)
      {
        scene.GetActor(i)->GetProperty()->SetBackfaceCulling(!back);
        scene.GetActor(i)->GetProperty()->SetFrontfaceCulling(back);
      }
      scene.Render();
      const RelevoPicture picture(scene.Window);
      for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
      {
        seen[back].push_back(picture.Colors[3 * i] > 0);
      }
    }
    for (size_t i = 0; i < seen[0].size(); ++i)
    {
      covered += seen[0][i];
      leaks += seen[0][i] != seen[1][i];
    }
  }
  return leaks;
}

vtkActor* AddWhite(RelevoScene& scene, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  scene.Renderer->SetBackground(0, 0, 0);
  vtkActor* actor = scene.Add(mesh, recipe);
  actor->GetProperty()->LightingOff();
  return actor;
}
}
