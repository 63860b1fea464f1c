// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefGaps
 * @brief   foresees where a captured relief comes open, seen from elsewhere
 *
 * Neighbouring texels that are not joined move apart in other views, by what their projections say;
 * so do the sides of what was captured and those of the view. Behind a silhouette with nothing
 * beyond it there is nothing to foresee. Private to the module.
 */
#ifndef ReliefGaps_h
#define ReliefGaps_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
class Relief;

/// Of a view in cells of CellSize x CellSize pixels, how many pixels are shown, and how many open.
struct GapMap
{
  static constexpr int CellSize = 8;

  /// Pixels.
  GapMap(int width, int height);

  int Width;
  int Height;
  std::vector<double> Shown;
  std::vector<double> Open;
  /// The median of what is shown, in pixels; infinity if nothing is.
  double TexelWidth;

  bool Contains(const dvec2& pixel) const;
  /// At a pixel; outside of the view nothing counts.
  void AddShown(const dvec2& pixel, double area) { this->Add(this->Shown, pixel, area); }
  void AddOpen(const dvec2& pixel, double area) { this->Add(this->Open, pixel, area); }

private:
  void Add(std::vector<double>& areas, const dvec2& pixel, double area) const;
};

class ReliefGaps
{
public:
  /// The sides are those that FindReliefSides() finds.
  ReliefGaps(const Relief& relief, const std::vector<unsigned char>& sides);

  /// In the view that this matrix is of, from the world to clip coordinates.
  GapMap Find(const dmat4& worldToClip, int width, int height) const;

private:
  struct Texel
  {
    float Column;
    float Row;
    float Height;
  };
  struct Pair
  {
    Texel First;
    Texel Second; // on the other side of the opening
    bool IsUpwards;
  };
  struct Side // of the relief, where what was captured goes on
  {
    Texel From;
    dvec2 Outwards;
  };

  class View;

  void AddPair(const Relief& relief, int column, int row, bool isUpwards);
  void AddBorder(const Relief& relief, int column, int row, int right, int up);

  dmat4 TexelToWorld;
  std::vector<Texel> Samples; // some of the valid texels, SampleStep apart
  std::vector<Pair> Pairs;
  std::vector<Side> Sides;
};

/// The share of what is shown that is open in all of the maps, which are of one view.
double FindHoleShare(const std::vector<GapMap>& maps);
}

#endif
