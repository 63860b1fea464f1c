// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TransferFunction2D
 * @brief   colour and opacity of a scalar and the length of its gradient, as an image gives them
 *
 * Columns are scalars, rows lengths of gradients, by the image's origin and spacing; bilinear in
 * between, constant outside.
 *
 * Private to the module's own sources.
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
   * false with words that follow "a 2D transfer function " where the image cannot be used. It has 4
   * components: red, green, blue and opacity.
   */
  bool Read(vtkImageData* image, std::string& error);

  bool IsEmpty() const { return this->Columns.empty(); }

  /// The scalars of columns, in ascending order, and the steepness of rows.
  const std::vector<double>& GetColumns() const { return this->Columns; }
  const std::vector<double>& GetRows() const { return this->Rows; }

  /// Straight colour and opacity.
  dvec4 Evaluate(double scalar, double steepness) const;

private:
  std::vector<double> Columns;
  std::vector<double> Rows;
  std::vector<dvec4> Texels; // row after row
};
}

#endif
