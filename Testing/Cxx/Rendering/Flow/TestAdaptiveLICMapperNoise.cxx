// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that noise which could not be read is tried again, and that noise is only generated again
// if its settings change. Contrast factors that contradict each other are errors where they are
// used.
#include "RelevoLICScene.h"

#include "vtkImageData.h"
#include "vtkPNGWriter.h"

#include <cstdio>

namespace
{
struct Scene : public RelevoLICScene
{
  Scene()
    : RelevoLICScene(60, 50)
    , Mapper(this->Add(MakePixelMesh(60, 50, 5,
        [](double, double, double* vector)
        {
          vector[0] = 1.0;
          vector[1] = 0.5;
        })))
    , Errors(this->Mapper)
  {
    this->LookAtPixels();
  }
  vtkAdaptiveLICMapper* Mapper;
  RelevoErrors Errors;
};

vtkSmartPointer<vtkImageData> MakeNoise()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  unsigned int random = 1;
  for (int i = 0; i < 64 * 64; ++i)
  {
    random = 1664525u * random + 1013904223u;
    values[i] = static_cast<unsigned char>(random >> 24);
  }
  return image;
}

void TestFile(RelevoCheck& check, const std::string& folder)
{
  const std::string file = folder + "/LICMapperNoise.png";
  std::remove(file.c_str());
  Scene scene;
  scene.Mapper->SetNoiseFileName(file.c_str());
  scene.Render();
  CHECK(scene.Errors.Said("cannot be opened"));
  scene.Render();
  CHECK(scene.Errors.None()); // reported once
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 0);
  std::fclose(std::fopen(file.c_str(), "w"));
  scene.Render();
  CHECK(scene.Errors.Said("LICMapperNoise.png"));

  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(MakeNoise());
  writer->Write();
  const RelevoLICPicture picture = scene.Render();
  CHECK(scene.Errors.None());
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1);
  Scene other;
  other.Mapper->SetNoiseDataSet(MakeNoise());
  CHECK_EQUAL(picture.Grey.Values, other.Render().Grey.Values);

  // The file is read once.
  std::remove(file.c_str());
  scene.Mapper->SetNumberOfSteps(10);
  scene.Render();
  CHECK(scene.Errors.None());
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 2);
  scene.Mapper->SetNoiseGeneratorSeed(7);
  scene.Render();
  CHECK(scene.Errors.None());
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 2);
}

// Settings of generated noise have an effect only if noise is generated.
void TestSeed(RelevoCheck& check)
{
  Scene scene;
  scene.Mapper->SetNoiseDataSet(MakeNoise());
  scene.Render();
  scene.Mapper->SetNoiseGeneratorSeed(7);
  scene.Mapper->SetNoiseGrainSize(3);
  scene.Render();
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 1);
  scene.Mapper->SetNoiseDataSet(nullptr);
  scene.Render();
  scene.Mapper->SetNoiseGeneratorSeed(8);
  scene.Render();
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 3);
}

void TestContrast(RelevoCheck& check)
{
  Scene scene;
  vtkAdaptiveLICMapper* mapper = scene.Mapper;
  mapper->SetEnhanceContrastToBoth();
  mapper->SetLowLICContrastEnhancementFactor(0.6);
  mapper->SetHighLICContrastEnhancementFactor(0.6);
  scene.Render();
  CHECK(scene.Errors.Said("LowLICContrastEnhancementFactor 0.6 and HighLICContrast"));
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 0);
  mapper->SetHighLICContrastEnhancementFactor(0.3);
  mapper->SetLowColorContrastEnhancementFactor(1.0);
  scene.Render();
  CHECK(scene.Errors.Said("LowColorContrastEnhancementFactor 1 and HighColorContrast"));
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 0);
  mapper->SetHighColorContrastEnhancementFactor(-0.5);
  scene.Render();
  CHECK(scene.Errors.None());
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 1);

  // Unused factors are not checked, as in vtkSurfaceLICMapper.
  mapper->SetHighLICContrastEnhancementFactor(0.6);
  mapper->SetHighColorContrastEnhancementFactor(0.5);
  mapper->SetEnhanceContrastToOff();
  scene.Render();
  CHECK(scene.Errors.None());
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 2);
}
}

int TestAdaptiveLICMapperNoise(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoComparison comparison(check, argc, argv);
  TestFile(check, comparison.GetFolder());
  TestSeed(check);
  TestContrast(check);
  return check.GetResult();
}
