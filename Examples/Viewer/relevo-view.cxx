// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   draws a height map or a mesh in a window or to a picture
 */
#include "Files/ViewerExport.h"
#include "Files/ViewerFile.h"
#include "Files/ViewerPicture.h"
#include "Options/OptionParser.h"
#include "Options/ProgramRun.h"
#include "Options/ViewerUsage.h"
#include "Scene/OffscreenWindow.h"
#include "Scene/PictureSeries.h"
#include "Scene/ReliefCaptures.h"
#include "Scene/SceneFactory.h"
#include "Scene/SceneProgram.h"
#include "Scene/SceneSession.h"
#include "Scene/TerrainHeight.h"
#include "Scene/ViewerScene.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"
#include "Window/DisplayConnection.h"
#include "Window/SceneAdditions.h"
#include "Window/ViewerServer.h"
#include "Window/ViewerWindow.h"

#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <array>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
void Draw(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages)
{
  auto window = NewOffscreenWindow();
  messages.Observe(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetMultiSamples(4);
  window->AddRenderer(scene.GetRenderer());
  SceneAdditions additions;
  additions.Show(scene, options);
  if (!options.Flight.empty())
  {
    DrawFlight(scene, window, options, messages);
    scene.CheckPictures();
    return;
  }
  if (options.IsSeries())
  {
    DrawTimeSteps(scene, window, options, messages);
    return;
  }
  scene.Draw(window);
  ShowReliefs(scene.GetRenderer(), window, options, messages);
  if (!options.Output.empty())
  {
    WritePicture(window, options.Output, messages);
  }
  const std::array<int, 2> size = { { options.Size[0], options.Size[1] } };
  if (!options.SaveScript.empty())
  {
    SaveScript(scene, options, size, options.SaveScript);
  }
  if (!options.SaveSource.empty())
  {
    SaveSource(scene, options, size, options.SaveSource);
  }
  scene.CheckPictures();
}

void Run(const ViewerOptions& options)
{
  if (options.HeightAt)
  {
    InstallCrashHandlers(options.Input);
    std::cout << std::setprecision(10) << FindTerrainHeight(options.Input, *options.HeightAt)
              << std::endl;
    return;
  }
  const bool isInteractive = !options.Serve && options.Output.empty() && options.Export.empty() &&
    options.Capture.empty() && options.Against.empty() && options.MicroMesh.empty();
  if (isInteractive && !HasDisplay())
  {
    throw ViewerError("there is no display; use --output FILE.png to write a picture without one");
  }
  std::vector<std::string> files = { options.Output, options.Export, options.MicroMesh,
    options.SaveScript, options.SaveSession };
  if (options.IsTiled && !options.Imagery.empty() && !options.Export.empty())
  {
    const std::vector<std::string> companions = GetCompanions(options.Export);
    files.insert(files.end(), companions.begin(), companions.end());
  }
  for (const std::string& fileName : files)
  {
    if (!fileName.empty() && !IsFramePattern(fileName))
    {
      CheckOutput(fileName);
    }
  }
  InstallCrashHandlers(options.Input);
  ViewerMessages messages;
  const std::unique_ptr<ViewerScene> scene = MakeScene(options, messages);
  messages.ShowWarnings();
  messages.ShowNotes();
  scene->Report();
  if (options.Camera)
  {
    SetCamera(scene->GetRenderer(), *options.Camera);
  }
  if (!options.Export.empty())
  {
    scene->Export(options.Export);
  }
  if (isInteractive)
  {
    ShowWindow(*scene, options, messages);
  }
  else if (options.Serve)
  {
    ServeScene(*scene, options, messages);
  }
  else if (!options.Output.empty() || !options.Capture.empty() || options.Statistics)
  {
    Draw(*scene, options, messages);
  }
  if (!options.SaveSession.empty())
  {
    SaveSession(*scene, options);
  }
}
}

int main(int argc, char* argv[])
{
  return RunProgram("relevo-view",
    [&]
    {
      const ViewerOptions options = ParseOptions(argc, argv);
      if (options.Help)
      {
        std::cout << GetUsage();
      }
      else if (options.Version)
      {
        std::cout << "relevo-view " << RELEVO_VERSION << std::endl;
      }
      else
      {
        Run(options);
      }
    });
}
