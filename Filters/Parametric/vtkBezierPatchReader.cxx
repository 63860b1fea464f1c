// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBezierPatchReader.h"

#include "Cells/BezierCells.h"
#include "Checks/MemoryGuard.h"
#include "Files/BezierPatchFile.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <filesystem>
#include <fstream>

vtkStandardNewMacro(vtkBezierPatchReader);

vtkBezierPatchReader::vtkBezierPatchReader()
  : FileName(nullptr)
{
  this->SetNumberOfInputPorts(0);
}

vtkBezierPatchReader::~vtkBezierPatchReader()
{
  this->SetFileName(nullptr);
}

int vtkBezierPatchReader::CanReadFile(const char* fileName)
{
  std::ifstream file(fileName ? fileName : "", std::ios::binary);
  return file && relevo::IsBezierPatchFile(file) ? 1 : 0;
}

int vtkBezierPatchReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return relevo::RequestWithinMemory(this, outputVector, "the patches of the file",
    [&] { return this->Read(vtkUnstructuredGrid::GetData(outputVector)); });
}

int vtkBezierPatchReader::Read(vtkUnstructuredGrid* output)
{
  output->Initialize();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: call SetFileName().");
    return 0;
  }
  std::error_code unknown; // only regular files, because opening a pipe would block
  std::ifstream file;
  if (std::filesystem::is_regular_file(this->FileName, unknown))
  {
    file.open(this->FileName, std::ios::binary);
  }
  if (!file.is_open())
  {
    vtkErrorMacro("The file cannot be read: " << this->FileName);
    return 0;
  }
  std::vector<relevo::BezierPatch> patches;
  std::string error;
  if (!relevo::ReadBezierPatches(file, patches, error))
  {
    vtkErrorMacro(<< this->FileName << ", " << error);
    return 0;
  }
  relevo::BezierCells cells(output, false);
  for (const relevo::BezierPatch& patch : patches)
  {
    cells.AddQuadrilateral(patch.Degrees, patch.Points);
  }
  return 1;
}

void vtkBezierPatchReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
