// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICScreenDrawer
 * @brief   draws the vectors of a screen and their LIC
 *
 * OpenGL's state and the framebuffer in use are what they were when a method returns. Private to
 * the module's own sources.
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

  /// Have the noise of the settings. What is wrong with them, as a sentence; or "". The same below.
  std::string CheckSettings(vtkLICSettings* settings);
  /// Add what is convolved: not how it is combined with colours.
  void AddTo(Dependencies& dependencies, const Parameters& parameters) const;
  /// How far, in pixels, the image looks around what is seen.
  int FindReach(const Parameters& parameters) const;

  /// Have textures of the size of the viewport that is set.
  std::string Allocate(vtkRenderer* ren, LICScreen& screen, bool withColors);

  /**
   * Draw the surface's vectors: draw() draws them, without the actor's render passes.
   * finish(framebuffer) is called when the screen's textures have them.
   */
  std::string DrawVectors(vtkRenderer* ren, vtkActor* act, LICScreen& screen,
    const std::function<void()>& draw,
    const std::function<void(vtkOpenGLFramebufferObject*)>& finish);

  /// Make the LIC of the vectors, if `convolve`, and the range of colours that are stretched.
  std::string DrawImage(vtkRenderer* ren, LICScreen& screen, const Parameters& parameters,
    bool convolve, const LICImage::RangeMerger& merge);
  /// How often `merge` is called then.
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
