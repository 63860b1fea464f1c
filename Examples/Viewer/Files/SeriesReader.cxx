// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SeriesReader.h"

#include "FileEnd.h"
#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

#include "vtk_jsoncpp.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <fstream>

//------------------------------------------------------------------------------
SeriesReader::SeriesReader(
  const std::string& fileName, ViewerMessages& messages, const Opener& open)
  : Messages(messages)
  , Open(open)
{
  std::ifstream file(fileName);
  Json::Value root;
  std::string errors;
  if (!Json::parseFromStream(Json::CharReaderBuilder(), file, &root, &errors) || !root.isObject() ||
    !root["files"].isArray())
  {
    throw ViewerError("it is not JSON with a list of files");
  }
  const std::string folder = vtksys::SystemTools::GetFilenamePath(fileName);
  int number = 0;
  for (const Json::Value& entry : root["files"])
  {
    ++number;
    if (!entry.isObject() || !entry["name"].isString() || entry["name"].asString().empty())
    {
      throw ViewerError("entry " + std::to_string(number) + " of its files has no name");
    }
    const std::string name = entry["name"].asString();
    // Without times, steps are counted.
    const Json::Value time = entry.isMember("time") ? entry["time"] : Json::Value(number - 1);
    if (!time.isNumeric() || !std::isfinite(time.asDouble()))
    {
      throw ViewerError("the time of " + name + " is not a number");
    }
    const bool isWhole = vtksys::SystemTools::FileIsFullPath(name) || folder.empty();
    this->Files[time.asDouble()] = isWhole ? name : folder + "/" + name;
  }
  if (this->Files.empty())
  {
    throw ViewerError("it lists no files");
  }
}

//------------------------------------------------------------------------------
std::vector<double> SeriesReader::GetTimes()
{
  std::vector<double> times;
  for (const auto& step : this->Files)
  {
    times.push_back(step.first);
  }
  return times;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> SeriesReader::Read(const std::optional<double>& time)
{
  const std::string& name = this->Files.at(time.value_or(this->Files.begin()->first));
  CheckFile(name);
  try
  {
    if (GetExtension(name) == ".series")
    {
      throw ViewerError("a series cannot list another one");
    }
    CheckFileEnd(name, [this](const std::string& text) { this->Messages.Warn(text); });
    return this->Open(name, this->Messages)->Read({});
  }
  catch (const std::exception&)
  {
    ThrowReadingError(name);
  }
}
