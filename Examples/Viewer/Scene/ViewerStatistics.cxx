// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerStatistics.h"

#include "Text/ViewerMessages.h"

#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <chrono>
#include <iomanip>
#include <ostream>

//------------------------------------------------------------------------------
double MeasureFrame(vtkRenderer* renderer, vtkRenderWindow* window, ViewerMessages& messages)
{
  // The first frame builds buffers and shaders. Its camera differs slightly, so that the second
  // frame selects levels again. The picture of the second frame remains.
  vtkCamera* camera = renderer->GetActiveCamera();
  const double angle = camera->GetViewAngle();
  camera->SetViewAngle(angle * (1.0 + 1e-6));
  window->Render();
  messages.Check();
  camera->SetViewAngle(angle);
  window->WaitForCompletion();
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  window->Render();
  window->WaitForCompletion();
  const double milliseconds =
    std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  messages.Check();
  return milliseconds;
}

//------------------------------------------------------------------------------
void DrawWithStatistics(vtkAdaptiveRefinementMapper* mapper, vtkRenderer* renderer,
  vtkRenderWindow* window, ViewerMessages& messages, std::ostream& stream)
{
  const double milliseconds = MeasureFrame(renderer, window, messages);
  stream << std::fixed << std::setprecision(1)
         << "coarse faces: " << mapper->GetNumberOfCoarseFaces() << "\n"
         << "culled faces: " << mapper->GetNumberOfCulledFaces() << "\n"
         << "drawn triangles: " << mapper->GetNumberOfDrawnTriangles() << "\n"
         << "culled triangles: " << mapper->GetNumberOfCulledTriangles() << "\n"
         << "patterns: " << mapper->GetNumberOfUsedPatterns() << "\n"
         << "draw calls: " << mapper->GetNumberOfDrawCalls() << "\n"
         << "graphics memory: " << mapper->GetGraphicsMemorySize() / 1048576.0 << " MiB\n"
         << "selection time: " << 1000.0 * mapper->GetSelectionTime() << " ms\n"
         << "frame time: " << milliseconds << " ms" << std::endl;
}
