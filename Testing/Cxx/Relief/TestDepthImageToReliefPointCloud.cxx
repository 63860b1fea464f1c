// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that reliefs of z-buffers agree with vtkDepthImageToPointCloud.
#include "Data/Relief.h"
#include "RelevoCheck.h"
#include "RelevoReliefs.h"

#include "vtkCamera.h"
#include "vtkDepthImageToPointCloud.h"
#include "vtkDepthImageToRelief.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace
{
using relevo::dvec3;

// That filter places the outermost pixels at the edges of the view. Its pixel of column i lies at i
// width / (width - 1) - 0.5 in texels, whose centres are where OpenGL samples.
double GetTexel(int pixel, int size)
{
  return static_cast<double>(pixel) * size / (size - 1) - 0.5;
}

void TestPlaces(RelevoCheck& check, vtkCamera* camera, vtkImageData* depths)
{
  vtkNew<vtkDepthImageToPointCloud> cloud;
  cloud->SetInputData(depths);
  cloud->SetCamera(camera);
  cloud->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cloud->Update();
  vtkNew<vtkDepthImageToRelief> filter;
  filter->SetInputData(depths);
  filter->SetCamera(camera);
  filter->Update();
  relevo::Relief relief;
  CHECK(relief.Read(filter->GetOutput()).empty());

  // The output has the points that are not background, in order.
  vtkIdType point = 0;
  for (int row = 0; row < relief.GetHeight(); ++row)
  {
    for (int column = 0; column < relief.GetWidth(); ++column)
    {
      const double height = relief.GetTexelHeight(column, row);
      if (height == height) // not NaN
      {
        dvec3 expected;
        cloud->GetOutput()->GetPoint(point++, &expected.x);
        const dvec3 there = relief.GetWorldPoint(
          GetTexel(column, relief.GetWidth()), GetTexel(row, relief.GetHeight()), height);
        CHECK_LESS(distance(there, expected), 2e-6 * length(expected));
        const dvec3 texel = relief.GetWorldPoint(column, row, height);
        const dvec3 next = relief.GetWorldPoint(column + 1, row + 1, height);
        CHECK_LESS_EQUAL(distance(texel, expected), 0.51 * distance(texel, next));
      }
    }
  }
  CHECK_EQUAL(point, cloud->GetOutput()->GetNumberOfPoints());
  CHECK_EQUAL(point, 32 * 24 - 48);
}
}

int TestDepthImageToReliefPointCloud(int, char*[])
{
  RelevoCheck check;
  const auto depths = RelevoMakeImage(32, 24, VTK_FLOAT,
    [](int column, int row)
    { return row < 2 && column > 7 ? 1.0 : 0.1 + 0.02 * column + 0.01 * row; });
  vtkNew<vtkCamera> camera;
  camera->SetPosition(3.0, -4.0, 5.0);
  camera->SetFocalPoint(0.5, 1.0, 0.0);
  camera->SetClippingRange(2.0, 20.0);
  for (bool isParallel : { false, true })
  {
    CHECK_CASE(isParallel);
    camera->SetParallelProjection(isParallel);
    TestPlaces(check, camera, depths);
  }
  return check.GetResult();
}
