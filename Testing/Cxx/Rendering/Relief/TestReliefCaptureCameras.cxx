// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises cameras around the visible props, far from the origin, and inside them,
// and cropped reliefs.
#include "RelevoCaptureScene.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"

#include <cmath>
#include <iostream>

namespace
{
using namespace RelevoVectors;

vtkImageData* GetRelief(RelevoCaptureScene& scene, unsigned int block)
{
  return vtkImageData::SafeDownCast(scene.Source->GetOutput()->GetBlock(block));
}

// Largest distance of the mesh's points from the texels of all blocks. Takes every tenth texel.
double FindGap(RelevoCaptureScene& scene, vtkPolyData* mesh, const Vector& offset)
{
  std::vector<Vector> points;
  for (unsigned int i = 0; i < scene.Source->GetOutput()->GetNumberOfBlocks(); ++i)
  {
    for (const RelevoTexel& texel : RelevoReadTexels(GetRelief(scene, i)))
    {
      points.push_back(texel.Point);
    }
  }
  double gap = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 10)
  {
    Vector x;
    mesh->GetPoint(i, x.data());
    double nearest = VTK_DOUBLE_MAX;
    for (const Vector& point : points)
    {
      const Vector apart = point - offset - x;
      nearest = std::min(nearest, dot(apart, apart));
    }
    gap = std::max(gap, std::sqrt(nearest));
  }
  return gap;
}

// The direction in which a relief's depths increase.
Vector GetDirection(vtkImageData* relief)
{
  vtkDataArray* m = relief->GetFieldData()->GetArray("ReliefMatrix");
  Vector direction;
  for (int row = 0; row < 3; ++row)
  {
    direction[row] = m->GetVariantValue(4 * row + 2).ToDouble();
  }
  return direction;
}

void TestBox(RelevoCheck& check, const Vector& offset)
{
  RelevoCaptureScene scene;
  scene.Source->SetResolution(128);
  CHECK_EQUAL(scene.Source->GetNumberOfCameras(), 6);
  const vtkSmartPointer<vtkPolyData> ball = RelevoBumpyBall();
  scene.Add(ball)->SetPosition(offset[0], offset[1], offset[2]);
  scene.ResetCamera();
  scene.Source->Update();
  CHECK_EQUAL(scene.Source->GetOutput()->GetNumberOfBlocks(), 6);
  for (unsigned int i = 0; i < 6; ++i)
  {
    vtkImageData* relief = GetRelief(scene, i);
    CHECK(relief->GetDimensions()[0] == 128 && relief->GetDimensions()[1] == 128);
    Vector expected{};
    expected[i / 2] = i % 2 ? -1.0 : 1.0;
    const Vector apart = GetDirection(relief) - expected;
    CHECK_LESS(std::sqrt(dot(apart, apart)), 1e-9);
    double range[2];
    relief->GetPointData()->GetArray("Depth")->GetRange(range);
    CHECK(range[0] > 0.0 && range[0] < 0.1 && range[1] < 2.5);
  }
  // The ball is about 2.3 wide and a texel 0.018. Except for dents, one of the six cameras sees
  // each point.
  const double gap = FindGap(scene, ball, offset);
  std::cout << "box: largest distance of a point " << gap << " from the nearest texel\n";
  CHECK_LESS(gap, 0.04);
}

// Four of the six cameras see a flat mesh edge-on, if at all.
void TestFlat(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Source->SetResolution(64);
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  scene.Add(plane->GetOutput());
  RelevoErrors errors(scene.Source);
  scene.Source->Update();
  CHECK(errors.None());
  CHECK_EQUAL(scene.Source->GetOutput()->GetNumberOfBlocks(), 6);
  for (unsigned int i = 0; i < 6; ++i)
  {
    vtkImageData* relief = GetRelief(scene, i);
    const size_t number = relief ? RelevoReadTexels(relief).size() : 0;
    CHECK(i < 4 ? number <= 64 : number > 60 * 60);
  }
}

// Directions of the sphere's cameras: the requested number, all different, evenly distributed.
void TestSphere(RelevoCheck& check)
{
  const int numbers[] = { 12, 42, 162, 642 };
  RelevoCaptureScene scene;
  scene.Source->SetResolution(16);
  scene.Add(RelevoBumpyBall(20));
  scene.ResetCamera();
  for (int level = 0; level < 3; ++level)
  {
    scene.Source->SetCamerasToSphere(level);
    CHECK_EQUAL(scene.Source->GetNumberOfCameras(), numbers[level]);
    scene.Source->Update();
    const unsigned int number = scene.Source->GetOutput()->GetNumberOfBlocks();
    CHECK_EQUAL(static_cast<int>(number), numbers[level]);
    std::vector<Vector> directions;
    Vector sum{};
    for (unsigned int i = 0; i < number; ++i)
    {
      CHECK_GREATER(RelevoReadTexels(GetRelief(scene, i)).size(), 40);
      directions.push_back(GetDirection(GetRelief(scene, i)));
      sum = sum + directions.back();
    }
    CHECK_LESS(std::sqrt(dot(sum, sum)), 1e-9);
    double closest = -1.0;
    for (unsigned int i = 0; i < number; ++i)
    {
      CHECK_NEAR(dot(directions[i], directions[i]), 1.0, 1e-9);
      for (unsigned int j = 0; j < i; ++j)
      {
        closest = std::max(closest, dot(directions[i], directions[j]));
      }
    }
    // Neighbouring points of an icosahedron are 63.4 degrees apart, and about half of that after
    // each subdivision.
    CHECK_GREATER(std::acos(closest), 0.95 / (1 << level) / 1.2);
  }
  RelevoErrors errors(scene.Source);
  scene.Source->SetCamerasToSphere(4);
  CHECK(errors.Said("CamerasToSphere must be in [0, 3]"));
  CHECK_EQUAL(scene.Source->GetNumberOfCameras(), 162);
  scene.Source->SetCamerasToSphere(3);
  CHECK_EQUAL(scene.Source->GetNumberOfCameras(), 642);
}

// Far from the origin, camera and matrix are accurate to double precision.
void TestFar(RelevoCheck& check, bool parallel)
{
  const Vector offset{ { 1e6, -2e6, 5e5 } };
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall())->SetPosition(offset[0], offset[1], offset[2]);
  scene.ResetCamera();
  scene.GetCamera()->SetParallelProjection(parallel);
  scene.Source->AddCamera(scene.GetCamera());
  const std::vector<RelevoTexel> far = RelevoReadTexels(scene.Capture());
  RelevoCaptureScene same;
  same.Add(RelevoBumpyBall());
  same.ResetCamera();
  same.GetCamera()->SetParallelProjection(parallel);
  same.Source->AddCamera(same.GetCamera());
  const std::vector<RelevoTexel> near = RelevoReadTexels(same.Capture());
  CHECK_GREATER(far.size(), 2000);
  double largest = 0.0;
  size_t others = 0;
  for (size_t i = 0, j = 0; i < far.size() && j < near.size(); ++i, ++j)
  {
    // At a silhouette, either of both may have an additional texel.
    const int at = 160 * far[i].Row + far[i].Column;
    while (j < near.size() && 160 * near[j].Row + near[j].Column < at)
    {
      ++j, ++others;
    }
    if (j < near.size() && near[j].Row == far[i].Row && near[j].Column == far[i].Column)
    {
      const Vector apart = far[i].Point - offset - near[j].Point;
      largest = std::max(largest, std::sqrt(dot(apart, apart)));
    }
  }
  std::cout << "far from the origin: error " << largest << ", " << others << " texels differ\n";
  CHECK_LESS(others, 5);
  CHECK_LESS(largest, 0.01);
}

// The near plane is in front of the eye, and the surface surrounds it.
void TestInside(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall());
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.1, 0.2, 0.1);
  camera->SetFocalPoint(1.0, 0.3, 0.2);
  camera->SetViewAngle(70.0);
  scene.Source->AddCamera(camera);
  const std::vector<RelevoTexel> texels = RelevoReadTexels(scene.Capture());
  CHECK_EQUAL(texels.size(), 160u * 120u);
  for (const RelevoTexel& texel : texels)
  {
    const double radius = std::sqrt(dot(texel.Point, texel.Point));
    CHECK_GREATER(radius, 0.84);
    CHECK_LESS(radius, 1.16);
  }
}

void TestCropping(RelevoCheck& check)
{
  for (bool parallel : { false, true })
  {
    CHECK_CASE(parallel);
    RelevoCaptureScene scene;
    scene.Add(RelevoBumpyBall());
    scene.ResetCamera();
    scene.GetCamera()->SetParallelProjection(parallel);
    scene.GetCamera()->SetWindowCenter(0.2, -0.1);
    scene.Source->AddCamera(scene.GetCamera());
    const std::vector<RelevoTexel> whole = RelevoReadTexels(scene.Capture());
    scene.Source->CroppingOn();
    vtkImageData* relief = scene.Capture();
    const std::vector<RelevoTexel> part = RelevoReadTexels(relief);
    CHECK(relief->GetDimensions()[0] < 100 && relief->GetDimensions()[1] < 100);
    CHECK_EQUAL(whole.size(), part.size());
    int right = 0;
    int top = 0;
    double largest = 0.0;
    for (size_t i = 0; i < part.size(); ++i)
    {
      const Vector apart = whole[i].Point - part[i].Point;
      largest = std::max(largest, dot(apart, apart));
      CHECK(std::equal(whole[i].Color, whole[i].Color + 3, part[i].Color));
      right = std::max(right, part[i].Column);
      top = std::max(top, part[i].Row);
    }
    CHECK_LESS(largest, 1e-20);
    CHECK_EQUAL(part[0].Row, 0);
    CHECK(right + 1 == relief->GetDimensions()[0] && top + 1 == relief->GetDimensions()[1]);
  }
}

void TestThin(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall());
  scene.ResetCamera();
  scene.Source->AddCamera(scene.GetCamera());
  scene.Source->SetResolution(1, 90);
  vtkImageData* relief = scene.Capture();
  CHECK(relief->GetDimensions()[0] == 1 && relief->GetDimensions()[1] == 90);
  CHECK_GREATER(RelevoReadTexels(relief).size(), 20);
  scene.GetCamera()->SetViewAngle(2.0);
  scene.Source->SetResolution(90, 1);
  CHECK_GREATER(RelevoReadTexels(scene.Capture()).size(), 1);
}
}

int TestReliefCaptureCameras(int, char*[])
{
  RelevoCheck check;
  TestBox(check, Vector{ { 0.0, 0.0, 0.0 } });
  TestBox(check, Vector{ { 1e6, -2e6, 5e5 } });
  TestFlat(check);
  TestSphere(check);
  TestFar(check, false);
  TestFar(check, true);
  TestInside(check);
  TestCropping(check);
  TestThin(check);
  return check.GetResult();
}
