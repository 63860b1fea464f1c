// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshWriter.h"

#include "Checks/MemoryGuard.h"
#include "Data/MicroMeshArrays.h"
#include "Files/AtomicFile.h"
#include "Files/MicroMeshFile.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vector>

vtkStandardNewMacro(vtkMicroMeshWriter);

vtkMicroMeshWriter::vtkMicroMeshWriter() = default;

vtkMicroMeshWriter::~vtkMicroMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkMicroMeshWriter::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkMicroMeshWriter::Fail(const std::string& message, unsigned long code)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< message);
}

void vtkMicroMeshWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    this->Fail("There is no file name: call SetFileName().", vtkErrorCode::NoFileNameError);
  }
  else if (!relevo::FitsMemory(
             [this] { this->WriteMesh(vtkPolyData::SafeDownCast(this->GetInput())); }))
  {
    this->Fail(std::string(this->FileName) + ": not enough memory to write the micro-mesh.",
      vtkErrorCode::UnknownError);
  }
}

void vtkMicroMeshWriter::WriteMesh(vtkPolyData* mesh)
{
  const std::string start = std::string(this->FileName) + ": ";
  relevo::MicroMesh micro;
  std::string error = "the mesh is not a micro-mesh: it has no triangles. Use vtkMicroMeshFilter";
  if (!mesh || mesh->GetNumberOfPolys() == 0 || !relevo::TakeMicroMesh(mesh, micro, error))
  {
    this->Fail(start + error + ".", vtkErrorCode::UnknownError);
    return;
  }
  std::vector<std::string> leftOut;
  relevo::AtomicFile file(this->FileName);
  file.Append(relevo::PackMicroMesh(mesh, micro, leftOut));
  if (!file.Commit())
  {
    this->Fail(
      start + "cannot be written: " + file.GetError() + ".", vtkErrorCode::CannotOpenFileError);
    return;
  }
  for (const std::string& name : leftOut)
  {
    vtkWarningMacro("Array \"" << name << "\" is not numeric and is left out.");
  }
}

void vtkMicroMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
