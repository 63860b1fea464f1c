// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerExport.h"

#include "ViewerArguments.h"
#include "ViewerMessages.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <fstream>
#include <functional>
#include <map>

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

// Whether it was written.
template <typename Writer>
bool Write(vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Writer> writer;
  SetBinary(writer.Get());
  messages.Observe(writer, "writing");
  writer->SetInputData(mesh);
  writer->SetFileName(fileName.c_str());
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
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
  // Some of VTK's writers say nothing where the file cannot be opened.
  if (!std::ofstream(fileName))
  {
    throw ViewerError("cannot write " + fileName);
  }
  const bool isWritten = GetWriters().at(GetExtension(fileName))(mesh, fileName, messages);
  messages.Check();
  if (!isWritten)
  {
    throw ViewerError("cannot write " + fileName);
  }
}
