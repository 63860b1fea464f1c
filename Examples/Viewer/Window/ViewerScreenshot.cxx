// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerScreenshot.h"

#include "Files/ViewerPicture.h"
#include "Text/PrintableText.h"
#include "Text/StandardError.h"
#include "Text/ViewerMessages.h"
#include "Window/ViewerFrames.h"

#include "vtkCommand.h"
#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>

//------------------------------------------------------------------------------
ViewerScreenshot::ViewerScreenshot(vtkRenderWindowInteractor* interactor, ViewerFrames& frames,
  const std::string& input, const std::vector<vtkProp*>& words, ViewerMessages& messages)
  : Frames(frames)
  , Input(input)
  , Words(words)
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
    const std::string fileName = FindPictureName(this->Input);
    this->Frames.Flush();
    this->Write(interactor->GetRenderWindow(), fileName);
    std::cout << "picture: " << ToPrintable(fileName) << std::endl;
  }
  catch (const ViewerError& error)
  {
    // The window stays open.
    WriteMessage("warning", error.what());
  }
}

//------------------------------------------------------------------------------
void ViewerScreenshot::Write(vtkRenderWindow* window, const std::string& fileName)
{
  std::vector<vtkProp*> shown;
  std::copy_if(this->Words.begin(), this->Words.end(), std::back_inserter(shown),
    [](vtkProp* words) { return words->GetVisibility() != 0; });
  const auto draw = [&](bool hasWords)
  {
    for (vtkProp* words : shown)
    {
      words->SetVisibility(hasWords);
    }
    // If texts are hidden for the picture, the frame must not appear on the screen.
    window->SetSwapBuffers(hasWords);
    window->Render();
  };
  if (!shown.empty())
  {
    draw(false);
  }
  std::exception_ptr error;
  try
  {
    // Another window may have created the file in the meantime.
    WritePicture(window, fileName, this->Messages, relevo::AtomicFile::OldFile::Keep);
  }
  catch (const ViewerError&)
  {
    error = std::current_exception();
  }
  if (!shown.empty())
  {
    draw(true);
  }
  if (error)
  {
    std::rethrow_exception(error);
  }
}
