// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellProjector
 * @brief   the stage that draws cells from back to front, to the frame's target
 *
 * Private to the module.
 */
#ifndef CellProjector_h
#define CellProjector_h

#include "Targets/RenderTarget.h"
#include "View/QuadBatches.h"

#include <string>

class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
struct VolumeFrame;

class CellProjector
{
public:
  /// Sort and draw the cells. Return the error, or "". The target then contains an image, or data
  /// that the program VolumeShader::Finish converts to one, see IsStored().
  std::string Draw(const VolumeFrame& frame);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string RenderRayLimits(const VolumeFrame& frame);
  bool DrawCells(const VolumeFrame& frame, vtkShaderProgram* program);

  RenderTarget Limits; // depth limits of each ray, drawn once for all cells
  QuadBatches Quads;
};
}

#endif
