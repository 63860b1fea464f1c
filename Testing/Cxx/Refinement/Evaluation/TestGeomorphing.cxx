// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on geomorphing: while a camera moves by at most a pixel per frame, no point of
// the refined surface jumps more than a quarter of a pixel, with both frames seen from one camera.
// Without geomorphing, some points jump further. Levels per edge change faster for edges seen
// end-on; there, jumps must be a fraction of those without geomorphing. The meshes are a sphere, a
// scan and real terrain, with levels from edge lengths on the screen.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDEMReader.h"
#include "vtkDisplacement.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPLYReader.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkQuadricDecimation.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace RelevoMeshes;

namespace
{
constexpr int Width = 400;
constexpr int Height = 300;
constexpr int NumberOfFrames = 12;

using Pixel = std::array<double, 2>;

// Projects points of the world to the screen.
class Viewer
{
public:
  explicit Viewer(vtkCamera* camera)
  {
    this->Matrix->DeepCopy(camera->GetCompositeProjectionTransformMatrix(
      static_cast<double>(Width) / Height, -1.0, 1.0));
  }

  Pixel Project(const double point[3]) const
  {
    const double in[4] = { point[0], point[1], point[2], 1.0 };
    double out[4];
    this->Matrix->MultiplyPoint(in, out);
    return { { 0.5 * Width * out[0] / out[3], 0.5 * Height * out[1] / out[3] } };
  }

private:
  vtkNew<vtkMatrix4x4> Matrix;
};

// Largest motion of a mesh's points on the screen between two cameras.
double GetMotion(vtkPolyData* mesh, vtkCamera* before, vtkCamera* after)
{
  const Viewer from(before);
  const Viewer to(after);
  double motion = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    const Pixel a = from.Project(point);
    const Pixel b = to.Project(point);
    motion = std::max(motion, std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  return motion;
}

// Largest distance of vertices and triangle centres from another surface, in pixels.
double GetDistance(vtkPolyData* mesh, vtkPolyData* surface, vtkCamera* camera)
{
  const Viewer viewer(camera);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double distance = 0.0;
  auto visit = [&](const double point[3])
  {
    double closest[3];
    vtkIdType id;
    int subId;
    double squared;
    locator->FindClosestPoint(point, closest, cell, id, subId, squared);
    const Pixel a = viewer.Project(point);
    const Pixel b = viewer.Project(closest);
    distance = std::max(distance, std::hypot(b[0] - a[0], b[1] - a[1]));
  };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    visit(point);
  }
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    polys->GetCurrentCell(size, ids);
    double corners[3][3];
    double middle[3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids[i], corners[i]);
    }
    vtkTriangle::TriangleCenter(corners[0], corners[1], corners[2], middle);
    visit(middle);
  }
  return distance;
}

// Rotates and approaches by turns. An `amount` of 1 is about one degree.
void Move(vtkCamera* camera, int frame, double amount)
{
  switch (frame % 3)
  {
    case 0:
      camera->Azimuth(amount);
      break;
    case 1:
      camera->Dolly(1.0 + 0.02 * amount);
      break;
    default:
      camera->Azimuth(0.5 * amount);
      camera->Dolly(1.0 + 0.01 * amount);
      break;
  }
  camera->OrthogonalizeViewUp();
}

// Largest jump during a flight, in pixels.
double Fly(RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, vtkCamera* start)
{
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(start);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(mesh);
  filter->SetRefinement(recipe);
  filter->SetCamera(camera);
  filter->SetViewportSize(Width, Height);
  filter->Update();
  Mesh last = Make();
  double jump = 0.0;
  for (int frame = 0; frame < NumberOfFrames; ++frame)
  {
    last->ShallowCopy(filter->GetOutput());
    CHECK_GREATER(last->GetNumberOfCells(), 3 * mesh->GetNumberOfCells());

    vtkNew<vtkCamera> before;
    before->DeepCopy(camera);
    vtkNew<vtkCamera> trial;
    trial->DeepCopy(camera);
    Move(trial, frame, 0.01);
    Move(camera, frame, 0.01 * 0.95 / GetMotion(last, before, trial));
    const double motion = GetMotion(last, before, camera);
    CHECK_GREATER(motion, 0.8);
    CHECK_LESS_EQUAL(motion, 1.0);

    filter->Update();
    vtkPolyData* next = filter->GetOutput();
    jump = std::max({ jump, GetDistance(last, next, before), GetDistance(next, last, before) });
  }
  return jump;
}

void Check(RelevoCheck& check, const char* name, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe,
  vtkCamera* camera)
{
  for (const bool edges : { false, true })
  {
    CHECK_CASE(edges);
    recipe->SetLevelRule(edges ? 1 : 0);
    recipe->GeomorphingOff();
    const double popping = Fly(check, mesh, recipe, camera);
    recipe->GeomorphingOn();
    const double morphing = Fly(check, mesh, recipe, camera);
    std::cout << name << (edges ? ", per edge: " : ", per vertex: ") << morphing << " of a pixel, "
              << popping << " without geomorphing\n";
    CHECK_LESS_EQUAL(morphing, (edges ? 0.25 * popping : 0.25));
    CHECK_GREATER(popping, 0.5);
  }
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(double referenceLength)
{
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  metric->SetReferenceLength(referenceLength);
  vtkSmartPointer<vtkAdaptiveRefinement> recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(5);
  recipe->SetMetric(metric);
  return recipe;
}

void TestSphere(RelevoCheck& check)
{
  Mesh mesh = Sphere(8, 6);
  vtkSmartPointer<vtkAdaptiveRefinement> recipe = MakeRecipe(10.0);
  vtkNew<vtkPNTriangleSurface> surface;
  recipe->SetSurface(surface);
  vtkNew<vtkCamera> camera;
  const double size = mesh->GetLength();
  camera->SetPosition(0.3 * size, -size, 0.4 * size);
  Check(check, "sphere", mesh, recipe, camera);
}

void TestBunny(RelevoCheck& check, const std::string& file)
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputConnection(reader->GetOutputPort());
  decimation->SetTargetReduction(0.995);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(decimation->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  vtkPolyData* mesh = normals->GetOutput();
  CHECK_GREATER(mesh->GetNumberOfCells(), 200);
  vtkSmartPointer<vtkAdaptiveRefinement> recipe = MakeRecipe(10.0);
  vtkNew<vtkPNTriangleSurface> surface;
  recipe->SetSurface(surface);
  vtkNew<vtkCamera> camera;
  double center[3];
  mesh->GetCenter(center);
  const double size = mesh->GetLength();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + 0.3 * size, center[1] + 0.2 * size, center[2] + 1.2 * size);
  Check(check, "bunny", mesh, recipe, camera);
}

void TestTerrain(RelevoCheck& check, const std::string& file)
{
  vtkNew<vtkDEMReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int* dimensions = image->GetDimensions();
  vtkNew<RelevoHeights> heights;
  heights->Fill(dimensions[0], dimensions[1],
    [&](double u, double v)
    {
      return image->GetScalarComponentAsDouble(
        static_cast<int>(u * dimensions[0]), static_cast<int>(v * dimensions[1]), 0, 0);
    });

  vtkNew<vtkPlaneSource> plane;
  const double width = image->GetSpacing()[0] * dimensions[0];
  const double height = image->GetSpacing()[1] * dimensions[1];
  plane->SetPoint1(width, 0.0, 0.0);
  plane->SetPoint2(0.0, height, 0.0);
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetResolution(12, 16);
  plane->Update();
  vtkSmartPointer<vtkAdaptiveRefinement> recipe = MakeRecipe(5.0);
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  displacement->SetDirection(0.0, 0.0, 1.0);
  recipe->SetDisplacement(displacement);
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(0.5 * width, 0.5 * height, 1500.0);
  camera->SetPosition(0.5 * width, -0.4 * height, 6000.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  Check(check, "terrain", plane->GetOutput(), recipe, camera);
}
}

int TestGeomorphing(int, char*[])
{
  RelevoCheck check;
  TestSphere(check);
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string folder = data ? data : "";
  const std::string bunny = folder + "/mesh/bunny.ply";
  const std::string terrain = folder + "/relief/SainteHelens.dem";
  if (!std::ifstream(bunny) || !std::ifstream(terrain))
  {
    std::cerr << "RELEVO_TEST_DATA has no mesh/bunny.ply and relief/SainteHelens.dem: skipped\n";
    return check.GetResult() ? EXIT_FAILURE : 125;
  }
  TestBunny(check, bunny);
  TestTerrain(check, terrain);
  return check.GetResult();
}
