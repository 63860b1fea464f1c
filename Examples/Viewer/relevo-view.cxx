// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   draws a height map or a mesh: in a window, or into a picture
 */
#include "ViewerMessages.h"
#include "ViewerOptions.h"
#include "ViewerScene.h"

#include "vtkCamera.h"
#include "vtkInteractorStyleTerrain.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWindowToImageFilter.h"

#ifdef VIEWER_HAS_EGL
#include "vtkEGLOffscreenRenderWindow.h"
#endif

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

namespace
{
enum ExitCode
{
  Success = 0,
  BadInput = 1,
  BadUsage = 2
};

/// Turns about the vertical as VTK's terrain style does, with the wheel and shift as everywhere.
class TerrainStyle : public vtkInteractorStyleTerrain
{
public:
  static TerrainStyle* New();
  vtkTypeMacro(TerrainStyle, vtkInteractorStyleTerrain);

  void OnLeftButtonDown() override
  {
    if (this->Interactor->GetShiftKey())
    {
      this->OnMiddleButtonDown();
    }
    else
    {
      this->Superclass::OnLeftButtonDown();
    }
  }

  void OnLeftButtonUp() override
  {
    this->OnMiddleButtonUp();
    this->Superclass::OnLeftButtonUp();
  }

  void OnMouseWheelForward() override { this->DollyBy(1.1); }
  void OnMouseWheelBackward() override { this->DollyBy(1.0 / 1.1); }

private:
  void DollyBy(double factor)
  {
    this->FindPokedRenderer(
      this->Interactor->GetEventPosition()[0], this->Interactor->GetEventPosition()[1]);
    if (this->CurrentRenderer)
    {
      this->CurrentRenderer->GetActiveCamera()->Dolly(factor);
      this->CurrentRenderer->ResetCameraClippingRange();
      this->Interactor->Render();
    }
  }
};
vtkStandardNewMacro(TerrainStyle);

bool HasDisplay()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

vtkSmartPointer<vtkRenderWindow> NewOffscreenWindow()
{
#ifdef VIEWER_HAS_EGL
  return vtkSmartPointer<vtkEGLOffscreenRenderWindow>::New();
#else
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  return window;
#endif
}

void WritePicture(vtkRenderWindow* window, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  messages.Observe(writer, "writing");
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(fileName.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw ViewerError("cannot write " + fileName);
  }
}

void Draw(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages)
{
  auto window = NewOffscreenWindow();
  messages.Observe(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetMultiSamples(4);
  window->AddRenderer(scene.GetRenderer());
  window->Render();
  messages.Check();
  if (options.Statistics)
  {
    scene.PrintStatistics(window, std::cout);
  }
  if (!options.Output.empty())
  {
    WritePicture(window, options.Output, messages);
  }
}

void Interact(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages)
{
  vtkNew<vtkRenderWindow> window;
  // At once, for VTK ends the program after its message that the display cannot be reached.
  messages.ThrowErrorsOf(window);
  window->GetScreenSize();
  // VTK 9.4 and later make a window without display of it instead.
  if (!window->GetShowWindow())
  {
    throw ViewerError("cannot reach DISPLAY=" + std::string(std::getenv("DISPLAY")) +
      "; --output FILE.png draws a picture without one");
  }
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName(("relevo-view " + options.Input).c_str());
  window->AddRenderer(scene.GetRenderer());
  vtkNew<vtkRenderWindowInteractor> interactor;
  // A terrain has a vertical; a mesh is turned in the hand.
  auto style = vtkSmartPointer<vtkInteractorStyle>::Take(options.IsMesh
      ? static_cast<vtkInteractorStyle*>(vtkInteractorStyleTrackballCamera::New())
      : TerrainStyle::New());
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  window->Render();
  messages.Check();
  if (options.Statistics)
  {
    scene.PrintStatistics(window, std::cout);
  }
  interactor->Start();
}

void Run(const ViewerOptions& options)
{
  const bool isInteractive = options.Output.empty() && options.Export.empty();
  if (isInteractive && !HasDisplay())
  {
    throw ViewerError("there is no display; --output FILE.png draws a picture without one");
  }
  ViewerMessages messages;
  const std::unique_ptr<ViewerScene> scene = MakeScene(options, messages);
  if (!options.Export.empty())
  {
    scene->Export(options.Export);
  }
  if (isInteractive)
  {
    Interact(*scene, options, messages);
  }
  else if (!options.Output.empty() || options.Statistics)
  {
    Draw(*scene, options, messages);
  }
}
}

int main(int argc, char* argv[])
{
  try
  {
    const ViewerOptions options = ParseOptions(argc, argv);
    if (options.Help)
    {
      std::cout << GetUsage();
    }
    else
    {
      Run(options);
    }
    return Success;
  }
  catch (const UsageError& error)
  {
    std::cerr << "relevo-view: error: " << error.what() << " (see relevo-view --help)" << std::endl;
    return BadUsage;
  }
  catch (const std::exception& error)
  {
    std::cerr << "relevo-view: error: " << error.what() << std::endl;
    return BadInput;
  }
}
