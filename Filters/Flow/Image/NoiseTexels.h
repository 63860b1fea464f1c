// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   NoiseTexels
 * @brief   an image of noise as line integral convolution takes it
 *
 * Private to the modules' own sources.
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
  std::vector<float> Values; // in [0, 1], of one sample after the other

  /**
   * Takes the first component of a flat image's scalars: in [0, 1], or as shares of the largest
   * unsigned char or unsigned short. False, and why as what follows "the noise", if it cannot.
   */
  bool Read(vtkImageData* image, std::string& error);

  /// Of all values; 0 for none.
  float GetMean() const;
};
}

#endif
