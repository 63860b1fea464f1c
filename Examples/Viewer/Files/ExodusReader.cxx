// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ExodusReader.h"

#include "Text/ViewerMessages.h"

#include "vtkCompositeDataGeometryFilter.h"
#include "vtkExodusIIReader.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <sstream>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadExodusBlocks(
  const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkExodusIIReader> reader;
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->UpdateInformation();
  messages.Check();
  for (int type : { vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK })
  {
    reader->SetAllArrayStatus(type, 1);
  }
  // Reads the first time step explicitly.
  const int steps = reader->GetNumberOfTimeSteps();
  vtkInformation* information = reader->GetOutputInformation(0);
  if (steps > 1 && information->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
  {
    const double* times = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    std::ostringstream text;
    text << fileName << ": only time step 1 of " << steps << " is drawn (time " << times[0] << ")";
    messages.Tell(text.str());
  }
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadExodus(const std::string& fileName, ViewerMessages& messages)
{
  const auto blocks = ReadExodusBlocks(fileName, messages);
  vtkNew<vtkCompositeDataGeometryFilter> surface;
  messages.Observe(surface, "extracting the surface");
  surface->SetInputDataObject(blocks);
  surface->Update();
  messages.Check();
  return surface->GetOutput();
}
