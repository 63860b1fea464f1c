// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerStatistics.h"

#include "ViewerMessages.h"

#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <ostream>
#include <vector>

//------------------------------------------------------------------------------
void PrintStatistics(vtkAdaptiveRefinementMapper* mapper, vtkRenderer* renderer,
  vtkRenderWindow* window, ViewerMessages& messages, std::ostream& stream)
{
  using Clock = std::chrono::steady_clock;
  const int numberOfFrames = 5;
  // A camera that moves, though hardly: levels are chosen anew for every frame.
  vtkCamera* camera = renderer->GetActiveCamera();
  const double position = camera->GetViewAngle();
  std::vector<double> milliseconds;
  window->Render();
  for (int i = 0; i < numberOfFrames; ++i)
  {
    camera->SetViewAngle(position * (1.0 + 1e-6 * (i + 1)));
    window->WaitForCompletion();
    const auto start = Clock::now();
    window->Render();
    window->WaitForCompletion();
    milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  camera->SetViewAngle(position);
  window->Render();
  messages.Check();
  std::sort(milliseconds.begin(), milliseconds.end());

  stream << std::fixed << std::setprecision(1)
         << "coarse faces: " << mapper->GetNumberOfCoarseFaces() << "\n"
         << "culled faces: " << mapper->GetNumberOfCulledFaces() << "\n"
         << "drawn triangles: " << mapper->GetNumberOfDrawnTriangles() << "\n"
         << "patterns: " << mapper->GetNumberOfUsedPatterns() << "\n"
         << "draw calls: " << mapper->GetNumberOfDrawCalls() << "\n"
         << "graphics memory: " << mapper->GetGraphicsMemorySize() / 1048576.0 << " MiB\n"
         << "selection time: " << 1000.0 * mapper->GetSelectionTime() << " ms\n"
         << "frame time: " << milliseconds[numberOfFrames / 2] << " ms" << std::endl;
}
