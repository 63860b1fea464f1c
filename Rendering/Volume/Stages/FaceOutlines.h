// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceOutlines
 * @brief   the projected outlines of the faces of active cells
 *
 * A pass computes them for a view. Private to the module.
 */
#ifndef FaceOutlines_h
#define FaceOutlines_h

#include "Buffers/CellPass.h"
#include "Shaders/VolumeShader.h"

class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class ActiveCells;
class RayView;
struct VolumeFrame;

class FaceOutlines
{
public:
  /// Find the outlines of the uploaded faces. The options determine which data are stored with
  /// them. Return false if there is not enough memory.
  bool Find(const VolumeFrame& frame, const VolumeShaderOptions& options, const RayView& view,
    ActiveCells& cells);

  //@{
  /// Bind the outlines to the samplers of a vertex shader.
  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Pass.Deactivate(); }
  //@}

  void ReleaseGraphicsResources(vtkWindow* window) { this->Pass.ReleaseGraphicsResources(window); }

private:
  CellPass Pass;
};
}

#endif
