// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICPasses
 * @brief   the passes that compute a LIC image: convolve, sharpen, convolve again, smooth, stretch
 *
 * Private to the module.
 */
#ifndef LICPasses_h
#define LICPasses_h

#include "Image/LICPassSettings.h"
#include "Image/LICPlane.h"
#include "Image/LICVectors.h"

#include <functional>
#include <vector>

namespace relevo
{
class LICPasses
{
public:
  /**
   * Receives the progress from 0 to 1. Returns false to stop.
   */
  using Watch = std::function<bool(double share)>;

  LICPasses(const LICPlane& plane, const LICVectors& vectors, const LICPassSettings& settings);

  /**
   * Replaces the noise in `image` by its LIC, except where it is masked. Returns false if the watch
   * stopped it; the image is invalid then.
   */
  bool Run(std::vector<float>& image, const Watch& watch);

private:
  bool Convolve(std::vector<float>& image, const LICKernel& kernel);
  bool Sharpen(std::vector<float>& image);
  bool Smooth(std::vector<float>& image, ivec2 direction);
  bool Stretch(std::vector<float>& image, vec2 factors);
  template <typename Function>
  bool ReplaceUnmasked(std::vector<float>& image, double cost, Function&& f);

  const LICPlane& Plane;
  const LICVectors& Vectors;
  const LICPassSettings& Settings;
  Watch ProgressWatch;
  double Done = 0.0;  // steps of convolution per sample
  double Total = 1.0; // total of Done
};
}

#endif
