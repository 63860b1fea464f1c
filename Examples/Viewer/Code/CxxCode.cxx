// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/CxxCode.h"

#include "Code/ClassModules.h"
#include "Code/NumberText.h"
#include "Code/SceneCode.h"
#include "Code/ValueText.h"

#include <set>
#include <vector>

namespace
{
const std::size_t CxxColumns = 100;

const LanguageWords CxxWords = { "true", "false", "->", "::", "(folder + \"/\" + ", ").c_str()",
  [](const std::string& name) { return name; } };

std::string WriteCxxCall(const CodeStatement& call)
{
  std::string line = "  " + (call.Object.empty() ? "" : call.Object + "->") + call.Method + "(";
  std::string text;
  for (std::size_t i = 0; i < call.Arguments.size(); ++i)
  {
    const bool isLast = i + 1 == call.Arguments.size();
    const std::string argument = WriteValue(call.Arguments[i], CxxWords) + (isLast ? ");" : ",");
    const std::string space = i > 0 ? " " : "";
    if (line.size() + space.size() + argument.size() > CxxColumns)
    {
      text += line + "\n";
      line = "    " + argument;
      continue;
    }
    line += space + argument;
  }
  return text + line + (call.Arguments.empty() ? ");\n" : "\n");
}

std::string WriteCxxRows(const CodeStatement& statement)
{
  const std::size_t size = statement.Rows.empty() ? 1 : statement.Rows.front().size();
  const std::string type = "std::array<double, " + std::to_string(size) + ">";
  std::string text = "  for (const auto& row : std::vector<" + type + ">{\n";
  for (const std::vector<double>& row : statement.Rows)
  {
    text += "         { { " + WriteRow(row) + " } },\n";
  }
  text += "       })\n  {\n    " + statement.Object + "->" + statement.Method + "(";
  for (std::size_t i = 0; i < size; ++i)
  {
    text += (i > 0 ? ", row[" : "row[") + std::to_string(i) + "]";
  }
  return text + ");\n  }\n";
}

std::string WriteCxxStatement(const CodeStatement& statement)
{
  switch (statement.Type)
  {
    case CodeStatement::Kind::Note:
      return "\n" + WrapComment(statement.Text, "  // ");
    case CodeStatement::Kind::New:
      return "  vtkNew<" + statement.Class + "> " + statement.Object + ";\n";
    case CodeStatement::Kind::Get:
      return "  " + statement.Class + "* " + statement.Object + " = " + statement.Source + "->" +
        statement.Method + "();\n";
    case CodeStatement::Kind::Call:
      return WriteCxxCall(statement);
    case CodeStatement::Kind::Rows:
      return WriteCxxRows(statement);
  }
  return "";
}
}

//------------------------------------------------------------------------------
std::string WriteCxx(const SceneCode& code, const ProgramText& text)
{
  std::string body;
  for (const auto& function : code.GetFunctions())
  {
    body += function.second.Cxx + "\n";
  }
  body += "int main(int argc, char* argv[])\n{\n"
          "  const std::string folder = SCENE_FOLDER;\n"
          "  const char* picture = argc > 1 ? argv[1] : " +
    Quote(text.Name + ".png") + ";\n";
  for (const CodeStatement& statement : code.GetStatements())
  {
    body += WriteCxxStatement(statement);
  }
  body += "  return 0;\n}\n";
  std::string includes;
  for (const std::string& name : code.GetClasses())
  {
    includes += "#include \"" + name + ".h\"\n";
  }
  return WrapComment("Draws " + text.Input + " into a picture:", "// ") + "//\n//     " +
    text.Name + " [FILE.png]\n//\n" +
    WrapComment("Until you change it, the picture is that of this command, to the bit on one "
                "computer:",
      "// ") +
    "//\n//     " + text.Command + "\n//\n" +
    WrapComment("It has no window, so the keys, the panel and the values under the mouse are not "
                "part of it. The camera and the places of the legend are numbers: they do not "
                "follow other data or another size.",
      "// ") +
    includes + "#include \"vtkNew.h\"\n\n" +
    "#include <array>\n#include <cmath>\n#include <string>\n#include <vector>\n\n" + body;
}

//------------------------------------------------------------------------------
std::string WriteCMake(const SceneCode& code, const ProgramText& text)
{
  std::set<std::string> relevo;
  std::set<std::string> vtk = { "RenderingFreeType", "RenderingOpenGL2" };
  for (const std::string& name : code.GetClasses())
  {
    const ClassModule module = FindModule(name);
    (module.IsRelevo ? relevo : vtk).insert(module.Name);
  }
  std::string components[2];
  std::string libraries;
  for (const std::string& name : relevo)
  {
    components[0] += "\n  " + name;
    libraries += "\n  Relevo::" + name;
  }
  for (const std::string& name : vtk)
  {
    components[1] += "\n  " + name;
    libraries += "\n  VTK::" + name;
  }
  const std::string& name = text.Name;
  return "# cmake -S . -B build -DRelevo_DIR=PREFIX/lib/cmake/Relevo && cmake --build build\n"
         "cmake_minimum_required(VERSION 3.18...3.28)\n"
         "project(" +
    name + " LANGUAGES C CXX)\n\nfind_package(Relevo REQUIRED COMPONENTS" + components[0] +
    ")\nfind_package(VTK REQUIRED COMPONENTS" + components[1] + ")\nset(libraries" + libraries +
    ")\n\nadd_executable(" + name + " " + name + ".cxx)\ntarget_compile_features(" + name +
    " PRIVATE cxx_std_17)\n" + "target_compile_definitions(" + name +
    " PRIVATE\n  \"SCENE_FOLDER=\\\"${CMAKE_CURRENT_SOURCE_DIR}\\\"\")\n" +
    "target_link_libraries(" + name + " PRIVATE ${libraries})\nvtk_module_autoinit(TARGETS " +
    name + " MODULES ${libraries})\n";
}
