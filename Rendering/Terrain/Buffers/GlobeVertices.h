// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeVertices
 * @brief   the positions of the vertices of faces in the geocentric frame, on the GPU
 *
 * They are floats relative to an origin near the eye. Private to the module.
 */
#ifndef GlobeVertices_h
#define GlobeVertices_h

#include "Bisection/GlobeFaces.h"
#include "Buffers/BufferTexture.h"

#include <array>
#include <string> // for errors
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class GlobeVertices
{
public:
  /**
   * Upload the vertices of faces, in the order of TerrainInstances. Positions are those at a height
   * in metres, with this exaggeration. Return an error, or "". Nothing is uploaded that has not
   * changed.
   */
  std::string Upload(vtkOpenGLRenderWindow* window, const std::vector<unsigned int>& order,
    const std::vector<const GlobeFaces::Vertices*>& vertices, const std::array<double, 3>& origin,
    double height, double exaggeration);

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const { return this->Texture.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<float> Floats;
  BufferTexture Texture;
};
}

#endif
