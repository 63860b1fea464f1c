// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshFilter promises a coarse mesh whose surface and the input are within the tolerance of
// each other, with bounds of both distances. Distances are measured here by sampling, with VTK's
// locator. The result is the same for any number of threads and after a .vtp file.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMicroMeshFilter.h"
#include "vtkSMPTools.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <vector>

using namespace RelevoMicroMeshes;

namespace
{
void CheckErrors(RelevoCheck& check, vtkPolyData* dense, double share, double most)
{
  CHECK_CASE(share);
  const double tolerance = share * dense->GetLength();
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(dense);
  filter->SetTolerance(tolerance);
  filter->SetMaximumLevel(3);
  filter->SetTargetReduction(0.98);
  filter->Update();
  CHECK(errors.None());
  vtkPolyData* micro = filter->GetOutput();
  CHECK_GREATER(micro->GetNumberOfPolys(), 3);
  CHECK_LESS_EQUAL(micro->GetNumberOfPolys(), most * dense->GetNumberOfPolys());
  vtkDataArray* bounds = micro->GetFieldData()->GetArray("MicroMeshError");
  if (!CHECK(bounds && bounds->GetNumberOfTuples() == 2))
  {
    return;
  }
  CHECK_EQUAL(filter->GetError(), std::max(bounds->GetTuple1(0), bounds->GetTuple1(1)));
  CHECK_LESS_EQUAL(filter->GetError(), tolerance);
  const Mesh result = Decode(micro, 3);
  const double rounding = 1e-6 * dense->GetLength(); // of floats
  const double there = GetDistance(dense, result);
  const double back = GetDistance(result, dense);
  CHECK_LESS_EQUAL(there, bounds->GetTuple1(0) + rounding);
  CHECK_LESS_EQUAL(back, bounds->GetTuple1(1) + rounding);
  // The bounds are not far above the distances.
  CHECK_GREATER(std::max(there, back), 0.3 * tolerance);
}

Mesh Read(const std::string& text)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  return reader->GetOutput();
}

struct Progress
{
  int EventsBeforeAbort;
  std::vector<double> Shares;
};

// The output is empty if the filter is aborted.
void CheckProgress(RelevoCheck& check, vtkPolyData* dense, int eventsBeforeAbort)
{
  CHECK_CASE(eventsBeforeAbort);
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(dense);
  filter->SetTolerance(0.002);
  Progress progress{ eventsBeforeAbort, {} };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&progress);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto filter = static_cast<vtkAlgorithm*>(caller);
      auto progress = static_cast<Progress*>(data);
      progress->Shares.push_back(filter->GetProgress());
      if (static_cast<int>(progress->Shares.size()) == progress->EventsBeforeAbort)
      {
        filter->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  CHECK(errors.None());
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells() > 0, eventsBeforeAbort == 0);
  CHECK_GREATER(static_cast<int>(progress.Shares.size()) + 1, std::max(2, eventsBeforeAbort));
  CHECK(std::is_sorted(progress.Shares.begin(), progress.Shares.end()));
  CHECK(progress.Shares.front() >= 0.0 && progress.Shares.back() <= 1.0);
}
}

int TestMicroMeshFilter(int, char*[])
{
  RelevoCheck check;
  const Mesh sphere = ReliefSphere(48, 30);
  const Mesh plate = Plate(28);
  CheckErrors(check, sphere, 0.01, 0.05);
  CheckErrors(check, sphere, 0.002, 0.3);
  vtkNew<vtkAppendPolyData> parts;
  parts->AddInputData(plate);
  parts->AddInputData(sphere);
  parts->Update();
  CheckErrors(check, parts->GetOutput(), 0.005, 0.2);

  vtkSMPTools::Initialize(1);
  const Mesh one = Encode(plate, 0.003);
  vtkSMPTools::Initialize(3);
  const Mesh three = Encode(plate, 0.003);
  vtkSMPTools::Initialize();
  CHECK_GREATER(one->GetNumberOfCells(), 0);
  CHECK_EQUAL(CountDifferences(one, three), 0);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(one);
  writer->WriteToOutputStringOn();
  writer->Write();
  const Mesh read = Read(writer->GetOutputString());
  CHECK_EQUAL(CountDifferences(one, read), 0);
  CHECK_EQUAL(CountDifferences(Decode(one, 4), Decode(read, 4)), 0);
  for (int events : { 0, 1, 2, 4 })
  {
    CheckProgress(check, sphere, events);
  }
  return check.GetResult();
}
