// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe/VolumeSelection.h"

#include "OpenGL/RelevoOpenGL.h"
#include "Rays/PixelRays.h"
#include "View/WorldView.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
constexpr double Threshold = 0.5; // as in vtkVolumeProbe
// Larger areas get one ray for several pixels.
constexpr double MaximumRays = 4096.0;

struct PixelArea
{
  int Left;
  int Bottom;
  int Width;
  int Height;
};

// Write a colour and a depth into an area. This needs no shader.
void Fill(vtkOpenGLState* state, const PixelArea& area, const float color[3], double depth)
{
  state->vtkglScissor(area.Left, area.Bottom, area.Width, area.Height);
  state->vtkglClearColor(color[0], color[1], color[2], 1.0f);
  state->vtkglClearDepth(depth);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}
}

void VolumeSelection::Draw(
  const ProbeRequest& request, vtkRenderer* renderer, vtkMatrix4x4* matrix, StageReport& report)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !selector->GetActorPassOnly() || !this->Probed.Update(request, report))
  {
    return;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  unsigned int bounds[4]; // with the last pixels
  selector->GetArea(bounds);
  int low[2];
  int count[2];
  for (int i = 0; i < 2; ++i)
  {
    low[i] = std::max(static_cast<int>(bounds[i]), origin[i]);
    count[i] = std::min(static_cast<int>(bounds[2 + i]) + 1, origin[i] + size[i]) - low[i];
    if (count[i] <= 0)
    {
      return;
    }
  }
  const int step =
    static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count[0]) * count[1] / MaximumRays)));
  vtkCamera* camera = renderer->GetActiveCamera();
  const PixelRays rays(camera, size[0], size[1]);
  const dmat4 toDepth = MakeMatrix(camera->GetCompositeProjectionTransformMatrix(
    static_cast<double>(size[0]) / size[1], 0.0, 1.0));
  std::vector<float> depths(static_cast<size_t>(count[0]) * count[1]);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(low[0], low[1], count[0], count[1], GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  float color[3];
  selector->BeginRenderProp();
  selector->GetPropColorValue(color);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_TRUE);
  for (int y = 0; y < count[1]; y += step)
  {
    for (int x = 0; x < count[0]; x += step)
    {
      const PixelArea area = { low[0] + x, low[1] + y, std::min(step, count[0] - x),
        std::min(step, count[1] - y) };
      const Ray ray = rays.Make(
        area.Left - origin[0] + area.Width / 2, area.Bottom - origin[1] + area.Height / 2);
      VolumeHit hit;
      if (!this->Probed.Find(request, matrix, ray, Threshold, hit))
      {
        continue;
      }
      const dvec4 seen = toDepth * dvec4(hit.Position, 1.0);
      const double depth = seen.z / seen.w;
      for (int i = 0; i < area.Width * area.Height; ++i)
      {
        const int column = x + i % area.Width;
        const int row = y + i / area.Width;
        if (depth < depths[static_cast<size_t>(column + count[0] * row)])
        {
          Fill(state, { low[0] + column, low[1] + row, 1, 1 }, color, depth);
        }
      }
    }
  }
  state->vtkglClearDepth(1.0);
  selector->EndRenderProp();
}
}
