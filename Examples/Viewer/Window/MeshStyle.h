// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshStyle
 * @brief   VTK's trackball style without its stereo mode
 */
#ifndef MeshStyle_h
#define MeshStyle_h

#include "vtkInteractorStyleTrackballCamera.h"

class MeshStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static MeshStyle* New();
  vtkTypeMacro(MeshStyle, vtkInteractorStyleTrackballCamera);

  void OnChar() override;

  /// Does nothing. VTK's style would repeat the last motion of a drag with each timer.
  void OnTimer() override {}
};

#endif
