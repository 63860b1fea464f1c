// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoWarpScenes.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Distance = 60.0; // from the eye to the plane of a perspective relief
}

std::vector<RelevoWarpScene> RelevoMakeWarpScenes(int width, int height)
{
  const double x = 0.5 * (width - 1);
  const double y = 0.5 * (height - 1);
  const auto bump = [=](int column, int row)
  { return 6.0 - 5.0 * std::exp(-0.02 * (std::pow(column - x, 2) + std::pow(row - y, 2))); };
  const auto wave = [](int column, int row)
  { return 4.0 + 3.5 * std::sin(0.9 * column + 0.4 * row) * std::cos(0.7 * row); };
  const auto ball = [=](int column, int row)
  {
    const double radius = 0.4 * std::min(width, height);
    const double squared = radius * radius - std::pow(column - x, 2) - std::pow(row - y, 2);
    return squared > 0.0 ? radius - std::sqrt(squared) : NaN;
  };
  return { { "flat", [](int, int) { return 2.0; }, false },
    { "slanted", [](int column, int row) { return 0.3 * column + 0.1 * row; }, false },
    { "bump", bump, false }, { "waves", wave, true }, { "ball", ball, true },
    { "steps", [](int column, int row) { return column / 5 % 2 + 12 * (row / 7 % 2); }, true },
    { "holes",
      [=](int column, int row)
      { return column % 7 == 3 && row % 5 == 2 ? NaN : bump(column, row); },
      false },
    { "single texels",
      [=](int column, int row)
      { return column % 3 == 1 && row % 4 == 1 ? bump(column, row) : NaN; },
      false } };
}

vtkSmartPointer<vtkImageData> RelevoMakeWarpRelief(
  const RelevoWarpScene& scene, int width, int height, relevo::ReliefProjection projection)
{
  if (projection == relevo::ReliefProjection::Perspective)
  {
    return RelevoMakeRelief(width, height, projection, RelevoPinhole(width, height, 1.0 / Distance),
      [&](int column, int row) { return Distance + scene.Depth(column, row); });
  }
  relevo::dmat4 matrix(1.0);
  matrix[0][1] = 0.1;
  return RelevoMakeRelief(width, height, projection, matrix, scene.Depth);
}

vtkSmartPointer<vtkCamera> RelevoMakeWarpCamera(
  int width, int height, relevo::ReliefProjection projection, bool isParallel, double x, double y)
{
  const bool isPerspective = projection == relevo::ReliefProjection::Perspective;
  const double middle = 0.5 * (width - 1);
  const relevo::dvec3 target = isPerspective
    ? relevo::dvec3(0.0, 0.0, Distance)
    : relevo::dvec3(middle, 0.5 * (height - 1) + 0.1 * middle, 0.0);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(target.x, target.y, target.z);
  camera->SetPosition(target.x + x, target.y + y, target.z - Distance);
  camera->SetParallelProjection(isParallel);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(1.0, 1000.0);
  return camera;
}

void RelevoAddWarpNormals(vtkImageData* image)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double angle = 0.01 * static_cast<double>(i);
    normals->InsertNextTuple3(0.6 * std::cos(angle), 0.6 * std::sin(angle), -0.8);
  }
  image->GetPointData()->AddArray(normals);
}
