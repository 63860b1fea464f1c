// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefDatabaseWriter.h"

#include "Core/VTKCompatibility.h"
#include "Data/Reliefs.h"
#include "Database/CSVFile.h"
#include "Database/ReliefColumns.h"
#include "Database/ReliefFile.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <filesystem>
#include <fstream>
#include <system_error>

vtkStandardNewMacro(vtkReliefDatabaseWriter);

namespace
{
// "relief_0000"
std::string MakeFileName(std::size_t index)
{
  std::string number = std::to_string(index);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  return "relief_" + number;
}

bool WriteTable(const std::vector<relevo::ReliefParameters>& reliefs, const std::string& fileName)
{
  std::ofstream file(fileName, std::ios::binary);
  for (const std::vector<std::string>& row : relevo::MakeTable(reliefs))
  {
    file << relevo::FormatCSV(row);
  }
  file.close();
  return file.good();
}
}

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
  if (!this->FileName || !*this->FileName)
  {
    this->Fail("There is no file name: call SetFileName().", vtkErrorCode::NoFileNameError);
    return;
  }
  const std::filesystem::path folder = relevo::GetDatabaseFolder(this->FileName);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
  {
    this->Fail(
      "The folder " + folder.string() + " cannot be made.", vtkErrorCode::CannotOpenFileError);
    return;
  }
  const std::vector<relevo::ReliefBlock> blocks = relevo::ReadReliefs(this->GetInput());
  std::vector<relevo::ReliefParameters> written;
  for (const relevo::ReliefBlock& block : blocks)
  {
    this->UpdateProgress(static_cast<double>(&block - blocks.data()) / blocks.size());
    if (relevo::IsAborted(this))
    {
      return;
    }
    if (!block.Fault.empty())
    {
      this->Fail(block.Fault, vtkErrorCode::UnknownError);
      continue;
    }
    const std::string name = MakeFileName(written.size());
    relevo::ReliefParameters parameters = relevo::GetReliefParameters(block);
    parameters.emplace_back(relevo::FileColumn, name + ".vti");
    bool isWritten = relevo::WriteReliefFile(block.Data, (folder / (name + ".vti")).string());
    if (this->WriteImages)
    {
      parameters.emplace_back(std::string(relevo::FileColumn) + "_image", name + ".png");
      isWritten =
        isWritten && relevo::WriteReliefPicture(block.Data, (folder / (name + ".png")).string());
    }
    if (!isWritten)
    {
      this->Fail("The files " + (folder / name).string() + ".* cannot be written.",
        vtkErrorCode::CannotOpenFileError);
      return;
    }
    written.push_back(parameters);
  }
  const std::string table = (folder / relevo::DatabaseTable).string();
  if (written.empty())
  {
    this->Fail("There are no reliefs to write.", vtkErrorCode::UnknownError);
  }
  else if (!WriteTable(written, table))
  {
    this->Fail("The file " + table + " cannot be written.", vtkErrorCode::CannotOpenFileError);
  }
}

void vtkReliefDatabaseWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteImages: " << (this->WriteImages ? "On" : "Off") << "\n";
}
