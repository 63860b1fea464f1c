// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   QuadBatches
 * @brief   draws quads of four vertices whose only attribute is their index
 *
 * Private to the module.
 */
#ifndef QuadBatches_h
#define QuadBatches_h

#include "vtkSmartPointer.h"

class vtkOpenGLBufferObject;

namespace relevo
{
class QuadBatches
{
public:
  QuadBatches();
  ~QuadBatches();

  /// Draw with the current program and vertex array object.
  void Draw(int numberOfQuads);
  void ReleaseGraphicsResources();

private:
  bool Bind();

  vtkSmartPointer<vtkOpenGLBufferObject> Corners; // corners of one batch
};
}

#endif
