// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICScreenDrawer
 * @brief   draws the vectors of a screen and their LIC
 *
 * Methods restore OpenGL's state and the current framebuffer. Private to the module's own sources.
 */
#ifndef LICScreenDrawer_h
#define LICScreenDrawer_h

#include "Passes/LICImage.h"
#include "Passes/LICNoise.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkType.h"

#include <functional>
#include <string>

class vtkActor;
class vtkLICSettings;
class vtkRenderer;
class vtkWindow;

namespace relevo
{
class Dependencies;
struct LICScreen;

class LICScreenDrawer
{
public:
  /// The settings, and the length of the longest vector, negative for none.
  struct Parameters
  {
    vtkLICSettings* Settings;
    double Longest;

    bool StretchesColors() const;
    LICColoring GetColoring() const;
  };

  /// Update the noise of the settings. Return the error as a sentence, or ""; the methods below do
  /// the same.
  std::string CheckSettings(vtkLICSettings* settings);
  /// Add the dependencies of the convolution, without those of combining it with colours.
  void AddTo(Dependencies& dependencies, const Parameters& parameters) const;
  /// Return the number of pixels that the image needs around the visible region.
  int FindReach(const Parameters& parameters) const;

  /// Allocate textures of the size of the current viewport.
  std::string Allocate(vtkRenderer* ren, LICScreen& screen, bool withColors);

  /**
   * Draw the surface's vectors. draw() draws them without the actor's render passes.
   * finish(framebuffer) is called when the screen's textures contain them.
   */
  std::string DrawVectors(vtkRenderer* ren, vtkActor* act, LICScreen& screen,
    const std::function<void()>& draw,
    const std::function<void(vtkOpenGLFramebufferObject*)>& finish);

  /// Compute the LIC of the vectors if `convolve` is true, and the range of colours to stretch.
  std::string DrawImage(vtkRenderer* ren, LICScreen& screen, const Parameters& parameters,
    bool convolve, const LICImage::RangeMerger& merge);
  /// Return how often DrawImage() calls `merge`.
  int CountRanges(const Parameters& parameters, bool convolve) const;
  vtkIdType GetNumberOfConvolutions() const { return this->NumberOfConvolutions; }

  vtkTypeInt64 GetMemorySize() const
  {
    return this->Image.GetMemorySize() + this->Noise.GetMemorySize();
  }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  LICPassSettings GetPassSettings(const Parameters& parameters) const;

  LICNoise Noise;
  LICImage Image;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkIdType NumberOfConvolutions = 0;
};
}

#endif
