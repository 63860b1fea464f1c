// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainStyle
 * @brief   turns about the vertical as VTK's terrain style does, with the wheel and shift as
 * everywhere, without VTK's stereo mode
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
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;

private:
  void DollyBy(double factor);
};

#endif
