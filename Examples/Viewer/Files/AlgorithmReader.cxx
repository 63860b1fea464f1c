// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/AlgorithmReader.h"

#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
AlgorithmReader::AlgorithmReader(vtkAlgorithm* reader, ViewerMessages& messages)
  : Reader(reader)
  , Messages(messages)
{
  messages.Observe(reader, "reading");
}

//------------------------------------------------------------------------------
AlgorithmReader::~AlgorithmReader() = default;

//------------------------------------------------------------------------------
std::vector<double> AlgorithmReader::GetTimes()
{
  this->Reader->UpdateInformation();
  this->Messages.Check();
  vtkInformation* information = this->Reader->GetOutputInformation(0);
  vtkInformationDoubleVectorKey* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  std::vector<double> times;
  if (information->Has(key))
  {
    times.assign(information->Get(key), information->Get(key) + information->Length(key));
  }
  times.erase(
    std::remove_if(times.begin(), times.end(), [](double t) { return !std::isfinite(t); }),
    times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> AlgorithmReader::Read(const std::optional<double>& time)
{
  ReadingGuard::RestartProgress();
  if (time)
  {
    this->Reader->UpdateTimeStep(*time);
  }
  else
  {
    this->Reader->Update();
  }
  this->Messages.Check();
  // The reader uses its output again for the next step.
  vtkDataObject* output = this->Reader->GetOutputDataObject(0);
  if (!output)
  {
    return nullptr;
  }
  auto data = vtkSmartPointer<vtkDataObject>::Take(output->NewInstance());
  data->ShallowCopy(output);
  return data;
}
