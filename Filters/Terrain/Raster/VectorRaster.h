// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VectorRaster
 * @brief   vectors over the unit square, sampled from an image
 *
 * Private to the module.
 */
#ifndef VectorRaster_h
#define VectorRaster_h

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace relevo
{
/**
 * Texels have the positions of vtkHeightField: row 0 at v = 0, centres at (i + 0.5) / n. Samples
 * are interpolated bilinearly and clamped to the border.
 */
class VectorRaster
{
public:
  /**
   * Components with at least the magnitude `noDataMagnitude`, NaN and blanked points are missing
   * data. Returns false with an `error` if the image is not flat or the array, of 2 or 3
   * components, has a wrong length.
   */
  bool SetImage(
    vtkImageData* image, vtkDataArray* array, double noDataMagnitude, std::string& error);

  /**
   * Interpolates three components. The third is 0 if the array has two. Returns false if a sample
   * with a weight at (u, v) is missing.
   */
  bool Sample(double u, double v, double vector[3]) const;

private:
  int Size[2] = { 0, 0 };
  int NumberOfComponents = 0;
  std::vector<float> Samples; // 0 where data is missing
  std::vector<unsigned char> Validity;
};
}

#endif
