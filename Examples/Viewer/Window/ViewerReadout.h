// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerReadout
 * @brief   what is under the mouse: in the lower left corner, and with c on standard output
 *
 * Where the mouse rests, for a frame is drawn for it.
 */
#ifndef ViewerReadout_h
#define ViewerReadout_h

#include "vtkSmartPointer.h"

#include <string>

class vtkObject;
class vtkRenderWindowInteractor;
class vtkTextActor;
class ViewerScene;

class ViewerReadout
{
public:
  /// Is there until the interactor has ended.
  ViewerReadout(vtkRenderWindowInteractor* interactor, ViewerScene& scene);
  ~ViewerReadout();

private:
  void OnChange(vtkObject* caller, unsigned long event, void* data);
  void OnTimer(vtkObject* caller, unsigned long event, void* data);
  void OnKey(vtkObject* caller, unsigned long event, void* data);
  /// Empty where there is nothing.
  std::string Describe(vtkRenderWindowInteractor* interactor);

  ViewerScene& Scene;
  vtkSmartPointer<vtkTextActor> Text;
  int Timer = 0; // of the interactor, until mouse and picture count as resting; 0 for none
};

#endif
