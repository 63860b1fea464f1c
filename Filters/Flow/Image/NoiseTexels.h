// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   NoiseTexels
 * @brief   a noise image for line integral convolution
 *
 * Private to the modules.
 */
#ifndef NoiseTexels_h
#define NoiseTexels_h

#include "Image/LICPlane.h"          // for members
#include "RelevoFiltersFlowModule.h" // for export macro

#include <string> // for messages
#include <vector> // for members

class vtkImageData;

namespace relevo
{
class RELEVOFILTERSFLOW_EXPORT NoiseTexels
{
public:
  LICPlane Plane;
  std::vector<float> Values; // one per sample, in [0, 1]

  /**
   * Reads the first component of the scalars of a flat image: in [0, 1], or in the full range of
   * unsigned char or unsigned short. Returns false with an `error`, as a continuation of "the
   * noise".
   */
  bool Read(vtkImageData* image, std::string& error);

  /// Returns the mean of all values, 0 without values.
  float GetMean() const;
};
}

#endif
