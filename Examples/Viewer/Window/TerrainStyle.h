// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainStyle
 * @brief   rotates about the vertical axis like VTK's terrain style, with the usual actions of
 * wheel and shift, and without VTK's stereo mode
 */
#ifndef TerrainStyle_h
#define TerrainStyle_h

#include "vtkInteractorStyleTerrain.h"

class TerrainStyle : public vtkInteractorStyleTerrain
{
public:
  static TerrainStyle* New();
  vtkTypeMacro(TerrainStyle, vtkInteractorStyleTerrain);

  void OnChar() override;
  /// Does nothing. VTK's style would repeat the last motion of a drag with each timer.
  void OnTimer() override {}
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;

private:
  void DollyBy(double factor);
};

#endif
