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

#include "Buffers/BufferTexture.h"
#include "Integral/TransferFunctions.h"

#include <string>
#include <vector>

namespace relevo
{
class FunctionBuffers
{
public:
  /**
   * Upload the functions. Scalars are low + size * the mesh's scalars, and lengths are radius * the
   * mesh's, so gradients are size / radius * the mesh's. Return false if they do not fit into the
   * buffer textures of this OpenGL.
   */
  bool Upload(vtkOpenGLRenderWindow* window, const TransferFunctions& functions, const Scalars& low,
    const Scalars& size, double radius);

  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Pieces.Deactivate(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Pieces.ReleaseGraphicsResources(window);
  }
  vtkTypeInt64 GetMemorySize() const { return this->Pieces.GetMemorySize(); }

private:
  void AddPieces(const TransferFunctions::Curve& curve, bool hasOpacity, double low, double size);
  void AddTable(const TransferFunctions::Curve& curve, double low, double size, double steepness);
  void AddGradientOpacity(const LinearPieces& pieces, double steepness);

  BufferTexture Pieces;
  std::vector<float> Texels; // of the pieces, before the upload
  // The ranges of pieces: the first piece, and the number of pieces minus one.
  struct Ranges
  {
    std::vector<int> First;
    std::vector<int> Sizes;
    void Set(vtkShaderProgram* program, const std::string& name) const;
  };
  Ranges Curves;
  Ranges Gradients;
  std::vector<float> Rows; // of 2D functions, 3 floats each
  std::vector<float> UnitDistances;
  // The range of scalars that are colours.
  float ColorLow[MaximumComponents] = {};
  float ColorSize[MaximumComponents] = {};
};
}

#endif
