// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderClock
 * @brief   measures the time to draw on the CPU and on the GPU, without waiting for either
 *
 * The GPU reports its time when it has finished, usually one frame later, so the latest known time
 * is added. Software renderers draw on the CPU, partly while commands are submitted and partly in
 * the time that they report as the GPU's. The sum is right for them, too; for a graphics card it is
 * an upper bound.
 */
#ifndef RenderClock_h
#define RenderClock_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkOpenGLRenderTimer.h"      // for members

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT RenderClock
{
public:
  void Start();
  /// Return the time in seconds.
  double Stop();

  void ReleaseGraphicsResources();

private:
  vtkOpenGLRenderTimer Timer;
  double StartTime = 0.0;
};
}

#endif
