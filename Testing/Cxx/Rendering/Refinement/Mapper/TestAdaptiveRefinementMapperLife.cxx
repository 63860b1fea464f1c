// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the mapper follows changes between frames: properties, input, recipe, renderers,
// windows and released resources.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"
#include "RelevoTextures.h"

#include "vtkCellArray.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkIdList.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

namespace
{
using namespace RelevoMeshes;

const RelevoTolerance Tight{ 1, 5e-7, 0 };
// As in TestAdaptiveRefinementMapperTwin. A scalar at the border of two colours may get either.
const RelevoTolerance Close{ 3, 2e-6, 30 };

vtkProperty* GetProperty(RelevoScene& scene)
{
  return scene.GetActor(0)->GetProperty();
}

void SetScalars(vtkPolyData* mesh, int factor)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i * factor % 10) * 0.1f);
  }
  mesh->GetPointData()->SetScalars(values);
}

// Sets the input of the scene's first actor, for every kind of mapper.
void SetInput(RelevoScene& scene, vtkPolyData* mesh)
{
  vtkPolyDataMapper::SafeDownCast(scene.GetActor(0)->GetMapper())->SetInputData(mesh);
}

// Changes properties one after the other on the same mapper.
void TestProperties(RelevoComparison& comparison)
{
  comparison.Compare("Life.Properties", Tight,
    [](RelevoScene& s)
    {
      Mesh mesh = Cube();
      SetScalars(mesh, 7);
      s.Add(mesh)->GetMapper()->ScalarVisibilityOff();
    },
    { { "Wireframe", [](RelevoScene& s) { GetProperty(s)->SetRepresentationToWireframe(); } },
      { "Points",
        [](RelevoScene& s)
        {
          GetProperty(s)->SetRepresentationToPoints();
          GetProperty(s)->SetPointSize(9);
        } },
      { "Surface", [](RelevoScene& s) { GetProperty(s)->SetRepresentationToSurface(); } },
      { "Edges", [](RelevoScene& s) { GetProperty(s)->EdgeVisibilityOn(); } },
      { "WideEdges", [](RelevoScene& s) { GetProperty(s)->SetLineWidth(4); } },
      { "Vertices",
        [](RelevoScene& s)
        {
          GetProperty(s)->VertexVisibilityOn();
          s.GetActor(0)->GetMapper()->Modified(); // vtkPolyDataMapper does not detect the change
        } },
      { "Flat",
        [](RelevoScene& s)
        {
          GetProperty(s)->EdgeVisibilityOff();
          // Up to VTK 9.4, vertices are not drawn if edges are off.
          GetProperty(s)->VertexVisibilityOff();
          GetProperty(s)->SetInterpolationToFlat();
        } },
      { "Gouraud", [](RelevoScene& s) { GetProperty(s)->SetInterpolationToGouraud(); } },
      { "Scalars", [](RelevoScene& s) { s.GetActor(0)->GetMapper()->ScalarVisibilityOn(); } },
      { "InterpolatedScalars",
        [](RelevoScene& s) { s.GetActor(0)->GetMapper()->InterpolateScalarsBeforeMappingOn(); } },
      { "NoScalars", [](RelevoScene& s) { s.GetActor(0)->GetMapper()->ScalarVisibilityOff(); } },
      { "Texture",
        [](RelevoScene& s) { s.GetActor(0)->SetTexture(RelevoTextures::MakeMotley()); } },
      { "NoTexture",
        [](RelevoScene& s)
        {
          s.GetActor(0)->SetTexture(nullptr);
          s.GetActor(0)->GetMapper()->Modified(); // vtkPolyDataMapper does not detect the change
        } },
      { "Translucent", [](RelevoScene& s) { GetProperty(s)->SetOpacity(0.5); } },
      { "Peeled", [](RelevoScene& s) { s.Renderer->UseDepthPeelingOn(); } },
      { "Opaque", [](RelevoScene& s) { GetProperty(s)->SetOpacity(1); } },
      { "Clipped",
        [](RelevoScene& s)
        {
          vtkNew<vtkPlane> plane;
          plane->SetNormal(1, 0.5, 0.2);
          s.GetActor(0)->GetMapper()->AddClippingPlane(plane);
        } },
      { "Whole", [](RelevoScene& s) { s.GetActor(0)->GetMapper()->RemoveAllClippingPlanes(); } },
      { "Unlit", [](RelevoScene& s) { GetProperty(s)->LightingOff(); } },
      { "Lit", [](RelevoScene& s) { GetProperty(s)->LightingOn(); } } });
}

void TestInput(RelevoComparison& comparison)
{
  Mesh moving = Sphere(12, 10);
  Mesh sphere = Sphere(8, 6);
  comparison.Compare("Life.Input", Tight, [](RelevoScene& s) { s.Add(Cube()); },
    { { "Sphere", [&](RelevoScene& s) { SetInput(s, moving); } },
      { "MovedPoints",
        [&](RelevoScene&)
        {
          for (vtkIdType i = 0; i < moving->GetNumberOfPoints(); ++i)
          {
            double p[3];
            const double z = 0.1 * (i % 4);
            moving->GetPoint(i, p);
            moving->GetPoints()->SetPoint(i, p[0], 0.8 * p[1], p[2] > 0 ? 0.5 + z : -0.5 - z);
          }
          moving->GetPoints()->Modified();
          moving->Modified();
        } },
      { "NewScalars", [&](RelevoScene&) { SetScalars(moving, 3); } },
      { "ChangedScalars", [&](RelevoScene&) { SetScalars(moving, 7); } },
      { "FewerCells",
        [&](RelevoScene&)
        {
          vtkNew<vtkCellArray> polys;
          vtkNew<vtkIdList> ids;
          for (vtkIdType i = 0; i < moving->GetNumberOfPolys(); i += 2)
          {
            moving->GetCellPoints(i, ids);
            polys->InsertNextCell(ids);
          }
          moving->SetPolys(polys);
        } },
      { "NoNormals", [&](RelevoScene&) { moving->GetPointData()->SetNormals(nullptr); } },
      { "Smaller", [&](RelevoScene& s) { SetInput(s, sphere); } },
      { "Strips", [&](RelevoScene& s) { SetInput(s, Strips()); } },
      { "Cone", [&](RelevoScene& s) { SetInput(s, Cone()); } } });
}

// A recipe and its parts.
struct Parts
{
  Parts()
  {
    this->Heights->FillRandom(20, 20, 1);
    this->Others->FillRandom(33, 14, 2);
    this->Displacement->SetHeightMap(this->Heights);
    this->Displacement->SetScale(0.1);
    this->Recipe->SetMaximumLevel(0);
  }

  // Adds all parts to the recipe.
  void Join()
  {
    this->Recipe->SetMaximumLevel(4);
    this->Recipe->SetSurface(this->Surface);
    this->Recipe->SetDisplacement(this->Displacement);
  }

  void AddTo(RelevoScene& scene)
  {
    Mesh mesh = TexturedSphere(9, 7);
    AddTags(mesh, 3, 4);
    SetScalars(mesh, 3);
    scene.Add(mesh, this->Recipe)->GetProperty()->EdgeVisibilityOff();
  }

  vtkNew<vtkPNTriangleSurface> Surface;
  vtkNew<RelevoHeights> Heights;
  vtkNew<RelevoHeights> Others;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkAdaptiveRefinement> Recipe;
};

void TestRecipe(RelevoComparison& comparison, Parts& parts)
{
  comparison.Compare("Life.Recipe", Close,
    [&](RelevoScene& s)
    {
      Mesh mesh = TexturedSphere(9, 7);
      AddTags(mesh, 3, 5);
      mesh->GetPointData()->GetArray("DepthTag")->SetName("Mine");
      s.Add(mesh, parts.Recipe);
    },
    { { "Level3", [&](RelevoScene&) { parts.Recipe->SetMaximumLevel(3); } },
      { "Surface", [&](RelevoScene&) { parts.Recipe->SetSurface(parts.Surface); } },
      { "Level5", [&](RelevoScene&) { parts.Recipe->SetMaximumLevel(5); } },
      { "Tags", [&](RelevoScene&) { parts.Recipe->SetDepthTagArrayName("Mine"); } },
      { "LinearNormals", [&](RelevoScene&) { parts.Surface->QuadraticNormalsOff(); } },
      { "Displaced", [&](RelevoScene&) { parts.Recipe->SetDisplacement(parts.Displacement); } },
      { "Scale", [&](RelevoScene&) { parts.Displacement->SetScale(0.2); } },
      { "Offset", [&](RelevoScene&) { parts.Displacement->SetOffset(-0.1); } },
      { "Direction", [&](RelevoScene&) { parts.Displacement->SetDirection(0, 1, 1); } },
      { "Normal", [&](RelevoScene&) { parts.Displacement->SetDirectionToNormal(); } },
      { "OtherHeights", [&](RelevoScene&) { parts.Displacement->SetHeightMap(parts.Others); } },
      { "ChangedHeights", [&](RelevoScene&) { parts.Others->FillRandom(20, 40, 5); } },
      { "NoHeights", [&](RelevoScene&) { parts.Displacement->SetHeightMap(nullptr); } },
      { "Heights", [&](RelevoScene&) { parts.Displacement->SetHeightMap(parts.Heights); } },
      { "NoSurface", [&](RelevoScene&) { parts.Recipe->SetSurface(nullptr); } },
      { "NotDisplaced", [&](RelevoScene&) { parts.Recipe->SetDisplacement(nullptr); } },
      { "Coarse", [&](RelevoScene&) { parts.Recipe->SetMaximumLevel(0); } } });
}

// Releases resources between frames: those of the actor and those of the window.
void TestRelease(RelevoComparison& comparison, Parts& parts)
{
  comparison.Compare("Life.Release", Close, [&](RelevoScene& s) { parts.AddTo(s); },
    { { "Again", [](RelevoScene&) {} },
      { "Actor", [](RelevoScene& s) { s.GetActor(0)->ReleaseGraphicsResources(s.Window); } },
      { "Window", [](RelevoScene& s) { s.Window->Finalize(); } },
      { "Resized", [](RelevoScene& s) { s.Window->SetSize(250, 200); } } });
}

// One mapper in two renderers with different cameras and view-dependent levels.
void TestRenderers(RelevoComparison& comparison, vtkRefinementSurface* surface)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(5);
  vtkNew<vtkAdaptiveRefinement> nearby;
  nearby->SetMaximumLevel(5);
  nearby->SetMetric(metric);
  nearby->SetSurface(surface);
  comparison.Compare("Life.Shared", Close,
    [&](RelevoScene& s)
    {
      Mesh mesh = Sphere(9, 7);
      s.Renderer->SetViewport(0, 0, 0.5, 1);
      vtkRenderer* right = s.AddRenderer(0.5, 0, 1, 1);
      vtkActor* first = s.Add(mesh, nearby);
      first->GetProperty()->SetInterpolationToFlat();
      if (s.Kind == RelevoScene::Twin)
      {
        s.Add(right, mesh, nearby)->GetProperty()->SetInterpolationToFlat();
      }
      else
      {
        vtkNew<vtkActor> second;
        second->SetMapper(first->GetMapper());
        second->GetProperty()->SetInterpolationToFlat();
        right->AddActor(second);
      }
    },
    { { "Moved", [](RelevoScene& s) { s.GetRenderers()[1]->GetActiveCamera()->Dolly(1.5); } } });
}

// One mapper in two windows by turns, then without the first window.
void TestWindows(RelevoComparison& comparison, RelevoScene& scene, const RelevoPicture& expected)
{
  {
    RelevoScene second(RelevoScene::Refining);
    second.Renderer->AddActor(scene.GetActor(0));
    second.CopyCameras(scene);
    for (int i = 0; i < 2; ++i)
    {
      second.Render();
      comparison.Compare("Life.SecondWindow", { 0, 0, 0 }, RelevoPicture(second.Window), expected);
      scene.Render();
      comparison.Compare("Life.FirstWindow", { 0, 0, 0 }, RelevoPicture(scene.Window), expected);
    }
    second.Render();
  }
  scene.Render();
  comparison.Compare("Life.LeftWindow", { 0, 0, 0 }, RelevoPicture(scene.Window), expected);
}

// A mapper that outlives its window.
void TestSurvivor(
  RelevoComparison& comparison, Parts& parts, RelevoScene& scene, const RelevoPicture& expected)
{
  vtkSmartPointer<vtkActor> survivor;
  {
    RelevoScene first(RelevoScene::Refining);
    parts.AddTo(first);
    first.CopyCameras(scene);
    first.Render();
    survivor = first.GetActor(0);
  }
  RelevoScene next(RelevoScene::Refining);
  next.Renderer->AddActor(survivor);
  next.CopyCameras(scene);
  next.Render();
  comparison.Compare("Life.NextWindow", { 0, 0, 0 }, RelevoPicture(next.Window), expected);
}

// A mapper that never had a window.
void TestNoWindow()
{
  vtkNew<vtkAdaptiveRefinementMapper> unused;
  unused->ReleaseGraphicsResources(nullptr);
}
}

int TestAdaptiveRefinementMapperLife(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);

  TestProperties(comparison);
  TestInput(comparison);
  Parts parts;
  TestRecipe(comparison, parts);
  parts.Join();
  TestRelease(comparison, parts);
  TestRenderers(comparison, parts.Surface);
  RelevoScene scene(RelevoScene::Refining);
  parts.AddTo(scene);
  scene.ResetCameras();
  scene.Render();
  const RelevoPicture expected(scene.Window);
  TestWindows(comparison, scene, expected);
  TestSurvivor(comparison, parts, scene, expected);
  TestNoWindow();
  return check.GetResult();
}
