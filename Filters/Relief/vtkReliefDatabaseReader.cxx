// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefDatabaseReader.h"

#include "Checks/MemoryGuard.h"
#include "Compatibility/VTKCompatibility.h"
#include "Database/ReliefFile.h"
#include "Database/ReliefTable.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <filesystem>
#include <vector>

vtkStandardNewMacro(vtkReliefDatabaseReader);

namespace
{
void SetName(vtkMultiBlockDataSet* blocks, unsigned int block, const std::string& name)
{
  if (!name.empty())
  {
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}

// Reads the relief of a row. Returns nullptr with an `error` if that fails.
vtkSmartPointer<vtkImageData> ReadRow(
  const relevo::ReliefTable& table, std::size_t row, std::string& error)
{
  const std::string file = table.FindFile(row, error);
  if (!error.empty())
  {
    return nullptr;
  }
  auto image = relevo::ReadReliefFile(file, error);
  if (!error.empty())
  {
    const auto folder = std::filesystem::path(table.GetFileName()).parent_path();
    error = std::filesystem::path(file).lexically_relative(folder).string() + ": " + error;
  }
  return image;
}

// Returns the last time that is not later than the requested one, or the first.
double ChooseTime(const std::vector<double>& times, double asked)
{
  const auto later = std::upper_bound(times.begin(), times.end(), asked);
  return later == times.begin() ? times.front() : *(later - 1);
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
  const auto hasFile = [fileName]
  {
    const relevo::ReliefTable table(fileName);
    for (std::size_t row = 0; row < table.GetNumberOfRows(); ++row)
    {
      std::string error;
      table.FindFile(row, error);
      if (error.empty())
      {
        return true;
      }
    }
    return false;
  };
  bool result = false;
  return relevo::FitsMemory([&] { result = hasFile(); }) && result ? 1 : 0;
}

int vtkReliefDatabaseReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return relevo::RequestWithinMemory(this, outputVector, "the table of reliefs",
    [&] { return this->FindTimes(outputVector) ? 1 : 0; });
}

bool vtkReliefDatabaseReader::FindTimes(vtkInformationVector* outputVector)
{
  vtkMultiBlockDataSet::GetData(outputVector)->Initialize();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: call SetFileName().");
    return false;
  }
  const relevo::ReliefTable table(this->FileName);
  if (!table.GetError().empty())
  {
    vtkErrorMacro(<< table.GetError());
    return false;
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  const std::vector<double> times = table.GetTimes();
  information->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  information->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (!times.empty())
  {
    const double range[2] = { times.front(), times.back() };
    information->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    information->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  return true;
}

int vtkReliefDatabaseReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return relevo::RequestWithinMemory(
    this, outputVector, "the reliefs", [&] { return this->ReadReliefs(outputVector) ? 1 : 0; });
}

bool vtkReliefDatabaseReader::ReadReliefs(vtkInformationVector* outputVector)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  output->Initialize();
  const relevo::ReliefTable table(this->FileName);
  if (!table.GetError().empty()) // it may have changed since RequestInformation()
  {
    vtkErrorMacro(<< table.GetError());
    return false;
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  const std::vector<double> times = table.GetTimes();
  double time = 0.0;
  if (!times.empty())
  {
    vtkInformationDoubleKey* asked = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    time = information->Has(asked) ? ChooseTime(times, information->Get(asked)) : times.front();
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  this->ReadRows(table, time, output);
  return true;
}

void vtkReliefDatabaseReader::ReadRows(
  const relevo::ReliefTable& table, double time, vtkMultiBlockDataSet* output)
{
  unsigned int block = 0;
  std::size_t errors = 0;
  std::string firstError;
  for (std::size_t row = 0; row < table.GetNumberOfRows(); ++row)
  {
    this->UpdateProgress(static_cast<double>(row) / table.GetNumberOfRows());
    if (relevo::IsAborted(this))
    {
      return;
    }
    if (!table.IsOfTime(row, time))
    {
      continue;
    }
    std::string error;
    output->SetBlock(block, ReadRow(table, row, error));
    SetName(output, block++, table.GetName(row));
    if (!error.empty() && errors++ == 0)
    {
      firstError =
        table.GetFileName() + ", line " + std::to_string(table.GetLine(row)) + ": " + error;
    }
  }
  if (errors > 0)
  {
    vtkErrorMacro(<< firstError << " " << errors << " of " << block << " rows cannot be read.");
  }
}

void vtkReliefDatabaseReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
