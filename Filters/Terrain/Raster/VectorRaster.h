// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VectorRaster
 * @brief   vectors over the unit square, from an image
 *
 * Private to the module's own sources.
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
 * Texels as those of vtkHeightField: row 0 at v = 0, centres at (i + 0.5) / n, bilinear between
 * them, clamped outside.
 */
class VectorRaster
{
public:
  /**
   * A magnitude that no component may reach is no data, as are NaN and blanked points. False, and
   * why in `error`, when the image is not flat or the array, of 2 or 3 components, does not fit.
   */
  bool SetImage(
    vtkImageData* image, vtkDataArray* array, double noDataMagnitude, std::string& error);

  /**
   * Three components, the third 0 where the array has two. False where a sample that has a weight
   * at (u, v) has no data.
   */
  bool Sample(double u, double v, double vector[3]) const;

private:
  int Size[2] = { 0, 0 };
  int NumberOfComponents = 0;
  std::vector<float> Samples; // 0 where there is no data
  std::vector<unsigned char> Validity;
};
}

#endif
