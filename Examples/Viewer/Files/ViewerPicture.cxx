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

#include <filesystem>
#include <system_error>

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

//------------------------------------------------------------------------------
std::string FindPictureName(const std::string& input)
{
  const std::string stem = std::filesystem::path(input).stem().string();
  for (int number = 1;; ++number)
  {
    const std::string fileName = stem + "-" + std::to_string(number) + ".png";
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(fileName, error)))
    {
      return fileName;
    }
  }
}
