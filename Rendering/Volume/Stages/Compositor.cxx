// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/Compositor.h"

#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/VolumeFrame.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// The distance in pixels, if it follows from the time.
constexpr double LargestDistance = 16.0;
}

std::string Compositor::ReadDepths(
  vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport)
{
  return this->Depth.Copy(window, viewport.data()) ? ""
                                                   : "The depths of opaque props cannot be read.";
}

std::string Compositor::SetDepths(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport,
  const std::vector<float>& depths, const std::vector<float>& begins)
{
  const size_t pixels = static_cast<size_t>(viewport[2]) * viewport[3];
  if (depths.size() != pixels || (!begins.empty() && begins.size() != pixels))
  {
    return "There are " + std::to_string(depths.size()) + " depths for " +
      std::to_string(viewport[2]) + " x " + std::to_string(viewport[3]) + " pixels.";
  }
  return this->Depth.Upload(window, viewport[2], viewport[3], depths.data(),
           begins.empty() ? nullptr : begins.data())
    ? ""
    : "The depths of opaque props cannot be uploaded.";
}

std::array<int, 2> Compositor::ChooseSize(
  const std::array<int, 4>& viewport, const SamplingRequest& request)
{
  this->SampleDistance = request.Distance;
  if (request.IsAutomatic)
  {
    const double allocated = std::max(request.AllocatedTime, 1e-6);
    const double needed = std::min(std::sqrt(this->WholeTime / allocated), LargestDistance);
    this->SampleDistance = needed > 1.0 ? std::max(request.Distance, needed) : request.Distance;
  }
  const auto divide = [this](int pixels)
  { return std::max(static_cast<int>(std::lround(pixels / this->SampleDistance)), 1); };
  return { { divide(viewport[2]), divide(viewport[3]) } };
}

void Compositor::SetTime(double seconds)
{
  this->WholeTime = seconds * this->SampleDistance * this->SampleDistance;
}

std::string Compositor::Add(const VolumeFrame& frame, VolumeShader shader)
{
  vtkShaderProgram* program = frame.Programs.Ready(frame.Window, shader, frame.Features.Options);
  if (!program)
  {
    return VolumePrograms::Error;
  }
  frame.GetView(frame.Viewport).SetUniforms(program);
  frame.Functions.Buffers.Activate(program);
  const char* samplers[] = { "projected", "projected1", "projected2" };
  for (size_t i = 0; i < 3; ++i)
  {
    this->Target.Activate(program, samplers[i], i);
  }
  this->Screen.DrawOver(frame.Window);
  this->Target.Deactivate();
  frame.Functions.Buffers.Deactivate();
  return "";
}

void Compositor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depth.ReleaseGraphicsResources(window);
  this->Target.ReleaseGraphicsResources(window);
  this->Screen.ReleaseGraphicsResources();
}
}
