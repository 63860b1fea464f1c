// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves methods.md: every method draws the picture of ARKFPI, except where the page lists a
// difference.
#include "RelevoMethods.h"
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkCullerCollection.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <initializer_list>
#include <iostream>
#include <map>
#include <sstream>

namespace
{
using namespace RelevoMeshes;
using namespace RelevoMethods;
using namespace RelevoPicks;

// One mesh, drawn by one method after another.
struct Subject
{
  explicit Subject(vtkDataObject* mesh, int level = 4)
    : Scene(RelevoScene::Refining)
  {
    this->Heights->FillRandom(64, 64, 9);
    this->Displacement->SetHeightMap(this->Heights);
    this->Displacement->SetScale(0.1);
    this->Recipe->SetMaximumLevel(level);
    this->Recipe->SetSurface(this->Surface);
    this->Recipe->SetGeomorphing(0);
    this->Scene.Add(mesh, this->Recipe);
    this->Scene.ResetCameras();
  }
  Mapper* GetMapper() { return this->Scene.GetMapper(0); }
  vtkProperty* GetProperty() { return this->Scene.GetActor(0)->GetProperty(); }

  RelevoPicture Draw(int method)
  {
    this->GetMapper()->SetMethod(method);
    this->Scene.Render();
    return RelevoPicture(this->Scene.Window);
  }

  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkPNTriangleSurface> Surface;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  RelevoScene Scene;
};

Mesh Noisy(unsigned int seed)
{
  Mesh mesh = Sphere(12, 8);
  PerturbNormals(mesh, seed, 0.3);
  AddRandomTextureCoordinates(mesh, seed);
  return mesh;
}

Mesh Tagged(Mesh mesh, unsigned int seed, int level)
{
  AddTags(mesh, seed, level);
  return mesh;
}

void TestSetting(RelevoCheck& check)
{
  vtkNew<Mapper> mapper;
  RelevoErrors errors(mapper);
  CHECK_EQUAL(mapper->GetMethod(), Mapper::METHOD_ARKFPI);
  mapper->SetMethodToUniform();
  CHECK_EQUAL(mapper->GetMethod(), Mapper::METHOD_UNIFORM);
  CHECK(errors.None());
  for (int wrong : { -1, 1000 })
  {
    CHECK_CASE(wrong);
    mapper->SetMethod(wrong);
    CHECK(errors.Said("Method"));
    CHECK_EQUAL(mapper->GetMethod(), Mapper::METHOD_UNIFORM);
  }
  vtkNew<Mapper> copy;
  copy->ShallowCopy(mapper);
  CHECK_EQUAL(copy->GetMethod(), Mapper::METHOD_UNIFORM);
  std::ostringstream text;
  mapper->Print(text);
  CHECK_NOT_EQUAL(text.str().find("Method: Uniform"), std::string::npos);
}

// ARK uses one draw call per face and gives the same picture, bit for bit.
void TestARK(RelevoCheck& check, RelevoComparison& comparison)
{
  for (int morphing : { 0, 1 })
  {
    CHECK_CASE(morphing);
    Subject subject(Tagged(Noisy(3), 3, 5), 5);
    Mapper* mapper = subject.GetMapper();
    mapper->SetSelectionDeviceToCPU();
    mapper->FrustumCullingOff();
    subject.Recipe->SetGeomorphing(morphing);
    subject.Recipe->SetDisplacement(subject.Displacement);
    for (int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
    {
      CHECK_CASE(representation);
      subject.GetProperty()->SetRepresentation(representation);
      const RelevoPicture expected = subject.Draw(Mapper::METHOD_ARKFPI);
      const vtkIdType triangles = mapper->GetNumberOfDrawnTriangles();
      const RelevoPicture actual = subject.Draw(Mapper::METHOD_ARK);
      CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARK);
      CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), mapper->GetNumberOfCoarseFaces());
      CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), triangles);
      comparison.Compare("ARK" + std::to_string(morphing) + "." + std::to_string(representation),
        RelevoTolerance(), actual, expected);
    }
  }
}

// For the same triangles in another order. If two triangles have the same depth at a pixel, the
// order of drawing decides; the order of a triangle's corners affects the last bit.
RelevoTolerance GetTolerance()
{
  RelevoTolerance tolerance;
  tolerance.Color = 3;
  tolerance.Depth = 1e-5;
  tolerance.Pixels = 20;
  return tolerance;
}

// If all levels are equal, all methods draw the same triangles.
void TestEqualLevels(RelevoCheck& check, RelevoComparison& comparison)
{
  const RelevoTolerance tolerance = GetTolerance();
  struct Case
  {
    std::string Name;
    Mesh Input;
    RelevoComparison::Builder Change; // nullptr for none
  };
  const auto inColors = [](RelevoScene& scene) { scene.GetMapper(0)->SetColorModeToLevel(); };
  const auto byPatterns = [](RelevoScene& scene) { scene.GetMapper(0)->SetColorModeToPattern(); };
  const auto clipped = [](RelevoScene& scene) { scene.Renderer->GetActiveCamera()->Zoom(4.0); };
  const auto withEdges = [](RelevoScene& scene)
  { scene.GetActor(0)->GetProperty()->EdgeVisibilityOn(); };
  const auto translucent = [](RelevoScene& scene)
  {
    scene.Window->SetAlphaBitPlanes(1);
    scene.Renderer->SetUseDepthPeeling(1);
    scene.Renderer->SetMaximumNumberOfPeels(20);
    scene.GetActor(0)->GetProperty()->SetOpacity(0.5);
  };
  Mesh colored = Noisy(6);
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType cell = 0; cell < colored->GetNumberOfCells(); ++cell)
  {
    scalars->InsertNextValue(static_cast<float>(cell % 7) / 7.0f);
  }
  colored->GetCellData()->SetScalars(scalars);
  for (const Case& c : std::initializer_list<Case>{ { "Sphere", Noisy(1), nullptr },
         { "SplitNormals", Cube(), nullptr }, { "Strips", Strips(), nullptr },
         { "Mixed", Mixed(), nullptr }, { "Levels", Noisy(2), inColors },
         { "Patterns", Noisy(2), byPatterns }, { "Culled", Noisy(3), clipped },
         { "Edges", Noisy(3), withEdges }, { "Translucent", Noisy(3), translucent },
         { "CellColors", colored, nullptr } })
  {
    CHECK_CASE(c.Name);
    for (bool displaced : { false, true })
    {
      CHECK_CASE(displaced);
      if (displaced && !c.Input->GetPointData()->GetTCoords())
      {
        continue;
      }
      Subject subject(c.Input);
      subject.Recipe->SetDisplacement(displaced ? subject.Displacement.Get() : nullptr);
      subject.Heights->Punch([](int x, int y) { return x > 40 && y > 40; });
      if (c.Change)
      {
        c.Change(subject.Scene);
      }
      const RelevoPicture expected = subject.Draw(Mapper::METHOD_ARKFPI);
      for (int method : GetMethods())
      {
        const RelevoPicture actual = subject.Draw(method);
        CHECK_EQUAL(subject.GetMapper()->GetMethodInUse(), method);
        comparison.Compare(c.Name + (displaced ? ".Displaced." : ".") + GetName(method), tolerance,
          actual, expected);
      }
    }
  }
}

// Switching methods does not prepare the mesh or upload levels again. The GPU memory of the
// previous method is released.
void TestSwitching(RelevoCheck& check, RelevoComparison& comparison)
{
  Subject subject(Tagged(Noisy(4), 4, 4));
  Mapper* mapper = subject.GetMapper();
  mapper->SetSelectionDeviceToCPU();
  std::map<int, RelevoPicture> pictures;
  for (int method : GetMethods())
  {
    pictures.insert({ method, subject.Draw(method) });
  }
  const vtkIdType builds = mapper->GetNumberOfBufferBuilds();
  const vtkIdType selections = mapper->GetNumberOfSelections();
  std::map<int, vtkTypeInt64> sizes;
  for (int round = 0; round < 2; ++round)
  {
    for (int method : GetMethods())
    {
      const RelevoPicture actual = subject.Draw(method);
      comparison.Compare(
        std::string("Back.") + GetName(method), RelevoTolerance(), actual, pictures.at(method));
      const vtkTypeInt64 size = mapper->GetGraphicsMemorySize();
      CHECK(round == 0 || sizes[method] == size);
      sizes[method] = size;
    }
  }
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), builds);
  CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);
  CHECK_EQUAL(builds, 1);
  CHECK_EQUAL(selections, 1);

  // An unchanged view needs no work. A stream takes 48 bytes per triangle.
  subject.Draw(Mapper::METHOD_DMR);
  const vtkTypeInt64 withStream = mapper->GetGraphicsMemorySize();
  CHECK_GREATER(withStream, 48 * mapper->GetNumberOfDrawnTriangles());
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  subject.Draw(Mapper::METHOD_DMR);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
  CHECK_EQUAL(mapper->GetGraphicsMemorySize(), withStream);

  for (int method : GetMethods())
  {
    subject.Draw(method);
    mapper->ReleaseGraphicsResources(subject.Scene.Window);
    const RelevoPicture actual = subject.Draw(method);
    comparison.Compare(
      std::string("Released.") + GetName(method), RelevoTolerance(), actual, pictures.at(method));
  }
}

// ARKFPI replaces a method that cannot draw the scene.
void TestSubstitute(RelevoCheck& check, RelevoComparison& comparison)
{
  Subject subject(Tagged(Noisy(5), 5, 4));
  Mapper* mapper = subject.GetMapper();
  mapper->SetSelectionDeviceToCPU();
  RelevoErrors errors(mapper);
  for (int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    CHECK_CASE(representation);
    subject.GetProperty()->SetRepresentation(representation);
    const RelevoPicture expected = subject.Draw(Mapper::METHOD_ARKFPI);
    const RelevoPicture actual = subject.Draw(Mapper::METHOD_DMR);
    CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARKFPI);
    comparison.Compare(
      "Substitute." + std::to_string(representation), RelevoTolerance(), actual, expected);
    subject.Draw(Mapper::METHOD_SUAPT);
    CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_SUAPT);
  }
  subject.GetProperty()->SetRepresentationToSurface();
  CHECK(errors.None());

  subject.Recipe->SetSegmentPolicyToWholeNumbers();
  const RelevoPicture expected = subject.Draw(Mapper::METHOD_ARKFPI);
  const RelevoPicture actual = subject.Draw(Mapper::METHOD_DMR);
  CHECK(errors.Said("DMR cannot be used: it halves edges"));
  CHECK_EQUAL(mapper->GetMethod(), Mapper::METHOD_DMR);
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARKFPI);
  comparison.Compare("WholeNumbers", RelevoTolerance(), actual, expected);
  subject.Draw(Mapper::METHOD_DMR);
  CHECK(errors.None()); // reported once
  subject.Recipe->SetSegmentPolicyToPowersOfTwo();
  subject.Draw(Mapper::METHOD_DMR);
  CHECK(errors.None());
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_DMR);
}

// Methods without geomorphing draw the same rounded levels whether the recipe morphs or not.
void TestRounding(RelevoComparison& comparison)
{
  Subject subject(Tagged(Noisy(7), 7, 4));
  for (int method : { Mapper::METHOD_DMR, Mapper::METHOD_SUAPT, Mapper::METHOD_UNIFORM })
  {
    subject.Recipe->SetGeomorphing(0);
    const RelevoPicture expected = subject.Draw(method);
    subject.Recipe->SetGeomorphing(1);
    const RelevoPicture actual = subject.Draw(method);
    comparison.Compare(
      std::string("Rounded.") + GetName(method), RelevoTolerance(), actual, expected);
  }
}

// Nothing is in view, before and after something was.
void TestNothing(RelevoCheck& check, RelevoComparison& comparison)
{
  Subject subject(Noisy(1));
  RelevoErrors errors(subject.GetMapper());
  vtkCamera* camera = subject.Scene.Renderer->GetActiveCamera();
  subject.Scene.Renderer->GetCullers()->RemoveAllItems(); // they cull whole actors
  const RelevoPicture expected = subject.Draw(Mapper::METHOD_ARKFPI);
  for (int method : GetMethods())
  {
    camera->Yaw(180.0);
    CHECK_EQUAL(subject.Draw(method).CountForeground(), 0);
    Mapper* mapper = subject.GetMapper();
    CHECK_EQUAL(mapper->GetNumberOfCulledFaces(), mapper->GetNumberOfCoarseFaces());
    CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), 0);
    CHECK_GREATER(mapper->GetNumberOfCulledTriangles(), 0);
    camera->Yaw(180.0);
    comparison.Compare(
      std::string("Again.") + GetName(method), GetTolerance(), subject.Draw(method), expected);
  }
  CHECK(errors.None());
}

// Hardware selection finds the same cells and points.
void TestPicking(RelevoCheck& check)
{
  Subject subject(Mixed(), 3);
  for (int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    CHECK_CASE(association);
    subject.GetMapper()->SetMethodToARKFPI();
    const std::vector<Hit> expected = SelectPixels(subject.Scene, association);
    const size_t hits = expected.size() - std::count(expected.begin(), expected.end(), Hit());
    CHECK_GREATER(hits, 100);
    for (int method : GetMethods())
    {
      subject.GetMapper()->SetMethod(method);
      const std::vector<Hit> actual = SelectPixels(subject.Scene, association);
      size_t differences = 0;
      for (size_t i = 0; i < expected.size(); ++i)
      {
        differences += !(actual[i] == expected[i]);
      }
      std::cout << "Picks of " << GetName(method) << ": " << differences << " of " << hits
                << " differ" << std::endl;
      CHECK_EQUAL(actual.size(), expected.size());
      CHECK_LESS_EQUAL(differences, hits / 1000);
    }
  }
}

// Blocks follow the method.
void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  Mesh one = Noisy(1);
  Mesh two = Cube();
  blocks->SetBlock(0, one);
  blocks->SetBlock(1, two);
  Subject subject(blocks, 2);
  Mapper* mapper = subject.GetMapper();
  mapper->FrustumCullingOff();
  subject.Draw(Mapper::METHOD_ARK);
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARK);
  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), mapper->GetNumberOfCoarseFaces());
  CHECK_EQUAL(
    mapper->GetNumberOfCoarseFaces(), one->GetNumberOfCells() + 2 * two->GetNumberOfCells());
  subject.Draw(Mapper::METHOD_DMR);
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_DMR);
  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), 2);
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), 16 * mapper->GetNumberOfCoarseFaces());
}
}

int TestAdaptiveRefinementMapperMethods(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestSetting(check);
  TestARK(check, comparison);
  TestEqualLevels(check, comparison);
  TestSwitching(check, comparison);
  TestSubstitute(check, comparison);
  TestRounding(comparison);
  TestNothing(check, comparison);
  TestPicking(check);
  TestBlocks(check);
  return check.GetResult();
}
