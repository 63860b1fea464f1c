// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerScene.h"

#include "Code/RendererCode.h"
#include "Legend/LegendText.h"
#include "Legend/ViewerLegend.h"
#include "Options/ViewerArguments.h"
#include "Scene/PictureMarks.h"
#include "Scene/ViewerCamera.h"
#include "Text/ViewerText.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

//------------------------------------------------------------------------------
ViewerScene::ViewerScene(const ViewerOptions& options, ViewerMessages& messages)
  : Options(options)
  , Messages(messages)
{
  std::copy_n(options.Size, 2, this->ViewSize.begin());
  this->Camera = std::make_unique<ViewerCamera>(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.86, 0.90, 0.94);
  this->Renderer->SetBackground2(0.42, 0.58, 0.78);
}

//------------------------------------------------------------------------------
ViewerScene::~ViewerScene() = default;

//------------------------------------------------------------------------------
std::string ViewerScene::ChangeByKey(char key)
{
  const std::string change = this->Change(key);
  const std::size_t space = change.find(' ');
  if (change.compare(0, 2, "--") == 0 && space != std::string::npos)
  {
    this->Changes[change.substr(0, space)] = change.substr(space + 1);
  }
  return change;
}

//------------------------------------------------------------------------------
void ViewerScene::AddCode(SceneCode& code, const std::array<int, 2>& size)
{
  if (!this->Options.Relief) // reliefs have replaced the surface
  {
    this->AddDataCode(code);
  }
  AddRendererCode(code, this->Renderer, size,
    [&](vtkProp* prop) { return this->Legend && this->Legend->AddCode(code, prop); });
  AddPictureCode(code, this->Renderer);
}

//------------------------------------------------------------------------------
void ViewerScene::AddLegend(vtkScalarsToColors* table, const std::string& name,
  const std::string& unit, int numberOfLabels, const std::optional<double>& mark)
{
  if (this->Options.Legend)
  {
    this->Legend = std::make_unique<ViewerLegend>(
      this->Renderer, table, MakeLegendTitle(name, unit), numberOfLabels, mark);
  }
}

//------------------------------------------------------------------------------
void ViewerScene::FitView(vtkPoints* points, const ViewerDirection& defaultDirection)
{
  ViewerDirection direction = defaultDirection;
  if (this->Options.View)
  {
    direction.Azimuth = (*this->Options.View)[0];
    // Avoids exactly vertical views by less than a pixel, so that the azimuth points upwards in the
    // picture.
    direction.Elevation = std::clamp((*this->Options.View)[1], -89.9999, 89.9999);
  }
  this->ViewAxis = direction.UpAxis;
  ViewerPicture picture;
  picture.Size = this->ViewSize;
  if (this->Legend)
  {
    picture.Corner = this->Legend->GetCorner(this->ViewSize.data());
  }
  FitCamera(this->Renderer, points, direction, picture);
}

//------------------------------------------------------------------------------
std::string ViewerScene::ShowRuler(
  const std::array<double, 3>& first, const std::array<double, 3>& second)
{
  if (!this->Ruler)
  {
    this->Ruler = std::make_unique<PictureMarks>(this->Renderer);
  }
  this->Ruler->Clear();
  std::ostringstream text;
  text.precision(5);
  text << std::sqrt(vtkMath::Distance2BetweenPoints(first.data(), second.data()));
  text << (this->GetUnit().empty() ? "" : " ") << this->GetUnit();
  this->Ruler->AddLine(first, second, text.str());
  return "--ruler " +
    JoinNumbers({ first[0], first[1], first[2], second[0], second[1], second[2] }) + "  length " +
    text.str();
}

//------------------------------------------------------------------------------
void ViewerScene::HideRuler()
{
  this->Ruler.reset();
}

//------------------------------------------------------------------------------
std::string ViewerScene::ShowPlanView(char key)
{
  static const std::array<const char*, 6> names = { { "front", "back", "left", "right", "top",
    "bottom" } };
  double bounds[6];
  this->Renderer->ComputeVisiblePropBounds(bounds);
  if (key < '1' || key > '6' || !vtkMath::AreBoundsInitialized(bounds))
  {
    return "";
  }
  const char* name = names[static_cast<std::size_t>(key - '1')];
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners->InsertNextPoint(bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)]);
  }
  this->Options.View = FindPlanView(name);
  std::copy_n(this->Renderer->GetSize(), 2, this->ViewSize.begin());
  this->FitView(corners, { 0.0, 0.0, this->Options.UpAxis });
  return std::string("--view ") + name;
}

//------------------------------------------------------------------------------
void ViewerScene::SetView(const double bounds[6])
{
  const int up = this->Options.UpAxis;
  this->SetLights({ { { 250.0, 45.0, up }, 0.95 }, { { 150.0, 15.0, up }, 0.45 } });
  this->ViewBounds.emplace();
  std::copy_n(bounds, 6, this->ViewBounds->begin());
  this->ResetView();
}

//------------------------------------------------------------------------------
void ViewerScene::ResetView()
{
  if (!this->ViewBounds)
  {
    return;
  }
  const std::array<double, 6>& bounds = *this->ViewBounds;
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners->InsertNextPoint(bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)]);
  }
  this->FitView(corners, { 205.0, 20.0, this->Options.UpAxis });
  if (this->Options.Center)
  {
    const std::vector<double>& place = *this->Options.Center;
    MoveFocus(this->Renderer, { { place[0], place[1], place[2] } });
  }
  this->Zoom();
}

//------------------------------------------------------------------------------
void ViewerScene::Zoom()
{
  this->Renderer->GetActiveCamera()->Dolly(this->Options.Zoom);
  this->Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void ViewerScene::SetLights(std::vector<ViewerLamp> lamps)
{
  this->Lamps = lamps;
  if (this->Options.Light)
  {
    const double turn = (*this->Options.Light)[0] - lamps.front().From.Azimuth;
    for (ViewerLamp& lamp : lamps)
    {
      lamp.From.Azimuth += turn;
    }
    lamps.front().From.Elevation = (*this->Options.Light)[1];
  }
  for (const ViewerLamp& lamp : lamps)
  {
    AddLight(this->Renderer, lamp);
  }
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> ViewerScene::GetLight() const
{
  if (this->Options.Globe || this->Lamps.empty())
  {
    return std::nullopt;
  }
  const ViewerDirection& from = this->Lamps.front().From;
  return this->Options.Light.value_or(std::array<double, 2>{ { from.Azimuth, from.Elevation } });
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> ViewerScene::GetView()
{
  if (this->Options.Globe)
  {
    return std::nullopt;
  }
  const double* forward = this->Renderer->GetActiveCamera()->GetDirectionOfProjection();
  const ViewerDirection direction =
    FindViewerDirection({ { -forward[0], -forward[1], -forward[2] } }, this->ViewAxis);
  return { { { direction.Azimuth, direction.Elevation } } };
}

//------------------------------------------------------------------------------
OptionNames ViewerScene::GetUpdatedOptions()
{
  return { "--center", "--light", "--view", "--zoom" };
}

//------------------------------------------------------------------------------
bool ViewerScene::Update(const ViewerOptions& options, const OptionNames& changed)
{
  const OptionNames possible = this->GetUpdatedOptions();
  if (!std::includes(possible.begin(), possible.end(), changed.begin(), changed.end()))
  {
    return false;
  }
  const ViewerOptions old = this->Options;
  CopyOptions(options, changed, this->Options);
  try
  {
    if (this->ApplyOptions(changed))
    {
      return true;
    }
    this->Options = old;
    return false;
  }
  catch (const ViewerError&)
  {
    this->Options = old;
    this->ApplyOptions(changed);
    throw;
  }
}

//------------------------------------------------------------------------------
bool ViewerScene::ApplyOptions(const OptionNames& changed)
{
  if (changed.count("--light"))
  {
    this->Renderer->RemoveAllLights();
    this->SetLights(this->Lamps);
  }
  if (changed.count("--center") || changed.count("--view") || changed.count("--zoom"))
  {
    this->ResetView();
  }
  return true;
}
