// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerScreenshot.h"

#include "Files/ViewerPicture.h"
#include "Text/PrintableText.h"
#include "Text/StandardError.h"
#include "Text/ViewerMessages.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <filesystem>
#include <iostream>
#include <system_error>

//------------------------------------------------------------------------------
ViewerScreenshot::ViewerScreenshot(
  vtkRenderWindowInteractor* interactor, const std::string& input, ViewerMessages& messages)
  : Stem(std::filesystem::path(input).stem().string())
  , Messages(messages)
{
  interactor->AddObserver(vtkCommand::KeyPressEvent, this, &ViewerScreenshot::OnKey);
}

//------------------------------------------------------------------------------
void ViewerScreenshot::OnKey(vtkObject* caller, unsigned long, void*)
{
  auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  if (interactor->GetKeyCode() != 'i')
  {
    return;
  }
  try
  {
    const std::string fileName = this->FindName();
    // Another window may have taken the name by now.
    WritePicture(
      interactor->GetRenderWindow(), fileName, this->Messages, relevo::AtomicFile::OldFile::Keep);
    std::cout << "picture: " << ToPrintable(fileName) << std::endl;
  }
  catch (const ViewerError& error)
  {
    // The window stays.
    WriteMessage("warning", error.what());
  }
}

//------------------------------------------------------------------------------
std::string ViewerScreenshot::FindName() const
{
  for (int number = 1;; ++number)
  {
    const std::string fileName = this->Stem + "-" + std::to_string(number) + ".png";
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(fileName, error)))
    {
      return fileName;
    }
  }
}
