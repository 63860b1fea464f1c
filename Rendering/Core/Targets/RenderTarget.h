// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderTarget
 * @brief   textures as render targets, with their framebuffer
 *
 * The textures are cached until another size or other formats are needed. Private to the modules.
 */
#ifndef RenderTarget_h
#define RenderTarget_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkNew.h"                    // for members
#include "vtkSmartPointer.h"           // for members
#include "vtkType.h"                   // for VTK_FLOAT

#include <functional> // for drawing
#include <string>     // for names of samplers
#include <vector>     // for members

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
/// How a fragment is combined with the pixel: it is added, it covers the pixel by its premultiplied
/// alpha, or it replaces the pixel if its depth is at least as high, or as low. Nearest is Minimum
/// with transparent empty pixels.
enum class BlendOperation
{
  Add,
  Over,
  Maximum,
  Minimum,
  Nearest
};

/// Return whether the operation finds extremes.
inline bool IsExtremum(BlendOperation operation)
{
  return operation == BlendOperation::Maximum || operation == BlendOperation::Minimum;
}

/// Return whether the operation depends on the depth.
inline bool NeedsDepth(BlendOperation operation)
{
  return IsExtremum(operation) || operation == BlendOperation::Nearest;
}

class RELEVORENDERINGCORE_EXPORT RenderTarget
{
public:
  RenderTarget();
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  void operator=(const RenderTarget&) = delete;

  /// The format of one texture.
  struct Format
  {
    int Components = 4;
    int Type = VTK_FLOAT;
    bool IsSRGB = false; // for bytes
    bool operator==(const Format& other) const
    {
      return this->Components == other.Components && this->Type == other.Type &&
        this->IsSRGB == other.IsSRGB;
    }
  };

  /// The value of empty pixels with BlendOperation Maximum and Minimum.
  static constexpr float Empty = -1.0f;

  //@{
  /**
   * Allocate the textures and bind their framebuffer; End() restores the previous binding. Depths
   * are floats. Return false, without binding, if the textures cannot be allocated.
   */
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height,
    const std::vector<Format>& formats, bool hasDepth = false);
  void End();
  //@}

  /**
   * Clear all textures and call a function that draws vertices without attributes by the current
   * program, between Begin() and End(). The rest of OpenGL's state is restored. With a channel from
   * 0 to 3, only that channel is written.
   */
  void Draw(BlendOperation operation, const std::function<void()>& draw, int channel = -1);

  //@{
  /// Bind a texture to a sampler, if the program has the sampler and the target the texture.
  void Activate(vtkShaderProgram* program, const std::string& sampler, size_t texture = 0);
  void Deactivate();
  //@}

  void ReleaseGraphicsResources(vtkWindow* window);

  //@{
  /// Return the texture, or nullptr if there is none.
  vtkTextureObject* GetTexture(size_t texture = 0) const;
  vtkOpenGLFramebufferObject* GetFramebuffer() const;
  //@}

private:
  bool Has(int width, int height, const std::vector<Format>& formats, bool hasDepth) const;
  bool Create(vtkOpenGLRenderWindow* window, int width, int height,
    const std::vector<Format>& formats, bool hasDepth);
  void Clear(BlendOperation operation);

  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  std::vector<Format> Formats;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
};
}

#endif
