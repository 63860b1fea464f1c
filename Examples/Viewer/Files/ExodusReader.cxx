// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ExodusReader.h"

#include "Text/ViewerMessages.h"

#include "vtkCompositeDataGeometryFilter.h"
#include "vtkExodusIIReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

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
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadExodus(const std::string& fileName, ViewerMessages& messages)
{
  const auto blocks = ReadExodusBlocks(fileName, messages);
  vtkNew<vtkCompositeDataGeometryFilter> surface;
  messages.Observe(surface, "taking the surface");
  surface->SetInputDataObject(blocks);
  surface->Update();
  messages.Check();
  return surface->GetOutput();
}
