// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerRuler
 * @brief   measures the distance between two points under the mouse, by a key
 */
#ifndef ViewerRuler_h
#define ViewerRuler_h

#include <array>
#include <optional>

class ViewerFrames;
class ViewerScene;
class vtkObject;
class vtkRenderWindowInteractor;

class ViewerRuler
{
public:
  /// Must live until the interactor has ended.
  ViewerRuler(vtkRenderWindowInteractor* interactor, ViewerFrames& frames, ViewerScene& scene);

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);

  ViewerFrames& Frames;
  ViewerScene& Scene;
  std::optional<std::array<double, 3>> First; // the end that is set
};

#endif
