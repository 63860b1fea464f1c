// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFaceColors.h"

#include "vtkProperty.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>

namespace RelevoFaceColors
{
Color GetColor(vtkScalarsToColors* table, double value)
{
  const unsigned char* rgb = table->MapValue(value);
  return { { rgb[0], rgb[1], rgb[2] } };
}

bool IsNear(const Color& a, const Color& b, int tolerance)
{
  return std::abs(a[0] - b[0]) <= tolerance && std::abs(a[1] - b[1]) <= tolerance &&
    std::abs(a[2] - b[2]) <= tolerance;
}

View::View()
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(RelevoMeshes::Plane(7, 6));
  triangles->Update();
  this->Plane = triangles->GetOutput();
  this->Metric->SetMaximumDistance(1.6);
  this->Recipe->SetMetric(this->Metric);
  this->Recipe->SetMaximumLevel(MaximumLevel);
  this->Mapper->SetRefinement(this->Recipe);
  this->Mapper->SetSelectionDevice(RelevoScene::GetSelectionDevice());
  this->Mapper->SetInputDataObject(this->Plane);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetBackground(0.25, 0.25, 0.25);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(400, 400);
  this->Window->AddRenderer(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.2, -0.9, 0.7);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  this->Renderer->ResetCameraClippingRange();
}

void View::Render()
{
  this->Window->Render();
  this->Picture = std::make_unique<RelevoPicture>(this->Window);
}

bool View::GetColorAt(vtkIdType face, const Weights& weights, Color& color)
{
  double corners[3][3];
  double display[3][2];
  double point[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    this->Plane->GetPoint(this->Plane->GetCell(face)->GetPointId(i), corners[i]);
    for (int c = 0; c < 3; ++c)
    {
      point[c] += weights[i] * corners[i][c];
    }
    this->Project(corners[i], display[i]);
  }
  const double area = std::abs((display[1][0] - display[0][0]) * (display[2][1] - display[0][1]) -
    (display[2][0] - display[0][0]) * (display[1][1] - display[0][1]));
  double pixel[2];
  this->Project(point, pixel);
  const int x = static_cast<int>(pixel[0]);
  const int y = static_cast<int>(pixel[1]);
  if (area < 200.0 || x < 0 || y < 0 || x >= this->Picture->Size[0] || y >= this->Picture->Size[1])
  {
    return false;
  }
  const unsigned char* rgb =
    &this->Picture->Colors[3 * (static_cast<size_t>(y) * this->Picture->Size[0] + x)];
  color = { { rgb[0], rgb[1], rgb[2] } };
  return true;
}

std::set<Color> View::GetColors() const
{
  std::set<Color> colors;
  for (size_t i = 0; i < this->Picture->GetNumberOfPixels(); ++i)
  {
    const unsigned char* rgb = &this->Picture->Colors[3 * i];
    colors.insert({ { rgb[0], rgb[1], rgb[2] } });
  }
  return colors;
}

void View::Project(const double point[3], double display[2])
{
  this->Renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
  this->Renderer->WorldToDisplay();
  std::copy_n(this->Renderer->GetDisplayPoint(), 2, display);
}
}
