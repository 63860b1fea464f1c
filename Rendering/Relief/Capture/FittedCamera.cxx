// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/FittedCamera.h"

#include "Data/ZBufferSpace.h"
#include "View/WorldView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace relevo
{
namespace
{
dvec4 GetRow(const dmat4& matrix, int row)
{
  return dvec4(matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]);
}

// Copy a camera, including the members that DeepCopy() of VTK 9.1 does not copy.
vtkSmartPointer<vtkCamera> Copy(vtkCamera* camera)
{
  auto copy = vtkSmartPointer<vtkCamera>::New();
  copy->DeepCopy(camera);
  copy->SetExplicitProjectionTransformMatrix(camera->GetExplicitProjectionTransformMatrix());
  copy->SetUseExplicitProjectionTransformMatrix(camera->GetUseExplicitProjectionTransformMatrix());
  copy->SetUseExplicitAspectRatio(camera->GetUseExplicitAspectRatio());
  copy->SetExplicitAspectRatio(camera->GetExplicitAspectRatio());
  return copy;
}

void SetExplicitProjection(vtkCamera* camera, const dmat4& projection)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix->SetElement(i / 4, i % 4, projection[i % 4][i / 4]);
  }
  camera->SetUserTransform(nullptr); // the matrix includes it
  camera->SetExplicitProjectionTransformMatrix(matrix);
  camera->UseExplicitProjectionTransformMatrixOn();
}

// Return the smallest and largest value of a function over the corners.
dvec2 FindRange(const dvec4& function, const std::vector<dvec3>& corners)
{
  dvec2 range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const dvec3& corner : corners)
  {
    const double value = dot(function, dvec4(corner, 1.0));
    range.x = std::min(range.x, value);
    range.y = std::max(range.y, value);
  }
  return range;
}

double FindDiagonal(const std::vector<dvec3>& corners)
{
  dvec3 size;
  for (int axis = 0; axis < 3; ++axis)
  {
    dvec4 coordinate(0.0);
    coordinate[axis] = 1.0;
    const dvec2 range = FindRange(coordinate, corners);
    size[axis] = range.y - range.x;
  }
  return length(size);
}

using Triangles = std::vector<std::array<size_t, 3>>;

// Return the triangles of an icosahedron in the unit sphere.
Triangles FindNearTriples(const std::vector<dvec3>& points)
{
  const auto near = [&](size_t i, size_t j) { return distance(points[i], points[j]) < 1.1; };
  Triangles triples;
  for (size_t i = 0; i < points.size(); ++i)
  {
    for (size_t j = i + 1; j < points.size(); ++j)
    {
      for (size_t k = j + 1; k < points.size(); ++k)
      {
        if (near(i, j) && near(j, k) && near(k, i))
        {
          triples.push_back({ { i, j, k } });
        }
      }
    }
  }
  return triples;
}

// Split each triangle in four at the midpoints of edges, which are added to the points of the unit
// sphere.
Triangles Split(const Triangles& faces, std::vector<dvec3>& points)
{
  std::map<std::pair<size_t, size_t>, size_t> middles;
  const auto findMiddle = [&](size_t i, size_t j)
  {
    const auto found = middles.insert({ std::minmax({ i, j }), points.size() });
    if (found.second)
    {
      points.push_back(normalize(points[i] + points[j]));
    }
    return found.first->second;
  };
  Triangles parts;
  for (const auto& face : faces)
  {
    const size_t middle[3] = { findMiddle(face[0], face[1]), findMiddle(face[1], face[2]),
      findMiddle(face[2], face[0]) };
    parts.push_back({ { middle[0], middle[1], middle[2] } });
    for (size_t i = 0; i < 3; ++i)
    {
      parts.push_back({ { face[i], middle[i], middle[(i + 2) % 3] } });
    }
  }
  return parts;
}
}

FittedCamera FitCamera(vtkCamera* camera, int width, int height, const std::vector<dvec3>& corners,
  double nearClippingPlaneTolerance)
{
  FittedCamera fitted;
  const vtkSmartPointer<vtkCamera> copy = Copy(camera);
  const double aspect = static_cast<double>(width) / height;
  const dmat4 view = MakeMatrix(copy->GetModelViewTransformMatrix());
  dmat4 projection = MakeMatrix(copy->GetProjectionTransformMatrix(aspect, -1.0, 1.0));
  const bool isPerspective = dvec3(GetRow(projection, 3)) != dvec3(0.0);

  // Depth as a function of positions in camera coordinates, and in world coordinates.
  const dvec4 depth = isPerspective ? GetRow(projection, 3) : dvec4(0.0, 0.0, -1.0, 0.0);
  const double unit = isPerspective ? 1.0 : length(dvec3(GetRow(view, 2)));
  dvec2 range = FindRange(transpose(view) * depth, corners);
  const double margin = 0.001 * unit * FindDiagonal(corners);
  const double rounding = 1e-6 * std::max(std::abs(range.x), std::abs(range.y));
  range += std::max(margin, rounding) * dvec2(-1.0, 1.0);
  if (isPerspective)
  {
    const double least = nearClippingPlaneTolerance > 0.0 ? nearClippingPlaneTolerance : 0.001;
    range.x = std::max(range.x, least * range.y);
  }
  fitted.IsSingular = !std::isfinite(range.x) || !std::isfinite(range.y);
  if (fitted.IsSingular || !(range.y > range.x) || (isPerspective && !(range.x > 0.0)))
  {
    return fitted;
  }
  // The row of the projection that maps the near plane's depth to -1 and the far plane's to 1.
  const double length = range.y - range.x;
  const dvec4 row = isPerspective
    ? (range.x + range.y) / length * depth - dvec4(0.0, 0.0, 0.0, 2.0 * range.x * range.y / length)
    : (2.0 * depth - dvec4(0.0, 0.0, 0.0, range.x + range.y)) / length * projection[3][3];
  for (int column = 0; column < 4; ++column)
  {
    projection[column][2] = row[column];
  }
  SetExplicitProjection(copy, projection);
  copy->SetClippingRange(range.x / unit, range.y / unit);
  fitted.Range = range;
  fitted.IsSingular = !ZBufferSpace(copy, width, height).IsRegular();
  fitted.Camera = fitted.IsSingular ? nullptr : copy;
  return fitted;
}

vtkSmartPointer<vtkCamera> WidenCamera(
  vtkCamera* camera, int width, int height, const ivec2& margin)
{
  const vtkSmartPointer<vtkCamera> copy = Copy(camera);
  const double aspect = static_cast<double>(width) / height;
  dmat4 projection = MakeMatrix(copy->GetProjectionTransformMatrix(aspect, -1.0, 1.0));
  for (int column = 0; column < 4; ++column)
  {
    projection[column].x *= width / (width + 2.0 * margin.x);
    projection[column].y *= height / (height + 2.0 * margin.y);
  }
  SetExplicitProjection(copy, projection);
  return copy;
}

vtkSmartPointer<vtkCamera> MakeCameraAlong(
  const dvec3& direction, int width, int height, const std::vector<dvec3>& corners)
{
  const dvec3 along = normalize(direction);
  const dvec3 upwards = std::abs(along.z) < 0.9 ? dvec3(0.0, 0.0, 1.0) : dvec3(0.0, 1.0, 0.0);
  const dvec3 right = normalize(cross(along, upwards));
  const dvec3 up = cross(right, along);
  const dvec2 x = FindRange(dvec4(right, 0.0), corners);
  const dvec2 y = FindRange(dvec4(up, 0.0), corners);
  const dvec2 z = FindRange(dvec4(along, 0.0), corners);
  const double diagonal = FindDiagonal(corners);

  // The size of a pixel in world units.
  const double pixel = std::max({ (x.y - x.x) / std::max(width - 2, 1),
    (y.y - y.x) / std::max(height - 2, 1), 1e-6 * diagonal });
  const dvec3 middle =
    0.5 * (x.x + x.y) * right + 0.5 * (y.x + y.y) * up + (z.x - 0.5 * diagonal) * along;
  const dvec3 focus = middle + along * std::max(diagonal, 1e-6);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(diagonal > 0.0 ? 0.5 * pixel * height : 1.0);
  camera->SetPosition(&middle[0]);
  camera->SetFocalPoint(&focus[0]);
  camera->SetViewUp(&up[0]);
  return camera;
}

std::vector<dvec3> GetBoxDirections()
{
  std::vector<dvec3> directions;
  for (int axis = 0; axis < 3; ++axis)
  {
    dvec3 direction(0.0);
    for (double sign : { 1.0, -1.0 })
    {
      direction[axis] = sign;
      directions.push_back(direction);
    }
  }
  return directions;
}

std::vector<dvec3> GetSphereDirections(int level)
{
  std::vector<dvec3> points;
  const double golden = 0.5 + 0.5 * std::sqrt(5.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int signs = 0; signs < 4; ++signs)
    {
      dvec3 point(0.0);
      point[(axis + 1) % 3] = signs & 1 ? 1.0 : -1.0;
      point[(axis + 2) % 3] = signs & 2 ? golden : -golden;
      points.push_back(normalize(point));
    }
  }
  Triangles faces = FindNearTriples(points);
  for (int i = 0; i < level; ++i)
  {
    faces = Split(faces, points);
  }
  for (dvec3& point : points)
  {
    point = -point;
  }
  return points;
}
}
