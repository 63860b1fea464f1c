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
#include <vector>

namespace
{
const double Filled = 0.94; // share of the picture's sides

// Along the camera's right, up and forward directions.
using Vector = std::array<double, 3>;

// The nearest camera position for which all points lie in a window at distance 1: left, right,
// bottom and top.
Vector GetEye(const std::vector<Vector>& points, const std::array<double, 4>& window)
{
  Vector eye{};
  double middle[2];
  double sums[2];
  double differences[2];
  for (int i = 0; i < 2; ++i)
  {
    middle[i] = 0.5 * (window[2 * i] + window[2 * i + 1]);
    const double half = 0.5 * Filled * (window[2 * i + 1] - window[2 * i]);
    // A point (x, z) lies between two planes of the view: |x - X - middle (z - Z)| <= half (z - Z).
    double upper = -std::numeric_limits<double>::infinity();
    double lower = upper;
    for (const Vector& point : points)
    {
      upper = std::max(upper, point[i] - (middle[i] + half) * point[2]);
      lower = std::max(lower, (middle[i] - half) * point[2] - point[i]);
    }
    differences[i] = upper - lower;
    sums[i] = (upper + lower) / half;
  }
  eye[2] = -0.5 * std::max(sums[0], sums[1]);
  for (int i = 0; i < 2; ++i)
  {
    eye[i] = 0.5 * differences[i] + middle[i] * eye[2];
  }
  return eye;
}

// Whether a line through (x, y), at distance 1 from the camera, separates the points from the upper
// left corner.
bool IsOutOfCorner(const std::vector<Vector>& points, const Vector& eye, double x, double y)
{
  const int steps = 30;
  for (int step = 0; step <= steps; ++step)
  {
    const double angle = 0.5 * vtkMath::Pi() * step / steps;
    const double normal[2] = { -std::cos(angle), std::sin(angle) };
    if (std::all_of(points.begin(), points.end(),
          [&](const Vector& point)
          {
            const double depth = point[2] - eye[2];
            return normal[0] * (point[0] - eye[0] - x * depth) +
              normal[1] * (point[1] - eye[1] - y * depth) <=
              0.0;
          }))
    {
      return true;
    }
  }
  return false;
}
}

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
ViewerDirection FindViewerDirection(const std::array<double, 3>& vector, int upAxis)
{
  const double east = upAxis == 0 ? vector[1] : vector[0];
  const double north = upAxis == 0 ? vector[2] : upAxis == 1 ? -vector[2] : vector[1];
  const double azimuth = vtkMath::DegreesFromRadians(std::atan2(east, north));
  const double elevation =
    vtkMath::DegreesFromRadians(std::asin(std::clamp(vector[upAxis], -1.0, 1.0)));
  return { azimuth < 0.0 ? azimuth + 360.0 : azimuth, elevation, upAxis };
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
void FitCamera(vtkRenderer* renderer, vtkPoints* points, const ViewerDirection& from,
  const ViewerPicture& picture)
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
  std::vector<Vector> turned(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    turned[i] = { { vtkMath::Dot(point, right), vtkMath::Dot(point, up),
      vtkMath::Dot(point, forward) } };
  }

  vtkCamera* camera = renderer->GetActiveCamera();
  const double pixel =
    2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) / picture.Size[1];
  const double width = picture.Size[0] * pixel;
  const double height = picture.Size[1] * pixel;
  // The lower right end of the corner, relative to the picture's centre.
  const double x = picture.Corner[0] * pixel - 0.5 * width;
  const double y = 0.5 * height - picture.Corner[1] * pixel;
  Vector eye = GetEye(turned, { { -0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height } });
  if (!IsOutOfCorner(turned, eye, x, y))
  {
    eye = GetEye(turned, { { x, 0.5 * width, -0.5 * height, 0.5 * height } });
    if (y > -0.5 * height)
    {
      const Vector below = GetEye(turned, { { -0.5 * width, 0.5 * width, -0.5 * height, y } });
      eye = below[2] > eye[2] ? below : eye;
    }
  }

  points->Modified();
  double bounds[6];
  points->GetBounds(bounds);
  const double centre[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double distance = vtkMath::Dot(centre, forward) - eye[2];
  double position[3];
  double focus[3];
  for (int i = 0; i < 3; ++i)
  {
    position[i] = eye[0] * right[i] + eye[1] * up[i] + eye[2] * forward[i];
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
