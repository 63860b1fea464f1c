// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/VariantPainter.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkPoints.h"
#include "vtkShaderProperty.h"

#include <type_traits>

namespace relevo
{
VariantPainter::VariantPainter(int numberOfVariants)
  : Variants(numberOfVariants)
{
  for (int variant = 0; variant < numberOfVariants; ++variant)
  {
    this->Variants.GetHelper(variant).PrimitiveType = PrimitiveTris;
  }
  this->ScalarVisibility = 0;
  this->PopulateSelectionSettings = 0; // the mapper that owns the painter does this
  this->Box->SetPoints(vtkNew<vtkPoints>());
  this->SetInputData(this->Box);
}

VariantPainter::~VariantPainter() = default;

bool VariantPainter::UpdateProgram(
  vtkOpenGLHelper& helper, const Dependencies& options, vtkRenderer* renderer, vtkActor* actor)
{
  Dependencies sources = options;
  sources.Add(actor->GetShaderProperty()->GetShaderMTime());
  sources.Add(this->GetMTime());
  return this->Variants.Update(
    helper, sources, [&] { this->UpdateShaders(helper, renderer, actor); });
}

bool VariantPainter::IsSelectingCells() const
{
  return this->LastSelectionState == vtkHardwareSelector::CELL_ID_LOW24 ||
    this->LastSelectionState == vtkHardwareSelector::CELL_ID_HIGH24;
}

void VariantPainter::BuildShaders(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Variants.Build(shaders, [&] { this->Superclass::BuildShaders(shaders, renderer, actor); });
}

void VariantPainter::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->PrepareShaders(shaders, actor);
  primitiveInfo& info = this->PrimitiveInfo[this->LastBoundBO];
  const auto complexity = info.LastLightComplexity;
  if (!this->IsLit())
  {
    info.LastLightComplexity = std::decay_t<decltype(complexity)>(0);
  }
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  info.LastLightComplexity = complexity;
  this->FinishShaders(shaders);
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 20260726)
// The fragments know their cells without VTK's geometry shader for primitive ids. Compared with the
// source of VTK after 9.7, but not yet run with it.
bool VariantPainter::FragmentShaderUsesPrimitiveID(vtkRenderer*, vtkActor*)
{
  return false;
}
#endif

void VariantPainter::ProcessSelectorPixelBuffers(
  vtkHardwareSelector*, std::vector<unsigned int>&, vtkProp*)
{
}

void VariantPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Variants.ReleaseGraphicsResources(window);
}
}
