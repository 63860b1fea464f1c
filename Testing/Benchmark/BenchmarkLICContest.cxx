// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkLICContest.h"

#include "BenchmarkFlow.h"
#include "BenchmarkMeasure.h"
#include "Benchmarks.h"

#include "vtkActor.h"
#include "vtkAdaptiveLICMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace
{
vtkSmartPointer<vtkAdaptiveRefinementMapper> MakeMapper(
  vtkImageData* noise, const LICSettings& settings)
{
  auto mapper = vtkSmartPointer<vtkAdaptiveLICMapper>::New();
  mapper->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, FlowScene::VectorsName);
  mapper->SetNumberOfSteps(settings.NumberOfSteps);
  mapper->SetStepSize(settings.StepSize);
  mapper->SetEnhancedLIC(settings.EnhancedLIC);
  mapper->SetEnhanceContrast(settings.EnhanceContrast);
  mapper->SetAntiAlias(settings.AntiAlias);
  mapper->SetLICIntensity(1.0);
  mapper->SetNoiseDataSet(noise);
  return mapper;
}
}

BenchmarkLICContest::BenchmarkLICContest(const BenchmarkOptions& options, const FlowScene& scene,
  vtkImageData* noise, const LICSettings& settings, const LICSettings& vtkSettings)
  : View(options.Quick ? 160 : 1024, options.Quick ? 120 : 768)
  , Rival(options, scene.Mesh, this->View.GetWidth(), this->View.GetHeight(), noise, vtkSettings)
{
  LICSettings oneStep = settings;
  oneStep.NumberOfSteps = 1;
  this->Add(PLAIN, scene, vtkSmartPointer<vtkAdaptiveRefinementMapper>::New());
  this->Add(LIC, scene, MakeMapper(noise, settings));
  this->Add(LIC_SHORT, scene, MakeMapper(noise, oneStep));
}

BenchmarkLICContest::~BenchmarkLICContest()
{
  for (auto& actor : this->Actors)
  {
    this->View.GetRenderer()->RemoveActor(actor.second);
  }
}

void BenchmarkLICContest::Add(
  Policy way, const FlowScene& scene, vtkSmartPointer<vtkAdaptiveRefinementMapper> mapper)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(0);
  mapper->SetRefinement(recipe);
  mapper->SetInputData(scene.Mesh);
  mapper->ScalarVisibilityOff();
  this->Actors[way] = this->View.AddActor(mapper);
  this->Actors[way]->GetProperty()->LightingOff();
}

vtkCamera* BenchmarkLICContest::GetCamera()
{
  return this->View.GetRenderer()->GetActiveCamera();
}

LICFrame BenchmarkLICContest::Draw(Policy way)
{
  if (way == VTK_PLAIN || way == VTK_LIC)
  {
    this->Rival.SetCamera(this->GetCamera());
    return this->Rival.Draw(way == VTK_LIC);
  }
  for (auto& actor : this->Actors)
  {
    actor.second->SetVisibility(actor.first == way);
  }
  const double start = GetProcessorSeconds();
  const double seconds = this->View.TimeFrame();
  return { 1e3 * seconds, 1e3 * (GetProcessorSeconds() - start) };
}
