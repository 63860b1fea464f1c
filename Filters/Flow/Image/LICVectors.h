// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICVectors
 * @brief   the vectors of a flat image in samples, and their mask
 *
 * Private to the module.
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
   * Reads a point array with 2 components, along the axes of the plane, or 3, in physical
   * coordinates. Vectors are missing if a component is not finite or at least noDataMagnitude in
   * absolute value, or the point is blanked. Missing vectors are masked, and so are vectors whose
   * projection is not longer than the threshold, in units of the array. Returns false with an
   * `error` if spacing or directions of the image are invalid.
   */
  bool Read(vtkImageData* image, vtkDataArray* array, const LICPlane& plane, double noDataMagnitude,
    double threshold, std::string& error);

  /**
   * Returns the vectors in samples, divided by the longest length, and zero where missing. One more
   * column and row on each side repeat the border.
   */
  const std::vector<vec2>& GetPadded() const { return this->Padded; }

  /**
   * Returns 0 or 1 for each sample.
   */
  const std::vector<unsigned char>& GetMask() const { return this->Mask; }

  /**
   * Returns the length of the longest vector in samples, or 0.
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
