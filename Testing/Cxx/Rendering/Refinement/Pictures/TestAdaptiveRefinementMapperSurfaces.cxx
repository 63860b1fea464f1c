// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves surfaces.md: every surface is drawn as the filter refines it. Live parameters change the
// picture without a rebuild, and your own GLSL functions work.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPhongSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProceduralSurface.h"

#include <cmath>

using namespace RelevoMeshes;

namespace
{
// The tolerance is that of TestAdaptiveRefinementMapperTwin.
const RelevoTolerance Close{ 2, 2e-6, 10 };

// Adds depth-tags, and scalar tags for surfaces that use them.
Mesh AllTagged(Mesh mesh, int level)
{
  AddRandomScalarTags(mesh, 11);
  return Tagged(mesh, level);
}

void testTwins(RelevoComparison& comparison)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(40, 30, 3);
  auto displacement = MakeDisplacement(heights, 0.1);
  const double far[3] = { 5e6, -4e6, 100 };
  for (const auto& surface : RelevoMakeSurfaces())
  {
    const std::string name = "Surfaces." + surface.first;
    comparison.Compare(name + ".Tagged", Close,
      [&](RelevoScene& s) { s.Add(AllTagged(Sphere(9, 7), 5), MakeRecipe(5, surface.second)); });
    comparison.Compare(name + ".Cube", Close,
      [&](RelevoScene& s) { s.Add(AllTagged(Cube(), 5), MakeRecipe(5, surface.second)); });
    comparison.Compare(name + ".Displaced", Close,
      [&](RelevoScene& s)
      { s.Add(AllTagged(TexturedSphere(9, 7), 5), MakeRecipe(5, surface.second, displacement)); });
  }
  for (const auto& surface : RelevoMakeSurfaces(100.0))
  {
    comparison.Compare("Surfaces." + surface.first + ".FarAway", Close,
      [&](RelevoScene& s) {
        s.Add(
          AllTagged(Moved(Sphere(9, 7), 100, far, VTK_DOUBLE), 5), MakeRecipe(5, surface.second));
      });
  }

  vtkNew<vtkPhongSurface> phong;
  phong->SetAlphaArrayName("alpha");
  comparison.Compare("Surfaces.AlphaArray", Close,
    [&](RelevoScene& s)
    {
      Mesh mesh = Tagged(Explode(TexturedSphere(9, 7)), 5);
      vtkNew<vtkFloatArray> alphas;
      alphas->SetName("alpha");
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        alphas->InsertNextValue((i % 7) / 6.0f);
      }
      mesh->GetPointData()->AddArray(alphas);
      s.Add(mesh, MakeRecipe(5, phong));
    });
}

// Draws twice with a change in between, which must be visible and rebuild nothing.
void testLive(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(40, 30, 3);
  auto displacement = MakeDisplacement(heights, 0.05);
  vtkNew<vtkPhongSurface> phong;
  vtkNew<vtkProceduralSurface> fur;
  fur->SetAmplitude(0.05);
  fur->SetBaseSurface(phong);
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "Amplitude", [&]() { fur->SetAmplitude(0.15); } },
    { "Frequency", [&]() { fur->SetFrequency(3.0); } },
    { "Alpha", [&]() { phong->SetAlpha(0.1); } },
    { "Scale", [&]() { displacement->SetScale(0.15); } },
    { "Offset", [&]() { displacement->SetOffset(0.1); } }
  };
  RelevoScene scene(RelevoScene::Refining);
  RelevoScene twin(RelevoScene::Twin);
  for (RelevoScene* s : { &scene, &twin })
  {
    s->Add(Tagged(TexturedSphere(9, 7), 5), MakeRecipe(5, fur, displacement));
    s->ResetCameras();
    s->Renderer->GetActiveCamera()->Zoom(0.7);
    s->Render();
  }
  vtkAdaptiveRefinementMapper* mapper = scene.GetMapper(0);
  const vtkIdType buffers = mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  const vtkIdType selections = mapper->GetNumberOfSelections();
  CHECK_EQUAL(buffers, 1);
  CHECK_EQUAL(shaders, 1);
  for (const auto& change : changes)
  {
    const RelevoPicture before(scene.Window);
    change.second();
    twin.Render();
    scene.CopyCameras(twin);
    scene.Render();
    const RelevoPicture after(scene.Window);
    comparison.Compare(
      std::string("Surfaces.Live.") + change.first, Close, after, RelevoPicture(twin.Window));
    CHECK_NOT_EQUAL(before.Colors, after.Colors);
    CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), buffers);
    CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
    CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);
    double bounds[6];
    double reached[6];
    mapper->GetBounds(bounds);
    twin.GetActor(0)->GetMapper()->GetBounds(reached);
    for (int c = 0; c < 3; ++c)
    {
      CHECK_LESS_EQUAL(bounds[2 * c], reached[2 * c] + 1e-6);
      CHECK_GREATER_EQUAL(bounds[2 * c + 1], reached[2 * c + 1] - 1e-6);
    }
  }
  // Negative control: another base surface requires a rebuild.
  fur->SetBaseSurface(nullptr);
  scene.Render();
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), buffers + 1);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders + 1);
}

// Has the function in GLSL, and in C++ for the filter.
class Waves : public vtkProceduralSurface
{
public:
  static Waves* New();
  vtkTypeMacro(Waves, vtkProceduralSurface);
  double Phase = 0.0;
  bool HasHeightFunction() override { return true; }
  double EvaluateHeight(
    const double position[3], const float normal[3], const float weights[3]) override
  {
    return 0.6 * std::sin(this->Frequency * position[0] + this->Phase) * normal[2] +
      4.0 * weights[0] * weights[1] * weights[2];
  }
  void SetPhase(double phase)
  {
    this->Phase = phase;
    this->SetUniform("phase", phase);
    this->SetUniform("colors", 1.0, 2.0, 3.0); // a uniform that the shader does not use
  }

protected:
  Waves()
  {
    this->SetShaderFunction("uniform float phase;\n"
                            "float proceduralHeight(vec3 position, vec3 normal, vec3 weights)\n"
                            "{\n"
                            "  return 0.6 * sin(relevoFrequency * position.x + phase) * normal.z\n"
                            "    + 4.0 * weights.x * weights.y * weights.z;\n"
                            "}\n");
  }
};
vtkStandardNewMacro(Waves);

void testFunction(RelevoComparison& comparison)
{
  // Differences of heights amplify rounding errors, which affects lighting.
  RelevoTolerance lit = Close;
  lit.Color = 6;
  vtkNew<Waves> waves;
  waves->SetAmplitude(0.2);
  waves->SetFrequency(8.0);
  waves->SetPhase(0.3);
  comparison.Compare("Surfaces.Function", lit,
    [&](RelevoScene& s) { s.Add(Tagged(Sphere(9, 7), 5), MakeRecipe(5, waves)); },
    { { "Phase", [&](RelevoScene&) { waves->SetPhase(1.5); } } });
  // Normals that differ on both sides of each edge open no cracks.
  comparison.Compare("Surfaces.Function.Cube", lit,
    [&](RelevoScene& s) { s.Add(Tagged(Cube(), 5), MakeRecipe(5, waves)); });
}

// Invalid GLSL is reported once and nothing is drawn. The next function works.
void testBadFunction(RelevoCheck& check)
{
  vtkNew<vtkProceduralSurface> surface;
  surface->SetShaderFunction("float proceduralHeight(vec3 p, vec3 n, vec3 w) { return nonsense; }");
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(9, 7), MakeRecipe(2, surface));
  scene.ResetCameras();
  RelevoErrors errors(scene.GetMapper(0));
  scene.Render();
  scene.Render();
  CHECK(errors.Said("ShaderFunction"));
  CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  surface->SetShaderFunction("float proceduralHeight(vec3 p, vec3 n, vec3 w) { return 0.5; }");
  scene.Render();
  CHECK(errors.None());
  CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 1000);
}
}

int TestAdaptiveRefinementMapperSurfaces(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  testTwins(comparison);
  testLive(check, comparison);
  testFunction(comparison);
  testBadFunction(check);
  return check.GetResult();
}
