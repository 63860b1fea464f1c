// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves flow.md: vtkAdaptiveLICMapper convolves again exactly when the view, the data or a setting
// changes. A repeated picture is the same, bit for bit.
#include "RelevoSurfaceFields.h"

#include "vtkAdaptiveLICMapper.h"
#include "vtkDataArray.h"
#include "vtkDisplacement.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <iostream>

namespace
{
struct Scene : public RelevoLICScene
{
  Scene()
    : RelevoLICScene(120, 100)
  {
    using namespace RelevoMeshes;
    const auto fields = MakeSurfaceFields(NormalOfTorus);
    this->Mesh = WithField(Torus(), fields[1].Field);
    this->Mesh->GetPointData()->GetNormals()->SetName("Normals");
    vtkNew<vtkFloatArray> other;
    other->SetName("Other");
    FillVectors(this->Mesh, fields[2].Field, other);
    this->Mesh->GetPointData()->AddArray(other);
    this->Heights->FillWaves();
    this->Displacement->SetHeightMap(this->Heights);
    this->Displacement->SetScale(0.05);
    this->Metric->SetArrayName("Flow");
    vtkNew<vtkPNTriangleSurface> surface;
    this->Recipe = MakeRecipe(3, surface, this->Displacement);
    this->Recipe->SetMetric(this->Metric);
    this->Mapper = this->Add(this->Mesh, this->Recipe);
    this->Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Flow");
    this->Mapper->SetLICIntensity(0.8);
    this->Mapper->SetMaskIntensity(0.0);
    this->Actor->GetProperty()->LightingOn();
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Elevation(-40.0);
  }

  std::size_t CountDifferences(const RelevoPicture& a, const RelevoPicture& b) const
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.Colors.size() && a.Colors.size() == b.Colors.size(); ++i)
    {
      count += a.Colors[i] != b.Colors[i] ? 1 : 0;
    }
    return a.Colors.size() == b.Colors.size() ? count : a.Colors.size();
  }

  RelevoMeshes::Mesh Mesh;
  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkFieldVariationDepthTagMetric> Metric;
  vtkSmartPointer<vtkAdaptiveRefinement> Recipe;
  vtkAdaptiveLICMapper* Mapper = nullptr;
};

struct Change
{
  std::string Name;
  std::function<void(Scene&)> Make;
};

// Each of these changes the picture.
std::vector<Change> MakeChangesOfLIC()
{
  using M = vtkAdaptiveLICMapper;
  return {
    { "camera", [](Scene& s) { s.Renderer->GetActiveCamera()->Azimuth(1.0); } },
    { "parallel projection",
      [](Scene& s) { s.Renderer->GetActiveCamera()->ParallelProjectionOn(); } },
    { "actor's place", [](Scene& s) { s.Actor->SetPosition(0.1, 0.0, 0.0); } },
    { "actor's scale", [](Scene& s) { s.Actor->SetScale(1.1, 0.9, 1.0); } },
    { "window's size", [](Scene& s) { s.Window->SetSize(130, 100); } },
    { "viewport", [](Scene& s) { s.Renderer->SetViewport(0.1, 0.0, 0.9, 1.0); } },
    { "steps", [](Scene& s) { s.Mapper->SetNumberOfSteps(9); } },
    { "step size", [](Scene& s) { s.Mapper->SetStepSize(1.5); } },
    { "normalisation", [](Scene& s) { s.Mapper->NormalizeVectorsOff(); } },
    { "second pass", [](Scene& s) { s.Mapper->EnhancedLICOff(); } },
    { "orientation", [](Scene& s) { s.Mapper->OrientedLICOn(); } },
    { "phase", [](Scene& s) { s.Mapper->SetPhase(0.4); } },
    { "anti-aliasing", [](Scene& s) { s.Mapper->SetAntiAlias(1); } },
    { "contrast", [](Scene& s) { s.Mapper->SetEnhanceContrastToLIC(); } },
    { "share cut off",
      [](Scene& s)
      {
        s.Mapper->SetEnhanceContrastToLIC();
        s.Mapper->SetLowLICContrastEnhancementFactor(0.2);
      } },
    { "threshold", [](Scene& s) { s.Mapper->SetMaskThreshold(0.8); } },
    { "threshold on the surface",
      [](Scene& s)
      {
        s.Mapper->SetMaskThreshold(0.8);
        s.Mapper->MaskOnSurfaceOn();
      } },
    { "no-data", [](Scene& s) { s.Mapper->SetNoDataMagnitude(0.7); } },
    { "array",
      [](Scene& s) {
        s.Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
      } },
    { "vectors",
      [](Scene& s)
      {
        vtkDataArray* flow = s.Mesh->GetPointData()->GetVectors();
        for (vtkIdType i = 0; i < flow->GetNumberOfTuples(); ++i)
        {
          flow->SetComponent(i, 2, 1.0);
        }
        flow->Modified();
      } },
    { "points",
      [](Scene& s)
      {
        double p[3];
        s.Mesh->GetPoint(3, p);
        s.Mesh->GetPoints()->SetPoint(3, 1.1 * p[0], 1.1 * p[1], p[2]);
        s.Mesh->GetPoints()->Modified();
      } },
    { "input",
      [](Scene& s)
      {
        s.Mapper->SetInputDataObject(
          WithField(RelevoMeshes::Torus(20, 12), MakeSurfaceFields(NormalOfTorus)[1].Field));
      } },
    { "displacement", [](Scene& s) { s.Displacement->SetScale(0.07); } },
    { "heights", [](Scene& s) { s.Heights->FillRandom(16, 16, 3); } },
    { "metric", [](Scene& s) { s.Metric->SetMaximumVariation(0.9); } },
    { "level", [](Scene& s) { s.Recipe->SetMaximumLevel(1); } },
    { "surface", [](Scene& s) { s.Recipe->SetSurface(nullptr); } },
    { "clipping plane",
      [](Scene& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0, 0.0, 0.0);
        s.Mapper->AddClippingPlane(plane);
      } },
    { "noise's seed", [](Scene& s) { s.Mapper->SetNoiseGeneratorSeed(5); } },
    { "noise's type", [](Scene& s) { s.Mapper->SetNoiseType(M::NOISE_TYPE_PERLIN); } },
    { "noise's image", [](Scene& s) { s.Mapper->SetNoiseDataSet(MakeNoiseImage(50, 60)); } },
    { "front faces culled", [](Scene& s) { s.Actor->GetProperty()->FrontfaceCullingOn(); } },
  };
}

std::vector<Change> MakeChangesOfColors()
{
  return {
    { "colour", [](Scene& s) { s.Actor->GetProperty()->SetColor(0.3, 0.9, 0.4); } },
    { "opacity", [](Scene& s) { s.Actor->GetProperty()->SetOpacity(0.4); } },
    { "specular light", [](Scene& s) { s.Actor->GetProperty()->SetSpecular(0.7); } },
    { "LIC's share", [](Scene& s) { s.Mapper->SetLICIntensity(0.5); } },
    { "multiplication", [](Scene& s) { s.Mapper->SetColorModeToMultiply(); } },
    { "bias",
      [](Scene& s)
      {
        s.Mapper->SetColorModeToMultiply();
        s.Mapper->SetMapModeBias(0.3);
      } },
    { "light",
      [](Scene& s)
      {
        vtkNew<vtkLight> light;
        light->SetPosition(-3.0, 2.0, 1.0);
        s.Renderer->AddLight(light);
      } },
    { "background", [](Scene& s) { s.Renderer->SetBackground(0.9, 0.9, 0.5); } },
    { "neighbour",
      [](Scene& s)
      {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(RelevoMeshes::Sphere(20, 20));
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        s.Renderer->AddActor(actor);
      } },
    { "shown again",
      [](Scene& s)
      {
        s.Actor->VisibilityOff();
        s.Window->Render();
        s.Actor->VisibilityOn();
        s.Actor->GetProperty()->SetDiffuse(0.5);
      } },
  };
}

void Test(RelevoCheck& check, const Change& change, vtkIdType expected)
{
  std::cout << change.Name << "\n";
  Scene scene;
  scene.Window->Render();
  const RelevoPicture before(scene.Window);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1);
  change.Make(scene);
  scene.Window->Render();
  const RelevoPicture after(scene.Window);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1 + expected);
  CHECK_GREATER(scene.CountDifferences(before, after), 100);
  for (int i = 0; i < 3; ++i)
  {
    scene.Window->Render();
    CHECK_EQUAL(scene.CountDifferences(after, RelevoPicture(scene.Window)), 0);
  }
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1 + expected);
}

// Masked regions have a separate colour.
void TestMaskColor(RelevoCheck& check)
{
  Scene scene;
  scene.Mapper->SetMaskThreshold(0.8);
  scene.Window->Render();
  const RelevoPicture before(scene.Window);
  scene.Mapper->SetMaskIntensity(0.6);
  scene.Window->Render();
  const RelevoPicture mixed(scene.Window);
  scene.Mapper->SetMaskColor(0.0, 1.0, 0.0);
  scene.Window->Render();
  CHECK_GREATER(scene.CountDifferences(before, mixed), 100);
  CHECK_GREATER(scene.CountDifferences(mixed, RelevoPicture(scene.Window)), 100);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1);
}

// An image of noise that changes, and a plane that moves.
void TestModified(RelevoCheck& check)
{
  Scene scene;
  const auto noise = MakeNoiseImage(40, 40);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->SetNoiseDataSet(noise);
  scene.Mapper->AddClippingPlane(plane);
  scene.Window->Render();
  const RelevoPicture first(scene.Window);
  noise->ShallowCopy(MakeNoiseImage(40, 40, 9));
  scene.Window->Render();
  const RelevoPicture second(scene.Window);
  CHECK_GREATER(scene.CountDifferences(first, second), 100);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 2);
  plane->SetOrigin(0.3, 0.0, 0.0);
  scene.Window->Render();
  CHECK_GREATER(scene.CountDifferences(second, RelevoPicture(scene.Window)), 100);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 3);
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Window->Render();
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 4);
}

// Colours by scalars.
void TestLookupTable(RelevoCheck& check)
{
  Scene scene;
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < scene.Mesh->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(scene.Mesh->GetPoint(i)[0]));
  }
  scene.Mesh->GetPointData()->SetScalars(scalars);
  vtkNew<vtkLookupTable> table;
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetScalarRange(-1.5, 1.5);
  scene.Mapper->ScalarVisibilityOn();
  scene.Window->Render();
  const RelevoPicture before(scene.Window);
  table->SetHueRange(0.1, 0.3);
  table->ForceBuild();
  scene.Window->Render();
  CHECK_GREATER(scene.CountDifferences(before, RelevoPicture(scene.Window)), 100);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1);
}

// A triangle budget finds its levels over several frames and then stays.
void TestBudget(RelevoCheck& check)
{
  Scene scene;
  scene.Mapper->SetTargetNumberOfTriangles(800);
  for (int i = 0; i < 10; ++i)
  {
    scene.Window->Render();
  }
  const RelevoPicture first(scene.Window);
  CHECK_LESS_EQUAL(scene.Mapper->GetNumberOfDrawnTriangles(), 800);
  const vtkIdType convolutions = scene.Mapper->GetNumberOfConvolutions();
  CHECK_LESS_EQUAL(convolutions, 4);
  for (int i = 0; i < 3; ++i)
  {
    scene.Window->Render();
    CHECK_EQUAL(scene.CountDifferences(first, RelevoPicture(scene.Window)), 0);
  }
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), convolutions);
}

// The range of lightness is computed again without a convolution.
void TestColorRange(RelevoCheck& check)
{
  Scene scene;
  scene.Mapper->SetEnhanceContrastToColor();
  scene.Window->Render();
  const RelevoPicture first(scene.Window);
  scene.Actor->GetProperty()->SetColor(0.8, 0.3, 0.2);
  scene.Window->Render();
  CHECK_GREATER(scene.CountDifferences(first, RelevoPicture(scene.Window)), 100);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1);
}
}

int TestAdaptiveLICMapperKept(int, char*[])
{
  RelevoCheck check;
  for (const Change& change : MakeChangesOfLIC())
  {
    Test(check, change, 1);
  }
  for (const Change& change : MakeChangesOfColors())
  {
    Test(check, change, 0);
  }
  TestMaskColor(check);
  TestModified(check);
  TestLookupTable(check);
  TestBudget(check);
  TestColorRange(check);
  return check.GetResult();
}
