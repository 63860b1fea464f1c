// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/OptionValues.h"

#include "Options/OptionParser.h"
#include "Options/UsageError.h"

#include <set>

namespace
{
const std::string On = "on";

bool IsOption(const std::string& argument)
{
  return argument.size() > 1 && argument[0] == '-';
}
}

//------------------------------------------------------------------------------
bool IsFlag(const std::string& name)
{
  static const std::set<std::string> flags = { "axes", "contour-labels", "extremes", "globe",
    "help", "log", "no-geomorphing", "no-legend", "patch-edges", "per-edge", "scale-bar", "stats",
    "stretch", "version", "wireframe" };
  return flags.count(name) > 0;
}

//------------------------------------------------------------------------------
void CheckForStudio(const OptionValues& values)
{
  for (const char* name : { "against", "capture", "export", "flight", "height-at", "micromesh",
         "output", "relief", "save-script", "save-session", "save-source", "session", "stats" })
  {
    if (values.Get(name))
    {
      throw UsageError(std::string("--") + name + " is an option of relevo-view only");
    }
  }
}

//------------------------------------------------------------------------------
OptionValues::OptionValues(const std::vector<std::string>& arguments)
{
  bool isOption = true;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (isOption && argument == "--")
    {
      isOption = false;
      continue;
    }
    if (!isOption || !IsOption(argument))
    {
      if (!this->Input.empty())
      {
        throw UsageError(
          "more than one file is given: '" + this->Input + "' and '" + argument + "'");
      }
      this->Input = argument;
      continue;
    }
    if (argument.compare(0, 2, "--") != 0)
    {
      throw UsageError("unknown option '" + argument + "'");
    }
    const std::size_t equals = argument.find('=');
    std::string name = argument.substr(2, equals == std::string::npos ? equals : equals - 2);
    name = name == "image" ? "imagery" : name;
    const bool hasNext = i + 1 < arguments.size();
    if (equals != std::string::npos)
    {
      this->Values[name] = argument.substr(equals + 1);
    }
    else if (IsFlag(name))
    {
      this->Values[name] = On;
    }
    else if (name == "volume")
    {
      // If FILE came before, an array may follow.
      const bool hasArray = !this->Input.empty() && hasNext && !IsOption(arguments[i + 1]);
      this->Values[name] = hasArray ? arguments[++i] : "";
    }
    else if (!HasOption("--" + name))
    {
      throw UsageError("unknown option '--" + name + "'");
    }
    else if (hasNext)
    {
      this->Values[name] = arguments[++i];
    }
    else
    {
      throw UsageError(argument + " needs a value");
    }
  }
  this->Parse();
}

//------------------------------------------------------------------------------
std::optional<std::string> OptionValues::Get(const std::string& name) const
{
  const auto value = this->Values.find(name);
  return value == this->Values.end() ? std::nullopt : std::optional<std::string>(value->second);
}

//------------------------------------------------------------------------------
void OptionValues::Set(const std::string& name, const std::optional<std::string>& value)
{
  if (value)
  {
    this->Values[name] = *value;
  }
  else
  {
    this->Values.erase(name);
  }
}

//------------------------------------------------------------------------------
void OptionValues::Choose(const std::string& name, const std::optional<std::string>& value)
{
  const OptionValues old = *this;
  this->Set(name, value);
  if (name != "array" && name != "volume")
  {
    return;
  }
  if (value)
  {
    this->Set(name == "array" ? "volume" : "array", std::nullopt);
  }
  if (this->IsValid())
  {
    return;
  }
  // An option must go if it suits the kind of the old picture, but not that of the new one.
  const auto suits = [](const OptionValues& values, const std::string& option)
  {
    OptionValues pair = values;
    pair.Values.clear();
    for (const std::string& kept : { std::string("array"), std::string("volume"), option })
    {
      pair.Set(kept, values.Get(kept));
    }
    return pair.IsValid();
  };
  for (const auto& other : old.Values)
  {
    if (suits(old, other.first) && !suits(*this, other.first))
    {
      this->Set(other.first, std::nullopt);
    }
  }
}

//------------------------------------------------------------------------------
bool OptionValues::IsValid() const
{
  try
  {
    this->Parse();
    return true;
  }
  catch (const UsageError&)
  {
    return false;
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> OptionValues::GetArguments() const
{
  std::vector<std::string> arguments = { "relevo-studio" };
  for (const auto& value : this->Values)
  {
    arguments.push_back("--" + value.first + (IsFlag(value.first) ? "" : "=" + value.second));
  }
  if (!this->Input.empty())
  {
    arguments.insert(arguments.end(), { "--", this->Input });
  }
  return arguments;
}

//------------------------------------------------------------------------------
ViewerOptions OptionValues::Parse() const
{
  std::vector<std::string> arguments = this->GetArguments();
  std::vector<char*> pointers;
  for (std::string& argument : arguments)
  {
    pointers.push_back(argument.data());
  }
  return ParseOptions(static_cast<int>(pointers.size()), pointers.data());
}

//------------------------------------------------------------------------------
OptionNames OptionValues::Compare(const OptionValues& other) const
{
  OptionNames names;
  for (const auto* values : { &this->Values, &other.Values })
  {
    for (const auto& value : *values)
    {
      if (this->Get(value.first) != other.Get(value.first))
      {
        names.insert("--" + value.first);
      }
    }
  }
  return names;
}
