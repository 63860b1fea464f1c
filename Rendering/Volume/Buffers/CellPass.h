// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellPass
 * @brief   a pass that computes values for each cell or face, in a pixel of its own
 *
 * Private to the module.
 */
#ifndef CellPass_h
#define CellPass_h

#include "Targets/RenderTarget.h"

#include "vtkPixelBufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <string>
#include <tuple> // for sizes of arrays
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class CellPass
{
public:
  /// Draw with the current program, and set its uniforms cellsPerRow and numberOfCells. Return
  /// false if there are more than 16.7 million cells, or not enough memory.
  bool Draw(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, size_t numberOfCells,
    const std::vector<RenderTarget::Format>& formats);

  /// Read the texels of a texture, as arrays with its number of components. This call waits for the
  /// GPU.
  template <typename Texel>
  std::vector<Texel> Read(int type, size_t texture = 0) const
  {
    vtkTextureObject* drawn = this->Target.GetTexture(texture);
    unsigned int size[2] = { drawn->GetWidth(), drawn->GetHeight() };
    std::vector<Texel> texels(static_cast<size_t>(size[0]) * size[1]);
    vtkIdType increments[2] = { 0, 0 };
    vtkSmartPointer<vtkPixelBufferObject> pixels;
    pixels.TakeReference(drawn->Download());
    pixels->Download2D(
      type, texels.data(), size, static_cast<int>(std::tuple_size<Texel>::value), increments);
    texels.resize(this->NumberOfCells);
    return texels;
  }

  //@{
  /// Bind a texture to a sampler, and set the uniform cellsPerRow, to read texels in shaders.
  void Activate(vtkShaderProgram* program, const std::string& sampler, size_t texture);
  void Deactivate() { this->Target.Deactivate(); }
  //@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  RenderTarget Target;
  size_t NumberOfCells = 0;
};
}

#endif
