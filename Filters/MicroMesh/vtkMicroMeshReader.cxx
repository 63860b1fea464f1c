// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshReader.h"

#include "Checks/MemoryGuard.h"
#include "Files/ChunkFile.h"
#include "Files/MicroMeshFile.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace
{
// Reads at most `most` bytes. Returns false if that fails.
bool ReadBytes(const char* fileName, std::size_t most, std::string& bytes)
{
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(fileName, unknown))
  {
    return false;
  }
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  if (!file)
  {
    return false;
  }
  bytes.resize(std::min(most, static_cast<std::size_t>(std::max(file.tellg(), std::streampos(0)))));
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file.good();
}
}

vtkStandardNewMacro(vtkMicroMeshReader);

vtkMicroMeshReader::vtkMicroMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMicroMeshReader::~vtkMicroMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkMicroMeshReader::CanReadFile(const char* fileName)
{
  constexpr std::size_t start = 16;
  std::string bytes;
  return fileName && ReadBytes(fileName, start, bytes) && relevo::AreChunks(bytes) ? 1 : 0;
}

int vtkMicroMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return relevo::RequestWithinMemory(this, outputVector, "the micro-mesh",
    [&] { return this->ReadMesh(vtkPolyData::GetData(outputVector)) ? 1 : 0; });
}

bool vtkMicroMeshReader::ReadMesh(vtkPolyData* output)
{
  output->Initialize();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: call SetFileName().");
    return false;
  }
  std::string bytes;
  if (!ReadBytes(this->FileName, bytes.max_size(), bytes))
  {
    vtkErrorMacro(<< this->FileName << ": the file does not exist or cannot be read.");
    return false;
  }
  vtkNew<vtkPolyData> mesh;
  const std::string error = relevo::UnpackMicroMesh(bytes, mesh);
  if (!error.empty())
  {
    vtkErrorMacro(<< this->FileName << ": " << error << ".");
    return false;
  }
  output->ShallowCopy(mesh);
  return true;
}

void vtkMicroMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
