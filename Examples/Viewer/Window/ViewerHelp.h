// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerHelp
 * @brief   what mouse and keys do, over the picture and away again with h
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
  /// Is there until the interactor has ended.
  ViewerHelp(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  ~ViewerHelp();

  vtkProp* GetText() const;

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);

  vtkSmartPointer<vtkTextActor> Text;
};

#endif
