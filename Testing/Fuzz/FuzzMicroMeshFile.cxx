// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of micro-meshes. Checksums would reject nearly all inputs, so the bytes are the contents of
// the chunks, each with a length of two bytes, unless they are a file.
#include "RelevoFuzzAssert.h"
#include "RelevoFuzzFolder.h"

#include "Files/ChunkFile.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkMicroMeshReader.h"
#include "vtkMicroMeshSurface.h"
#include "vtkMicroMeshWriter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace
{
std::string MakeFile(const std::string& bytes)
{
  std::vector<std::string> chunks;
  std::size_t place = 0;
  while (place + 2 <= bytes.size())
  {
    const auto low = static_cast<unsigned char>(bytes[place]);
    const auto high = static_cast<unsigned char>(bytes[place + 1]);
    chunks.push_back(bytes.substr(place + 2, low + 256u * high));
    place += 2 + chunks.back().size();
  }
  return relevo::PackChunks(chunks);
}

std::string Read(vtkMicroMeshReader* reader, const std::string& file)
{
  reader->SetFileName(file.c_str());
  reader->Update();
  return file;
}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size)
{
  static const RelevoFuzzFolder folder;
  vtkObject::GlobalWarningDisplayOff();
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  vtkNew<vtkMicroMeshReader> reader;
  const bool isFile = reader->CanReadFile(folder.Write("m.rmm", bytes).c_str()) == 1;
  Read(reader, folder.Write("m.rmm", isFile ? bytes : MakeFile(bytes)));
  vtkPolyData* mesh = reader->GetOutput();
  if (mesh->GetNumberOfCells() == 0)
  {
    return 0;
  }
  vtkNew<vtkMicroMeshWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(folder.GetFile("w.rmm").c_str());
  FUZZ_ASSERT(writer->Write() == 1);
  vtkNew<vtkMicroMeshReader> again;
  Read(again, folder.GetFile("w.rmm"));
  FUZZ_ASSERT(again->GetOutput()->GetNumberOfPoints() == mesh->GetNumberOfPoints());
  FUZZ_ASSERT(again->GetOutput()->GetNumberOfCells() == mesh->GetNumberOfCells());
  if (mesh->GetNumberOfCells() <= 64)
  {
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetSurface(vtkNew<vtkMicroMeshSurface>());
    recipe->SetMaximumLevel(2);
    vtkNew<vtkAdaptiveRefinementFilter> filter;
    filter->SetInputData(mesh);
    filter->SetRefinement(recipe);
    filter->Update();
  }
  return 0;
}
