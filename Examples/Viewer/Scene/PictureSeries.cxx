// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PictureSeries.h"

#include "Files/FlightFile.h"
#include "Files/FramePattern.h"
#include "Files/ViewerFile.h"
#include "Files/ViewerPicture.h"
#include "Options/ViewerOptions.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <vtksys/SystemTools.hxx>

#include <functional>
#include <vector>

namespace
{
// Writes pictures to files named by the pattern. prepare() changes the scene for each.
void DrawPictures(ViewerScene& scene, vtkRenderWindow* window, const std::string& pattern,
  std::size_t number, ViewerMessages& messages, const std::function<void(std::size_t)>& prepare)
{
  const std::string folder = vtksys::SystemTools::GetFilenamePath(pattern);
  if (!folder.empty() && !vtksys::SystemTools::MakeDirectory(folder))
  {
    throw ViewerError("cannot create the folder " + folder);
  }
  CheckOutput(MakeFrameName(pattern, 0));
  vtkNew<vtkObject> frames;
  messages.ObserveProgress(frames, "drawing frames");
  for (std::size_t i = 0; i < number; ++i)
  {
    double share = static_cast<double>(i) / number;
    frames->InvokeEvent(vtkCommand::ProgressEvent, &share);
    prepare(i);
    scene.Draw(window);
    WritePicture(window, MakeFrameName(pattern, i), messages);
  }
  frames->InvokeEvent(vtkCommand::EndEvent);
}
}

//------------------------------------------------------------------------------
void DrawFlight(ViewerScene& scene, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages)
{
  const std::vector<FlightPosition> positions = ReadFlightFile(options.Flight);
  scene.CheckFlight(positions);
  DrawPictures(scene, window, options.Output, positions.size(), messages,
    [&](std::size_t i) { scene.LookFrom(positions[i]); });
}

//------------------------------------------------------------------------------
void DrawTimeSteps(ViewerScene& scene, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages)
{
  const auto number = static_cast<std::size_t>(scene.GetNumberOfTimeSteps());
  DrawPictures(scene, window, options.Output, number, messages,
    [&](std::size_t i) { scene.SetTimeStep(static_cast<int>(i)); });
}
