// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/SessionFile.h"

#include "Files/AtomicFile.h"
#include "Options/UsageError.h"
#include "Text/ViewerMessages.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>
#include <vector>

namespace
{
const int SessionVersion = 1;
const std::size_t LargestSession = 1 << 20; // bytes

// The options with the name of a file to read.
const std::set<std::string> FileOptions = { "--against", "--flight", "--height", "--image",
  "--imagery", "--transfer" };

// A transfer function can also be the nodes themselves.
bool IsFile(const std::string& option, const std::string& value)
{
  const bool isList = option == "--transfer" && value.find(';') != std::string::npos;
  return FileOptions.count(option) > 0 && !isList;
}

class SessionReader
{
public:
  explicit SessionReader(const std::string& fileName)
    : Name(fileName)
    , Folder(std::filesystem::path(fileName).parent_path())
  {
  }

  ViewerSession Read()
  {
    const Json::Value root = this->Parse();
    this->CheckNames(root, "", { "version", "file", "options", "camera" });
    const Json::Value& version = root["version"];
    if (!version.isInt() || version.asInt() < 1)
    {
      this->Throw("version must be " + std::to_string(SessionVersion));
    }
    if (version.asInt() > SessionVersion)
    {
      this->Throw("version is " + std::to_string(version.asInt()) +
        ", and this program reads up to " + std::to_string(SessionVersion));
    }
    ViewerSession session;
    if (!root["file"].isString() || root["file"].asString().empty())
    {
      this->Throw("file must be the name of a file");
    }
    session.Input = this->FindFile(root["file"].asString());
    const Json::Value& options = root["options"];
    if (!options.isNull() && !options.isObject())
    {
      this->Throw("options must be an object");
    }
    for (const std::string& name : options.getMemberNames())
    {
      const std::string option = name.compare(0, 2, "--") == 0 ? name : "--" + name;
      session.Options[option] = this->ReadOption(option, options[name]);
    }
    if (root.isMember("camera"))
    {
      session.Camera = this->ReadCamera(root["camera"]);
    }
    return session;
  }

private:
  [[noreturn]] void Throw(const std::string& problem) const
  {
    throw UsageError("--session " + this->Name + ": " + problem);
  }

  Json::Value Parse() const
  {
    std::error_code error;
    const bool isFile = std::filesystem::is_regular_file(this->Name, error);
    std::ifstream file(this->Name, std::ios::binary);
    if (!isFile || !file)
    {
      this->Throw("the file cannot be read");
    }
    std::string text(LargestSession + 1, '\0');
    file.read(&text[0], static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > LargestSession)
    {
      this->Throw("the file is larger than 1 MiB");
    }
    Json::CharReaderBuilder builder;
    Json::CharReaderBuilder::strictMode(&builder.settings_);
    Json::Value root;
    std::string problem;
    try
    {
      const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
      if (reader->parse(text.data(), text.data() + text.size(), &root, &problem))
      {
        return root;
      }
    }
    catch (const std::exception& exception) // nested too deep
    {
      problem = exception.what();
    }
    std::istringstream lines(problem);
    std::string where, what;
    std::getline(lines, where);
    std::getline(lines, what);
    where = where.compare(0, 2, "* ") == 0 ? where.substr(2) : where;
    what.erase(0, what.find_first_not_of(' '));
    this->Throw("not valid JSON: " + where + (what.empty() ? "" : ": ") + what);
  }

  void CheckNames(
    const Json::Value& object, const std::string& of, const std::set<std::string>& names) const
  {
    if (!object.isObject())
    {
      this->Throw(of.empty() ? "the file must contain an object" : of + " must be an object");
    }
    for (const std::string& name : object.getMemberNames())
    {
      if (names.count(name) == 0)
      {
        this->Throw("unknown name '" + name + "'" + (of.empty() ? "" : " in " + of));
      }
    }
  }

  // A name with a colon can be a part of a file, for GDAL.
  std::string FindFile(const std::string& name) const
  {
    return name.empty() || std::filesystem::path(name).is_absolute() ||
        name.find(':') != std::string::npos
      ? name
      : (this->Folder / name).string();
  }

  std::optional<std::string> ReadOption(const std::string& option, const Json::Value& value) const
  {
    if (value.isBool() && value.asBool())
    {
      return std::nullopt;
    }
    if (value.isString())
    {
      return IsFile(option, value.asString()) ? this->FindFile(value.asString()) : value.asString();
    }
    if (!value.isNumeric())
    {
      this->Throw(option + " must be a text, a number or true");
    }
    std::ostringstream text;
    text.precision(17);
    text << value.asDouble();
    return text.str();
  }

  double ReadNumber(const Json::Value& value, const std::string& what) const
  {
    if (!value.isNumeric() || !std::isfinite(value.asDouble()))
    {
      this->Throw("camera: " + what + " must be a number");
    }
    return value.asDouble();
  }

  std::array<double, 3> ReadVector(const Json::Value& camera, const std::string& name) const
  {
    const Json::Value& value = camera[name];
    if (!value.isArray() || value.size() != 3)
    {
      this->Throw("camera: " + name + " must be three numbers");
    }
    std::array<double, 3> numbers;
    for (Json::ArrayIndex i = 0; i < 3; ++i)
    {
      numbers[i] = this->ReadNumber(value[i], name);
    }
    return numbers;
  }

  SessionCamera ReadCamera(const Json::Value& value) const
  {
    this->CheckNames(value, "camera",
      { "position", "focal-point", "view-up", "view-angle", "parallel-scale", "parallel" });
    SessionCamera camera;
    camera.Position = this->ReadVector(value, "position");
    camera.FocalPoint = this->ReadVector(value, "focal-point");
    camera.ViewUp = this->ReadVector(value, "view-up");
    camera.ViewAngle = this->ReadNumber(value["view-angle"], "view-angle");
    camera.ParallelScale = this->ReadNumber(value["parallel-scale"], "parallel-scale");
    if (!value["parallel"].isBool())
    {
      this->Throw("camera: parallel must be true or false");
    }
    camera.IsParallel = value["parallel"].asBool();
    if (!(camera.ViewAngle > 0.0 && camera.ViewAngle < 180.0))
    {
      this->Throw("camera: view-angle must be more than 0 and less than 180 degrees");
    }
    if (!(camera.ParallelScale > 0.0))
    {
      this->Throw("camera: parallel-scale must be more than 0");
    }
    const std::array<double, 3>& up = camera.ViewUp;
    std::array<double, 3> line;
    for (int i = 0; i < 3; ++i)
    {
      line[i] = camera.FocalPoint[i] - camera.Position[i];
    }
    const double across = std::hypot(line[1] * up[2] - line[2] * up[1],
      line[2] * up[0] - line[0] * up[2], line[0] * up[1] - line[1] * up[0]);
    if (!(across > 0.0) || !std::isfinite(across))
    {
      this->Throw("camera: position, focal-point and view-up define no view");
    }
    return camera;
  }

  const std::string Name;
  const std::filesystem::path Folder;
};

// Relative to the folder of the session if there is such a file.
std::string MakeRelative(const std::string& file, const std::string& session)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error))
  {
    return file;
  }
  const auto folder = std::filesystem::absolute(session, error).parent_path();
  const auto relative =
    std::filesystem::absolute(file, error).lexically_relative(folder.lexically_normal());
  return error || relative.empty() ? file : relative.generic_string();
}

Json::Value ToJSON(const std::array<double, 3>& numbers)
{
  Json::Value value(Json::arrayValue);
  for (const double number : numbers)
  {
    value.append(number);
  }
  return value;
}
}

//------------------------------------------------------------------------------
ViewerSession ReadSession(const std::string& fileName)
{
  return SessionReader(fileName).Read();
}

//------------------------------------------------------------------------------
void WriteSession(const std::string& fileName, const ViewerSession& session)
{
  Json::Value root;
  root["version"] = SessionVersion;
  root["file"] = MakeRelative(session.Input, fileName);
  root["options"] = Json::Value(Json::objectValue);
  for (const auto& option : session.Options)
  {
    Json::Value& value = root["options"][option.first.substr(2)];
    value = true;
    if (option.second)
    {
      value = IsFile(option.first, *option.second) ? MakeRelative(*option.second, fileName)
                                                   : *option.second;
    }
  }
  if (session.Camera)
  {
    Json::Value& camera = root["camera"];
    camera["position"] = ToJSON(session.Camera->Position);
    camera["focal-point"] = ToJSON(session.Camera->FocalPoint);
    camera["view-up"] = ToJSON(session.Camera->ViewUp);
    camera["view-angle"] = session.Camera->ViewAngle;
    camera["parallel-scale"] = session.Camera->ParallelScale;
    camera["parallel"] = session.Camera->IsParallel;
  }
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  builder["precision"] = 17;
  const std::string problem =
    relevo::AtomicFile::Write(fileName, Json::writeString(builder, root) + "\n");
  if (!problem.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + problem);
  }
}
