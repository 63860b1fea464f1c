// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises points on the captured mesh, and the colours of a window of the
// capture's size.
#include "RelevoCaptureScene.h"

#include "vtkCellLocator.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;
// OpenGL rounds triangle corners to 1/256 of a pixel. On small and steep triangles the effect is
// slightly larger.
constexpr double SubPixel = 0.01;

struct View
{
  const char* Name;
  std::function<void(vtkCamera*)> Set;
};

const View Views[] = {
  { "perspective", [](vtkCamera*) {} },
  { "wide, near",
    [](vtkCamera* camera)
    {
      camera->SetViewAngle(90.0);
      camera->Dolly(2.0);
    } },
  { "horizontal angle", [](vtkCamera* camera) { camera->UseHorizontalViewAngleOn(); } },
  { "off the middle", [](vtkCamera* camera) { camera->SetWindowCenter(0.3, -0.2); } },
  { "sheared", [](vtkCamera* camera) { camera->SetViewShear(0.2, -0.1, 1.0); } },
  { "parallel", [](vtkCamera* camera) { camera->ParallelProjectionOn(); } },
  { "parallel, off the middle",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetWindowCenter(-0.2, 0.4);
    } },
  { "oblique",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetObliqueAngles(60.0, 50.0);
    } },
};

// Returns nullptr if the data are not available.
vtkSmartPointer<vtkPolyData> ReadCow()
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  vtkNew<vtkXMLPolyDataReader> reader;
  const std::string name = std::string(data ? data : "") + "/mesh/cow.vtp";
  if (!reader->CanReadFile(name.c_str()))
  {
    return nullptr;
  }
  reader->SetFileName(name.c_str());
  vtkNew<vtkTriangleFilter> triangles; // its polygons may not be plane
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

// Largest distance of a texel from the mesh, in texel widths.
double FindDistance(const std::vector<RelevoTexel>& texels, vtkPolyData* mesh)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  double farthest = 0.0;
  for (const RelevoTexel& texel : texels)
  {
    double closest[3];
    double squared = 0.0;
    vtkIdType cell = -1;
    int part = 0;
    locator->FindClosestPoint(texel.Point.data(), closest, cell, part, squared);
    farthest = std::max(farthest, std::sqrt(squared) / texel.Width);
  }
  return farthest;
}

// Differences in colour between texels and pixels. Pixels that are covered in only one of both are
// counted separately.
struct Difference
{
  int Largest = 0;
  size_t Shapes = 0;
};

Difference CompareColors(const std::vector<RelevoTexel>& texels, const RelevoPicture& picture)
{
  Difference difference;
  std::vector<bool> isShown(picture.GetNumberOfPixels(), false);
  for (const RelevoTexel& texel : texels)
  {
    const size_t at = static_cast<size_t>(texel.Row) * picture.Size[0] + texel.Column;
    isShown[at] = true;
    for (int i = 0; i < 3; ++i)
    {
      const int apart = std::abs(texel.Color[i] - picture.Colors[3 * at + i]);
      difference.Largest = std::max(difference.Largest, apart);
    }
  }
  for (size_t i = 0; i < isShown.size(); ++i)
  {
    difference.Shapes += isShown[i] == (picture.Depths[i] < 1.0f) ? 0 : 1;
  }
  return difference;
}

// Compares texels with the world coordinates of their centres, computed from the renderer in double
// precision.
void TestPlaces(RelevoCheck& check, vtkCamera* camera, const std::vector<RelevoTexel>& texels)
{
  const double aspect = static_cast<double>(Width) / Height;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
  double farthest = 0.0;
  for (const RelevoTexel& texel : texels)
  {
    const double point[4] = { texel.Point[0], texel.Point[1], texel.Point[2], 1.0 };
    double clip[4];
    matrix->MultiplyPoint(point, clip);
    const double column = (clip[0] / clip[3] + 1.0) * 0.5 * Width - 0.5;
    const double row = (clip[1] / clip[3] + 1.0) * 0.5 * Height - 0.5;
    farthest = std::max(farthest, std::hypot(column - texel.Column, row - texel.Row));
  }
  CHECK_LESS(farthest, 1e-6);
}

void TestMesh(RelevoCheck& check, vtkPolyData* mesh, const char* meshName)
{
  for (const View& view : Views)
  {
    CHECK_CASE(view.Name);
    RelevoCaptureScene scene;
    scene.Add(mesh);
    scene.ResetCamera();
    vtkNew<vtkCamera> camera;
    camera->DeepCopy(scene.GetCamera());
    view.Set(camera);
    scene.Source->AddCamera(camera);
    vtkImageData* relief = scene.Capture();
    if (!CHECK_NOT_EQUAL(relief, nullptr))
    {
      continue;
    }
    const std::vector<RelevoTexel> texels = RelevoReadTexels(relief);
    const double distance = FindDistance(texels, mesh);
    const RelevoPicture picture = scene.Draw(camera, Width, Height);
    const Difference difference = CompareColors(texels, picture);
    std::cout << meshName << ", " << view.Name << ": " << texels.size() << " texels, " << distance
              << " texels off, colours differ by " << difference.Largest << ", shapes by "
              << difference.Shapes << "\n";
    CHECK_GREATER(texels.size(), 500);
    CHECK_LESS(distance, SubPixel);
    CHECK_EQUAL(difference.Largest, 0);
    CHECK_EQUAL(difference.Shapes, 0);
    TestPlaces(check, camera, texels);
  }
}

// A headlight is at the capture's camera.
void TestHeadlight(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Renderer->RemoveAllLights();
  scene.Add(RelevoBumpyBall());
  scene.ResetCamera();
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(scene.GetCamera());
  camera->Azimuth(80.0);
  scene.Source->AddCamera(camera);
  const std::vector<RelevoTexel> texels = RelevoReadTexels(scene.Capture());
  CHECK_EQUAL(scene.Renderer->GetLights()->GetNumberOfItems(), 0);
  CHECK_EQUAL(CompareColors(texels, scene.Draw(camera, Width, Height)).Largest, 0);
}
}

int TestReliefCapture(int, char*[])
{
  RelevoCheck check;
  TestMesh(check, RelevoBumpyBall(), "ball");
  if (vtkSmartPointer<vtkPolyData> cow = ReadCow())
  {
    TestMesh(check, cow, "cow");
  }
  TestHeadlight(check);
  return check.GetResult();
}
