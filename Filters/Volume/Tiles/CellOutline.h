// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellOutline
 * @brief   the convex hull of a cell on the screen, and the pixels of each row inside of it
 *
 * Positions are in pixels; the centre of the first pixel is at 0.
 *
 * Private to the module.
 */
#ifndef CellOutline_h
#define CellOutline_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
class CellOutline
{
public:
  /// Removes all points.
  void Clear();
  void Add(const dvec2& point);

  /// Computes the hull of the points, widened by a margin. Call this before GetSpan().
  void Close(double margin);

  //@{
  /// The box of the points, widened by the margin.
  dvec2 GetLow() const { return this->Low - this->Margin; }
  dvec2 GetHigh() const { return this->High + this->Margin; }
  //@}

  /// Finds the first and the last position of a row inside of the hull. Returns false for none.
  bool GetSpan(double row, double& first, double& last) const;

private:
  struct Edge
  {
    dvec2 Low;
    dvec2 High;   // y is not less than that of Low
    double Slope; // x per y
  };
  std::vector<dvec2> Points;
  std::vector<dvec2> Hull;
  std::vector<Edge> Edges;
  dvec2 Low;
  dvec2 High;
  double Margin = 0.0;
};
}

#endif
