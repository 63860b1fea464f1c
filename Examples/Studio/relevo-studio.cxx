// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   shows a height map or a mesh in a window with controls
 */
#include "Options/ProgramRun.h"
#include "Options/UsageError.h"
#include "Options/ViewerArguments.h"
#include "Program/GraphicsReport.h"
#include "Program/StudioUsage.h"
#include "Program/StudioWindow.h"
#include "State/OptionValues.h"
#include "Text/ReadingGuard.h"

#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace
{
// Takes the value of an option out of the arguments. Returns "" without the option.
std::string TakeOption(std::vector<std::string>& arguments, const std::string& name)
{
  for (auto argument = arguments.begin(); argument != arguments.end() && *argument != "--";
       ++argument)
  {
    if (argument->compare(0, name.size() + 1, name + "=") == 0)
    {
      const std::string value = argument->substr(name.size() + 1);
      arguments.erase(argument);
      return value;
    }
    if (*argument == name)
    {
      if (argument + 1 == arguments.end() || (argument + 1)->empty())
      {
        throw UsageError(name + " needs the name of a file");
      }
      const std::string value = argument[1];
      arguments.erase(argument, argument + 2);
      return value;
    }
  }
  return "";
}

// Takes --serve, with its port if there is one, out of the arguments.
std::optional<int> TakePort(std::vector<std::string>& arguments)
{
  const std::string name = "--serve";
  for (auto argument = arguments.begin(); argument != arguments.end() && *argument != "--";
       ++argument)
  {
    const bool isAlone = *argument == name;
    if (!isAlone && argument->compare(0, name.size() + 1, name + "=") != 0)
    {
      continue;
    }
    const bool hasNext = isAlone && argument + 1 != arguments.end() && !argument[1].empty() &&
      argument[1].find_first_not_of("0123456789") == std::string::npos;
    const std::string text = hasNext ? argument[1]
      : isAlone                      ? "0"
                                     : argument->substr(name.size() + 1);
    arguments.erase(argument, argument + (hasNext ? 2 : 1));
    return ToInteger(name, text, 0, 65535);
  }
  return std::nullopt;
}
}

int main(int argc, char* argv[])
{
  return RunProgram("relevo-studio",
    [&]
    {
      std::vector<std::string> arguments(argv + 1, argv + argc);
      const std::string layout = TakeOption(arguments, "--layout");
      const std::string script = TakeOption(arguments, "--script");
      if (arguments == std::vector<std::string>{ "--report" })
      {
        std::cout << MakeGraphicsReport(RELEVO_VERSION);
        return;
      }
      const std::optional<int> port = TakePort(arguments);
      if (port && !script.empty())
      {
        throw UsageError("--serve cannot be combined with --script");
      }
      for (std::string& argument : arguments)
      {
        argument = argument == "-h" ? "--help" : argument;
      }
      const OptionValues values(arguments);
      if (values.Get("help"))
      {
        std::cout << GetStudioUsage();
        return;
      }
      if (values.Get("version"))
      {
        std::cout << "relevo-studio " << RELEVO_VERSION << std::endl;
        return;
      }
      CheckForStudio(values);
      InstallCrashHandlers(values.GetInput());
      if (port)
      {
        ServeStudio(values, layout, *port);
      }
      else
      {
        script.empty() ? ShowStudio(values, layout) : RunScript(values, layout, script);
      }
    });
}
