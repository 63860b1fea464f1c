// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerPicture.h"

#include "Files/WriteFile.h"
#include "Text/ViewerMessages.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

//------------------------------------------------------------------------------
void WritePicture(vtkRenderWindow* window, const std::string& fileName, ViewerMessages& messages,
  relevo::AtomicFile::OldFile oldFile)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  messages.ObserveProgress(writer, "writing");
  writer->SetInputConnection(picture->GetOutputPort());
  relevo::AtomicFile file(fileName);
  relevo::WritePNG(file, writer.Get());
  if (!file.Commit(oldFile))
  {
    throw ViewerError("cannot write " + fileName + ": " + file.GetError());
  }
}
