// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Bad input: vtkAdaptiveLICMapper says once what is wrong and draws the surface as
// vtkAdaptiveRefinementMapper does; put right, it has a LIC again.
#include "RelevoLICVectors.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"

#include <fstream>
#include <limits>

namespace
{
using namespace RelevoMeshes;
using RelevoLICVectors::Screw;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

bool Equal(const RelevoPicture& a, const RelevoPicture& b)
{
  return a.Colors == b.Colors && a.Depths == b.Depths;
}

// A mesh drawn with a LIC, and without by the class above.
struct View
{
  RelevoScene Scene{ RelevoScene::Refining };
  vtkAdaptiveLICMapper* Mapper;
  RelevoScene Plain{ RelevoScene::Refining };
  RelevoErrors Errors;

  explicit View(vtkDataObject* mesh)
    : Mapper(Add(this->Scene, mesh,
        [](vtkDataObject*) -> vtkAdaptiveRefinementMapper* { return vtkAdaptiveLICMapper::New(); }))
    , Errors(Mapper)
  {
    Add(this->Plain, mesh, [](vtkDataObject*) { return vtkAdaptiveRefinementMapper::New(); });
    for (RelevoScene* scene : { &this->Scene, &this->Plain })
    {
      scene->Window->SetSize(120, 120);
      scene->ResetCameras();
    }
  }

  static vtkAdaptiveLICMapper* Add(
    RelevoScene& scene, vtkDataObject* mesh, vtkAdaptiveRefinementMapper* (*make)(vtkDataObject*))
  {
    RelevoScene::NewMapper = make;
    vtkActor* actor = scene.Add(mesh, MakeRecipe(1));
    return RelevoLICVectors::GetMapper(actor);
  }

  RelevoPicture Draw()
  {
    this->Scene.Render();
    return RelevoPicture(this->Scene.Window);
  }
  RelevoPicture DrawPlain()
  {
    this->Plain.CopyCameras(this->Scene);
    this->Plain.Render();
    return RelevoPicture(this->Plain.Window);
  }
};

vtkSmartPointer<vtkDataArray> NewArray(
  vtkDataArray* array, const char* name, int components, vtkIdType count, double value = 1.0)
{
  auto result = vtk::TakeSmartPointer(array);
  result->SetName(name);
  result->SetNumberOfComponents(components);
  result->SetNumberOfTuples(count);
  result->Fill(value);
  return result;
}

Mesh MakeSphere()
{
  Mesh mesh = Sphere(12, 10);
  RelevoLICVectors::AddVectors(mesh, Screw);
  return mesh;
}

vtkSmartPointer<vtkImageData> MakeNoise(int width, int height, int depth, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, depth);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(value);
  return image;
}
}

int TestAdaptiveLICMapperErrors(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv); // for its folder's arguments
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;

  // One error with these words, then silence; the surface is as ever.
  auto testFails = [&](View& view, const std::string& words)
  {
    const bool plain = Equal(view.Draw(), view.DrawPlain());
    const bool said = view.Errors.Said(words);
    view.Draw();
    view.Scene.Renderer->GetActiveCamera()->Azimuth(5);
    view.Scene.Renderer->ResetCameraClippingRange();
    const bool still = Equal(view.Draw(), view.DrawPlain());
    const bool quiet = view.Errors.None();
    if (!plain || !still || !said || !quiet)
    {
      check.Fail(__FILE__, __LINE__,
        "\"" + words + "\"" + (said ? "" : ": not said") + (quiet ? "" : ": said again") +
          (plain && still ? "" : ": not the plain surface"));
    }
  };
  auto testShows = [&](View& view, const std::string& what)
  {
    const bool shows = !Equal(view.Draw(), view.DrawPlain());
    if (!shows || !view.Errors.None())
    {
      view.Errors.Said("");
      check.Fail(__FILE__, __LINE__, what + (shows ? ": an error" : ": no LIC"));
    }
  };
  // Nothing to follow is no error.
  auto testPlain = [&](View& view, const std::string& what)
  {
    const bool plain = Equal(view.Draw(), view.DrawPlain());
    if (!plain || !view.Errors.None())
    {
      view.Errors.Said("");
      check.Fail(__FILE__, __LINE__, what + (plain ? ": an error" : ": not the plain surface"));
    }
  };

  {
    // Arrays that are not there, or are not vectors.
    Mesh mesh = MakeSphere();
    const vtkIdType count = mesh->GetNumberOfPoints();
    View view(mesh);
    testShows(view, "active vectors");
    mesh->GetPointData()->SetActiveVectors(nullptr);
    mesh->Modified();
    testFails(view, "no array of vectors");
    view.Mapper->SetInputArrayToProcess(0, 0, 0, points, "Flow");
    testShows(view, "by name");
    view.Mapper->SetInputArrayToProcess(0, 0, 0, points, "Wind");
    testFails(view, "no array of vectors");
    view.Mapper->SetInputArrayToProcess(0, 0, 0, cells, "Flow");
    view.Draw();
    CHECK(view.Errors.None()); // the same words
    view.Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_NONE, "Flow");
    view.Draw();
    CHECK(view.Errors.None());
    for (const int components : { 1, 4, 9 })
    {
      const std::string name = "A" + std::to_string(components);
      mesh->GetPointData()->AddArray(
        NewArray(vtkFloatArray::New(), name.c_str(), components, count));
      view.Mapper->SetInputArrayToProcess(0, 0, 0, points, name.c_str());
      testFails(view, "\"" + name + "\" has " + std::to_string(components) + " component");
    }
    const auto shorter = NewArray(vtkFloatArray::New(), "Short", 3, 5);
    mesh->GetPointData()->AddArray(shorter);
    view.Mapper->SetInputArrayToProcess(0, 0, 0, points, "Short");
    testFails(view, "5 vectors for " + std::to_string(count) + " points");
    // Of other types, of two components, of cells.
    mesh->GetPointData()->AddArray(NewArray(vtkIntArray::New(), "Integers", 3, count, 7));
    view.Mapper->SetInputArrayToProcess(0, 0, 0, points, "Integers");
    testShows(view, "integers");
    mesh->GetPointData()->AddArray(NewArray(vtkDoubleArray::New(), "Pairs", 2, count));
    view.Mapper->SetInputArrayToProcess(0, 0, 0, points, "Pairs");
    testShows(view, "two components");
    mesh->GetCellData()->AddArray(
      NewArray(vtkDoubleArray::New(), "Cells", 3, mesh->GetNumberOfCells()));
    view.Mapper->SetInputArrayToProcess(0, 0, 0, cells, "Cells");
    testShows(view, "cells");
  }
  {
    // Fields without anything to show.
    Mesh mesh = Sphere(12, 10);
    const vtkIdType count = mesh->GetNumberOfPoints();
    vtkSmartPointer<vtkDataArray> vectors = NewArray(vtkDoubleArray::New(), "Flow", 3, count, 0.0);
    mesh->GetPointData()->SetVectors(vectors);
    View view(mesh);
    testPlain(view, "zero vectors");
    for (const double value : { NaN, Infinity, -Infinity, -1e9, 1e20, 1e8 })
    {
      vectors->Fill(0.5);
      vectors->Modified();
      mesh->Modified();
      testShows(view, "a field");
      vectors->Fill(value);
      vectors->Modified();
      mesh->Modified();
      testFails(view, "All vectors are no-data");
    }
    vectors->Fill(9.9e7);
    vectors->Modified();
    mesh->Modified();
    testShows(view, "long vectors");
    view.Mapper->SetNoDataMagnitude(1e6);
    testFails(view, "All vectors are no-data");
    view.Mapper->SetNoDataMagnitude(1e9);
    testShows(view, "a larger NoDataMagnitude");
  }
  {
    // Normal to the surface.
    Mesh mesh = Plane(4, 4);
    RelevoLICVectors::AddVectors(mesh,
      [](const double*) {
        return std::array<double, 3>{ { 0, 0, 1 } };
      });
    View view(mesh);
    testPlain(view, "normal vectors");
  }
  {
    // Settings out of range change nothing.
    Mesh mesh = MakeSphere();
    View view(mesh);
    vtkAdaptiveLICMapper* mapper = view.Mapper;
    const RelevoPicture picture = view.Draw();
    const auto testSetting = [&](const std::string& words, const std::function<void()>& set)
    {
      set();
      if (!view.Errors.Said(words) || !Equal(view.Draw(), picture))
      {
        check.Fail(__FILE__, __LINE__, words + ": accepted");
      }
    };
    testSetting("NumberOfSteps", [&]() { mapper->SetNumberOfSteps(0); });
    testSetting("NumberOfSteps", [&]() { mapper->SetNumberOfSteps(-3); });
    for (const double value : { 0.0, -1.0, NaN, Infinity })
    {
      testSetting("StepSize", [&]() { mapper->SetStepSize(value); });
      testSetting("LICIntensity", [&]() { mapper->SetLICIntensity(value == 0.0 ? 1.1 : value); });
      testSetting("MaskIntensity", [&]() { mapper->SetMaskIntensity(value == 0.0 ? 2 : value); });
      testSetting("MapModeBias", [&]() { mapper->SetMapModeBias(value <= 0.0 ? -1.1 : value); });
    }
    testSetting("Phase", [&]() { mapper->SetPhase(NaN); });
    testSetting("Phase", [&]() { mapper->SetPhase(Infinity); });
    testSetting("AntiAlias", [&]() { mapper->SetAntiAlias(-1); });
    testSetting("MaskThreshold", [&]() { mapper->SetMaskThreshold(NaN); });
    testSetting("MaskColor", [&]() { mapper->SetMaskColor(NaN, 0, 0); });
    testSetting("EnhanceContrast", [&]() { mapper->SetEnhanceContrast(2); });
    testSetting("EnhanceContrast", [&]() { mapper->SetEnhanceContrast(5); });
    {
      RelevoErrors errors(mapper->GetLICInterface());
      mapper->GetLICInterface()->SetColorMode(2);
      CHECK(errors.Said("ColorMode") && Equal(view.Draw(), picture));
    }
    testSetting("NoDataMagnitude", [&]() { mapper->SetNoDataMagnitude(0.0); });
    testSetting("NoDataMagnitude", [&]() { mapper->SetNoDataMagnitude(NaN); });
    testSetting("LowLICContrast", [&]() { mapper->SetLowLICContrastEnhancementFactor(-1.1); });
    testSetting("HighColorContrast", [&]() { mapper->SetHighColorContrastEnhancementFactor(1.1); });
  }
  {
    // Noise.
    Mesh mesh = MakeSphere();
    View view(mesh);
    vtkAdaptiveLICMapper* mapper = view.Mapper;
    mapper->SetNoiseFileName("/there/is/no/such/file.png");
    testFails(view, "/there/is/no/such/file.png\" cannot be opened");
    const std::string folder = comparison.GetFolder();
    const std::string text = folder + "/LICNoise.txt";
    std::ofstream(text) << "no image";
    mapper->SetNoiseFileName(text.c_str());
    testFails(view, "LICNoise.txt\" is of no image format");
    const std::string broken = folder + "/LICNoise.bmp";
    std::ofstream(broken) << "BM, and then nothing";
    mapper->SetNoiseFileName(broken.c_str());
    testFails(view, "LICNoise.bmp\" ");
    mapper->SetNoiseFileName(folder.c_str());
    testFails(view, "The noise file");
    mapper->SetNoiseDataSet(MakeNoise(16, 16, 1, 0.5)); // goes before the file
    testShows(view, "a noise image");
    vtkNew<vtkImageData> empty;
    mapper->SetNoiseDataSet(empty);
    testFails(view, "The noise image is empty");
    empty->SetDimensions(4, 4, 1);
    testFails(view, "The noise image has no point scalars");
    mapper->SetNoiseDataSet(MakeNoise(4, 4, 4, 0.5));
    testFails(view, "The noise image ");
    mapper->SetNoiseDataSet(MakeNoise(4, 4, 1, NaN));
    testFails(view, "outside [0, 1]");
    mapper->SetNoiseDataSet(MakeNoise(1, 1, 1, 0.5));
    testShows(view, "one texel");
    mapper->SetNoiseDataSet(MakeNoise(301, 3, 1, 7.0));
    testFails(view, "has the value 7 outside [0, 1]");
    mapper->SetNoiseDataSet(nullptr);
    mapper->SetNoiseFileName(nullptr);
    testShows(view, "generated noise");
    mapper->SetNoiseTextureSize(0);
    CHECK(view.Errors.Said("NoiseTextureSize must be in [2, 16384], got 0."));
    testShows(view, "the noise as it was");
    mapper->SetNoiseGrainSize(300);
    testFails(view, "Noise cannot be made");
    mapper->SetNoiseTextureSize(400);
    testShows(view, "a noise size");
    mapper->SetImpulseNoiseProbability(NaN);
    CHECK(view.Errors.Said("ImpulseNoiseProbability"));
    testShows(view, "the noise as it was");
    mapper->SetMinNoiseValue(0.9);
    testFails(view, "Noise cannot be made");
    mapper->SetMaxNoiseValue(1.0);
    mapper->SetNoiseGrainSize(1);
    mapper->SetImpulseNoiseProbability(0.5);
    testShows(view, "sparse noise");
    mapper->GenerateNoiseTextureOff();
    testShows(view, "default noise");
  }
  {
    // Without a mesh, with an empty one, without a recipe.
    vtkNew<vtkPolyData> empty;
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (vtkDataObject* input :
      { vtkDataObject::SafeDownCast(empty), vtkDataObject::SafeDownCast(blocks) })
    {
      RelevoScene::NewMapper = RelevoLICVectors::NewVisible;
      RelevoScene scene(RelevoScene::Refining);
      vtkActor* actor = scene.Add(input);
      RelevoErrors errors(actor->GetMapper());
      scene.Render();
      CHECK(errors.None());
      CHECK(RelevoPicture(scene.Window).CountForeground() == 0);
    }
    vtkNew<vtkAdaptiveLICMapper> mapper;
    RelevoErrors errors(mapper);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    RelevoScene scene(RelevoScene::Refining);
    scene.Renderer->AddActor(actor);
    scene.Render();
    CHECK(errors.None()); // without bounds it is not drawn
    mapper->SetInputData(MakeSphere());
    const vtkSmartPointer<vtkAdaptiveRefinement> recipe = mapper->GetRefinement();
    CHECK(recipe && recipe->GetMaximumLevel() == 0);
    mapper->SetRefinement(nullptr);
    scene.Render();
    CHECK(errors.Said("No recipe"));
    mapper->SetRefinement(recipe);
    scene.ResetCameras();
    scene.Render();
    CHECK(errors.None());
    CHECK(RelevoPicture(scene.Window).CountForeground() > 0);
    CHECK(mapper->GetNumberOfConvolutions() == 1);
  }
  return check.GetResult();
}
