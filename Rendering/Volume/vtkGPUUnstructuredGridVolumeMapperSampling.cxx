// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "Checks/SettingChecks.h"

#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of pixels, when the distance follows from the time.
constexpr double LargestDistance = 10.0;
}

void vtkGPUUnstructuredGridVolumeMapper::SetImageSampleDistance(double distance)
{
  relevo::SetInRange(this, "ImageSampleDistance", this->ImageSampleDistance, distance, 0.1, 100.0);
}

// The pixels that rays are cast for; false if they are the viewport's.
bool vtkGPUUnstructuredGridVolumeMapper::FindSampledSize(vtkVolume* volume, const int viewport[4])
{
  vtkInternals& data = *this->Internals;
  double distance = this->ImageSampleDistance;
  if (this->AutoAdjustSampleDistances)
  {
    const double allocated = std::max(volume->GetAllocatedRenderTime(), 1e-6);
    distance = std::clamp(std::sqrt(data.WholeTime / allocated), 1.0, LargestDistance);
  }
  data.SampleDistance = distance;
  for (int i = 0; i < 2; ++i)
  {
    data.SampledSize[i] = std::max(static_cast<int>(std::lround(viewport[2 + i] / distance)), 1);
  }
  return data.SampledSize[0] != viewport[2] || data.SampledSize[1] != viewport[3];
}

void vtkGPUUnstructuredGridVolumeMapper::DrawSampled(vtkVolume* volume, const int viewport[4])
{
  vtkInternals& data = *this->Internals;
  const int sampled[4] = { 0, 0, data.SampledSize[0], data.SampledSize[1] };
  if (!this->ReadyRays(volume, sampled))
  {
    return;
  }
  const bool hasTarget = data.Projection.Begin(data.GetWindow(), sampled[2], sampled[3], { {} });
  if (hasTarget)
  {
    data.Projection.Draw(relevo::BlendOperation::Over, &relevo::ScreenPass::DrawTriangle);
    data.Projection.End();
  }
  data.FinishRays();
  if (!hasTarget)
  {
    vtkErrorMacro("This OpenGL has no room for " << sampled[2] << " x " << sampled[3]
                                                 << " pixels; choose a larger "
                                                    "ImageSampleDistance.");
    return;
  }
  this->BlendProjection(viewport, relevo::MakeProjectedShader());
}

// What has been drawn into the target, into the window, by a shader that reads it.
void vtkGPUUnstructuredGridVolumeMapper::BlendProjection(
  const int viewport[4], const std::string& source)
{
  vtkInternals& data = *this->Internals;
  data.View.SetViewport(relevo::dvec4(viewport[0], viewport[1], viewport[2], viewport[3]));
  vtkShaderProgram* program = this->ReadyProgram(relevo::ScreenPass::GetVertexShader(), source);
  if (program)
  {
    data.View.SetUniforms(program);
    data.FunctionBuffers.Activate(program);
    const char* samplers[] = { "projected", "projected1", "projected2" };
    for (size_t i = 0; i < 3; ++i)
    {
      data.Projection.Activate(program, samplers[i], i);
    }
    data.Screen.DrawOver(data.GetWindow());
    data.Projection.Deactivate();
    data.FunctionBuffers.Deactivate();
  }
}

// Drawn as the last render drew them, when somebody wants to know.
int vtkGPUUnstructuredGridVolumeMapper::GetNumberOfLayers()
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = data.GetWindow();
  if (!window || !data.HasMesh || data.LayersSize[0] == 0)
  {
    return 0;
  }
  if (data.NumberOfLayers < 0)
  {
    window->MakeCurrent();
    const int width = data.LayersSize[0];
    const int height = data.LayersSize[1];
    if (!this->RenderRayEntries(width, height))
    {
      vtkShaderProgram* program = this->ReadyProgram(
        relevo::ScreenPass::GetVertexShader(), relevo::MakeCountShader(this->GetShaderOptions()));
      if (!program || !data.Entries.Begin(window, width, height))
      {
        return 0;
      }
      data.View.SetUniforms(program);
      data.MeshBuffers.Activate(program);
      data.Entries.DrawCounts();
      data.MeshBuffers.Deactivate();
    }
    data.NumberOfLayers = data.Entries.ReadMost();
  }
  return data.NumberOfLayers;
}
