// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthImageToRelief promises where the texels of a depth image or z-buffer lie, their colours
// and their normals.
#include "Data/Relief.h"
#include "RelevoCheck.h"
#include "RelevoReliefs.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDepthImageToRelief.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
using relevo::dvec3;
using relevo::dvec4;
using relevo::Relief;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkMatrix4x4> MakePose()
{
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, -20.0, 5.0);
  transform->RotateWXYZ(77.0, 1.0, 2.0, -0.5);
  return transform->GetMatrix();
}

// Depths in millimetres, as from depth cameras, with the first row at the top or at the bottom.
void TestPinhole(RelevoCheck& check)
{
  const int width = 5;
  const int height = 4;
  const auto millimetres = [](int column, int row) { return 1500 + 100 * column + 30 * row; };
  for (bool isTurned : { false, true })
  {
    const auto rowFromTop = [=](int row) { return isTurned ? height - 1 - row : row; };
    vtkNew<vtkDepthImageToRelief> filter;
    filter->SetInputData(RelevoMakeImage(width, height, VTK_UNSIGNED_SHORT,
      [&](int column, int row) { return millimetres(column, rowFromTop(row)); }));
    filter->SetDepthScale(0.001);
    filter->SetIntrinsics(6.0, 5.0, 1.75, 1.25);
    filter->SetBottomRowFirst(isTurned);
    const auto pose = MakePose();
    filter->SetPose(pose);
    const Relief relief = RelevoReadRelief(check, filter);
    CHECK(relief.IsPerspective() && relief.GetNumberOfValidTexels() == width * height);
    for (int row = 0; row < height; ++row)
    {
      for (int column = 0; column < width; ++column)
      {
        const double depth = 0.001 * millimetres(column, rowFromTop(row));
        dvec4 place(
          (column - 1.75) * depth / 6.0, (rowFromTop(row) - 1.25) * depth / 5.0, depth, 1.0);
        pose->MultiplyPoint(&place.x, &place.x);
        CHECK_LESS(distance(RelevoGetPoint(relief, column, row), dvec3(place)), 1e-6);
      }
    }
    // A change of the pose takes effect.
    pose->SetElement(0, 3, 1000.0);
    CHECK_GREATER(RelevoGetPoint(RelevoReadRelief(check, filter), 0, 0).x, 900.0);
  }
}

void TestInvalidDepths(RelevoCheck& check)
{
  const double samples[] = { 1.0, 0.0, -2.0, NaN, Infinity, -Infinity, 1e300, 2.0 };
  vtkNew<vtkDepthImageToRelief> filter;
  filter->SetInputData(
    RelevoMakeImage(8, 1, VTK_DOUBLE, [&](int column, int) { return samples[column]; }));
  filter->SetIntrinsics(10.0, 10.0, 3.5, 0.0);
  Relief relief = RelevoReadRelief(check, filter);
  for (int i = 0; i < 8; ++i)
  {
    CHECK_EQUAL(std::isnan(relief.GetDepths()[i]), (i != 0 && i != 7));
  }

  // Missing depths of a z-buffer: 1 is the background, and 0 is at the near plane.
  const double values[] = { 0.0, 0.5, -0.1, NaN, 1.0, 1.1, Infinity, 0.25 };
  vtkNew<vtkCamera> camera;
  for (bool isParallel : { false, true })
  {
    CHECK_CASE(isParallel);
    camera->SetParallelProjection(isParallel);
    filter->SetInputData(
      RelevoMakeImage(8, 1, VTK_FLOAT, [&](int column, int) { return values[column]; }));
    filter->SetCamera(camera);
    relief = RelevoReadRelief(check, filter);
    for (int i = 0; i < 8; ++i)
    {
      CHECK_EQUAL(std::isnan(relief.GetDepths()[i]), (i != 0 && i != 1 && i != 7));
    }
  }
}

// Points that the camera's matrices project to pixel centres are reconstructed.
void TestZBuffer(RelevoCheck& check)
{
  const int width = 7;
  const int height = 5;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(3.0, -4.0, 5.0);
  camera->SetFocalPoint(0.5, 1.0, 0.0);
  camera->SetClippingRange(2.0, 20.0);
  camera->SetParallelScale(2.0);
  for (int kind = 0; kind < 6; ++kind)
  {
    camera->SetParallelProjection(kind % 2);
    camera->SetWindowCenter(kind / 2 == 1 ? 0.3 : 0.0, 0.0);
    camera->SetViewShear(kind / 2 == 2 ? 0.2 : 0.0, 0.1, 1.0);
    const auto z = [](int column, int row) { return 0.05 + 0.1 * column + 0.03 * row; };
    vtkNew<vtkDepthImageToRelief> filter;
    filter->SetInputData(RelevoMakeImage(width, height, VTK_DOUBLE, z));
    filter->SetCamera(camera);
    const Relief relief = RelevoReadRelief(check, filter);
    CHECK_EQUAL(relief.IsPerspective(), (kind % 2 == 0));
    CHECK(relief.IsPerspective() || relief.GetDepthRange().x == 0.0);
    vtkMatrix4x4* project =
      camera->GetCompositeProjectionTransformMatrix(static_cast<double>(width) / height, 0.0, 1.0);
    for (int row = 0; row < height; ++row)
    {
      for (int column = 0; column < width; ++column)
      {
        dvec4 view(RelevoGetPoint(relief, column, row), 1.0);
        project->MultiplyPoint(&view.x, &view.x);
        const dvec3 expected(
          (2.0 * column + 1.0) / width - 1.0, (2.0 * row + 1.0) / height - 1.0, z(column, row));
        CHECK_LESS(distance(dvec3(view) / view.w, expected), 1e-6);
      }
    }
    // Depths are measured along the camera's axis.
    const double difference = relief.GetDepths()[8] - relief.GetDepths()[0];
    dvec3 axis;
    camera->GetDirectionOfProjection(&axis.x);
    CHECK_NEAR(
      difference, dot(axis, RelevoGetPoint(relief, 1, 1) - RelevoGetPoint(relief, 0, 0)), 1e-5);
  }
}

void TestColors(RelevoCheck& check)
{
  const auto depth = [](int column, int) { return 1.0 + column; };
  vtkNew<vtkDepthImageToRelief> filter;
  filter->SetInputData(RelevoMakeImage(3, 2, VTK_FLOAT, depth));
  filter->SetIntrinsics(3.0, 3.0, 1.0, 0.5);
  Relief relief = RelevoReadRelief(check, filter);
  const auto color = [&](int texel, int component)
  { return relief.GetColors()[texel * relief.GetNumberOfColorComponents() + component]; };
  CHECK_EQUAL(color(0, 0), 255);
  CHECK_EQUAL(color(1, 1), 159);
  CHECK_EQUAL(color(2, 2), 64); // nearer is lighter

  struct Kind
  {
    int Type;
    double White;
  };
  for (const Kind& kind : { Kind{ VTK_UNSIGNED_CHAR, 255.0 }, Kind{ VTK_UNSIGNED_SHORT, 65535.0 },
         Kind{ VTK_FLOAT, 1.0 }, Kind{ VTK_DOUBLE, 1.0 } })
  {
    for (int components = 1; components <= 4; ++components)
    {
      const auto image = RelevoMakeImage(3, 2, kind.Type, depth, components);
      for (int k = 0; k < components; ++k)
      {
        image->GetPointData()->GetScalars()->SetComponent(4, k, kind.White * (k + 1) / 5.0);
      }
      filter->SetInputData(1, image);
      relief = RelevoReadRelief(check, filter);
      CHECK_EQUAL(relief.GetNumberOfColorComponents(), (components % 2 == 0 ? 4 : 3));
      for (int k = 0; k < relief.GetNumberOfColorComponents(); ++k)
      {
        CHECK_EQUAL(color(4, k), 51 * (components < 3 ? k / 3 + 1 : k + 1));
      }
    }
  }

  // The picture of a renderer may have the z-buffer as a second array.
  const auto picture = RelevoMakeImage(
    3, 2, VTK_UNSIGNED_CHAR, [](int, int) { return 7.0; }, 3);
  vtkNew<vtkFloatArray> buffer;
  buffer->SetName("ZBuffer");
  buffer->SetNumberOfTuples(6);
  buffer->Fill(0.5);
  picture->GetPointData()->AddArray(buffer);
  filter->SetInputData(picture);
  filter->SetInputConnection(1, nullptr);
  filter->SetCamera(vtkNew<vtkCamera>());
  relief = RelevoReadRelief(check, filter);
  CHECK_EQUAL(color(5, 0), 7);
  CHECK_EQUAL(relief.GetNumberOfColorComponents(), 3);
  CHECK_EQUAL(relief.GetNumberOfValidTexels(), 6);
}

// Normals of a plane are exact in every projection and face the viewer.
void TestNormals(RelevoCheck& check)
{
  const dvec3 normal = normalize(dvec3(0.3, -0.4, -1.0));
  const double fx = 20.0;
  const double fy = 15.0;
  vtkNew<vtkDepthImageToRelief> filter;
  filter->SetInputData(RelevoMakeImage(9, 8, VTK_DOUBLE,
    [&](int column, int row)
    {
      const dvec3 way((column - 4.0) / fx, (row - 3.0) / fy, 1.0);
      return column == 2 && row == 2 ? 0.0 : -5.0 / dot(normal, way);
    }));
  filter->SetIntrinsics(fx, fy, 4.0, 3.0);
  Relief relief = RelevoReadRelief(check, filter);
  for (vtkIdType i = 0; i < relief.GetNumberOfTexels(); ++i)
  {
    const float* n = relief.GetNormals() + 3 * i;
    CHECK_LESS(distance(dvec3(n[0], n[1], n[2]), i == 20 ? dvec3(0.0) : normal), 1e-4);
  }

  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetClippingRange(1.0, 101.0);
  camera->SetParallelProjection(true);
  filter->SetCamera(camera);
  filter->SetInputData(
    RelevoMakeImage(9, 8, VTK_DOUBLE, [](int column, int) { return 0.4 + 0.001 * column; }));
  relief = RelevoReadRelief(check, filter);
  const dvec3 along = RelevoGetPoint(relief, 8, 0) - RelevoGetPoint(relief, 0, 0);
  for (vtkIdType i = 0; i < relief.GetNumberOfTexels(); ++i)
  {
    const dvec3 n(
      relief.GetNormals()[3 * i], relief.GetNormals()[3 * i + 1], relief.GetNormals()[3 * i + 2]);
    CHECK_LESS(std::abs(dot(n, along)), 1e-4);
    CHECK_GREATER(n.z, 0.5);
    CHECK_NEAR(length(n), 1.0, 1e-6);
  }
  filter->ComputeNormalsOff();
  CHECK(!RelevoReadRelief(check, filter).GetNormals());
}

// One row, one column, one texel, and extents that do not start at 0.
void TestSizes(RelevoCheck& check)
{
  const int sizes[][2] = { { 1, 6 }, { 6, 1 }, { 1, 1 } };
  vtkNew<vtkDepthImageToRelief> filter;
  filter->SetIntrinsics(3.0, 3.0, 0.0, 0.0);
  for (const auto& size : sizes)
  {
    const auto image = RelevoMakeImage(
      size[0], size[1], VTK_INT, [](int column, int row) { return 2 + column + row; });
    image->SetExtent(5, 4 + size[0], -3, size[1] - 4, 9, 9);
    filter->SetInputData(image);
    const Relief relief = RelevoReadRelief(check, filter);
    CHECK(relief.GetWidth() == size[0] && relief.GetHeight() == size[1]);
    CHECK(relief.GetImage()->GetExtent()[0] == 0 && relief.GetImage()->GetExtent()[4] == 0);
    CHECK_EQUAL(relief.GetTexelHeight(size[0] - 1, size[1] - 1), 1.0 / (size[0] + size[1]));
  }
}
}

int TestDepthImageToRelief(int, char*[])
{
  RelevoCheck check;
  TestPinhole(check);
  TestInvalidDepths(check);
  TestZBuffer(check);
  TestColors(check);
  TestNormals(check);
  TestSizes(check);
  return check.GetResult();
}
