// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerExport.h"

#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <system_error>

namespace
{
void SetBinary(vtkSTLWriter* writer)
{
  writer->SetFileTypeToBinary();
}

// The others are binary by default, or text by definition.
void SetBinary(vtkAlgorithm*)
{
}

[[noreturn]] void Fail(const std::string& fileName, const std::string& why)
{
  throw ViewerError("cannot write " + fileName + ": " + why);
}

void WriteText(const std::string& text, const std::string& fileName)
{
  errno = 0;
  std::ofstream file(fileName, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file)
  {
    Fail(fileName, std::generic_category().message(errno != 0 ? errno : EIO));
  }
}

// VTK's writers of PLY and OBJ do not notice that a disk is full: what they wrote is checked. A
// device is not read back.
[[noreturn]] void FailShort(const std::string& fileName)
{
  Fail(fileName, "the file is incomplete; the disk may be full");
}

// As long as its header says.
void CheckWritten(vtkPLYWriter*, vtkPolyData* mesh, const std::string& fileName)
{
  if (!std::filesystem::is_regular_file(fileName))
  {
    return;
  }
  const std::map<std::string, int> sizes = { { "float", 4 }, { "int", 4 }, { "uchar", 1 } };
  std::ifstream file(fileName, std::ios::binary);
  std::streamoff count = 0; // of the element whose properties follow
  std::streamoff size = 0;
  std::string line;
  while (std::getline(file, line) && line != "end_header")
  {
    std::istringstream words(line);
    std::string word;
    std::string type;
    words >> word >> type;
    if (word == "element")
    {
      words >> count;
    }
    else if (type == "list")
    {
      size += count + 4 * mesh->GetPolys()->GetNumberOfConnectivityIds();
    }
    else if (word == "property" && sizes.count(type))
    {
      size += count * sizes.at(type);
    }
  }
  const std::streamoff header = file.tellg();
  file.seekg(0, std::ios::end);
  if (!file || file.tellg() - header < size)
  {
    FailShort(fileName);
  }
}

// One line for each point, polygon and line; the last of them is whole.
void CheckWritten(vtkOBJWriter*, vtkPolyData* mesh, const std::string& fileName)
{
  if (!std::filesystem::is_regular_file(fileName))
  {
    return;
  }
  std::map<std::string, vtkIdType> counts;
  std::ifstream file(fileName);
  bool endsWhole = false;
  for (std::string line; std::getline(file, line);)
  {
    ++counts[line.substr(0, line.find(' '))];
    endsWhole = !file.eof();
  }
  if (!endsWhole || counts["v"] != mesh->GetNumberOfPoints() ||
    counts["f"] < mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() ||
    counts["l"] != mesh->GetNumberOfLines())
  {
    FailShort(fileName);
  }
}

void CheckWritten(vtkAlgorithm*, vtkPolyData*, const std::string&)
{
}

// Whether it was written.
template <typename Writer>
bool Write(vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Writer> writer;
  SetBinary(writer.Get());
  messages.Observe(writer, "writing");
  writer->SetInputData(mesh);
  writer->SetFileName(fileName.c_str());
  if (writer->Write() != 1 || writer->GetErrorCode() != 0)
  {
    return false;
  }
  CheckWritten(writer.Get(), mesh, fileName);
  return true;
}

using Function = std::function<bool(vtkPolyData*, const std::string&, ViewerMessages&)>;
const std::map<std::string, Function>& GetWriters()
{
  static const std::map<std::string, Function> writers = {
    { ".obj", Write<vtkOBJWriter> },
    { ".ply", Write<vtkPLYWriter> },
    { ".stl", Write<vtkSTLWriter> },
    { ".vtp", Write<vtkXMLPolyDataWriter> },
  };
  return writers;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetExportExtensions()
{
  std::vector<std::string> extensions;
  for (const auto& writer : GetWriters())
  {
    extensions.push_back(writer.first);
  }
  return extensions;
}

//------------------------------------------------------------------------------
void WriteMesh(vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages)
{
  // Some of VTK's writers say nothing where the file cannot be opened or has no room.
  WriteText(" ", fileName);
  const bool isWritten = GetWriters().at(GetExtension(fileName))(mesh, fileName, messages);
  messages.Check();
  if (!isWritten)
  {
    throw ViewerError("cannot write " + fileName);
  }
}
