// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpSource
 * @brief   what warps of a relief read: prepared once, unchanged ever after
 *
 * Private to the module's own sources.
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
  /// What is wrong with the image, or "". Its values are copied: it may change while they are
  /// warped.
  std::string Read(vtkImageData* image, double maximumStretch);

  const Relief& GetRelief() const { return this->TheRelief; }
  int GetWidth() const { return this->TheRelief.GetWidth(); }
  int GetHeight() const { return this->TheRelief.GetHeight(); }

  /// Of a row's texels; NaN for none.
  const double* GetHeights(int row) const { return this->Heights.data() + this->GetIndex(0, row); }
  /// ReliefSide bits of a row's texels.
  const unsigned char* GetSides(int row) const
  {
    return this->Sides.data() + this->GetIndex(0, row);
  }
  size_t GetIndex(int column, int row) const
  {
    return static_cast<size_t>(row) * this->GetWidth() + column;
  }

  /// Whether one height is nearer to the viewer than another.
  bool IsNearer(double height, double other) const
  {
    return this->TheRelief.IsPerspective() ? height > other : height < other;
  }

  /// Whether the surface goes on to all sides of a place in a row, at or right of a column.
  bool IsInside(int column, int row, bool isAtColumn) const;

  /// Rows before this one take this share of the work of warping all.
  int FindRow(double share) const;

private:
  bool HasQuad(int column, int row) const
  {
    return column >= 0 && row >= 0 && (this->Sides[this->GetIndex(column, row)] & Quad);
  }

  Relief TheRelief;
  std::vector<double> Heights;
  std::vector<unsigned char> Sides;
  std::vector<double> Work; // of all rows up to one
};
}

#endif
