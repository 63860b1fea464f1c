// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerLoading
 * @brief   draws further frames while a scene loads data in the background
 */
#ifndef ViewerLoading_h
#define ViewerLoading_h

class ViewerScene;
class vtkRenderWindowInteractor;

class ViewerLoading
{
public:
  /// Observes the interactor and the scene, and must live as long as both draw.
  ViewerLoading(vtkRenderWindowInteractor* interactor, ViewerScene& scene);
  ViewerLoading(const ViewerLoading&) = delete;
  void operator=(const ViewerLoading&) = delete;

private:
  void OnFrame();
  void OnTimer(int timer);

  vtkRenderWindowInteractor* Interactor;
  ViewerScene& Scene;
  int Timer = 0; // the interactor's timer; 0 for none
};

#endif
