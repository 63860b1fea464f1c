// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Controls/ControlList.h"

#include "Controls/ControlNumbers.h"
#include "Controls/ControlTable.h"
#include "Options/UsageError.h"
#include "State/StudioState.h"

#include "vtkArrayQuantityFilter.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
const double StepsPerDegree = 100.0; // of directions in the panel

// Names of vectors and tensors are followed by their quantities.
std::vector<std::string> ListQuantities(const SceneContent& content)
{
  std::vector<std::string> names;
  vtkNew<vtkStringArray> quantities;
  for (const SceneArray& array : content.Arrays)
  {
    names.push_back(array.Name);
    vtkArrayQuantityFilter::ListQuantities(
      array.Name.c_str(), array.NumberOfComponents, quantities);
    for (vtkIdType i = 0; i < quantities->GetNumberOfValues(); ++i)
    {
      names.push_back(quantities->GetValue(i));
    }
  }
  return names;
}

// The arrays for an option.
std::vector<std::string> ListVectors(const SceneContent& content, const std::string& option)
{
  std::vector<std::string> names;
  for (const SceneArray& array : content.Arrays)
  {
    const int number = array.NumberOfComponents;
    const bool isUsable = option == "warp" ? array.IsOfPoints && number == 3
      : option == "lic"                    ? number == 2 || number == 3
      : option == "integration-points"     ? array.HasIntegrationPoints
                                           : number == 3;
    if (isUsable)
    {
      names.push_back(array.Name);
    }
  }
  return names;
}

// Whether a control changes colours by values.
bool NeedsRange(const std::string& name)
{
  static const std::set<std::string> names = { "above", "below", "extremes", "log", "palette",
    "range" };
  return names.count(name) > 0;
}

std::string GetSampleText(const std::string& name, bool isTerrain)
{
  static const std::map<std::string, std::string> texts = { { "imagery-bands", "1,1,1" },
    { "no-data-value", "0" }, { "ruler", "0,0,0,1,1,1" }, { "seed-line", "0,0,0,1,1,1" } };
  const auto text = texts.find(name);
  return text != texts.end() ? text->second
    : name == "center"       ? (isTerrain ? "0,0" : "0,0,0")
    : name == "region"       ? (isTerrain ? "0,0,1" : "0,0,0,1")
                             : "x.png";
}

// A value with which the option can be tried.
std::string GetSample(const Control& control, bool isTerrain)
{
  if (control.Value)
  {
    return *control.Value;
  }
  switch (control.Kind)
  {
    case ControlKind::Choice:
      return control.Choices.empty() ? "x" : control.Choices.front();
    case ControlKind::Flag:
      return "on";
    case ControlKind::Plane:
      return "0,0,0,1,0,0";
    case ControlKind::Step:
      return "0";
    case ControlKind::Transfer:
      return "0 0 0 0 0;1 1 1 1 1";
    case ControlKind::Color:
      return "white";
    case ControlKind::Text:
      return GetSampleText(control.Name, isTerrain);
    default:
      break;
  }
  return control.Name == "range" ? "0,1" : control.Start.size() == 2 ? "10,10" : "1";
}
}

//------------------------------------------------------------------------------
ControlList::ControlList()
  : Controls(GetControlTable())
{
  for (const Control& control : this->Controls)
  {
    if (control.Kind != ControlKind::Button && !IsOption(control))
    {
      this->Own[control.Name] = control.Default;
    }
  }
}

//------------------------------------------------------------------------------
bool ControlList::IsOption(const Control& control)
{
  static const std::set<std::string> others = { "compare-method", "compare-options",
    "difference-gain", "loop", "mesh-name", "panels-in-pictures", "pattern-levels", "pattern-name",
    "picture-name", "script-name", "session-name", "show-difference", "source-name", "table-name" };
  return control.Kind != ControlKind::Button && others.count(control.Name) == 0;
}

//------------------------------------------------------------------------------
const Control* ControlList::Find(const std::string& name) const
{
  const auto control = std::find_if(this->Controls.begin(), this->Controls.end(),
    [&](const Control& candidate) { return candidate.Name == name; });
  return control == this->Controls.end() ? nullptr : &*control;
}

//------------------------------------------------------------------------------
std::string ControlList::GetOwn(const std::string& name) const
{
  const auto value = this->Own.find(name);
  return value == this->Own.end() ? "" : value->second;
}

//------------------------------------------------------------------------------
void ControlList::SetOwn(const std::string& name, const std::string& value)
{
  this->Own[name] = value;
}

//------------------------------------------------------------------------------
bool ControlList::IsComparing() const
{
  for (const char* name : { "compare-method", "compare-options" })
  {
    if (this->GetOwn(name) != this->Find(name)->Default)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void ControlList::Update(const StudioState& state, const SceneContent& content)
{
  const std::array<int, 2> versions = { { state.GetVersion(), content.Version } };
  const bool isOutOfDate = versions != this->Versions;
  this->Versions = versions;
  for (Control& control : this->Controls)
  {
    if (!IsOption(control))
    {
      this->UpdateOwn(control, state, content);
    }
    else
    {
      control.Value = state.Get().Get(control.Name);
      this->FindRange(control, content);
      if (isOutOfDate)
      {
        control.Reason.clear();
        this->FindChoices(control, content);
        this->FindReason(control, state.Get(), content);
      }
    }
    control.IsEnabled = control.Reason.empty();
  }
}

//------------------------------------------------------------------------------
void ControlList::UpdateOwn(Control& control, const StudioState& state, const SceneContent& content)
{
  static const std::set<std::string> ofTime = { "loop", "play", "range-all", "step-back",
    "step-forward" };
  const std::string& name = control.Name;
  if (control.Kind != ControlKind::Button)
  {
    const std::string value = this->GetOwn(name);
    const bool isDefault = value == control.Default;
    const bool hasNone = control.Kind == ControlKind::Flag || control.Kind == ControlKind::Choice;
    control.Value = isDefault && hasNone ? std::nullopt : std::optional<std::string>(value);
  }
  const bool isOfDifference = name == "show-difference" || name == "difference-gain";
  control.Reason = name == "undo" && !state.CanUndo() ? "nothing has been changed"
    : name == "redo" && !state.CanRedo()              ? "nothing has been undone"
    : name == "measure"                               ? this->Find("ruler")->Reason
    : name == "forget-probe" && !this->HasProbe       ? "no values are kept"
    : ofTime.count(name) && content.Times.size() < 2  ? "the file has no time steps"
    : isOfDifference && !this->IsComparing()
    ? "there is no second view; set compare-method or compare-options"
    : "";
}

//------------------------------------------------------------------------------
void ControlList::FindChoices(Control& control, const SceneContent& content) const
{
  if (control.Name == "array")
  {
    control.Choices = ListQuantities(content);
  }
  else if (control.Name == "warp" || control.Name == "lic" || control.Name == "streamlines" ||
    control.Name == "integration-points")
  {
    control.Choices = ListVectors(content, control.Name);
  }
  else if (control.Name == "volume")
  {
    control.Choices = ListQuantities(content);
  }
}

//------------------------------------------------------------------------------
void ControlList::FindRange(Control& control, const SceneContent& content) const
{
  const std::string& name = control.Name;
  if ((name == "range" || name == "isosurfaces") && content.Range && !control.Value)
  {
    const std::array<double, 2>& range = *content.Range;
    control.Ranges = { range };
    control.Start = name == "range" ? std::vector<double>{ range[0], range[1] }
                                    : std::vector<double>{ 0.5 * (range[0] + range[1]) };
  }
  const auto& direction = name == "light" ? content.Light : content.View;
  if (direction && (name == "light" || name == "view"))
  {
    control.Current.clear();
    for (double degrees : *direction)
    {
      control.Current.push_back(std::round(degrees * StepsPerDegree) / StepsPerDegree);
    }
    if (name == "view" && content.IsViewMoved)
    {
      control.Value = WriteNumbers(control.Current);
    }
  }
  if (!content.Bounds)
  {
    return;
  }
  const std::array<double, 6>& bounds = *content.Bounds;
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  if (name == "unit-distance")
  {
    control.Ranges = { { { 1e-3 * diagonal, diagonal } } };
    control.Start = { content.UnitDistance };
  }
  else if (name == "amplitude" || name == "offset")
  {
    control.Ranges = { { { name == "offset" ? -0.2 * diagonal : 0.0, 0.2 * diagonal } } };
    control.Start = { name == "offset" ? 0.0 : 0.03 * diagonal };
  }
  else if (name == "reach")
  {
    control.Ranges = { { { 0.01 * diagonal, 30.0 * diagonal } } };
    control.Start = { 3.0 * diagonal };
  }
}

//------------------------------------------------------------------------------
void ControlList::FindReason(
  Control& control, const OptionValues& values, const SceneContent& content) const
{
  const std::string& name = control.Name;
  const bool isTerrain = !content.Bounds;
  OptionValues tried = values;
  tried.Choose(name, GetSample(control, isTerrain));
  try
  {
    tried.Parse();
  }
  catch (const UsageError& error)
  {
    control.Reason = error.what();
    return;
  }
  if (control.Kind == ControlKind::Choice && control.Choices.empty())
  {
    control.Reason = name == "warp"  ? "the file has no point array of 3 components"
      : name == "lic"                ? "the file has no array of 2 or 3 components"
      : name == "streamlines"        ? "the file has no array of 3 components"
      : name == "integration-points" ? "the file has no values at integration points"
                                     : "the file has no arrays";
  }
  else if (name == "time" && content.Times.size() < 2)
  {
    control.Reason = "the file has no time steps";
  }
  else if ((name == "volume" || name == "streamlines") && !content.HasSolidCells)
  {
    control.Reason = "the file has no 3D cells";
  }
  else if (NeedsRange(name) && !content.Range)
  {
    control.Reason = "no array and no heights colour the picture";
  }
}
