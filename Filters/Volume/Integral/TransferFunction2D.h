// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TransferFunction2D
 * @brief   colour and opacity as an image over scalar and gradient magnitude
 *
 * Columns are scalars and rows are gradient magnitudes, according to origin and spacing of the
 * image. Values are interpolated bilinearly and clamped outside.
 *
 * Private to the module.
 */
#ifndef TransferFunction2D_h
#define TransferFunction2D_h

#include "Integral/LinearSegment.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <string>
#include <vector>

class vtkImageData;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT TransferFunction2D
{
public:
  /**
   * Reads an image of 4 components: red, green, blue and opacity. Returns false with an `error`, as
   * a continuation of "a 2D transfer function ", if the image is invalid.
   */
  bool Read(vtkImageData* image, std::string& error);

  bool IsEmpty() const { return this->Columns.empty(); }

  /// The scalars of columns and the gradient magnitudes of rows, in ascending order.
  const std::vector<double>& GetColumns() const { return this->Columns; }
  const std::vector<double>& GetRows() const { return this->Rows; }

  /// Returns straight colour and opacity.
  dvec4 Evaluate(double scalar, double steepness) const;

private:
  std::vector<double> Columns;
  std::vector<double> Rows;
  std::vector<dvec4> Texels; // in rows
};
}

#endif
