// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefDatabaseReader promises that the pipeline's time selects rows of the table.
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoReliefFiles.h"
#include "RelevoReliefs.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkReliefDatabaseWriter.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

// Writes reliefs with 1, 2, 3, ... columns at these times.
void WriteDatabase(
  RelevoCheck& check, const std::string& folder, const char* name, const std::vector<double>& times)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const auto relief = RelevoMakeRelief(static_cast<int>(i) + 1, 3,
      relevo::ReliefProjection::Parallel, relevo::dmat4(1.0), [](int, int row) { return row; });
    vtkNew<vtkDoubleArray> time;
    time->SetName(name);
    time->InsertNextValue(times[i]);
    relief->GetFieldData()->AddArray(time);
    blocks->SetBlock(static_cast<unsigned int>(i), relief);
  }
  vtkNew<vtkReliefDatabaseWriter> writer;
  writer->SetInputData(blocks);
  writer->SetFileName(folder.c_str());
  CHECK_EQUAL(writer->Write(), 1);
}

std::vector<double> GetSteps(vtkReliefDatabaseReader* reader)
{
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  const double* steps = information->Get(Pipeline::TIME_STEPS());
  return std::vector<double>(steps, steps + information->Length(Pipeline::TIME_STEPS()));
}

// Columns of the reliefs that are read.
std::vector<int> GetColumns(vtkReliefDatabaseReader* reader)
{
  std::vector<int> columns;
  for (unsigned int i = 0; i < reader->GetOutput()->GetNumberOfBlocks(); ++i)
  {
    vtkImageData* image = RelevoGetImage(reader->GetOutput(), i);
    columns.push_back(image ? image->GetDimensions()[0] : 0);
  }
  return columns;
}

double GetTime(vtkReliefDatabaseReader* reader)
{
  return reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
}

void TestSteps(RelevoCheck& check, const std::string& folder)
{
  using Columns = std::vector<int>;
  for (const char* name : { "time", "TimeValue" })
  {
    CHECK_CASE(name);
    WriteDatabase(check, folder, name, { 2.5, 1.0, 2.5, 40.0 });
    vtkNew<vtkReliefDatabaseReader> reader;
    reader->SetFileName(folder.c_str());
    CHECK_EQUAL(GetSteps(reader), std::vector<double>({ 1.0, 2.5, 40.0 }));
    const double* range = reader->GetOutputInformation(0)->Get(Pipeline::TIME_RANGE());
    CHECK(range && range[0] == 1.0 && range[1] == 40.0);
    reader->Update();
    CHECK_EQUAL(GetColumns(reader), Columns({ 2 }));
    CHECK_EQUAL(GetTime(reader), 1.0);
    reader->UpdateTimeStep(2.5);
    CHECK_EQUAL(GetColumns(reader), Columns({ 1, 3 }));
    CHECK_EQUAL(GetTime(reader), 2.5);
    reader->UpdateTimeStep(39.0);
    CHECK_EQUAL(GetColumns(reader), Columns({ 1, 3 }));
    CHECK_EQUAL(GetTime(reader), 2.5);
    reader->UpdateTimeStep(1e9);
    CHECK_EQUAL(GetColumns(reader), Columns({ 4 }));
    reader->UpdateTimeStep(-7.0);
    CHECK_EQUAL(GetColumns(reader), Columns({ 2 }));
  }
}

// Rows without a time belong to every step. Text is not a time.
void TestTables(RelevoCheck& check, const std::string& folder)
{
  WriteDatabase(check, folder, "time", { 1.0, 2.0, 3.0 });
  const auto read = [&](const std::string& rows)
  {
    RelevoWriteFile(folder + "/data.csv", rows);
    auto reader = vtkSmartPointer<vtkReliefDatabaseReader>::New();
    RelevoErrors errors(reader);
    reader->SetFileName(folder.c_str());
    reader->Update();
    CHECK(errors.None());
    return reader;
  };
  auto reader = read("Time,FILE\n5,relief_0000.vti\n,relief_0001.vti\n-1e1 ,relief_0002.vti\n");
  CHECK_EQUAL(GetSteps(reader), std::vector<double>({ -10.0, 5.0 }));
  CHECK_EQUAL(GetColumns(reader), std::vector<int>({ 2, 3 }));
  for (const char* word : { "spring", "nan", "3 h" })
  {
    CHECK_CASE(word);
    reader = read("time,FILE\n5,relief_0000.vti\n" + std::string(word) + ",relief_0001.vti\n");
    CHECK(GetSteps(reader).empty() && GetColumns(reader) == std::vector<int>({ 1, 2 }));
  }
  // A new table without times removes the time steps.
  RelevoWriteFile(folder + "/data.csv", "time,FILE\n5,relief_0000.vti\n6,relief_0001.vti\n");
  reader->Modified();
  CHECK_EQUAL(GetSteps(reader).size(), 2);
  RelevoWriteFile(folder + "/data.csv", "FILE\nrelief_0000.vti\nrelief_0001.vti\n");
  reader->Modified();
  CHECK(GetSteps(reader).empty());
  reader->Update();
  CHECK_EQUAL(GetColumns(reader), std::vector<int>({ 1, 2 }));
  CHECK(!reader->GetOutput()->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()));
}
}

int TestReliefDatabaseTime(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "ReliefDatabaseTime");
  TestSteps(check, folder);
  TestTables(check, folder);
  return check.GetResult();
}
