// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoLICView.h"

#include "vtkMath.h"

#include <cmath>

RelevoLICView::RelevoLICView()
{
  RelevoScene::NewMapper = RelevoLICVectors::NewVisible;
  this->Scene = std::make_shared<RelevoScene>(RelevoScene::Refining);
}

vtkActor* RelevoLICView::Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe)
{
  this->Actor = this->Scene->Add(mesh, recipe);
  this->Mapper = RelevoLICVectors::GetMapper(this->Actor);
  return this->Actor;
}

void RelevoLICView::LookDown(double scale, int pixels)
{
  this->Scene->Window->SetSize(pixels, pixels);
  vtkCamera* camera = this->Scene->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(0, 0, 5);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  camera->SetParallelScale(scale);
  this->Scene->Renderer->ResetCameraClippingRange();
}

RelevoPicture RelevoLICView::Draw()
{
  this->Scene->Render();
  return RelevoPicture(this->Scene->Window);
}

RelevoPicture RelevoLICView::DrawColors()
{
  this->Mapper->EnableOff();
  RelevoPicture picture = this->Draw();
  this->Mapper->EnableOn();
  return picture;
}

RelevoPicture RelevoLICView::DrawLIC()
{
  const double intensity = this->Mapper->GetLICIntensity();
  const double maskIntensity = this->Mapper->GetMaskIntensity();
  const int mode = this->Mapper->GetLICInterface()->GetColorMode();
  const int contrast = this->Mapper->GetEnhanceContrast();
  Color maskColor;
  this->Mapper->GetMaskColor(maskColor.data());
  this->Mapper->SetLICIntensity(1.0);
  this->Mapper->SetMaskIntensity(1.0);
  this->Mapper->SetMaskColor(1, 0, 0);
  this->Mapper->SetColorModeToBlend();
  if (contrast == vtkAdaptiveLICMapper::ENHANCE_CONTRAST_COLOR)
  {
    this->Mapper->SetEnhanceContrastToOff();
  }
  RelevoPicture picture = this->Draw();
  this->Mapper->SetLICIntensity(intensity);
  this->Mapper->SetMaskIntensity(maskIntensity);
  this->Mapper->SetMaskColor(maskColor.data());
  this->Mapper->GetLICInterface()->SetColorMode(mode);
  this->Mapper->SetEnhanceContrast(contrast);
  return picture;
}

bool RelevoLICView::Compare(RelevoComparison& comparison, const std::string& name,
  const RelevoTolerance& tolerance, const Formula& formula, const Formula& ofMasked)
{
  const RelevoPicture colors = this->DrawColors();
  const RelevoPicture lic = this->DrawLIC();
  const RelevoPicture actual = this->Draw();
  RelevoPicture expected = colors;
  size_t masked = 0;
  size_t shown = 0;
  for (size_t i = 0; i < colors.GetNumberOfPixels(); ++i)
  {
    const Color color = At(colors, i);
    const Color grey = At(lic, i);
    if (colors.Depths[i] == 1.0f || grey == color)
    {
      continue;
    }
    const bool isMasked = IsMasked(grey);
    ++(isMasked ? masked : shown);
    const Color result = !isMasked ? formula(color, grey[0])
      : ofMasked                   ? ofMasked(color, 0.0)
                                   : color;
    for (int c = 0; c < 3; ++c)
    {
      // Colours above the displayable range are mixed before they are clamped.
      expected.Colors[3 * i + c] = color[c] < 1.0
        ? static_cast<unsigned char>(std::lround(255.0 * vtkMath::ClampValue(result[c], 0.0, 1.0)))
        : actual.Colors[3 * i + c];
    }
  }
  const size_t least = colors.GetNumberOfPixels() / 20;
  if (shown < least || (ofMasked && masked < least))
  {
    return comparison.Fail(name + ": the picture is almost empty");
  }
  return comparison.Compare(name, tolerance, actual, expected);
}

RelevoLICView::Color RelevoLICView::At(const RelevoPicture& picture, size_t pixel)
{
  return { { picture.Colors[3 * pixel] / 255.0, picture.Colors[3 * pixel + 1] / 255.0,
    picture.Colors[3 * pixel + 2] / 255.0 } };
}

RelevoLICView::Color RelevoLICView::Mix(const Color& a, const Color& b, double share)
{
  Color result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = a[i] * (1.0 - share) + b[i] * share;
  }
  return result;
}
