// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that for invalid input vtkAdaptiveLICMapper reports the cause once and draws the surface
// like vtkAdaptiveRefinementMapper. After a correction it draws streaks again.
#include "RelevoLICVectors.h"
#include "RelevoPictures.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTable.h"

#include <fstream>
#include <limits>

namespace
{
using namespace RelevoMeshes;
using RelevoLICVectors::Screw;
using RelevoPictures::Equal;

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

// A mesh drawn with a LIC, and by the superclass without.
struct View
{
  RelevoCheck& Check;
  RelevoScene Scene{ RelevoScene::Refining };
  vtkAdaptiveLICMapper* Mapper;
  RelevoScene Plain{ RelevoScene::Refining };
  RelevoErrors Errors;

  View(RelevoCheck& check, vtkDataObject* mesh)
    : Check(check)
    , Mapper(Add(this->Scene, mesh,
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

  // Expects one error with these words, no further messages, and the plain surface.
  void TestFails(const std::string& words)
  {
    const bool plain = Equal(this->Draw(), this->DrawPlain());
    const bool said = this->Errors.Said(words);
    this->Draw();
    this->Scene.Renderer->GetActiveCamera()->Azimuth(5);
    this->Scene.Renderer->ResetCameraClippingRange();
    const bool still = Equal(this->Draw(), this->DrawPlain());
    const bool quiet = this->Errors.None();
    if (!plain || !still || !said || !quiet)
    {
      this->Check.Fail(__FILE__, __LINE__,
        "\"" + words + "\"" + (said ? "" : ": not reported") + (quiet ? "" : ": reported again") +
          (plain && still ? "" : ": not the plain surface"));
    }
  }

  void TestShows(const std::string& what)
  {
    const bool shows = !Equal(this->Draw(), this->DrawPlain());
    if (!shows || !this->Errors.None())
    {
      this->Errors.Said("");
      this->Check.Fail(__FILE__, __LINE__, what + (shows ? ": an error" : ": no LIC"));
    }
  }

  // A field without streaks is not an error.
  void TestPlain(const std::string& what)
  {
    const bool plain = Equal(this->Draw(), this->DrawPlain());
    if (!plain || !this->Errors.None())
    {
      this->Errors.Said("");
      this->Check.Fail(
        __FILE__, __LINE__, what + (plain ? ": an error" : ": not the plain surface"));
    }
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

// Missing arrays.
void TestMissingArrays(RelevoCheck& check, View& view, vtkPolyData* mesh)
{
  view.TestShows("active vectors");
  mesh->GetPointData()->SetActiveVectors(nullptr);
  mesh->Modified();
  view.TestFails("does not have the array of vectors");
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Points, "Flow");
  view.TestShows("by name");
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Points, "Wind");
  view.TestFails("does not have the array of vectors");
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Cells, "Wind");
  view.Draw();
  CHECK(view.Errors.None()); // the same error
  view.Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_NONE, "Flow");
  view.Draw();
  CHECK(view.Errors.None());
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Cells, "Flow");
  view.TestFails("The input has no cell array \"Flow\", but a point array of that name. Use "
                 "SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "
                 "\"Flow\"). The surface is drawn without LIC.");
}

// Arrays that are not point vectors.
void TestUnfitArrays(View& view, vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  for (const int components : { 1, 4, 9 })
  {
    const std::string name = "A" + std::to_string(components);
    mesh->GetPointData()->AddArray(NewArray(vtkFloatArray::New(), name.c_str(), components, count));
    view.Mapper->SetInputArrayToProcess(0, 0, 0, Points, name.c_str());
    view.TestFails("\"" + name + "\" has " + std::to_string(components) + " component");
  }
  const auto shorter = NewArray(vtkFloatArray::New(), "Short", 3, 5);
  mesh->GetPointData()->AddArray(shorter);
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Points, "Short");
  view.TestFails("5 vectors, but there are " + std::to_string(count) + " points");
}

// Vectors of other types, of two components, and of cells.
void TestFitArrays(View& view, vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  mesh->GetPointData()->AddArray(NewArray(vtkIntArray::New(), "Integers", 3, count, 7));
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Points, "Integers");
  view.TestShows("integers");
  mesh->GetPointData()->AddArray(NewArray(vtkDoubleArray::New(), "Pairs", 2, count));
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Points, "Pairs");
  view.TestShows("two components");
  mesh->GetCellData()->AddArray(
    NewArray(vtkDoubleArray::New(), "Cells", 3, mesh->GetNumberOfCells()));
  view.Mapper->SetInputArrayToProcess(0, 0, 0, Cells, "Cells");
  view.TestShows("cells");
}

void TestArrays(RelevoCheck& check)
{
  Mesh mesh = MakeSphere();
  View view(check, mesh);
  TestMissingArrays(check, view, mesh);
  TestUnfitArrays(view, mesh);
  TestFitArrays(view, mesh);
}

// Reported once per input, before the surface is drawn.
void TestTypes(RelevoCheck& check)
{
  View view(check, MakeSphere());
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkTable> table;
    view.Mapper->SetInputDataObject(table);
    view.Draw();
    CHECK(view.Errors.Said("The input is a vtkTable; a vtkPolyData or a vtkCompositeDataSet is"));
    view.Draw();
    CHECK(view.Errors.None());
  }
  view.Mapper->SetInputDataObject(MakeSphere());
  view.TestShows("a mesh after a table");
}

// Fields without streaks.
void TestEmptyFields(RelevoCheck& check)
{
  Mesh mesh = Sphere(12, 10);
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkSmartPointer<vtkDataArray> vectors = NewArray(vtkDoubleArray::New(), "Flow", 3, count, 0.0);
  mesh->GetPointData()->SetVectors(vectors);
  View view(check, mesh);
  view.TestPlain("zero vectors");
  for (const double value : { NaN, Infinity, -Infinity, -1e9, 1e20, 1e8 })
  {
    vectors->Fill(0.5);
    vectors->Modified();
    mesh->Modified();
    view.TestShows("a field");
    vectors->Fill(value);
    vectors->Modified();
    mesh->Modified();
    view.TestFails("All vectors are missing values");
  }
  vectors->Fill(9.9e7);
  vectors->Modified();
  mesh->Modified();
  view.TestShows("long vectors");
  view.Mapper->SetNoDataMagnitude(1e6);
  view.TestFails("All vectors are missing values");
  view.Mapper->SetNoDataMagnitude(1e9);
  view.TestShows("a larger NoDataMagnitude");
}

void TestNormalVectors(RelevoCheck& check)
{
  Mesh mesh = Plane(4, 4);
  RelevoLICVectors::AddVectors(mesh,
    [](const double*) {
      return std::array<double, 3>{ { 0, 0, 1 } };
    });
  View view(check, mesh);
  view.TestPlain("normal vectors");
}

// Values out of range change nothing.
void TestSettings(RelevoCheck& check)
{
  Mesh mesh = MakeSphere();
  View view(check, mesh);
  vtkAdaptiveLICMapper* mapper = view.Mapper;
  const RelevoPicture picture = view.Draw();
  const auto testSetting = [&](const std::string& words, const std::function<void()>& set)
  {
    set();
    if (!view.Errors.Said(words) || !Equal(view.Draw(), picture))
    {
      check.Fail(__FILE__, __LINE__, words + ": no error");
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

void TestNoiseFiles(View& view, const std::string& folder)
{
  vtkAdaptiveLICMapper* mapper = view.Mapper;
  mapper->SetNoiseFileName("/there/is/no/such/file.png");
  view.TestFails("/there/is/no/such/file.png\" cannot be opened");
  const std::string text = folder + "/LICNoise.txt";
  std::ofstream(text) << "no image";
  mapper->SetNoiseFileName(text.c_str());
  view.TestFails("LICNoise.txt\" is not in an image format");
  const std::string broken = folder + "/LICNoise.bmp";
  std::ofstream(broken) << "BM, and then nothing";
  mapper->SetNoiseFileName(broken.c_str());
  view.TestFails("LICNoise.bmp\" ");
  mapper->SetNoiseFileName(folder.c_str());
  view.TestFails("The noise file");
}

void TestNoiseImages(View& view)
{
  vtkAdaptiveLICMapper* mapper = view.Mapper;
  mapper->SetNoiseDataSet(MakeNoise(16, 16, 1, 0.5)); // has precedence over a file
  view.TestShows("a noise image");
  vtkNew<vtkImageData> empty;
  mapper->SetNoiseDataSet(empty);
  view.TestFails("The noise image is empty");
  empty->SetDimensions(4, 4, 1);
  view.TestFails("The noise image has no point scalars");
  mapper->SetNoiseDataSet(MakeNoise(4, 4, 4, 0.5));
  view.TestFails("The noise image ");
  mapper->SetNoiseDataSet(MakeNoise(4, 4, 1, NaN));
  view.TestFails("outside [0, 1]");
  mapper->SetNoiseDataSet(MakeNoise(1, 1, 1, 0.5));
  view.TestShows("one texel");
  mapper->SetNoiseDataSet(MakeNoise(301, 3, 1, 7.0));
  view.TestFails("has the value 7 outside [0, 1]");
  mapper->SetNoiseDataSet(nullptr);
  mapper->SetNoiseFileName(nullptr);
  view.TestShows("generated noise");
}

void TestGeneratedNoise(RelevoCheck& check, View& view)
{
  vtkAdaptiveLICMapper* mapper = view.Mapper;
  mapper->SetNoiseTextureSize(0);
  CHECK(view.Errors.Said("NoiseTextureSize must be in [2, 16384], got 0."));
  view.TestShows("the noise as it was");
  mapper->SetNoiseGrainSize(300);
  view.TestFails("Cannot generate the noise");
  mapper->SetNoiseTextureSize(400);
  view.TestShows("a noise size");
  mapper->SetImpulseNoiseProbability(NaN);
  CHECK(view.Errors.Said("ImpulseNoiseProbability"));
  view.TestShows("the noise as it was");
  mapper->SetMinNoiseValue(0.9);
  view.TestFails("Cannot generate the noise");
  mapper->SetMaxNoiseValue(1.0);
  mapper->SetNoiseGrainSize(1);
  mapper->SetImpulseNoiseProbability(0.5);
  view.TestShows("sparse noise");
  mapper->GenerateNoiseTextureOff();
  view.TestShows("default noise");
}

void TestNoise(RelevoCheck& check, const std::string& folder)
{
  Mesh mesh = MakeSphere();
  View view(check, mesh);
  TestNoiseFiles(view, folder);
  TestNoiseImages(view);
  TestGeneratedNoise(check, view);
}

void TestEmptyMeshes(RelevoCheck& check)
{
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
    CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  }
}

void TestNoMeshAndNoRecipe(RelevoCheck& check)
{
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
  CHECK(errors.Said("no recipe"));
  mapper->SetRefinement(recipe);
  scene.ResetCameras();
  scene.Render();
  CHECK(errors.None());
  CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 0);
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 1);
}
}

int TestAdaptiveLICMapperErrors(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv); // reads the arguments with the folder
  TestArrays(check);
  TestTypes(check);
  TestEmptyFields(check);
  TestNormalVectors(check);
  TestSettings(check);
  TestNoise(check, comparison.GetFolder());
  TestEmptyMeshes(check);
  TestNoMeshAndNoRecipe(check);
  return check.GetResult();
}
