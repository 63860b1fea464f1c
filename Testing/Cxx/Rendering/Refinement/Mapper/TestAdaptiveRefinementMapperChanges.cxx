// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that after a change the mapper draws the same as a new mapper: nothing removed remains. A
// failed step is retried only after a change.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkDepthTagMetric.h"
#include "vtkG1Surface.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkProceduralSurface.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include "Metrics/MetricShader.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

constexpr const char* GoodFunction =
  "float proceduralHeight(vec3 p, vec3 n, vec3 w) { return 0.5; }";
constexpr const char* BadFunction =
  "float proceduralHeight(vec3 p, vec3 n, vec3 w) { return nonsense; }";

// Collects the errors of an object, all of which a test must expect.
class Errors
{
public:
  explicit Errors(vtkObject* object)
    : Object(object)
    , Tags{ object->AddObserver(vtkCommand::ErrorEvent, this, &Errors::Take),
      object->AddObserver(vtkCommand::WarningEvent, this, &Errors::Take) }
  {
  }
  ~Errors()
  {
    this->Object->RemoveObserver(this->Tags[0]);
    this->Object->RemoveObserver(this->Tags[1]);
  }
  Errors(const Errors&) = delete;
  void operator=(const Errors&) = delete;

  // Whether exactly these errors were reported in this order. Clears them.
  bool Were(const std::vector<std::string>& words)
  {
    bool found = this->Texts.size() == words.size();
    for (size_t i = 0; found && i < words.size(); ++i)
    {
      found = this->Texts[i].find(words[i]) != std::string::npos;
    }
    for (const std::string& text : found ? std::vector<std::string>() : this->Texts)
    {
      std::cerr << text;
    }
    this->Texts.clear();
    return found;
  }

private:
  void Take(vtkObject*, unsigned long, void* text)
  {
    const std::string said = static_cast<const char*>(text);
    // VTK 9.6 reports this additional error.
    if (said.find("Could not set shader program") == std::string::npos)
    {
      this->Texts.push_back(said);
    }
  }
  vtkObject* Object;
  unsigned long Tags[2];
  std::vector<std::string> Texts;
};

RelevoPicture Draw(RelevoScene& scene)
{
  scene.Render();
  return RelevoPicture(scene.Window);
}

// The picture of a new mapper.
RelevoPicture DrawAnew(RelevoScene& scene, const RelevoComparison::Builder& build)
{
  RelevoScene other(RelevoScene::Refining);
  build(other);
  other.CopyCameras(scene);
  return Draw(other);
}

// When a displacement is removed, its holes and its memory are released.
void TestDisplacement(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillWavesWithHoles();
  auto displacement = MakeDisplacement(heights, 0.1);
  auto recipe = MakeRecipe(3, nullptr, displacement);
  RelevoScene scene(RelevoScene::Refining);
  const Mesh mesh = Plane(4, 4);
  scene.Add(mesh, recipe);
  scene.ResetCameras();
  Errors errors(scene.GetMapper(0));
  const RelevoPicture displaced = Draw(scene);
  const vtkTypeInt64 memory = scene.GetMapper(0)->GetGraphicsMemorySize();
  recipe->SetDisplacement(nullptr);
  const RelevoPicture flat = Draw(scene);
  CHECK_GREATER(flat.CountForeground(), displaced.CountForeground());
  CHECK_EQUAL(
    flat.Colors, DrawAnew(scene, [&](RelevoScene& s) { s.Add(mesh, MakeRecipe(3)); }).Colors);
  int size[2];
  heights->GetDimensions(size);
  CHECK_GREATER_EQUAL(memory - scene.GetMapper(0)->GetGraphicsMemorySize(), size[0] * size[1] * 5);
  recipe->SetDisplacement(displacement);
  CHECK_EQUAL(Draw(scene).Colors, displaced.Colors);
  CHECK(errors.Were({}));
}

// DMR has no memory for so many triangles, so ARKFPI is used until there are fewer. Without a valid
// shader it draws none here, because that would take too long.
void TestRoom(RelevoCheck& check)
{
  vtkNew<vtkProceduralSurface> surface;
  surface->SetShaderFunction(BadFunction);
  const Mesh mesh = Plane(160, 160);
  auto recipe = MakeRecipe(7, surface);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, recipe);
  scene.ResetCameras();
  Mapper* mapper = scene.GetMapper(0);
  mapper->SetMethodToDMR();
  Errors errors(mapper);
  scene.Render();
  CHECK(errors.Were({ "The method DMR cannot be used: there is not enough graphics memory",
    "could not be built" }));
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARKFPI);
  scene.Render();
  recipe->SetLevelOffset(0.5); // not sufficient
  scene.Render();
  CHECK(errors.Were({}));
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARKFPI);

  // With fewer triangles DMR is used again, and with another method nothing is reported.
  surface->SetShaderFunction(GoodFunction);
  recipe->SetLevelOffset(0.0);
  recipe->SetMaximumLevel(1);
  CHECK_GREATER(Draw(scene).CountForeground(), 1000);
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_DMR);
  surface->SetShaderFunction(BadFunction);
  recipe->SetMaximumLevel(7);
  scene.Render();
  CHECK(errors.Were({ "not enough graphics memory", "could not be built" }));
  mapper->SetMethodToARKFPI();
  surface->SetShaderFunction(GoodFunction);
  recipe->SetMaximumLevel(1);
  CHECK_GREATER(Draw(scene).CountForeground(), 1000);
  CHECK(errors.Were({}));
}

// Each change that breaks the shaders is reported, and nothing is drawn with older shaders.
void TestBroken(RelevoCheck& check, RelevoScene& scene, const std::function<void()>& breakThem,
  const std::function<void()>& mend)
{
  Errors errors(scene.GetMapper(0));
  mend();
  const RelevoPicture expected = Draw(scene);
  CHECK_GREATER(expected.CountForeground(), 1000);
  for (int i = 0; i < 2; ++i)
  {
    breakThem();
    for (int frame = 0; frame < 3; ++frame)
    {
      CHECK_EQUAL(Draw(scene).CountForeground(), 0);
    }
    CHECK(errors.Were({ "vtkShaderProperty" }));
    mend();
    CHECK_EQUAL(Draw(scene).Colors, expected.Colors);
    CHECK(errors.Were({}));
  }
}

void TestShaders(RelevoCheck& check)
{
  vtkNew<vtkProceduralSurface> surface;
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(9, 7), MakeRecipe(2, surface));
  scene.ResetCameras();
  TestBroken(
    check, scene, [&] { surface->SetShaderFunction(BadFunction); },
    [&] { surface->SetShaderFunction(GoodFunction); });

  vtkShaderProperty* shaders = scene.GetActor(0)->GetShaderProperty();
  const std::string place = "//VTK::PositionVC::Impl";
  TestBroken(
    check, scene,
    [&] { shaders->AddVertexShaderReplacement(place, true, place + "\nnonsense;\n", false); },
    [&] { shaders->AddVertexShaderReplacement(place, true, place + "\n", false); });
}

// A colour function is sampled once per level.
void TestColors(RelevoCheck& check)
{
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(0.0, 0.0, 0.0, 1.0);
  function->AddRGBPoint(2.0, 1.0, 1.0, 0.0);
  function->AddRGBPoint(4.0, 1.0, 0.0, 0.0);
  auto recipe = MakeRecipe(1);
  const Mesh mesh = Plane(6, 5);
  AddTags(mesh, 1, 4);
  const auto build = [&](RelevoScene& scene)
  {
    scene.Add(mesh, recipe)->GetProperty()->LightingOff();
    scene.GetMapper(0)->SetLevelLookupTable(function);
    scene.GetMapper(0)->SetColorModeToMetric();
  };
  RelevoScene scene(RelevoScene::Refining);
  build(scene);
  scene.ResetCameras();
  const RelevoPicture shallow = Draw(scene);
  recipe->SetMaximumLevel(4);
  const RelevoPicture deep = Draw(scene);
  CHECK_NOT_EQUAL(deep.Colors, shallow.Colors);
  CHECK_EQUAL(deep.Colors, DrawAnew(scene, build).Colors);
}

// VTK shifts and scales positions by the camera. Refined positions follow.
void TestCamera(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<vtkG1Surface> surface;
  vtkNew<RelevoHeights> heights;
  heights->FillWaves();
  auto displacement = MakeDisplacementAlong(0.0, 0.0, 1.0, heights, 0.2);
  const Mesh mesh = Textured(Torus());
  const auto recipe = MakeRecipe(3, surface, displacement);
  RelevoScene twin(RelevoScene::Twin);
  twin.Add(mesh, recipe);
  twin.ResetCameras();
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, recipe);
  scene.GetMapper(0)->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::FOCAL_POINT_SHIFT_SCALE);
  RelevoTolerance tolerance;
  tolerance.Color = 6;
  tolerance.Depth = 1e-3;
  tolerance.Pixels = 30;
  const auto place = [&](double distance)
  {
    twin.ResetCameras();
    twin.Renderer->GetActiveCamera()->Dolly(1.0 / distance);
    twin.Renderer->ResetCameraClippingRange();
    scene.CopyCameras(twin);
  };
  // Starts far away: VTK chooses another scale if it differs by a factor of more than 100.
  place(1000.0);
  scene.Render();
  for (const double distance : { 1.0, 0.5 })
  {
    CHECK_CASE(distance);
    place(distance);
    const RelevoPicture expected = Draw(twin);
    comparison.Compare("Camera." + std::to_string(distance), tolerance, Draw(scene), expected);
    const vtkIdType builds = scene.GetMapper(0)->GetNumberOfBufferBuilds();
    scene.Render();
    CHECK_EQUAL(scene.GetMapper(0)->GetNumberOfBufferBuilds(), builds);
  }
}

// The same level everywhere, by a shader that a test can break.
class Constant : public vtkDepthTagMetric
{
public:
  static Constant* New();
  vtkTypeMacro(Constant, vtkDepthTagMetric);
  const char* Tag = "1.0";

  bool IsViewDependent() override { return true; }
  bool ComputeTags(
    vtkPolyData* mesh, const relevo::RefinementView&, int, vtkFloatArray* tags) override
  {
    tags->SetNumberOfTuples(mesh->GetNumberOfPoints());
    tags->Fill(1.0);
    return true;
  }
  bool GetShader(vtkPolyData*, const relevo::RefinementView&, int, const double*,
    relevo::MetricShader& shader) override
  {
    this->Source = "vec4 metricValue(vec3 x, vec4 datum) { return vec4(0.0); }\n"
                   "float metricPointMeasure(vec4 value) { return value.x; }\n"
                   "float metricEdgeMeasure(vec4 a, vec4 b) { return max(a.x, b.x); }\n"
                   "float metricTag(float measure) { return " +
      std::string(this->Tag) + "; }\n";
    shader.Source = this->Source.c_str();
    return true;
  }

private:
  std::string Source;
};
vtkStandardNewMacro(Constant);

// If the graphics card cannot select levels, the CPU does, until the mesh or the metric changes.
void TestSelection(RelevoCheck& check)
{
  vtkNew<Constant> metric;
  auto recipe = MakeRecipe(2);
  recipe->SetMetric(metric);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(9, 7), recipe);
  scene.ResetCameras();
  Mapper* mapper = scene.GetMapper(0);
  mapper->SetSelectionDeviceToGPU();
  Errors errors(mapper);
  const RelevoPicture expected = Draw(scene);
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetOpenGLVersion(major, minor);
  if (major < 4 || (major == 4 && minor < 3))
  {
    return;
  }
  CHECK_EQUAL(mapper->GetSelectionDeviceInUse(), Mapper::SELECTION_DEVICE_GPU);
  metric->Tag = "nonsense";
  metric->Modified();
  CHECK_EQUAL(Draw(scene).Colors, expected.Colors);
  CHECK_EQUAL(mapper->GetSelectionDeviceInUse(), Mapper::SELECTION_DEVICE_CPU);
  CHECK(errors.Were({ "Selection on the GPU failed" }));
  scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  scene.Render();
  CHECK_EQUAL(mapper->GetSelectionDeviceInUse(), Mapper::SELECTION_DEVICE_CPU);
  scene.Renderer->GetActiveCamera()->Azimuth(-10.0);
  metric->Tag = "1.0";
  metric->Modified();
  CHECK_EQUAL(Draw(scene).Colors, expected.Colors);
  CHECK_EQUAL(mapper->GetSelectionDeviceInUse(), Mapper::SELECTION_DEVICE_GPU);
  CHECK(errors.Were({}));
}
}

int TestAdaptiveRefinementMapperChanges(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestDisplacement(check);
  TestRoom(check);
  TestShaders(check);
  TestColors(check);
  TestCamera(check, comparison);
  TestSelection(check);
  return check.GetResult();
}
