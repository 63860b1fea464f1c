// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternDeviation
 * @brief   how far the triangles of a refined face are from the surface
 *
 * Measured from points of the triangles to those of the surface that have the same weights: the
 * distance to the nearest point is no larger.
 */
#ifndef PatternDeviation_h
#define PatternDeviation_h

#include <vector> // for members

namespace relevo
{
class HoleFinder;
class RefinementEvaluator;
struct FacePattern;

class PatternDeviation
{
public:
  /// `holes` may be nullptr. Both must outlive this.
  PatternDeviation(const RefinementEvaluator& evaluator, const HoleFinder* holes);

  /// The largest distance, measured at the middle of each triangle and at points that cut each of
  /// its sides into two parts or more, and the face's edges into `parts` or more. Points that are
  /// not finite are left out.
  double Measure(int face, const FacePattern& pattern, int parts);

private:
  void Refine(int face, const FacePattern& pattern);
  double MeasureTriangle(int face, const unsigned int* vertices, int parts) const;
  double MeasurePoint(int face, const unsigned int* vertices, const double shares[3]) const;

  const RefinementEvaluator& Evaluator;
  const HoleFinder* Holes;
  std::vector<float> Weights;
  std::vector<float> Points;
  std::vector<unsigned char> Out;
};
}

#endif
