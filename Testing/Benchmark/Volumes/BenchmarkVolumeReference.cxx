// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkVolumeReference.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr int Steps = 64; // per ray and tetrahedron

using Vector = std::array<double, 3>;

Vector Subtract(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector Normalize(const Vector& a)
{
  const double length = std::sqrt(Dot(a, a));
  return { a[0] / length, a[1] / length, a[2] / length };
}

// Directions from the eye through the pixels of a square picture.
struct Eye
{
  Eye(vtkCamera* camera, int size)
    : Size(size)
    , HalfHeight(std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle())))
  {
    Vector focus;
    Vector up;
    camera->GetPosition(this->Position.data());
    camera->GetFocalPoint(focus.data());
    camera->GetViewUp(up.data());
    this->Forward = Normalize(Subtract(focus, this->Position));
    this->Right = Normalize(Cross(this->Forward, up));
    this->Up = Cross(this->Right, this->Forward);
  }

  // In pixels, whose centres are at halves.
  std::array<double, 2> Project(const Vector& point) const
  {
    const Vector seen = Subtract(point, this->Position);
    const double scale = 1.0 / (Dot(seen, this->Forward) * this->HalfHeight);
    return { 0.5 * this->Size * (Dot(seen, this->Right) * scale + 1.0),
      0.5 * this->Size * (Dot(seen, this->Up) * scale + 1.0) };
  }

  Vector GetDirection(int i, int j) const
  {
    const double x = (2.0 * (i + 0.5) / this->Size - 1.0) * this->HalfHeight;
    const double y = (2.0 * (j + 0.5) / this->Size - 1.0) * this->HalfHeight;
    Vector direction;
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = this->Forward[k] + x * this->Right[k] + y * this->Up[k];
    }
    return Normalize(direction);
  }

  int Size;
  double HalfHeight;
  Vector Position;
  Vector Forward;
  Vector Right;
  Vector Up;
};

struct Part
{
  double Begin; // along the ray
  double End;
  double First; // the scalar there
  double Last;
};

struct Tetrahedron
{
  std::array<Vector, 4> Corners;
  std::array<double, 4> Scalars;
};

// Returns an empty part if the ray misses.
Part Intersect(const Tetrahedron& cell, const Vector& origin, const Vector& direction)
{
  Part part{ 0.0, 1e300, 0.0, 0.0 };
  std::array<double, 4> heights; // of the origin above each face, 1 at the opposite corner
  std::array<double, 4> slopes;
  for (int k = 0; k < 4; ++k)
  {
    const Vector& base = cell.Corners[(k + 1) % 4];
    const Vector normal =
      Cross(Subtract(cell.Corners[(k + 2) % 4], base), Subtract(cell.Corners[(k + 3) % 4], base));
    const double height = Dot(normal, Subtract(cell.Corners[k], base));
    heights[k] = Dot(normal, Subtract(origin, base)) / height;
    slopes[k] = Dot(normal, direction) / height;
    const double crossing = -heights[k] / slopes[k];
    if (slopes[k] > 0.0)
    {
      part.Begin = std::max(part.Begin, crossing);
    }
    else if (slopes[k] < 0.0)
    {
      part.End = std::min(part.End, crossing);
    }
    else if (heights[k] < 0.0)
    {
      part.End = 0.0;
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    part.First += cell.Scalars[k] * (heights[k] + part.Begin * slopes[k]);
    part.Last += cell.Scalars[k] * (heights[k] + part.End * slopes[k]);
  }
  return part;
}

// Colour and extinction as piecewise linear functions of the scalar.
class Functions
{
public:
  explicit Functions(vtkVolumeProperty* property)
  {
    vtkColorTransferFunction* colors = property->GetRGBTransferFunction();
    vtkPiecewiseFunction* opacities = property->GetScalarOpacity();
    for (int i = 0; i < opacities->GetSize(); ++i)
    {
      double color[6];
      double opacity[4];
      colors->GetNodeValue(i, color); // at the opacities' scalars, as in MakeProperty()
      opacities->GetNodeValue(i, opacity);
      this->Scalars.push_back(opacity[0]);
      this->Values.push_back(
        { color[1], color[2], color[3], opacity[1] / property->GetScalarOpacityUnitDistance() });
    }
  }

  std::array<double, 4> Get(double scalar) const
  {
    const auto next = std::upper_bound(this->Scalars.begin(), this->Scalars.end(), scalar);
    const size_t i = std::clamp<std::ptrdiff_t>(
      next - this->Scalars.begin(), 1, static_cast<std::ptrdiff_t>(this->Scalars.size()) - 1);
    const double t = std::clamp(
      (scalar - this->Scalars[i - 1]) / (this->Scalars[i] - this->Scalars[i - 1]), 0.0, 1.0);
    std::array<double, 4> value;
    for (int k = 0; k < 4; ++k)
    {
      value[k] = (1.0 - t) * this->Values[i - 1][k] + t * this->Values[i][k];
    }
    return value;
  }

private:
  std::vector<double> Scalars;
  std::vector<std::array<double, 4>> Values;
};

Vector Integrate(std::vector<Part>& parts, const Functions& functions, const double background[3])
{
  std::sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.Begin < b.Begin; });
  Vector sum = { 0.0, 0.0, 0.0 };
  double transparency = 1.0;
  for (const Part& part : parts)
  {
    for (int step = 0; step < Steps; ++step)
    {
      const double t = (step + 0.5) / Steps;
      const auto value = functions.Get((1.0 - t) * part.First + t * part.Last);
      const double through = std::exp(-value[3] * (part.End - part.Begin) / Steps);
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += transparency * (1.0 - through) * value[k];
      }
      transparency *= through;
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    sum[k] += transparency * background[k];
  }
  return sum;
}

std::vector<std::vector<Part>> FindParts(vtkUnstructuredGrid* mesh, const Eye& eye)
{
  std::vector<std::vector<Part>> parts(static_cast<size_t>(eye.Size) * eye.Size);
  vtkDataArray* scalars = mesh->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    vtkIdType count;
    const vtkIdType* points;
    mesh->GetCellPoints(id, count, points);
    Tetrahedron cell;
    std::array<int, 2> low = { eye.Size, eye.Size };
    std::array<int, 2> high = { 0, 0 };
    for (int k = 0; k < 4; ++k)
    {
      mesh->GetPoint(points[k], cell.Corners[k].data());
      cell.Scalars[k] = scalars->GetComponent(points[k], 0);
      const auto pixel = eye.Project(cell.Corners[k]);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double at = std::clamp(pixel[axis], -1.0, eye.Size + 1.0);
        low[axis] = std::min(low[axis], std::max(0, static_cast<int>(at) - 1));
        high[axis] = std::max(high[axis], std::min(eye.Size, static_cast<int>(at) + 2));
      }
    }
    for (int j = low[1]; j < high[1]; ++j)
    {
      for (int i = low[0]; i < high[0]; ++i)
      {
        const Part part = Intersect(cell, eye.Position, eye.GetDirection(i, j));
        // Also false if a degenerate cell has no heights.
        if (part.End > part.Begin && std::isfinite(part.First + part.Last))
        {
          parts[static_cast<size_t>(j) * eye.Size + i].push_back(part);
        }
      }
    }
  }
  return parts;
}

bool IsOutline(const std::vector<std::vector<Part>>& parts, int size, int pixel)
{
  const int x = pixel % size;
  const int y = pixel / size;
  int seen = 0;
  int count = 0;
  for (int j = std::max(0, y - 1); j < std::min(size, y + 2); ++j)
  {
    for (int i = std::max(0, x - 1); i < std::min(size, x + 2); ++i)
    {
      ++count;
      seen += parts[static_cast<size_t>(j) * size + i].empty() ? 0 : 1;
    }
  }
  return seen > 0 && seen < count;
}
}

VolumePicture MakeVolumeReference(vtkUnstructuredGrid* mesh, vtkVolumeProperty* property,
  vtkCamera* camera, int size, const double background[3])
{
  auto parts = FindParts(mesh, Eye(camera, size));
  const Functions functions(property);
  VolumePicture picture;
  picture.RGB.resize(3 * parts.size());
  for (int pixel = 0; pixel < size * size; ++pixel)
  {
    picture.IsOutline.push_back(IsOutline(parts, size, pixel));
  }
  vtkSMPTools::For(0, size * size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType pixel = begin; pixel < end; ++pixel)
      {
        const Vector color = Integrate(parts[pixel], functions, background);
        std::copy(color.begin(), color.end(), picture.RGB.begin() + 3 * pixel);
      }
    });
  return picture;
}
