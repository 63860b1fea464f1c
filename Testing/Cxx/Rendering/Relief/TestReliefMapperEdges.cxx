// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefMapper promises captures of parts with sharp edges without cracks, compared with the
// picture of the part.
#include "RelevoCaptureScene.h"
#include "RelevoCheck.h"

#include "vtkCubeSource.h"
#include "vtkDataObject.h"
#include "vtkLight.h"
#include "vtkLinearExtrusionFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkReliefMapper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace
{
// With a normal for each face.
vtkSmartPointer<vtkPolyData> Split(vtkAlgorithm* source, double angle)
{
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(angle, 1.0, 2.0, 3.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetTransform(turn);
  turned->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(turned->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(triangles->GetOutputPort());
  normals->SplittingOn();
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeCube(double angle)
{
  vtkNew<vtkCubeSource> cube;
  return Split(cube, angle);
}

// An angle bracket.
vtkSmartPointer<vtkPolyData> MakeBracket()
{
  const double corners[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 0.4 }, { 0.4, 0.4 }, { 0.4, 1.5 },
    { 0, 1.5 } };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(6);
  for (int i = 0; i < 6; ++i)
  {
    cells->InsertCellPoint(points->InsertNextPoint(corners[i][0], corners[i][1], 0.0));
  }
  vtkNew<vtkPolyData> profile;
  profile->SetPoints(points);
  profile->SetPolys(cells);
  vtkNew<vtkLinearExtrusionFilter> extrusion;
  extrusion->SetInputData(profile);
  extrusion->SetExtrusionTypeToVectorExtrusion();
  extrusion->SetVector(0.0, 0.0, 1.2);
  return Split(extrusion, 0.0);
}

struct Differences
{
  int Wrong = 0;   // another colour
  int Missing = 0; // shows the background in place of the part
  int Beyond = 0;  // shows the part in place of the background
};

Differences Compare(const RelevoPicture& part, const RelevoPicture& reliefs)
{
  Differences found;
  for (size_t i = 0; i < part.GetNumberOfPixels(); ++i)
  {
    const bool isPart = part.Depths[i] < 1.0f;
    const bool isRelief = reliefs.Depths[i] < 1.0f;
    int apart = 0;
    for (size_t j = 3 * i; j < 3 * i + 3; ++j)
    {
      apart = std::max(apart, std::abs(int(part.Colors[j]) - int(reliefs.Colors[j])));
    }
    found.Missing += isPart && !isRelief;
    found.Beyond += isRelief && !isPart;
    found.Wrong += isPart && isRelief && apart > 30;
  }
  return found;
}

class EdgeScene : public RelevoCaptureScene
{
public:
  explicit EdgeScene(vtkPolyData* mesh)
    : RelevoCaptureScene(300, 240)
    , Part(this->Add(mesh))
  {
    vtkNew<vtkLight> other;
    other->SetLightTypeToSceneLight();
    other->SetPosition(-2.0, 3.0, -4.0);
    other->SetIntensity(0.5);
    this->Renderer->AddLight(other);
    this->Part->GetProperty()->SetAmbient(0.2);
    this->Reliefs->SetMapper(this->Mapper);
  }

  void Capture(int size)
  {
    this->Source->SetResolution(size);
    this->Source->Update();
    this->Mapper->SetInputDataObject(this->Source->GetOutput());
    this->Renderer->AddActor(this->Reliefs);
  }

  // Sums four views.
  Differences Draw()
  {
    Differences sum;
    for (const auto& angles : { Angles{ 30, 20 }, Angles{ -40, 35 }, Angles{ 60, -30 } })
    {
      this->Part->VisibilityOn();
      this->Reliefs->VisibilityOff();
      this->ResetCamera();
      this->GetCamera()->Azimuth(angles.first - 35.0);
      this->GetCamera()->Elevation(angles.second - 25.0);
      this->Renderer->ResetCameraClippingRange();
      this->Window->Render();
      const RelevoPicture part(this->Window);
      this->Part->VisibilityOff();
      this->Reliefs->VisibilityOn();
      this->Window->Render();
      const Differences found = Compare(part, RelevoPicture(this->Window));
      sum.Wrong += found.Wrong;
      sum.Missing += found.Missing;
      sum.Beyond += found.Beyond;
    }
    return sum;
  }

  vtkActor* Part;
  vtkNew<vtkReliefMapper> Mapper;
  vtkNew<vtkActor> Reliefs;

private:
  using Angles = std::pair<double, double>;
};

void TestPart(RelevoCheck& check, const char* name, vtkPolyData* mesh, bool isPerspective)
{
  EdgeScene scene(mesh);
  if (isPerspective)
  {
    for (int i = 0; i < 6; ++i)
    {
      scene.ResetCamera();
      vtkNew<vtkCamera> camera;
      camera->DeepCopy(scene.GetCamera());
      camera->Azimuth(i < 4 ? 90.0 * i + 10.0 : 20.0);
      camera->Elevation(i < 4 ? -20.0 : i == 4 ? 55.0 : -110.0);
      scene.Source->AddCamera(camera);
    }
  }
  scene.Capture(160);
  for (int method : { vtkReliefMapper::METHOD_RAY_MARCH, vtkReliefMapper::METHOD_REFINEMENT })
  {
    scene.Mapper->SetMethod(method);
    scene.Mapper->FillCracksOff();
    const Differences before = scene.Draw();
    const vtkTypeInt64 memory = scene.Mapper->GetGraphicsMemorySize();
    scene.Mapper->FillCracksOn();
    const Differences after = scene.Draw();
    std::cout << name << ", method " << method << ": wrong " << before.Wrong << ", missing "
              << before.Missing << ", beyond " << before.Beyond << "; filled " << after.Wrong
              << ", " << after.Missing << ", " << after.Beyond << "; memory "
              << scene.Mapper->GetGraphicsMemorySize() / double(memory) << "\n";
    CHECK_GREATER(before.Wrong, 100); // negative control: the test detects cracks
    CHECK_LESS(after.Wrong, 0.3 * before.Wrong);
    CHECK_LESS(after.Missing, 0.6 * before.Missing);
    CHECK_LESS_EQUAL(after.Beyond, 100);
    CHECK_LESS(scene.Mapper->GetGraphicsMemorySize(), 1.8 * memory);
  }
}
}

int TestReliefMapperEdges(int, char*[])
{
  RelevoCheck check;
  TestPart(check, "cube", MakeCube(0.0), false);
  TestPart(check, "turned cube", MakeCube(17.0), false);
  TestPart(check, "bracket", MakeBracket(), false);
  TestPart(check, "cube in perspective", MakeCube(0.0), true);
  return check.GetResult();
}
