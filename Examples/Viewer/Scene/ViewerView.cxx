// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerView.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
std::array<double, 3> ViewerDirection::GetVector() const
{
  const double a = vtkMath::RadiansFromDegrees(this->Azimuth);
  const double e = vtkMath::RadiansFromDegrees(this->Elevation);
  const double east = std::sin(a) * std::cos(e);
  const double north = std::cos(a) * std::cos(e);
  const double up = std::sin(e);
  switch (this->UpAxis)
  {
    case 0:
      return { { up, east, north } };
    case 1:
      return { { east, up, -north } };
    default:
      return { { east, north, up } };
  }
}

//------------------------------------------------------------------------------
void AddLight(vtkRenderer* renderer, const ViewerLamp& lamp)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(lamp.From.GetVector().data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(lamp.Intensity);
  renderer->AddLight(light);
}

//------------------------------------------------------------------------------
void FitCamera(vtkRenderer* renderer, vtkPoints* points, const ViewerDirection& from, double filled,
  const int size[2])
{
  const std::array<double, 3> direction = from.GetVector();
  const double forward[3] = { -direction[0], -direction[1], -direction[2] };
  double vertical[3] = { 0.0, 0.0, 0.0 };
  vertical[from.UpAxis] = 1.0;
  double right[3];
  double up[3];
  vtkMath::Cross(forward, vertical, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);

  vtkCamera* camera = renderer->GetActiveCamera();
  const double tanY = filled * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  const double tanX = tanY * size[0] / size[1];

  // Every point is inside the four planes of the view: a point (x, y, z) along right, up and
  // forward needs |x - X| <= tanX (z - Z), |y - Y| <= tanY (z - Z).
  double limits[4];
  std::fill_n(limits, 4, -std::numeric_limits<double>::infinity());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    const double x = vtkMath::Dot(point, right);
    const double y = vtkMath::Dot(point, up);
    const double z = vtkMath::Dot(point, forward);
    limits[0] = std::max(limits[0], x - tanX * z);
    limits[1] = std::max(limits[1], -x - tanX * z);
    limits[2] = std::max(limits[2], y - tanY * z);
    limits[3] = std::max(limits[3], -y - tanY * z);
  }
  const double X = 0.5 * (limits[0] - limits[1]);
  const double Y = 0.5 * (limits[2] - limits[3]);
  const double Z = -0.5 * std::max((limits[0] + limits[1]) / tanX, (limits[2] + limits[3]) / tanY);
  points->Modified();
  double bounds[6];
  points->GetBounds(bounds);
  const double centre[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double distance = vtkMath::Dot(centre, forward) - Z;
  double position[3];
  double focus[3];
  for (int i = 0; i < 3; ++i)
  {
    position[i] = X * right[i] + Y * up[i] + Z * forward[i];
    focus[i] = position[i] + distance * forward[i];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(vertical);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void MoveFocus(vtkRenderer* renderer, const std::array<double, 3>& place)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double position[3];
  for (int i = 0; i < 3; ++i)
  {
    position[i] = place[i] + camera->GetPosition()[i] - camera->GetFocalPoint()[i];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(place.data());
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void FocusOnSurface(vtkRenderer* renderer, vtkPolyData* surface)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double beyond[3];
  for (int i = 0; i < 3; ++i)
  {
    beyond[i] = camera->GetPosition()[i] +
      camera->GetClippingRange()[1] * camera->GetDirectionOfProjection()[i];
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  double t;
  double place[3];
  double inCell[3];
  int part;
  if (locator->IntersectWithLine(camera->GetPosition(), beyond, 0.0, t, place, inCell, part))
  {
    camera->SetFocalPoint(place);
  }
}
