// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpSource
 * @brief   immutable input of the warps of a relief
 *
 * Private to the module.
 */
#ifndef WarpSource_h
#define WarpSource_h

#include "Data/Relief.h"
#include "Data/ReliefSides.h"

#include <string>
#include <vector>

namespace relevo
{
class WarpSource
{
public:
  /// Copies the image, so that it may change while it is warped. Returns an error, or "".
  std::string Read(vtkImageData* image, double maximumStretch);

  const Relief& GetRelief() const { return this->TheRelief; }
  int GetWidth() const { return this->TheRelief.GetWidth(); }
  int GetHeight() const { return this->TheRelief.GetHeight(); }

  /// Returns the heights of a row; NaN without surface.
  const double* GetHeights(int row) const { return this->Heights.data() + this->GetIndex(0, row); }
  /// Returns the ReliefSide bits of a row.
  const unsigned char* GetSides(int row) const
  {
    return this->Sides.data() + this->GetIndex(0, row);
  }
  size_t GetIndex(int column, int row) const
  {
    return static_cast<size_t>(row) * this->GetWidth() + column;
  }

  /// Whether a height is nearer to the viewer than another.
  bool IsNearer(double height, double other) const
  {
    return this->TheRelief.IsPerspective() ? height > other : height < other;
  }

  /// Whether a point in a row, at or right of a column, is surrounded by surface.
  bool IsInside(int column, int row, bool isAtColumn) const;

  /// Returns the row up to which the given fraction of the work is done.
  int FindRow(double share) const;

private:
  bool HasQuad(int column, int row) const
  {
    return column >= 0 && row >= 0 && (this->Sides[this->GetIndex(column, row)] & Quad);
  }

  Relief TheRelief;
  std::vector<double> Heights;
  std::vector<unsigned char> Sides;
  std::vector<double> Work; // prefix sums of the work per row
};
}

#endif
