// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerHelp
 * @brief   shows or hides the mouse actions and keys over the picture with h
 */
#ifndef ViewerHelp_h
#define ViewerHelp_h

#include "vtkSmartPointer.h"

class vtkObject;
class vtkProp;
class vtkRenderer;
class vtkRenderWindowInteractor;
class vtkTextActor;

class ViewerHelp
{
public:
  /// Must live until the interactor has ended.
  ViewerHelp(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  ~ViewerHelp();

  vtkProp* GetText() const;

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);

  vtkSmartPointer<vtkTextActor> Text;
};

#endif
