// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefGaps
 * @brief   predicts where holes open in a captured relief in another view
 *
 * Neighbouring texels that are not connected move apart in other views, as computed from their
 * projections. So do the borders of the captured region and of the view. Surfaces behind a
 * silhouette against the background cannot be predicted. Private to the module.
 */
#ifndef ReliefGaps_h
#define ReliefGaps_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
class Relief;

/// The number of shown and of open pixels of a view, in cells of CellSize x CellSize pixels.
struct GapMap
{
  static constexpr int CellSize = 8;

  /// The size is in pixels.
  GapMap(int width, int height);

  int Width;
  int Height;
  std::vector<double> Shown;
  std::vector<double> Open;
  /// The median width of the shown texels, in pixels; infinity if there are none.
  double TexelWidth;

  bool Contains(const dvec2& pixel) const;
  /// Add an area at a pixel; areas outside the view are ignored.
  void AddShown(const dvec2& pixel, double area) { this->Add(this->Shown, pixel, area); }
  void AddOpen(const dvec2& pixel, double area) { this->Add(this->Open, pixel, area); }

private:
  void Add(std::vector<double>& areas, const dvec2& pixel, double area) const;
};

class ReliefGaps
{
public:
  /// The sides are those of FindReliefSides().
  ReliefGaps(const Relief& relief, const std::vector<unsigned char>& sides);

  /// Return the map of a view, given by its matrix from world to clip coordinates.
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
    Texel Second; // on the far side of the opening
    bool IsUpwards;
  };
  struct Side // a border texel of the relief beyond which the captured surface continues
  {
    Texel From;
    dvec2 Outwards;
  };

  class View;

  void AddPair(const Relief& relief, int column, int row, bool isUpwards);
  void AddBorder(const Relief& relief, int column, int row, int right, int up);

  dmat4 TexelToWorld;
  std::vector<Texel> Samples; // a subset of the valid texels, SampleStep apart
  std::vector<Pair> Pairs;
  std::vector<Side> Sides;
};

/// Return the fraction of the shown area that is open in all maps of one view.
double FindHoleShare(const std::vector<GapMap>& maps);
}

#endif
