// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderClock
 * @brief   how long drawing takes, on the CPU and on the GPU, without waiting for either
 *
 * The GPU gives its time when it is done, mostly a frame later: the time of the latest that is
 * known is added. Software renderers draw on the CPU partly while commands are given and partly
 * afterwards, in what they call the GPU's time: the sum is right there, too, and for a graphics
 * card more than enough.
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
  /// Seconds.
  double Stop();

  void ReleaseGraphicsResources();

private:
  vtkOpenGLRenderTimer Timer;
  double StartTime = 0.0;
};
}

#endif
