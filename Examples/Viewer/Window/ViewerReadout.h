// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerReadout
 * @brief   shows values under the mouse in the lower left corner, and prints them with c
 *
 * It follows the mouse and the view, also during drags. If frames are slow, it waits until both
 * rest, because it needs an additional frame.
 */
#ifndef ViewerReadout_h
#define ViewerReadout_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkObject;
class vtkProp;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkTextActor;
class ViewerFrames;
class ViewerScene;

class ViewerReadout
{
public:
  /// Must live until the interactor has ended.
  ViewerReadout(vtkRenderWindowInteractor* interactor, ViewerFrames& frames, ViewerScene& scene);
  ~ViewerReadout();

  vtkProp* GetText() const;

private:
  void OnChange();
  void OnFrame(vtkObject* caller, unsigned long event, void* data);
  void OnTimer(int timer);
  void OnKey(vtkObject* caller, unsigned long event, void* data);
  /// Empty if there is nothing under the mouse.
  std::string Describe();

  vtkRenderWindowInteractor* Interactor;
  ViewerFrames& Frames;
  ViewerScene& Scene;
  vtkSmartPointer<vtkTextActor> Text;
  vtkNew<vtkRenderer> Layer; // in front of the scene, whose depths are known when it is drawn
  int Timer = 0;             // the interactor's timer until the next update; 0 for none
};

#endif
