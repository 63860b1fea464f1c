// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TranslucentLayers
 * @brief   a render pass that reads back the translucent fragments of all pixels
 *
 * It peels one layer after the other from the front (C. Everitt, "Interactive Order-Independent
 * Transparency", NVIDIA 2001), and supports all props that VTK's depth peeling supports.
 *
 * Private to the module.
 */
#ifndef TranslucentLayers_h
#define TranslucentLayers_h

#include "Targets/RenderTarget.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkTranslucentPass;

namespace relevo
{
class RaySegments;

class TranslucentLayers : public vtkOpenGLRenderPass
{
public:
  static TranslucentLayers* New();
  vtkTypeMacro(TranslucentLayers, vtkOpenGLRenderPass);

  /**
   * Find the fragments of the props of a render state that are not behind the window depths of the
   * opaque scene. They become segments without length, with a window depth, a premultiplied colour
   * and an opacity. Of each pixel, the `most` nearest are kept. The size is that of `fragments`.
   * Return false if textures cannot be allocated.
   */
  bool Read(const vtkRenderState* state, const std::vector<float>& opaqueDepths, int most,
    RaySegments& fragments);

  void Render(const vtkRenderState* state) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  TranslucentLayers();
  ~TranslucentLayers() override;

private:
  TranslucentLayers(const TranslucentLayers&) = delete;
  void operator=(const TranslucentLayers&) = delete;

  using Words = std::vector<std::uint32_t>;
  bool Peel(const vtkRenderState* state, int most, RaySegments& fragments);
  void DrawLayer(const vtkRenderState* state);
  void ReadLayer(Words& records);
  // Return the target of the current layer, or of the one before.
  RenderTarget& GetTarget(size_t before) { return this->Targets[(this->Layer + before) % 2]; }

  vtkNew<vtkTranslucentPass> Translucent;
  vtkSmartPointer<vtkTextureObject> OpaqueDepths;
  std::array<RenderTarget, 2> Targets; // of the layers in turn
  size_t Layer = 0;
};
}

#endif
