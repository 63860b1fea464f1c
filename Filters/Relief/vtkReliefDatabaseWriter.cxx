// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefDatabaseWriter.h"

#include "Checks/MemoryGuard.h"
#include "Compatibility/VTKCompatibility.h"
#include "Data/Reliefs.h"
#include "Database/ReliefColumns.h"
#include "Database/ReliefSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkReliefDatabaseWriter);

vtkReliefDatabaseWriter::vtkReliefDatabaseWriter()
  : FileName(nullptr)
  , WriteImages(true)
{
}

vtkReliefDatabaseWriter::~vtkReliefDatabaseWriter()
{
  this->SetFileName(nullptr);
}

int vtkReliefDatabaseWriter::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkReliefDatabaseWriter::Fail(const std::string& message, unsigned long code)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< message);
}

void vtkReliefDatabaseWriter::WriteData()
{
  if (!relevo::FitsMemory([this] { this->WriteInput(); }))
  {
    this->Fail("Not enough memory to write the reliefs.", vtkErrorCode::UnknownError);
  }
}

void vtkReliefDatabaseWriter::WriteInput()
{
  if (!this->FileName || !*this->FileName)
  {
    this->Fail("There is no file name: call SetFileName().", vtkErrorCode::NoFileNameError);
    return;
  }
  std::vector<relevo::ReliefBlock> blocks = relevo::ReadReliefs(this->GetInput());
  for (const relevo::ReliefBlock& block : blocks)
  {
    if (!block.Error.empty())
    {
      this->Fail(block.Error, vtkErrorCode::UnknownError);
    }
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](const relevo::ReliefBlock& block) { return !block.Error.empty(); }),
    blocks.end());
  if (blocks.empty())
  {
    this->Fail("There are no reliefs to write.", vtkErrorCode::UnknownError);
    return;
  }
  const std::string error = this->WriteReliefs(blocks);
  if (!error.empty())
  {
    this->Fail(error, vtkErrorCode::CannotOpenFileError);
  }
}

std::string vtkReliefDatabaseWriter::WriteReliefs(const std::vector<relevo::ReliefBlock>& blocks)
{
  relevo::ReliefSet set(
    relevo::GetDatabaseFolder(this->FileName), blocks.size(), this->WriteImages);
  for (const relevo::ReliefBlock& block : blocks)
  {
    this->UpdateProgress(static_cast<double>(&block - blocks.data()) / blocks.size());
    if (relevo::IsAborted(this))
    {
      return "";
    }
    if (!set.GetError().empty() || !set.Add(block))
    {
      return set.GetError();
    }
  }
  set.Commit();
  return set.GetError();
}

void vtkReliefDatabaseWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteImages: " << (this->WriteImages ? "On" : "Off") << "\n";
}
