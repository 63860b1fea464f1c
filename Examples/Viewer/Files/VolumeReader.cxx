// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/VolumeReader.h"

#include "Files/ResultFile.h"
#include "Files/ResultFormats.h"
#include "Files/StepFilter.h"
#include "Text/ViewerMessages.h"

#include "vtkDataObject.h"

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadVolume(
  ResultFile& file, int step, StepFilter& filter, ViewerMessages& messages)
{
  const std::string& fileName = file.GetFileName();
  if (!IsVolumeFile(fileName))
  {
    throw ViewerError("cannot read " + fileName + ": --volume reads " + GetVolumeFormats());
  }
  vtkSmartPointer<vtkDataObject> volume;
  file.Read(step, [&](vtkDataObject* data) { volume = filter.Apply(data, messages); });
  filter.Check(fileName);
  if (volume->GetNumberOfElements(vtkDataObject::CELL) == 0)
  {
    throw ViewerError(fileName + " has no cells to draw");
  }
  return volume;
}
