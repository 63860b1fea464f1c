// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefDatabaseReader.h"

#include "Core/VTKCompatibility.h"
#include "Database/CSVFile.h"
#include "Database/ReliefColumns.h"
#include "Database/ReliefFile.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

vtkStandardNewMacro(vtkReliefDatabaseReader);

namespace
{
std::filesystem::path GetTable(const std::string& fileName)
{
  return std::filesystem::path(relevo::GetDatabaseFolder(fileName)) / relevo::DatabaseTable;
}

// No rows if there is no table. A pipe would block.
std::vector<relevo::CSVRow> ReadTable(const std::filesystem::path& table)
{
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(table, unknown))
  {
    return {};
  }
  std::ifstream file(table, std::ios::binary);
  return relevo::ParseCSV(std::string(std::istreambuf_iterator<char>(file), {}));
}

void SetName(vtkMultiBlockDataSet* blocks, unsigned int block, const std::string& name)
{
  if (!name.empty())
  {
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}

// The relief of a row; nullptr, and what is wrong, if it has none.
vtkSmartPointer<vtkImageData> ReadRow(const std::filesystem::path& folder,
  const std::vector<std::string>& names, const std::vector<std::string>& row, std::string& fault)
{
  if (row.size() != names.size())
  {
    fault =
      std::to_string(row.size()) + " fields for " + std::to_string(names.size()) + " columns.";
    return nullptr;
  }
  const int column = relevo::FindReliefFile(names, row);
  if (column < 0)
  {
    fault = "no column FILE has the name of a .vti file.";
    return nullptr;
  }
  auto image = relevo::ReadReliefFile((folder / row[column]).string(), fault);
  fault = fault.empty() ? "" : row[column] + ": " + fault;
  return image;
}
}

vtkReliefDatabaseReader::vtkReliefDatabaseReader()
  : FileName(nullptr)
{
  this->SetNumberOfInputPorts(0);
}

vtkReliefDatabaseReader::~vtkReliefDatabaseReader()
{
  this->SetFileName(nullptr);
}

int vtkReliefDatabaseReader::CanReadFile(const char* fileName)
{
  if (!fileName || !*fileName)
  {
    return 0;
  }
  const std::vector<relevo::CSVRow> rows = ReadTable(GetTable(fileName));
  return std::any_of(rows.begin(), rows.end(),
    [&](const relevo::CSVRow& row)
    { return relevo::FindReliefFile(rows.front().Fields, row.Fields) >= 0; });
}

int vtkReliefDatabaseReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  output->Initialize();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: call SetFileName().");
    return 0;
  }
  const std::filesystem::path table = GetTable(this->FileName);
  const std::vector<relevo::CSVRow> rows = ReadTable(table);
  if (rows.empty())
  {
    vtkErrorMacro("There is no table of reliefs, or an empty one: " << table.string());
    return 0;
  }
  const std::vector<std::string>& names = rows.front().Fields;
  const auto nameColumn =
    static_cast<std::size_t>(std::find(names.begin(), names.end(), "name") - names.begin());
  output->SetNumberOfBlocks(static_cast<unsigned int>(rows.size() - 1));
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    this->UpdateProgress(static_cast<double>(i) / rows.size());
    if (relevo::IsAborted(this))
    {
      return 1;
    }
    const std::vector<std::string>& row = rows[i].Fields;
    const auto block = static_cast<unsigned int>(i - 1);
    std::string fault;
    output->SetBlock(block, ReadRow(table.parent_path(), names, row, fault));
    if (!fault.empty())
    {
      vtkErrorMacro(<< table.string() << ", line " << rows[i].Line << ": " << fault);
    }
    SetName(output, block, nameColumn < row.size() ? row[nameColumn] : "");
  }
  return 1;
}

void vtkReliefDatabaseReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
