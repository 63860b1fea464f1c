// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICImage
 * @brief   computes the LIC of a screen's vectors on the GPU
 *
 * The passes and their sources are those of vtkLineIntegralConvolution. Private to the module's own
 * sources.
 */
#ifndef LICImage_h
#define LICImage_h

#include "Image/LICPassSettings.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional> // for ranges
#include <memory>     // for passes

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class LICPass;
struct LICScreen;

/// How the LIC and the colours of the surface are combined.
struct LICColoring
{
  int Mode = 0;
  double Intensity = 0.8;
  double Bias = 0.0;

  void SetUniforms(vtkShaderProgram* program) const;
};

class LICImage
{
public:
  /// Extends the range (smallest, largest) of this image to that of the whole image.
  using RangeMerger = std::function<void(float range[2])>;

  LICImage();
  ~LICImage();
  LICImage(const LICImage&) = delete;
  void operator=(const LICImage&) = delete;

  /**
   * Convolve noise along the screen's vectors into its image. `merge`, if set, is called
   * CountRanges() times. Return false and set GetError() if a program or a texture cannot be
   * created.
   */
  bool Convolve(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
    LICScreen& screen, vtkTextureObject* noise, const LICPassSettings& settings,
    const RangeMerger& merge);
  static int CountRanges(const LICPassSettings& settings);

  /// Return the radius, in pixels, that the passes after the first read around a pixel.
  static int FindReach(const LICPassSettings& settings);

  /**
   * Compute the range of the lightness of the screen's colours with its LIC. `merge` is called
   * once. Return false on an error, like Convolve().
   */
  bool FindColorRange(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
    LICScreen& screen, const LICColoring& coloring, const RangeMerger& merge);

  //@{
  /// Return the error as a sentence, and the error of a texture.
  const char* GetError() const { return this->Error; }
  static const char* GetTextureError();
  //@}

  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const;

private:
  enum Filter
  {
    HIGH_PASS,
    SMOOTH,
    CONTRAST,
    NumberOfFilters
  };
  struct Work; // the work of one call

  bool ApplyConvolution(
    Work& work, const LICKernel& kernel, float noiseMean, vtkTextureObject* noise, bool isTiled);
  bool ApplyFilter(
    Work& work, Filter filter, ivec2 direction = ivec2(1, 0), vec2 factors = vec2(0.0f));
  vtkSmartPointer<vtkTextureObject> FindRange(
    Work& work, LICPass& first, const LICColoring* coloring);

  std::unique_ptr<LICPass> ConvolvePass;
  std::unique_ptr<LICPass> FilterPasses[NumberOfFilters];
  std::unique_ptr<LICPass> RangePass;      // range of an image
  std::unique_ptr<LICPass> ColorRangePass; // range of colours with an image
  std::unique_ptr<LICPass> ReducePass;     // reduction of ranges
  vtkSmartPointer<vtkTextureObject> Spare;
  const char* Error = "";
};
}

#endif
