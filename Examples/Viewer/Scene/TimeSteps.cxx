// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TimeSteps.h"

#include "Options/ViewerOptions.h"
#include "Text/StandardError.h"
#include "Text/ViewerMessages.h"

#include "vtkCoordinate.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <sstream>

namespace
{
const int FontSize = 16;
const double GroundOpacity = 0.4;
const double LabelPlace = 0.98; // share of the picture, from the lower left corner

std::string ToText(double time)
{
  std::ostringstream text;
  text << time;
  return text.str();
}
}

//------------------------------------------------------------------------------
TimeSteps::TimeSteps(const ViewerOptions& options, vtkRenderer* renderer, ViewerMessages& messages)
  : File(options.Input, messages)
  , Filter({ options.Warp, options.Warp.empty() ? 1.0 : options.Scale.value_or(1.0) },
      options.IsVolume ? options.VolumeArray : options.Array, options.IntegrationPoints)
  , Step(this->File.FindStep(options.Time))
{
  if (options.IsSeries() && this->GetNumber() == 0)
  {
    throw ViewerError(
      options.Input + " has no time steps, which --output " + options.Output + " would number");
  }
  vtkTextProperty* text = this->Label->GetTextProperty();
  text->SetColor(0.1, 0.1, 0.1);
  text->SetFontSize(FontSize);
  text->SetBackgroundColor(1.0, 1.0, 1.0);
  text->SetBackgroundOpacity(GroundOpacity);
  text->SetJustificationToRight();
  text->SetVerticalJustificationToTop();
  this->Label->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Label->SetPosition(LabelPlace, LabelPlace);
  if (this->GetNumber() < 2)
  {
    return;
  }
  if (options.Legend)
  {
    renderer->AddViewProp(this->Label);
  }
  this->SetStep(this->Step);
  const std::vector<double>& times = this->File.GetTimes();
  if (options.Time && (*options.Time < times.front() || *options.Time > times.back()))
  {
    messages.Warn("--time " + ToText(*options.Time) + " is outside of the file's times");
  }
  if (!options.IsSeries())
  {
    messages.Tell("time step " + std::to_string(this->Step + 1) + " of " +
      std::to_string(this->GetNumber()) + ", time " + ToText(times[this->Step]) + " of " +
      ToText(times.front()) + " to " + ToText(times.back()) +
      (options.Time ? "" : "; --time T draws another"));
  }
}

//------------------------------------------------------------------------------
TimeSteps::~TimeSteps() = default;

//------------------------------------------------------------------------------
void TimeSteps::SetStep(int step)
{
  this->Step = step;
  this->Label->SetInput(("time " + ToText(this->File.GetTimes()[step])).c_str());
}

//------------------------------------------------------------------------------
std::string TimeSteps::Change(char key, const std::function<void(int)>& show)
{
  const int shown = this->Step;
  const int step = shown + (key == '>' ? 1 : key == '<' ? -1 : 0);
  if (step == shown || step < 0 || step >= this->GetNumber())
  {
    return "";
  }
  try
  {
    show(step);
    return this->GetOption();
  }
  catch (const ViewerError& error)
  {
    WriteMessage("error", error.what());
    show(shown);
    return "";
  }
}

//------------------------------------------------------------------------------
std::string TimeSteps::GetOption() const
{
  return "--time " + ToText(this->File.GetTimes()[this->Step]);
}
