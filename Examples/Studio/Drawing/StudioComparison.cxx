// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/StudioComparison.h"

#include "Options/UsageError.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkImageMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <sstream>

//------------------------------------------------------------------------------
StudioComparison::StudioComparison(vtkRenderWindow* window, StudioScene& first, bool isComplete)
  : Window(window)
  , First(first)
  , IsComplete(isComplete)
{
  this->Image->SetDimensions(1, 1, 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkImageMapper> mapper;
  mapper->SetInputData(this->Image);
  mapper->SetColorWindow(255.0);
  mapper->SetColorLevel(127.5);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddViewProp(actor);
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  this->Renderer->InteractiveOff();
  // Both views are drawn before this one.
  this->Renderer->AddObserver(vtkCommand::StartEvent, this, &StudioComparison::ShowDifference);
}

//------------------------------------------------------------------------------
StudioComparison::~StudioComparison()
{
  this->Window->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
OptionValues StudioComparison::FindValues(const Request& request) const
{
  OptionValues values = this->First.GetValues();
  if (!request.Method.empty())
  {
    values.Set("method", request.Method);
  }
  std::istringstream options(request.Options);
  for (std::string option; std::getline(options, option, ';');)
  {
    const std::size_t equals = option.find('=');
    const std::string name = option.substr(0, equals);
    if (!IsFlag(name) && equals == std::string::npos)
    {
      throw UsageError("compare-options needs options such as max-level=2;metric=distance, not '" +
        request.Options + "'");
    }
    for (const char* other : { "center", "size", "view", "zoom" })
    {
      if (name == other)
      {
        throw UsageError("compare-options cannot have " + name + ": both views share the camera");
      }
    }
    values.Choose(name, equals == std::string::npos ? "on" : option.substr(equals + 1));
  }
  values.Parse();
  CheckForStudio(values);
  return values;
}

//------------------------------------------------------------------------------
void StudioComparison::Apply(const Request& request)
{
  if (!request.IsOn())
  {
    if (this->Second)
    {
      this->Second.reset();
      this->Shown = request;
      this->SetColumns();
    }
    return;
  }
  const OptionValues values = this->FindValues(request);
  if (this->Second)
  {
    this->Second->Apply(values);
  }
  else
  {
    this->Second = std::make_unique<StudioScene>(this->Window, values, this->IsComplete);
    this->Second->SetPanelWidth(this->First.GetPanelWidth());
  }
  const std::array<vtkRenderer*, 2> renderers = { { this->First.Get().GetRenderer(),
    this->Second->Get().GetRenderer() } };
  if (request == this->Shown &&
    std::equal(renderers.begin(), renderers.end(), this->Renderers.begin()))
  {
    return;
  }
  this->Second->ShareCamera(renderers[0]->GetActiveCamera());
  this->Shown = request;
  this->Renderer->Modified(); // another gain needs a frame of the scene
  if (renderers[0] != this->Renderers[0])
  {
    renderers[0]->AddObserver(vtkCommand::StartEvent, this, &StudioComparison::DrawInFirstPlace);
    renderers[0]->AddObserver(vtkCommand::EndEvent, this, &StudioComparison::Measure);
  }
  std::copy(renderers.begin(), renderers.end(), this->Renderers.begin());
  this->SetColumns();
}

//------------------------------------------------------------------------------
void StudioComparison::SetColumns()
{
  const bool isShown = this->Second && !this->IsHidden;
  const int number = !isShown ? 1 : this->Shown.HasDifference ? 3 : 2;
  this->First.SetColumn(0, number);
  this->Window->RemoveRenderer(this->Renderer);
  if (!this->Second)
  {
    return;
  }
  this->Second->Get().GetRenderer()->SetDraw(isShown);
  this->Second->SetColumn(number > 1 ? 1 : 0, number);
  if (number == 3)
  {
    const std::array<double, 4> viewport = this->First.GetColumnViewport(2);
    this->Renderer->SetViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    this->Window->AddRenderer(this->Renderer); // the last one
  }
}

//------------------------------------------------------------------------------
void StudioComparison::SetPanelWidth(int width)
{
  this->First.SetPanelWidth(width);
  if (this->Second)
  {
    this->Second->SetPanelWidth(width);
    const std::array<double, 4> viewport = this->First.GetColumnViewport(2);
    this->Renderer->SetViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  }
}

//------------------------------------------------------------------------------
void StudioComparison::SetHidden(bool hidden)
{
  if (hidden != this->IsHidden)
  {
    this->IsHidden = hidden;
    this->SetColumns();
  }
}

//------------------------------------------------------------------------------
void StudioComparison::CheckFrame()
{
  this->First.CheckFrame();
  if (this->Second)
  {
    this->Second->CheckFrame();
  }
}

//------------------------------------------------------------------------------
void StudioComparison::DrawInFirstPlace()
{
  if (!this->Second || this->IsHidden)
  {
    return;
  }
  vtkRenderer* renderer = this->Second->Get().GetRenderer();
  const auto place = [&](int column)
  {
    const std::array<double, 4> viewport = this->First.GetColumnViewport(column);
    renderer->SetViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  };
  place(0);
  renderer->Render();
  this->Difference.Read(1, this->Window, this->First.GetColumnSize());
  place(1);
}

//------------------------------------------------------------------------------
void StudioComparison::Measure()
{
  if (!this->Second || this->IsHidden)
  {
    return;
  }
  this->Difference.Read(0, this->Window, this->First.GetColumnSize());
  this->Difference.Compare();
}

//------------------------------------------------------------------------------
void StudioComparison::ShowDifference()
{
  if (this->Second)
  {
    this->Difference.Draw(this->Shown.Gain, this->Image);
  }
}

//------------------------------------------------------------------------------
SceneFigures StudioComparison::MeasureFrame()
{
  if (!this->Second || this->IsHidden)
  {
    return {};
  }
  SceneFigures figures;
  for (const auto& figure : this->Second->GetFigures())
  {
    figures.emplace_back("second-" + figure.first, figure.second);
  }
  figures.emplace_back("ssim", this->Difference.GetSimilarity());
  figures.emplace_back(
    "different-pixels", static_cast<double>(this->Difference.GetNumberOfDifferentPixels()));
  return figures;
}
