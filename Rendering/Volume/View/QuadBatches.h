// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   QuadBatches
 * @brief   draws quads of four vertices each that have no attributes but their number
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

  /// By the program that is in use, with a vertex array object bound.
  void Draw(int numberOfQuads);
  void ReleaseGraphicsResources();

private:
  bool Bind();

  vtkSmartPointer<vtkOpenGLBufferObject> Corners; // of one batch
};
}

#endif
