// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FunctionBuffers
 * @brief   transfer functions on the GPU: the pieces of relevoVolumeFunctions.glsl
 *
 * Private to the module.
 */
#ifndef FunctionBuffers_h
#define FunctionBuffers_h

#include "Buffers/RefinementBuffer.h"
#include "Integral/TransferFunctions.h"

#include <vector>

namespace relevo
{
class FunctionBuffers
{
public:
  /// For scalars that are low + size * what the mesh has.
  bool Upload(vtkOpenGLRenderWindow* window, const TransferFunctions& functions, const Scalars& low,
    const Scalars& size);

  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Pieces.Deactivate(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Pieces.ReleaseGraphicsResources(window);
  }
  vtkTypeInt64 GetMemorySize() const { return this->Pieces.GetMemorySize(); }

private:
  RefinementBuffer Pieces;
  std::vector<int> First; // of each curve's pieces
  std::vector<int> Sizes; // their number less one
  // Of scalars that are colours.
  float ColorLow[MostComponents] = {};
  float ColorSize[MostComponents] = {};
};
}

#endif
