// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Driving/ScriptFile.h"

#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace
{
std::string Trim(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos
    ? ""
    : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

// The error of a line, or "".
std::string ParseLine(const std::string& text, ScriptLine& line)
{
  static const std::map<std::string, std::string> forms = { { "set", "set NAME VALUE" },
    { "click", "click NAME" }, { "drag", "drag X0 Y0 X1 Y1" }, { "key", "key NAME" },
    { "wait", "wait" }, { "save", "save FILE" }, { "quit", "quit" } };
  const std::size_t space = text.find_first_of(" \t");
  line.Command = text.substr(0, space);
  const std::string rest = space == std::string::npos ? "" : Trim(text.substr(space));
  const auto form = forms.find(line.Command);
  if (form == forms.end())
  {
    return "unknown command '" + line.Command + "'";
  }
  const std::string error = "the command is '" + form->second + "', not '" + text + "'";
  if (line.Command == "wait" || line.Command == "quit")
  {
    return rest.empty() ? "" : error;
  }
  if (line.Command == "drag")
  {
    std::istringstream words(rest);
    for (std::string word; words >> word;)
    {
      char* end = nullptr;
      line.Numbers.push_back(std::strtod(word.c_str(), &end));
      if (*end != '\0' || !std::isfinite(line.Numbers.back()))
      {
        return "'" + word + "' is not a number of pixels";
      }
    }
    return line.Numbers.size() == 4 ? "" : error;
  }
  const std::size_t end = line.Command == "set" ? rest.find_first_of(" \t") : std::string::npos;
  line.Name = rest.substr(0, end);
  line.Value = end == std::string::npos ? "" : Trim(rest.substr(end));
  return line.Name.empty() || (line.Command == "set" && line.Value.empty()) ? error : "";
}
}

//------------------------------------------------------------------------------
std::vector<ScriptLine> ReadScript(const std::string& fileName)
{
  CheckFile(fileName);
  std::ifstream file(fileName);
  std::vector<ScriptLine> lines;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number)
  {
    text = Trim(text);
    if (text.empty() || text[0] == '#')
    {
      continue;
    }
    ScriptLine line;
    line.Number = number;
    const std::string error = ParseLine(text, line);
    if (!error.empty())
    {
      throw ViewerError(fileName + ", line " + std::to_string(number) + ": " + error);
    }
    lines.push_back(line);
  }
  return lines;
}
