// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLICSettings promises: programs for vtkSurfaceLICMapper run unchanged, and mappers and blocks
// share settings. A change uploads and convolves only what it requires.
#include "RelevoCheck.h"
#include "RelevoLICScene.h"
#include "RelevoLICVectors.h"
#include "RelevoPictures.h"

#include "vtkActor.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <functional>

namespace
{
using RelevoPictures::Equal;

RelevoMeshes::Mesh MakeMesh()
{
  RelevoMeshes::Mesh mesh = RelevoMeshes::Sphere(16, 12);
  RelevoLICVectors::AddVectors(mesh);
  return mesh;
}

// Code from a program for VTK, which draws the unrefined mesh.
template <typename SurfaceLICMapper>
vtkSmartPointer<SurfaceLICMapper> MakeAsInVTK(vtkPolyData* mesh)
{
  auto mapper = vtkSmartPointer<SurfaceLICMapper>::New();
  mapper->SetInputData(mesh);
  mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Flow");
  mapper->SetColorMode(VTK_COLOR_MODE_DEFAULT);
  auto* lic = mapper->GetLICInterface();
  lic->SetEnable(1);
  lic->SetNumberOfSteps(40);
  lic->SetStepSize(0.5);
  lic->NormalizeVectorsOff();
  lic->EnhancedLICOn();
  lic->SetEnhanceContrast(lic->ENHANCE_CONTRAST_BOTH);
  lic->SetLowLICContrastEnhancementFactor(0.05);
  lic->SetHighLICContrastEnhancementFactor(0.1);
  lic->SetLowColorContrastEnhancementFactor(0.02);
  lic->SetHighColorContrastEnhancementFactor(0.03);
  lic->SetAntiAlias(1);
  lic->SetColorMode(lic->COLOR_MODE_MAP);
  lic->SetLICIntensity(0.9);
  lic->SetMapModeBias(0.1);
  lic->MaskOnSurfaceOn();
  lic->SetMaskThreshold(0.6);
  lic->SetMaskIntensity(0.5);
  double green[3] = { 0.0, 1.0, 0.0 };
  lic->SetMaskColor(green);
  lic->SetGenerateNoiseTexture(1);
  lic->SetNoiseType(lic->NOISE_TYPE_UNIFORM);
  lic->SetNoiseTextureSize(150);
  lic->SetNoiseGrainSize(2);
  lic->SetMinNoiseValue(0.1);
  lic->SetMaxNoiseValue(0.9);
  lic->SetNumberOfNoiseLevels(64);
  lic->SetImpulseNoiseProbability(0.8);
  lic->SetImpulseNoiseBackgroundValue(0.2);
  lic->SetNoiseGeneratorSeed(7);
  lic->SetCompositeStrategy(lic->COMPOSITE_AUTO);
  return mapper;
}

vtkSmartPointer<vtkAdaptiveLICMapper> MakeByItsOwnSetters(vtkPolyData* mesh)
{
  auto mapper = vtkSmartPointer<vtkAdaptiveLICMapper>::New();
  mapper->SetInputData(mesh);
  mapper->SetNumberOfSteps(40);
  mapper->SetStepSize(0.5);
  mapper->NormalizeVectorsOff();
  mapper->SetEnhanceContrastToBoth();
  mapper->SetLowLICContrastEnhancementFactor(0.05);
  mapper->SetHighLICContrastEnhancementFactor(0.1);
  mapper->SetLowColorContrastEnhancementFactor(0.02);
  mapper->SetHighColorContrastEnhancementFactor(0.03);
  mapper->AntiAliasOn();
  mapper->SetColorModeToMap();
  mapper->SetLICIntensity(0.9);
  mapper->SetMapModeBias(0.1);
  mapper->MaskOnSurfaceOn();
  mapper->SetMaskThreshold(0.6);
  mapper->SetMaskIntensity(0.5);
  mapper->SetMaskColor(0.0, 1.0, 0.0);
  mapper->SetNoiseType(vtkAdaptiveLICMapper::NOISE_TYPE_UNIFORM);
  mapper->SetNoiseTextureSize(150);
  mapper->SetNoiseGrainSize(2);
  mapper->SetMinNoiseValue(0.1);
  mapper->SetMaxNoiseValue(0.9);
  mapper->SetNumberOfNoiseLevels(64);
  mapper->SetImpulseNoiseProbability(0.8);
  mapper->SetImpulseNoiseBackgroundValue(0.2);
  mapper->SetNoiseGeneratorSeed(7);
  return mapper;
}

// A window with the mapper.
struct View
{
  explicit View(vtkAdaptiveLICMapper* mapper)
    : Mapper(mapper)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(120, 110);
    this->Window->AddRenderer(this->Renderer);
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(0.9, 0.7, 0.5);
    this->Renderer->AddActor(this->Actor);
  }
  explicit View(vtkDataObject* input)
    : View(vtkNew<vtkAdaptiveLICMapper>().Get())
  {
    this->Mapper->SetInputDataObject(input);
  }

  RelevoPicture Draw()
  {
    this->Window->Render();
    return RelevoPicture(this->Window);
  }

  vtkSmartPointer<vtkAdaptiveLICMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void TestProgram(RelevoCheck& check)
{
  const auto mesh = MakeMesh();
  const auto plain = View(mesh).Draw();
  View asInVTK(MakeAsInVTK<vtkAdaptiveLICMapper>(mesh));
  View own(MakeByItsOwnSetters(mesh));
  RelevoErrors errors(asInVTK.Mapper);
  const auto picture = asInVTK.Draw();
  CHECK(errors.None());
  CHECK_EQUAL(asInVTK.Mapper->GetNumberOfConvolutions(), 1);
  CHECK_GREATER(picture.CountForeground(), 2000);
  CHECK(Equal(picture, own.Draw()));
  CHECK(!Equal(picture, plain));
}

// The colour mode for scalars is the mapper's, also through a pointer to vtkMapper.
void TestColorModes(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveLICMapper> mapper;
  vtkMapper* base = mapper;
  RelevoErrors errors(mapper);
  mapper->SetColorMode(VTK_COLOR_MODE_DIRECT_SCALARS);
  CHECK(errors.None());
  CHECK_EQUAL(base->GetColorMode(), VTK_COLOR_MODE_DIRECT_SCALARS);
  CHECK_EQUAL(mapper->GetColorMode(), VTK_COLOR_MODE_DIRECT_SCALARS);
  CHECK_EQUAL(mapper->GetLICInterface()->GetColorMode(), vtkLICSettings::COLOR_MODE_BLEND);
  mapper->SetColorModeToMultiply();
  base->SetColorMode(VTK_COLOR_MODE_MAP_SCALARS);
  CHECK_EQUAL(mapper->GetColorMode(), VTK_COLOR_MODE_MAP_SCALARS);
  CHECK_EQUAL(mapper->GetLICInterface()->GetColorMode(), vtkLICSettings::COLOR_MODE_MAP);
  mapper->SetColorModeToBlend();
  mapper->SetColorModeToDefault();
  CHECK_EQUAL(base->GetColorMode(), VTK_COLOR_MODE_DEFAULT);
  CHECK_EQUAL(mapper->GetLICInterface()->GetColorMode(), vtkLICSettings::COLOR_MODE_BLEND);
}

// Two mappers in two windows share settings: a change affects both.
void TestSharing(RelevoCheck& check)
{
  const auto mesh = MakeMesh();
  View a(mesh);
  View b(mesh);
  vtkLICSettings* settings = a.Mapper->GetLICSettings();
  CHECK(settings == a.Mapper->GetLICInterface() && settings != b.Mapper->GetLICSettings());
  b.Mapper->SetLICSettings(settings);
  CHECK_EQUAL(b.Mapper->GetLICSettings(), settings);
  const auto before = a.Draw();
  CHECK(Equal(b.Draw(), before));
  const std::function<void()> changes[] = { [&] { settings->SetNumberOfSteps(5); },
    [&] { b.Mapper->SetPhase(0.5); }, [&] { a.Mapper->SetLICIntensity(0.5); },
    [&] { settings->SetColorModeToMap(); }, [&] { settings->SetNoiseGeneratorSeed(2); },
    [&] { b.Mapper->SetNoDataMagnitude(1.05); }, [&] { settings->SetEnable(0); } };
  auto last = before;
  for (const auto& change : changes)
  {
    const vtkMTimeType times[] = { a.Mapper->GetMTime(), b.Mapper->GetMTime(),
      a.Actor->GetRedrawMTime(), b.Actor->GetRedrawMTime() };
    change();
    CHECK(a.Mapper->GetMTime() > times[0] && b.Mapper->GetMTime() > times[1]);
    CHECK(a.Actor->GetRedrawMTime() > times[2] && b.Actor->GetRedrawMTime() > times[3]);
    const auto picture = a.Draw();
    CHECK(!Equal(picture, last));
    CHECK(Equal(b.Draw(), picture));
    last = picture;
  }
  CHECK_EQUAL(a.Mapper->GetNumberOfConvolutions(), b.Mapper->GetNumberOfConvolutions());
  b.Mapper->SetLICSettings(nullptr); // new settings
  CHECK(b.Mapper->GetLICSettings() && b.Mapper->GetLICSettings() != settings);
  CHECK(Equal(b.Draw(), before));

  // Errors come from the object whose setter was called.
  RelevoErrors ofMapper(a.Mapper);
  RelevoErrors ofSettings(settings);
  a.Mapper->SetStepSize(0.0);
  CHECK(ofMapper.Said("StepSize must be more than 0 and finite, got 0."));
  CHECK(ofSettings.None());
  a.Mapper->SetMaskColor(0.0, 0.0, 2.0);
  CHECK(ofMapper.Said("MaskColor must be in [0, 1], got (0, 0, 2)") && ofSettings.None());
  settings->SetColorMode(2);
  CHECK(ofSettings.Said("ColorMode must be one of BLEND (0), MAP (1), got 2.") && ofMapper.None());
}

// Live settings upload and build nothing, and only settings that affect the LIC convolve again.
void TestUploads(RelevoCheck& check)
{
  View view(MakeMesh());
  view.Draw();
  vtkAdaptiveLICMapper* mapper = view.Mapper;
  const vtkIdType buffers = mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  vtkIdType convolutions = mapper->GetNumberOfConvolutions();
  const auto draw = [&](vtkIdType more)
  {
    view.Draw();
    convolutions += more;
    CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), buffers);
    CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
    CHECK_EQUAL(mapper->GetNumberOfConvolutions(), convolutions);
  };
  mapper->SetPhase(0.3);
  draw(1);
  mapper->SetPhase(1.3); // loops
  draw(0);
  mapper->SetMaskThreshold(0.5);
  draw(1);
  mapper->SetNoiseGeneratorSeed(4);
  draw(1);
  mapper->SetNoiseGeneratorSeed(5);
  mapper->SetNoiseGeneratorSeed(4);
  mapper->SetNumberOfSteps(9);
  mapper->SetNumberOfSteps(20);
  draw(0); // the original setting
  mapper->SetLICIntensity(0.4);
  mapper->SetMaskIntensity(0.7);
  mapper->GetLICInterface()->SetColorModeToMap();
  mapper->GetLICInterface()->SetCompositeStrategy(0);
  draw(0);
  mapper->SetNoDataMagnitude(1.05);
  view.Draw();
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), buffers + 1);
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), convolutions + 1);
}

// Blocks use the settings of their mapper, and copies of mappers share them.
void TestBlocks(RelevoCheck& check)
{
  const auto mesh = MakeMesh();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  View composite(blocks);
  View single(mesh);
  const auto compare = [&](const std::function<void(vtkAdaptiveLICMapper*)>& change)
  {
    const auto before = composite.Draw();
    change(composite.Mapper);
    change(single.Mapper);
    const auto after = composite.Draw();
    CHECK(Equal(after, single.Draw()) && !Equal(after, before));
  };
  compare([](vtkAdaptiveLICMapper* mapper) { mapper->GetLICInterface()->SetNumberOfSteps(6); });
  compare([](vtkAdaptiveLICMapper* mapper) { mapper->SetNoDataMagnitude(1.05); });
  compare(
    [](vtkAdaptiveLICMapper* mapper)
    {
      vtkNew<vtkLICSettings> settings;
      settings->SetNoDataMagnitude(1.0);
      settings->SetLICIntensity(0.6);
      mapper->SetLICSettings(settings);
    });
  compare([](vtkAdaptiveLICMapper* mapper) { mapper->GetLICInterface()->SetEnable(0); });

  vtkNew<vtkAdaptiveLICMapper> copy;
  copy->ShallowCopy(single.Mapper);
  CHECK_EQUAL(copy->GetLICInterface(), single.Mapper->GetLICInterface());
  CHECK(!copy->GetEnable());
}
}

int TestAdaptiveLICMapperSettings(int, char*[])
{
  RelevoCheck check;
  TestProgram(check);
  TestColorModes(check);
  TestSharing(check);
  TestUploads(check);
  TestBlocks(check);
  return check.GetResult();
}
