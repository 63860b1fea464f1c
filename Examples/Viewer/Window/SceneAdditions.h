// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneAdditions
 * @brief   the axes, the scale bar and the ruler that options add to a scene
 */
#ifndef SceneAdditions_h
#define SceneAdditions_h

#include "Options/OptionCopy.h"
#include "Scene/AxesTriad.h"
#include "Window/ViewerScaleBar.h"

#include <memory>

struct ViewerOptions;
class ViewerScene;

class SceneAdditions
{
public:
  /// The options that choose them.
  static OptionNames GetOptions() { return { "--axes", "--ruler", "--scale-bar" }; }

  /// Adds to a scene, or removes, what the options choose. The scene must outlive this object.
  void Show(ViewerScene& scene, const ViewerOptions& options);

private:
  std::unique_ptr<AxesTriad> Axes;
  std::unique_ptr<ViewerScaleBar> ScaleBar;
};

#endif
