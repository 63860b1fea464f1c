// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that hostile meshes, fields, settings and cameras in random order never crash, and that a
// scene drawn again looks the same.
#include "RelevoDice.h"
#include "RelevoLICVectors.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using namespace RelevoMeshes;

using Dice = RelevoDice;

// Meshes that are degenerate, collinear, far away or tiny, without normals, or with lines and
// vertices.
Mesh MakeMesh(Dice& dice)
{
  Mesh meshes[] = { Sphere(6, 5), Plane(3, 2), Cube(), Cone(), Strips(), Mixed(), NonManifold(),
    Moebius(), Slivers(), Torus(5, 4), Explode(Sphere(5, 4)),
    FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 1, 0 } } },
      { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 1, 3 } } }),
    Make() };
  Mesh mesh = meshes[dice.Throw(13)];
  const double scales[] = { 1.0, 1.0, 1.0, 1e9, 1e-9 };
  const double offset[3] = { dice.Throw(4) ? 0.0 : 1e5, 0, 0 };
  const double scale = scales[dice.Throw(5)];
  mesh = Moved(mesh, scale, offset, dice.Throw(2) ? VTK_DOUBLE : VTK_FLOAT);
  if (dice.Throw(4) == 0)
  {
    mesh->GetPointData()->SetNormals(nullptr);
  }
  if (dice.Throw(8) == 0 && mesh->GetNumberOfPoints() > 3)
  {
    mesh->GetPoints()->SetPoint(1, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  }
  return mesh;
}

void AddField(Dice& dice, vtkPolyData* mesh)
{
  const double marks[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -1e9, 1e20, 0.0, 1e300, -1e-300 };
  const double lengths[] = { 1.0, 1.0, 1e7, 1e-12, 1e-300, 0.0 };
  const bool ofCells = dice.Throw(3) == 0;
  const int components = dice.Throw(10) ? 2 + dice.Throw(2) : dice.Throw(5) + 1;
  const double length = lengths[dice.Throw(6)];
  vtkNew<vtkDoubleArray> field;
  field->SetName(dice.Throw(10) ? "Flow" : nullptr);
  field->SetNumberOfComponents(components);
  field->SetNumberOfTuples(ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < field->GetNumberOfValues(); ++i)
  {
    field->SetValue(i, dice.Throw(12) ? length * dice.Signed() : marks[dice.Throw(7)]);
  }
  vtkDataSetAttributes* data = mesh->GetPointData();
  if (ofCells)
  {
    data = mesh->GetCellData();
  }
  data->AddArray(field);
  if (components == 3)
  {
    data->SetVectors(field);
  }
}

void ChangeSettings(Dice& dice, vtkAdaptiveLICMapper* mapper)
{
  mapper->SetNumberOfSteps(1 + dice.Throw(6));
  mapper->SetStepSize(std::pow(10.0, 3.0 * dice.Signed()));
  mapper->SetNormalizeVectors(dice.Throw(2));
  mapper->SetEnhancedLIC(dice.Throw(2));
  mapper->SetOrientedLIC(dice.Throw(2));
  mapper->SetPhase(100.0 * dice.Signed());
  const int contrasts[] = { 0, 1, 3, 4 };
  mapper->SetEnhanceContrast(contrasts[dice.Throw(4)]);
  mapper->SetLowLICContrastEnhancementFactor(dice.Share());
  mapper->SetHighColorContrastEnhancementFactor(dice.Share());
  mapper->SetAntiAlias(dice.Throw(3));
  mapper->SetMaskThreshold(dice.Throw(2) ? dice.Signed() : -1.0);
  mapper->SetMaskOnSurface(dice.Throw(2));
  mapper->SetMaskIntensity(dice.Share());
  mapper->GetLICInterface()->SetColorMode(dice.Throw(2));
  mapper->SetLICIntensity(dice.Share());
  mapper->SetMapModeBias(dice.Signed());
  mapper->SetNoiseType(dice.Throw(3));
  mapper->SetNoiseTextureSize(1 + dice.Throw(40));
  mapper->SetNoDataMagnitude(std::pow(10.0, 20.0 * dice.Share()));
  mapper->SetEnable(dice.Throw(6) != 0);
  if (dice.Throw(3) == 0)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(dice.Signed(), dice.Signed(), 1.0);
    mapper->RemoveAllClippingPlanes();
    mapper->AddClippingPlane(plane);
  }
}

void ChangeScene(Dice& dice, RelevoScene& scene, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  const double scales[] = { 1.0, 1.0, -1.0, 1e-3, 0.0 };
  property->SetOpacity(dice.Throw(3) ? 1.0 : dice.Share());
  property->SetRepresentation(dice.Throw(6) ? VTK_SURFACE : dice.Throw(3));
  property->SetInterpolation(dice.Throw(3));
  property->SetEdgeVisibility(dice.Throw(4) == 0);
  property->SetBackfaceCulling(dice.Throw(4) == 0);
  property->SetLighting(dice.Throw(3) != 0);
  actor->SetScale(1.0, scales[dice.Throw(5)], 1.0);
  actor->RotateX(90.0 * dice.Signed());
  scene.Renderer->SetUseDepthPeeling(dice.Throw(2));
  const int sizes[] = { 1, 17, 40, 64 };
  scene.Window->SetSize(sizes[dice.Throw(4)], sizes[dice.Throw(4)]);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelProjection(dice.Throw(2));
  scene.Renderer->ResetCamera();
  camera->Zoom(std::pow(10.0, dice.Signed()));
  if (dice.Throw(3) == 0)
  {
    camera->Dolly(5.0); // inside
    scene.Renderer->ResetCameraClippingRange();
  }
}
}

int TestAdaptiveLICMapperRandom(int argc, char* argv[])
{
  RelevoCheck check;
  unsigned int first = 0;
  unsigned int last = 40;
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "--seed") // repeats one scene
    {
      first = static_cast<unsigned int>(std::atoi(argv[i + 1]));
      last = first + 1;
    }
  }
  RelevoScene::NewMapper = [](vtkDataObject*) -> vtkAdaptiveRefinementMapper*
  { return vtkAdaptiveLICMapper::New(); };
  vtkIdType convolutions = 0;
  for (unsigned int seed = first; seed < last; ++seed)
  {
    Dice dice(seed);
    RelevoScene scene(RelevoScene::Refining);
    scene.Window->OffScreenRenderingOn();
    vtkSmartPointer<vtkDataObject> input;
    vtkNew<vtkMultiBlockDataSet> blocks;
    const int count = 1 + dice.Throw(3);
    for (int i = 0; i < count; ++i)
    {
      Mesh mesh = MakeMesh(dice);
      AddField(dice, mesh);
      blocks->SetBlock(static_cast<unsigned int>(2 * i), mesh);
      input = mesh;
    }
    if (count > 1)
    {
      input = blocks;
    }
    vtkNew<vtkPNTriangleSurface> surface;
    vtkActor* actor =
      scene.Add(input, MakeRecipe(dice.Throw(4), dice.Throw(2) ? surface.Get() : nullptr));
    vtkAdaptiveLICMapper* mapper = RelevoLICVectors::GetMapper(actor);
    RelevoErrors errors(mapper);
    mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS,
      dice.Throw(8) ? "Flow" : "Other");
    for (int step = 0; step < 4; ++step)
    {
      ChangeSettings(dice, mapper);
      ChangeScene(dice, scene, actor);
      scene.Render();
      const RelevoPicture once(scene.Window);
      scene.Render();
      const RelevoPicture again(scene.Window);
      if (once.Colors != again.Colors)
      {
        check.Fail(__FILE__, __LINE__,
          "seed " + std::to_string(seed) + ", step " + std::to_string(step) +
            ": another picture of the same scene");
      }
    }
    convolutions += mapper->GetNumberOfConvolutions();
  }
  std::cout << convolutions << " convolutions" << std::endl;
  CHECK(last == first + 1 || convolutions > 60);
  return check.GetResult();
}
