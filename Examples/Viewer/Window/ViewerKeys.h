// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerKeys
 * @brief   keys that change the scene
 */
#ifndef ViewerKeys_h
#define ViewerKeys_h

class vtkObject;
class vtkRenderWindowInteractor;
class ViewerScene;

class ViewerKeys
{
public:
  /// Must live until the interactor has ended.
  ViewerKeys(vtkRenderWindowInteractor* interactor, ViewerScene& scene);

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);

  ViewerScene& Scene;
};

#endif
