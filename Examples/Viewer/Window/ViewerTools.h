// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerTools
 * @brief   the mouse, keys, texts and timers of a window that shows a scene
 */
#ifndef ViewerTools_h
#define ViewerTools_h

#include "Scene/AxesTriad.h"
#include "Window/ViewerFrames.h"
#include "Window/ViewerHelp.h"
#include "Window/ViewerKeys.h"
#include "Window/ViewerLoading.h"
#include "Window/ViewerReadout.h"
#include "Window/ViewerRuler.h"
#include "Window/ViewerScaleBar.h"
#include "Window/ViewerScreenshot.h"

#include <memory>

struct ViewerOptions;
class ViewerMessages;
class ViewerScene;
class vtkRenderWindowInteractor;

class ViewerTools
{
public:
  /// Must live until the interactor has ended.
  ViewerTools(vtkRenderWindowInteractor* interactor, ViewerScene& scene,
    const ViewerOptions& options, ViewerMessages& messages);

private:
  ViewerFrames Frames;
  const ViewerLoading Loading;
  const ViewerScaleBar ScaleBar;
  std::unique_ptr<AxesTriad> Axes;    // nullptr for a terrain
  std::unique_ptr<ViewerRuler> Ruler; // nullptr for a terrain
  const ViewerReadout Readout;
  const ViewerHelp Help;
  const ViewerKeys Keys;
  const ViewerScreenshot Screenshot;
};

#endif
