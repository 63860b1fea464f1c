// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICImage
 * @brief   makes the LIC of a screen's vectors on the GPU
 *
 * The passes of vtkLineIntegralConvolution, from the same sources. Private to the module's own
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
  /// What makes the range, (least, largest), of this image that of a whole that it is a part of.
  using RangeMerger = std::function<void(float range[2])>;

  LICImage();
  ~LICImage();
  LICImage(const LICImage&) = delete;
  void operator=(const LICImage&) = delete;

  /**
   * Convolve noise along the screen's vectors into its image. `merge`, if it is there, is called
   * CountRanges() times. False, with GetError(), when a program or a texture cannot be had.
   */
  bool Convolve(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
    LICScreen& screen, vtkTextureObject* noise, const LICPassSettings& settings,
    const RangeMerger& merge);
  static int CountRanges(const LICPassSettings& settings);

  /// How far, in pixels, the passes after the first look around a pixel.
  static int FindReach(const LICPassSettings& settings);

  /**
   * The range of the lightness of the screen's colours with its LIC; calls `merge` once. False as
   * above.
   */
  bool FindColorRange(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
    LICScreen& screen, const LICColoring& coloring, const RangeMerger& merge);

  //@{
  /// As sentences: what failed, and that a texture did.
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
  struct Work; // one call's

  bool ApplyConvolution(
    Work& work, const LICKernel& kernel, float noiseMean, vtkTextureObject* noise, bool isTiled);
  bool ApplyFilter(
    Work& work, Filter filter, ivec2 direction = ivec2(1, 0), vec2 factors = vec2(0.0f));
  vtkSmartPointer<vtkTextureObject> FindRange(
    Work& work, LICPass& first, const LICColoring* coloring);

  std::unique_ptr<LICPass> ConvolvePass;
  std::unique_ptr<LICPass> FilterPasses[NumberOfFilters];
  std::unique_ptr<LICPass> RangePass;      // of an image
  std::unique_ptr<LICPass> ColorRangePass; // of colours with an image
  std::unique_ptr<LICPass> ReducePass;     // of ranges
  vtkSmartPointer<vtkTextureObject> Spare;
  const char* Error = "";
};
}

#endif
