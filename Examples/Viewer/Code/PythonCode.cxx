// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/PythonCode.h"

#include "Code/ClassModules.h"
#include "Code/NumberText.h"
#include "Code/SceneCode.h"
#include "Code/ValueText.h"

#include <cctype>
#include <map>
#include <vector>

namespace
{
const std::size_t PythonColumns = 99;

// AddText becomes add_text.
std::string ToSnakeCase(const std::string& name)
{
  std::string snake;
  for (const char sign : name)
  {
    const bool isUpper = std::isupper(static_cast<unsigned char>(sign)) != 0;
    snake += isUpper && !snake.empty() ? "_" : "";
    snake += static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
  }
  return snake;
}

std::string GetPythonName(const std::string& className)
{
  return FindModule(className).IsRelevo ? "relevo." + className : className;
}

const LanguageWords PythonWords = { "True", "False", ".", ".", "os.path.join(FOLDER, ", ")",
  GetPythonName };

std::string WriteCall(const CodeStatement& call)
{
  std::string line = "    " +
    (call.Object.empty() ? ToSnakeCase(call.Method) : call.Object + "." + call.Method) + "(";
  const std::size_t column = line.size();
  std::string text;
  for (std::size_t i = 0; i < call.Arguments.size(); ++i)
  {
    const bool isLast = i + 1 == call.Arguments.size();
    const std::string argument = WriteValue(call.Arguments[i], PythonWords) + (isLast ? ")" : ",");
    if (line.size() > column && line.size() + 1 + argument.size() > PythonColumns)
    {
      text += line + "\n";
      line = std::string(column, ' ') + argument;
      continue;
    }
    line += (line.size() > column ? " " : "") + argument;
  }
  return text + line + (call.Arguments.empty() ? ")\n" : "\n");
}

std::string WriteRows(const CodeStatement& statement)
{
  std::string text = "    for row in [\n";
  for (const std::vector<double>& row : statement.Rows)
  {
    text += "        (" + WriteRow(row) + "),\n";
  }
  return text + "    ]:\n        " + statement.Object + "." + statement.Method + "(*row)\n";
}

std::string WriteStatement(const CodeStatement& statement)
{
  switch (statement.Type)
  {
    case CodeStatement::Kind::Note:
      return "\n" + WrapComment(statement.Text, "    # ");
    case CodeStatement::Kind::New:
      return "    " + statement.Object + " = " + GetPythonName(statement.Class) + "()\n";
    case CodeStatement::Kind::Get:
      return "    " + statement.Object + " = " + statement.Source + "." + statement.Method + "()\n";
    case CodeStatement::Kind::Call:
      return WriteCall(statement);
    case CodeStatement::Kind::Rows:
      return WriteRows(statement);
  }
  return "";
}

// Classes that only type variables in C++ are not imported.
std::string WriteImports(const SceneCode& code, const std::string& body)
{
  std::map<std::string, std::string> modules;
  for (const std::string& name : code.GetClasses())
  {
    const ClassModule module = FindModule(name);
    const bool isUsed =
      body.find(name + "(") != std::string::npos || body.find(name + ".") != std::string::npos;
    if (!module.IsRelevo && isUsed)
    {
      std::string& names = modules[module.Name];
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  std::string text = "import relevo\n"
                     "import vtkmodules.vtkRenderingFreeType  # noqa: F401, for text\n"
                     "import vtkmodules.vtkRenderingOpenGL2  # noqa: F401\n";
  for (const auto& module : modules)
  {
    std::string line = "from vtkmodules.vtk" + module.first + " import " + module.second;
    if (line.size() > PythonColumns)
    {
      line = "from vtkmodules.vtk" + module.first + " import (";
      std::string names = module.second;
      for (std::size_t comma = 0; comma != std::string::npos;)
      {
        comma = names.find(", ");
        line += "\n    " + names.substr(0, comma) + ",";
        names = comma == std::string::npos ? "" : names.substr(comma + 2);
      }
      line += "\n)";
    }
    text += line + "\n";
  }
  return text;
}
}

//------------------------------------------------------------------------------
std::string WritePython(const SceneCode& code, const ProgramText& text)
{
  std::string body;
  for (const auto& function : code.GetFunctions())
  {
    body += function.second.Python + "\n\n";
  }
  body += "def main():\n"
          "    picture = sys.argv[1] if len(sys.argv) > 1 else " +
    Quote(text.Name + ".png") + "\n";
  for (const CodeStatement& statement : code.GetStatements())
  {
    body += WriteStatement(statement);
  }
  const bool usesMath = body.find("math.") != std::string::npos;
  return "#!/usr/bin/env python3\n" +
    WrapComment("Draws " + text.Input + " into a picture:", "# ") + "#\n#     python3 " +
    text.Name + ".py [FILE.png]\n#\n" +
    WrapComment("Until you change it, the picture is that of this command, to the bit on one "
                "computer:",
      "# ") +
    "#\n#     " + text.Command + "\n#\n" +
    WrapComment("It has no window, so the keys, the panel and the values under the mouse are not "
                "part of it. The camera and the places of the legend are numbers: they do not "
                "follow other data or another size.",
      "# ") +
    (usesMath ? "import math\n" : "") + "import os\nimport sys\n\n" + WriteImports(code, body) +
    "\nFOLDER = os.path.dirname(os.path.abspath(__file__))\n\n\n" + body +
    "\n\nif __name__ == \"__main__\":\n    main()\n";
}
