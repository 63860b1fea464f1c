// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises normals, compared with those of the mesh, also for meshes without
// normals.
#include "RelevoCaptureScene.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCellLocator.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkReverseSense.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using namespace RelevoVectors;

double GetAngle(const Vector& a, const Vector& b)
{
  return vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(a.data(), b.data()));
}

Vector GetNormal(vtkCell* triangle)
{
  Vector corners[3];
  for (int i = 0; i < 3; ++i)
  {
    triangle->GetPoints()->GetPoint(i, corners[i].data());
  }
  return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

// Sorted angles between the texels' normals and those of the mesh in world coordinates: point
// normals, interpolated and then transformed, or normals of the triangles on the viewer's side.
std::vector<double> Compare(const std::vector<RelevoTexel>& texels, vtkPolyData* mesh,
  vtkCamera* camera, vtkDataArray* normals = nullptr, vtkLinearTransform* transform = nullptr)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  normals = normals ? normals : mesh->GetPointData()->GetNormals();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> angles;
  for (const RelevoTexel& texel : texels)
  {
    double closest[3];
    double squared = 0.0;
    vtkIdType id = -1;
    int part = 0;
    locator->FindClosestPoint(texel.Point.data(), closest, cell, id, part, squared);
    double parametric[3];
    double weights[3];
    cell->EvaluatePosition(closest, nullptr, part, parametric, squared, weights);
    Vector expected{};
    if (normals)
    {
      for (int i = 0; i < 3; ++i)
      {
        Vector normal;
        normals->GetTuple(cell->GetPointId(i), normal.data());
        expected = expected + weights[i] * normal;
      }
    }
    else
    {
      expected = GetNormal(cell);
    }
    if (transform)
    {
      transform->TransformNormal(expected.data(), expected.data());
    }
    Vector eye;
    camera->GetPosition(eye.data());
    if (dot(GetNormal(cell), eye - texel.Point) < 0.0)
    {
      expected = -1.0 * expected;
    }
    angles.push_back(GetAngle(texel.Normal, expected));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

std::vector<double> CompareMesh(
  RelevoCheck& check, const char* name, vtkPolyData* mesh,
  const std::function<void(vtkActor*)>& set = [](vtkActor*) {})
{
  RelevoCaptureScene scene;
  set(scene.Add(mesh));
  scene.ResetCamera();
  scene.Source->SetResolution(640, 480);
  scene.Source->AddCamera(scene.GetCamera());
  const std::vector<RelevoTexel> texels = RelevoReadTexels(scene.Capture());
  CHECK_GREATER(texels.size(), 2000);
  for (const RelevoTexel& texel : texels)
  {
    if (!(std::abs(dot(texel.Normal, texel.Normal) - 1.0) < 1e-5))
    {
      check.Fail(__FILE__, __LINE__, std::string(name) + ": a normal does not have length 1");
      break;
    }
  }
  const std::vector<double> angles = Compare(texels, mesh, scene.GetCamera());
  std::cout << name << ": 99 % within " << angles[angles.size() * 99 / 100]
            << " degrees, all within " << angles.back() << "\n";
  return angles;
}

vtkSmartPointer<vtkPolyData> Reverse(vtkPolyData* mesh)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(mesh);
  reverse->Update();
  return reverse->GetOutput();
}

// At a silhouette, the closest point may be on the back.
bool IsSmooth(const std::vector<double>& angles)
{
  return angles[angles.size() * 99 / 100] < 0.01 &&
    std::all_of(
      angles.begin(), angles.end(), [](double angle) { return angle < 0.05 || angle > 179.95; });
}

// At edges, the closest triangle may be the neighbour.
bool IsFlat(const std::vector<double>& angles)
{
  return angles[angles.size() * 98 / 100] < 0.05;
}

void TestMeshes(RelevoCheck& check)
{
  const vtkSmartPointer<vtkPolyData> smooth = RelevoBumpyBall();
  CHECK(IsSmooth(CompareMesh(check, "smooth", smooth)));
  CHECK(IsSmooth(CompareMesh(check, "smooth, reversed", Reverse(smooth))));
  vtkNew<vtkPolyData> flat;
  flat->CopyStructure(smooth);
  CHECK(IsFlat(CompareMesh(check, "flat", flat)));
  CHECK(IsFlat(CompareMesh(check, "flat, reversed", Reverse(flat))));
  CHECK(IsFlat(CompareMesh(check, "shaded flat", flat,
    [](vtkActor* actor) { actor->GetProperty()->SetInterpolationToFlat(); })));
}

// With a matrix that stretches and rotates, normals are those after the transform.
void TestStretched(RelevoCheck& check)
{
  vtkNew<vtkTransform> transform;
  transform->RotateZ(40.0);
  transform->Scale(1.0, 0.7, 1.5);
  const vtkSmartPointer<vtkPolyData> ball = RelevoBumpyBall();
  vtkNew<vtkTransformFilter> moved;
  moved->SetTransform(transform);
  moved->SetInputData(ball);
  moved->Update();
  RelevoCaptureScene scene;
  scene.Add(ball)->SetUserTransform(transform);
  scene.ResetCamera();
  scene.Source->AddCamera(scene.GetCamera());
  const std::vector<RelevoTexel> texels = RelevoReadTexels(scene.Capture());
  const std::vector<double> angles = Compare(texels, moved->GetPolyDataOutput(), scene.GetCamera(),
    ball->GetPointData()->GetNormals(), transform);
  CHECK_GREATER(texels.size(), 1500);
  CHECK(IsSmooth(angles));
}

// Unlit shaders have no normals, so they are computed from depths.
void TestFallback(RelevoCheck& check)
{
  vtkNew<vtkPolyData> flat;
  flat->CopyStructure(RelevoBumpyBall(8));
  const std::vector<double> angles =
    CompareMesh(check, "unlit", flat, [](vtkActor* actor) { actor->GetProperty()->LightingOff(); });
  CHECK_LESS(angles[angles.size() * 70 / 100], 0.1);
  CHECK_LESS(angles[angles.size() * 98 / 100], 40.0);
}

// With refinement on the GPU, a coarse ball becomes round.
void TestRefined(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  vtkNew<vtkPNTriangleSurface> surface;
  recipe->SetSurface(surface);
  recipe->SetMaximumLevel(4);
  RelevoCaptureScene scene;
  vtkActor* actor = scene.Add(RelevoBumpyBall(16));
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetRefinement(recipe);
  mapper->SetInputDataObject(actor->GetMapper()->GetInputDataObject(0, 0));
  actor->SetMapper(mapper);
  scene.ResetCamera();
  scene.Source->AddCamera(scene.GetCamera());
  const std::vector<RelevoTexel> texels = RelevoReadTexels(scene.Capture());
  CHECK_GREATER(texels.size(), 2000);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(recipe);
  filter->SetInputDataObject(mapper->GetInputDataObject(0, 0));
  filter->Update();
  auto* refined = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  CHECK_GREATER(refined->GetNumberOfCells(), 10000);
  const std::vector<double> angles = Compare(texels, refined, scene.GetCamera());
  std::cout << "refined: all within " << angles.back() << "\n";
  CHECK_LESS(angles[angles.size() * 99 / 100], 0.5);
}

void TestWithout(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall());
  scene.ResetCamera();
  scene.Source->AddCamera(scene.GetCamera());
  const vtkSmartPointer<vtkImageData> with = scene.Capture();
  const std::vector<RelevoTexel> texels = RelevoReadTexels(with);
  scene.Source->CaptureNormalsOff();
  vtkImageData* without = scene.Capture();
  CHECK_NOT_EQUAL(with->GetPointData()->GetArray("Normals"), nullptr);
  CHECK_EQUAL(without->GetPointData()->GetArray("Normals"), nullptr);
  const std::vector<RelevoTexel> same = RelevoReadTexels(without);
  CHECK(same.size() == texels.size() && same[1000].Point == texels[1000].Point);
}
}

int TestReliefCaptureNormals(int, char*[])
{
  RelevoCheck check;
  TestMeshes(check);
  TestStretched(check);
  TestFallback(check);
  TestRefined(check);
  TestWithout(check);
  return check.GetResult();
}
