// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerScaleBar.h"

#include "Text/ViewerText.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cmath>

namespace
{
// In pixels.
const int ScaleBarMargin = 16;
const int Tick = 5;
const double LongestShare = 0.2; // relative to the picture's width
}

//------------------------------------------------------------------------------
double GetPixelLength(vtkCamera* camera, int height)
{
  const double half = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return 2.0 * half / height;
}

//------------------------------------------------------------------------------
double GetRoundLength(double longest)
{
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  const double digit = longest / power;
  return (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0) * power;
}

//------------------------------------------------------------------------------
ViewerScaleBar::ViewerScaleBar(vtkRenderer* renderer, const std::string& unit)
  : Renderer(renderer)
  , Unit(unit)
  , Text(MakeText())
{
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1, 2, 3 });
  this->Points->SetNumberOfPoints(4);
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(this->Points);
  shape->SetLines(line);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  this->Bar->SetMapper(mapper);
  this->Bar->GetProperty()->SetColor(0.1, 0.1, 0.1);
  this->Bar->GetProperty()->SetLineWidth(2.0f);
  this->Text->GetTextProperty()->SetJustificationToCentered();
  renderer->AddViewProp(this->Bar);
  renderer->AddViewProp(this->Text);
  this->Tag = renderer->AddObserver(vtkCommand::StartEvent, this, &ViewerScaleBar::OnStart);
}

//------------------------------------------------------------------------------
ViewerScaleBar::~ViewerScaleBar()
{
  this->Renderer->RemoveViewProp(this->Bar);
  this->Renderer->RemoveViewProp(this->Text);
  this->Renderer->RemoveObserver(this->Tag);
}

//------------------------------------------------------------------------------
void ViewerScaleBar::OnStart(vtkObject* caller, unsigned long, void*)
{
  auto* renderer = static_cast<vtkRenderer*>(caller);
  const int* size = renderer->GetSize();
  const double pixel = GetPixelLength(renderer->GetActiveCamera(), size[1]);
  const double longest = LongestShare * size[0] * pixel;
  const bool isShown = std::isnormal(longest) && longest > 0.0;
  this->Bar->SetVisibility(isShown);
  this->Text->SetVisibility(isShown);
  if (!isShown)
  {
    return;
  }
  const double length = GetRoundLength(longest);
  const double right = size[0] - ScaleBarMargin;
  const double left = right - length / pixel;
  this->Points->SetPoint(0, left, ScaleBarMargin + Tick, 0.0);
  this->Points->SetPoint(1, left, ScaleBarMargin, 0.0);
  this->Points->SetPoint(2, right, ScaleBarMargin, 0.0);
  this->Points->SetPoint(3, right, ScaleBarMargin + Tick, 0.0);
  this->Points->Modified();
  this->Text->SetInput(this->GetText(length).c_str());
  this->Text->SetPosition(0.5 * (left + right), ScaleBarMargin + 2 * Tick);
}

//------------------------------------------------------------------------------
std::string ViewerScaleBar::GetText(double length) const
{
  const bool isFar = this->Unit == "m" && length >= 1000.0;
  const double shown = isFar ? 0.001 * length : length;
  return FormatNumber(shown, shown) + (this->Unit.empty() ? "" : (isFar ? " k" : " ") + this->Unit);
}
