// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICVectors
 * @brief   the vectors of a flat image in units of its samples, and where they are masked
 *
 * Private to the module's own sources.
 */
#ifndef LICVectors_h
#define LICVectors_h

#include "Image/LICPlane.h"
#include "Mathematics/RefinementMathematics.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace relevo
{
class LICVectors
{
public:
  /**
   * Takes the vectors of a point array with 2 components, along the plane's axes, or 3, in the
   * image's physical coordinates. Those with a component that is not finite or at least
   * noDataMagnitude in absolute value, and those at blanked points, are no data. They and those in
   * the plane that are no longer than the threshold, in the array's units, are masked. False, and
   * why, if the image's spacing or directions cannot be.
   */
  bool Read(vtkImageData* image, vtkDataArray* array, const LICPlane& plane, double noDataMagnitude,
    double threshold, std::string& error);

  /**
   * In samples, the longest of length 1; zero where there are no data. One more column and row on
   * each side repeat the border.
   */
  const std::vector<vec2>& GetPadded() const { return this->Padded; }

  /**
   * Of each sample, 0 or 1.
   */
  const std::vector<unsigned char>& GetMask() const { return this->Mask; }

  /**
   * The longest of the vectors, in samples; 0 if there is none.
   */
  double GetLongest() const { return this->Longest; }

private:
  void Pad(const std::vector<dvec2>& vectors, const LICPlane& plane);

  std::vector<vec2> Padded;
  std::vector<unsigned char> Mask;
  double Longest = 0.0;
};
}

#endif
