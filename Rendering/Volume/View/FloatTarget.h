// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FloatTarget
 * @brief   textures of floats that triangles are blended into
 *
 * Private to the module.
 */
#ifndef FloatTarget_h
#define FloatTarget_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class FloatTarget
{
public:
  FloatTarget();
  ~FloatTarget();

  /// What is drawn is added to what is there, or covers it by its alpha, or is taken where its
  /// depth is at least as high, or as low, and where nothing is, which the value None stands for.
  enum class Mixing
  {
    Add,
    Cover,
    Highest,
    Lowest
  };
  static constexpr float None = -1.0f;

  /// Make it ready and current, of so many pixels and textures; Draw() ends that. Extremes need
  /// depths. false if there is none to be had.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height, int components,
    int numberOfTextures = 1, bool hasDepth = false);
  /// Over zeros, or None, with the program that is in use, vertices without attributes.
  void Draw(int numberOfVertices, Mixing mixing);
  /// Likewise, of four vertices each; into one channel, or all.
  void DrawQuads(int numberOfQuads, Mixing mixing, int channel = -1);

  void Activate(vtkShaderProgram* program, const std::string& sampler, size_t texture = 0);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  /// The first; null if there is none.
  vtkTextureObject* GetTexture() const;

private:
  bool Has(int width, int height, int numberOfTextures, bool hasDepth) const;
  bool Create(vtkOpenGLRenderWindow* window, int width, int height, int components,
    int numberOfTextures, bool hasDepth);
  void Clear(Mixing mixing);
  void DrawBlended(Mixing mixing, int channel, const std::function<void()>& draw);
  bool BindQuads();

  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
  vtkSmartPointer<vtkOpenGLBufferObject> Quads; // of one call
};
}

#endif
