// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerFlight.h"

#include "Files/FlightFile.h"
#include "Files/ViewerFile.h"
#include "Files/ViewerPicture.h"
#include "Options/ViewerOptions.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <vtksys/SystemTools.hxx>

#include <vector>

namespace
{
// "frames/%04d.png", 7 -> "frames/0007.png"
std::string MakeFrameName(const std::string& pattern, std::size_t number)
{
  const std::size_t begin = pattern.find('%');
  const std::size_t end = pattern.find('d', begin);
  const std::string width = pattern.substr(begin + 1, end - begin - 1);
  std::string digits = std::to_string(number);
  const std::size_t length = width.empty() ? 0 : std::stoul(width);
  digits.insert(0, length > digits.size() ? length - digits.size() : 0, '0');
  return pattern.substr(0, begin) + digits + pattern.substr(end + 1);
}
}

//------------------------------------------------------------------------------
void DrawFlight(ViewerScene& scene, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages)
{
  const std::vector<FlightPosition> positions = ReadFlightFile(options.Flight);
  scene.CheckFlight(positions);
  const std::string folder = vtksys::SystemTools::GetFilenamePath(options.Output);
  if (!folder.empty() && !vtksys::SystemTools::MakeDirectory(folder))
  {
    throw ViewerError("cannot create the folder " + folder);
  }
  CheckOutput(MakeFrameName(options.Output, 0));
  vtkNew<vtkObject> frames;
  messages.ObserveProgress(frames, "drawing frames");
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    double share = static_cast<double>(i) / positions.size();
    frames->InvokeEvent(vtkCommand::ProgressEvent, &share);
    scene.LookFrom(positions[i]);
    scene.Draw(window);
    WritePicture(window, MakeFrameName(options.Output, i), messages);
  }
  frames->InvokeEvent(vtkCommand::EndEvent);
}
