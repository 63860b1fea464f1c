// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SceneProgram.h"

#include "Code/CxxCode.h"
#include "Code/PythonCode.h"
#include "Code/SceneCode.h"
#include "Files/WriteFile.h"
#include "Options/ViewerOptions.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"

#include "vtkDataSet.h"
#include "vtkXMLDataObjectWriter.h"
#include "vtkXMLWriter.h"

#include <vtksys/SystemTools.hxx>

#include <cctype>

namespace
{
void CheckOptions(const ViewerOptions& options)
{
  if (options.Given.count("--integration-points") > 0)
  {
    throw ViewerError("a program cannot draw --integration-points yet; omit it, or save a session, "
                      "which relevo-view draws");
  }
}

// A word in quotation marks for the shell if it needs them.
std::string QuoteWord(const std::string& word)
{
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                            "_-+=.,:/%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
  {
    return word;
  }
  std::string quoted = "'";
  for (const char sign : word)
  {
    quoted += sign == '\'' ? "'\\''" : sign == '\n' ? " " : std::string(1, sign);
  }
  return quoted + "'";
}

std::string MakeCommand(const ViewerOptions& options)
{
  std::string command = "relevo-view " + QuoteWord(options.Input);
  for (const auto& given : options.Given)
  {
    command += " " + given.first + (given.second ? "=" + QuoteWord(*given.second) : "");
  }
  return command;
}

// A name that programs and CMake allow.
std::string MakeProgramName(const std::string& name)
{
  std::string allowed;
  for (const char sign : name)
  {
    const bool isWord = std::isalnum(static_cast<unsigned char>(sign)) != 0 || sign == '_';
    allowed += isWord ? sign : '_';
  }
  return allowed.empty() || allowed == "test" || allowed == "all" ? "scene" : allowed;
}

void WriteText(const std::string& fileName, const std::string& text)
{
  const std::string error = relevo::AtomicFile::Write(fileName, text);
  if (!error.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + error);
  }
}

void WriteData(const SceneCode& code, const std::string& folder)
{
  for (const auto& data : code.GetData())
  {
    const auto writer = vtkSmartPointer<vtkXMLWriter>::Take(
      vtkXMLDataObjectWriter::NewWriter(data.second->GetDataObjectType()));
    writer->SetInputDataObject(data.second);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    relevo::AtomicFile file(folder + "/" + data.first);
    if (!relevo::WriteFile(file, writer.Get(), relevo::IsWholeXML) || !file.Commit())
    {
      throw ViewerError("cannot write " + file.GetFileName() + ": " + file.GetError());
    }
  }
}
}

//------------------------------------------------------------------------------
void SaveScript(ViewerScene& scene, const ViewerOptions& options, const std::array<int, 2>& size,
  const std::string& fileName)
{
  CheckOptions(options);
  const std::string path = vtksys::SystemTools::GetFilenamePath(fileName);
  const std::string folder = path.empty() ? "." : path;
  const std::string name = vtksys::SystemTools::GetFilenameWithoutLastExtension(fileName);
  SceneCode code(folder, name);
  scene.AddCode(code, size);
  const std::string text = WritePython(code, { name, options.Input, MakeCommand(options) });
  WriteData(code, folder);
  WriteText(fileName, text);
}

//------------------------------------------------------------------------------
void SaveSource(ViewerScene& scene, const ViewerOptions& options, const std::array<int, 2>& size,
  const std::string& folder)
{
  CheckOptions(options);
  const std::string name = MakeProgramName(
    vtksys::SystemTools::GetFilenameName(vtksys::SystemTools::CollapseFullPath(folder)));
  SceneCode code(folder, name);
  scene.AddCode(code, size);
  const ProgramText text = { name, options.Input, MakeCommand(options) };
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    throw ViewerError("cannot create the folder " + folder);
  }
  WriteData(code, folder);
  WriteText(folder + "/" + name + ".cxx", WriteCxx(code, text));
  WriteText(folder + "/CMakeLists.txt", WriteCMake(code, text));
}
