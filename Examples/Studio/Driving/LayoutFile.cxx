// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Driving/LayoutFile.h"

#include "Files/AtomicFile.h"
#include "Text/ViewerMessages.h"

#include "vtk_jsoncpp.h"

#include <cmath>

//------------------------------------------------------------------------------
void WriteLayout(const std::string& fileName, const LayoutList& layout, const SceneFigures& figures)
{
  Json::Value list(Json::arrayValue);
  for (const LayoutEntry& entry : layout.Get())
  {
    Json::Value item;
    item["name"] = entry.Name;
    item["kind"] = entry.Kind;
    item["value"] = entry.Value;
    item["default"] = entry.Default;
    item["unit"] = entry.Unit;
    item["enabled"] = entry.IsEnabled;
    item["visible"] = entry.IsVisible;
    item["focused"] = entry.IsFocused;
    if (!entry.IsEnabled)
    {
      item["reason"] = entry.Reason;
    }
    if (entry.HasRange)
    {
      item["range"].append(entry.Range[0]);
      item["range"].append(entry.Range[1]);
    }
    for (const double number : entry.Rectangle)
    {
      item["rectangle"].append(std::round(number));
    }
    list.append(item);
  }
  for (const auto& figure : figures)
  {
    Json::Value item;
    item["name"] = "figure-" + figure.first;
    item["kind"] = "figure";
    item["value"] = figure.second;
    list.append(item);
  }
  Json::StreamWriterBuilder builder;
  builder["indentation"] = " ";
  const std::string error =
    relevo::AtomicFile::Write(fileName, Json::writeString(builder, list) + "\n");
  if (!error.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + error);
  }
}
