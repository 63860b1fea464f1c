// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerExport.h"

#include "Files/ViewerFile.h"
#include "Files/WriteFile.h"
#include "Text/ViewerMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

namespace
{
void SetBinary(vtkSTLWriter* writer)
{
  writer->SetFileTypeToBinary();
}

// Other writers are binary by default, or their format is text.
void SetBinary(vtkAlgorithm*)
{
}

// VTK's writers do not detect every full disk, so the written files are checked.

// The file has the length that its header gives.
bool IsWhole(vtkPLYWriter*, vtkPolyData* mesh, const std::string& fileName)
{
  const std::map<std::string, int> sizes = { { "float", 4 }, { "int", 4 }, { "uchar", 1 } };
  std::ifstream file(fileName, std::ios::binary);
  std::streamoff count = 0; // number of elements whose properties follow
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
  return file && file.tellg() - header >= size;
}

// One line per point, polygon and line. The last line must be complete.
bool IsWhole(vtkOBJWriter*, vtkPolyData* mesh, const std::string& fileName)
{
  std::map<std::string, vtkIdType> counts;
  std::ifstream file(fileName);
  bool endsWhole = false;
  for (std::string line; std::getline(file, line);)
  {
    ++counts[line.substr(0, line.find(' '))];
    endsWhole = !file.eof();
  }
  return endsWhole && counts["v"] == mesh->GetNumberOfPoints() &&
    counts["f"] >= mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() &&
    counts["l"] == mesh->GetNumberOfLines();
}

// A header with the number of triangles, and 50 bytes per triangle.
bool IsWhole(vtkSTLWriter*, vtkPolyData*, const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  unsigned char count[4] = {};
  file.seekg(80);
  file.read(reinterpret_cast<char*>(count), 4);
  std::uintmax_t triangles = 0;
  for (int i = 0; i < 4; ++i)
  {
    triangles |= static_cast<std::uintmax_t>(count[i]) << (8 * i);
  }
  file.seekg(0, std::ios::end);
  return file && static_cast<std::uintmax_t>(file.tellg()) == 84 + 50 * triangles;
}

bool IsWhole(vtkXMLPolyDataWriter*, vtkPolyData*, const std::string& fileName)
{
  return relevo::IsWholeXML(fileName);
}

// Returns an error message, or an empty string.
template <typename Writer>
std::string Write(vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Writer> writer;
  SetBinary(writer.Get());
  messages.ObserveProgress(writer, "writing");
  writer->SetInputData(mesh);
  return relevo::WriteFile(fileName, writer.Get(),
    [&](const std::string& written) { return IsWhole(writer.Get(), mesh, written); });
}

using WriterFunction =
  std::function<std::string(vtkPolyData*, const std::string&, ViewerMessages&)>;
const std::map<std::string, WriterFunction>& GetWriters()
{
  static const std::map<std::string, WriterFunction> writers = {
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
  const std::string error = GetWriters().at(GetExtension(fileName))(mesh, fileName, messages);
  if (!error.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + error);
  }
}
