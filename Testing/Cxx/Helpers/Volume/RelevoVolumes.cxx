// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoVolumes.h"

#include "Integral/LinearSegment.h"
#include "RelevoDice.h"
#include "vtkCellData.h"
#include "vtkCellTypeSource.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using relevo::dvec4;

// Colour and extinction of the linear field at a point of the cube that begins at `low`.
dvec4 GetOptics(const RelevoRay& ray, double t, double low)
{
  const RelevoPoint p = ray.At(t);
  const double s = GetLinearField({ { p[0] - low, p[1] - low, p[2] - low } });
  return dvec4(1.0 - s, 0.0, s, (0.2 + 0.8 * s) / 0.5);
}
}

double GetLinearField(const RelevoPoint& at)
{
  return 0.2 * at[0] + 0.3 * at[1] + 0.5 * at[2];
}

vtkSmartPointer<vtkVolumeProperty> MakeLinearProperty()
{
  return MakeVolumeProperty(0.2, 1.0, 0.5);
}

std::vector<RelevoColor> MakeLinearPicture(vtkCamera* camera, int width, int height, double low)
{
  std::vector<RelevoColor> expected;
  for (int i = 0; i < width * height; ++i)
  {
    const RelevoRay ray(camera, i % width, i / width, width, height);
    double begin;
    double end;
    dvec4 color(0.0);
    if (ray.CutBox(low, low + 1.0, begin, end))
    {
      color =
        relevo::linearSegment(GetOptics(ray, begin, low), GetOptics(ray, end, low), end - begin);
    }
    expected.push_back({ { color.x, color.y, color.z, color.w } });
  }
  return expected;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra(int n, const RelevoField& field, double low)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("field");
  const int side = n + 1;
  for (int i = 0; i < side * side * side; ++i)
  {
    const RelevoPoint at = { { static_cast<double>(i % side) / n,
      static_cast<double>(i / side % side) / n, static_cast<double>(i / side / side) / n } };
    points->InsertNextPoint(low + at[0], low + at[1], low + at[2]);
    scalars->InsertNextValue(field(at));
  }
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(scalars);
  // From corner 0 to corner 7, along the three axes in each of their 6 orders.
  const int steps[6][2] = { { 1, 3 }, { 1, 5 }, { 2, 3 }, { 2, 6 }, { 4, 5 }, { 4, 6 } };
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    const auto corner = [=](int c)
    {
      const vtkIdType x = cube % n + c % 2;
      const vtkIdType y = cube / n % n + c / 2 % 2;
      const vtkIdType z = cube / n / n + c / 4;
      return x + side * (y + side * z);
    };
    for (const auto& step : steps)
    {
      const vtkIdType ids[4] = { corner(0), corner(step[0]), corner(step[1]), corner(7) };
      mesh->InsertNextCell(VTK_TETRA, 4, ids);
    }
  }
  return mesh;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeBlocksOfCells(
  int type, const RelevoField& field, double distortion, double x)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(3, 3, 3);
  source->Update();
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->DeepCopy(source->GetOutput());
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("waves");
  RelevoDice dice(5);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    at[0] += x;
    for (double& coordinate : at)
    {
      coordinate += distortion * dice.Signed();
    }
    points->InsertNextPoint(at.data());
    values->InsertNextValue(field(at));
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeDiscontinuous(vtkUnstructuredGrid* mesh, double jump)
{
  vtkDataArray* given = mesh->GetPointData()->GetScalars();
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName(given->GetName());
  values->SetNumberOfComponents(given->GetNumberOfComponents());
  RelevoDice dice(17);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    const double difference = jump * dice.Signed();
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType from = corners->GetId(i);
      corners->SetId(i, points->InsertNextPoint(mesh->GetPoint(from)));
      for (int c = 0; c < given->GetNumberOfComponents(); ++c)
      {
        values->InsertNextValue(given->GetComponent(from, c) + difference);
      }
    }
    result->InsertNextCell(mesh->GetCellType(cell), corners);
  }
  result->SetPoints(points);
  result->GetPointData()->SetScalars(values);
  return result;
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocksToLeaveOut(vtkUnstructuredGrid* solid)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkUnstructuredGrid> skin;
  skin->SetPoints(solid->GetPoints());
  skin->GetPointData()->ShallowCopy(solid->GetPointData());
  const vtkIdType corners[3] = { 0, 1, 2 };
  skin->InsertNextCell(VTK_TRIANGLE, 3, corners);
  const auto other = MakeTetrahedra(
    1, [](const RelevoPoint&) { return 0.0; }, 2.0);
  other->GetPointData()->GetArray(0)->SetName("other");
  blocks->SetBlock(0, skin);
  blocks->SetBlock(1, solid);
  blocks->SetBlock(2, other);
  const char* names[] = { "skin", "solid", "air" };
  for (unsigned int i = 0; i < 3; ++i)
  {
    blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), names[i]);
  }
  return blocks;
}

double GetTrilinear(const RelevoPoint& p)
{
  return 0.1 + 0.8 * p[0] * (1.0 - p[1]) + 0.7 * p[1] * (1.0 - p[0]) * p[2] + 0.1 * p[2];
}

vtkSmartPointer<vtkImageData> MakeVoxel(const RelevoField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    RelevoPoint point;
    image->GetPoint(i, point.data());
    image->GetPointData()->GetScalars()->SetComponent(i, 0, field(point));
  }
  return image;
}

vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty(
  double first, double last, double unitDistance)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(1.0, 0.0, 0.0, 1.0);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, first);
  property->GetScalarOpacity()->AddPoint(1.0, last);
  property->SetScalarOpacityUnitDistance(unitDistance);
  return property;
}

vtkSmartPointer<vtkCamera> MakeCamera(
  const RelevoPoint& position, const RelevoPoint& focalPoint, double angle)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewAngle(angle);
  camera->SetClippingRange(1e-6, 100.0);
  return camera;
}

std::vector<RelevoColor> Cast(vtkVolumeRayCastFilter* filter)
{
  filter->Update();
  vtkDataArray* colors = filter->GetOutput()->GetPointData()->GetArray("RGBA");
  std::vector<RelevoColor> result(colors ? colors->GetNumberOfTuples() : 0);
  for (size_t i = 0; i < result.size(); ++i)
  {
    colors->GetTuple(static_cast<vtkIdType>(i), result[i].data());
  }
  return result;
}

std::vector<RelevoColor> Cast(
  vtkDataObject* mesh, vtkVolumeProperty* property, vtkCamera* camera, int width, int height)
{
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputDataObject(mesh);
  filter->SetVolumeProperty(property);
  filter->SetCamera(camera);
  filter->SetViewportSize(width, height);
  return Cast(filter);
}

double FindLargestDifference(const std::vector<RelevoColor>& a, const std::vector<RelevoColor>& b)
{
  double largest = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < a.size() && i < b.size(); ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      const double difference = std::abs(a[i][c] - b[i][c]);
      largest = difference <= largest ? largest : difference; // also detects NaN
    }
  }
  return largest;
}

double FindLargestDifferenceInside(const std::vector<RelevoColor>& a,
  const std::vector<RelevoColor>& b, int width, int first, int last)
{
  const auto crop = [=](const std::vector<RelevoColor>& picture)
  {
    std::vector<RelevoColor> part;
    for (int row = first; row <= last; ++row)
    {
      for (int column = first; column <= last; ++column)
      {
        part.push_back(picture.at(static_cast<size_t>(row) * width + column));
        part.back()[3] = 0.0;
      }
    }
    return part;
  };
  return FindLargestDifference(crop(a), crop(b));
}

RelevoRay::RelevoRay(vtkCamera* camera, int column, int row, int width, int height)
{
  double forward[3];
  double up[3];
  double right[3];
  camera->GetDirectionOfProjection(forward);
  vtkMath::Cross(forward, camera->GetViewUp(), right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);
  const bool isParallel = camera->GetParallelProjection() != 0;
  const double half = isParallel
    ? camera->GetParallelScale()
    : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const double x = half * (2.0 * column + 1.0 - width) / height;
  const double y = half * (2.0 * row + 1.0 - height) / height;
  for (int c = 0; c < 3; ++c)
  {
    const double aside = x * right[c] + y * up[c];
    this->Origin[c] = camera->GetPosition()[c] + (isParallel ? aside : 0.0);
    this->Direction[c] = forward[c] + (isParallel ? 0.0 : aside);
  }
  vtkMath::Normalize(this->Direction.data());
}

RelevoPoint RelevoRay::At(double t) const
{
  RelevoPoint point;
  for (int c = 0; c < 3; ++c)
  {
    point[c] = this->Origin[c] + t * this->Direction[c];
  }
  return point;
}

bool RelevoRay::CutBox(double low, double high, double& begin, double& end) const
{
  begin = 0.0;
  end = std::numeric_limits<double>::max();
  for (int c = 0; c < 3; ++c)
  {
    const double a = (low - this->Origin[c]) / this->Direction[c];
    const double b = (high - this->Origin[c]) / this->Direction[c];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end;
}
