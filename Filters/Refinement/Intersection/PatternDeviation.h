// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternDeviation
 * @brief   the distance between the triangles of a refined face and the surface
 *
 * The distance is measured between points of the triangles and points of the surface with the same
 * weights. The distance to the nearest point is not larger.
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
  /// `holes` may be nullptr. Both must outlive this object.
  PatternDeviation(const RefinementEvaluator& evaluator, const HoleFinder* holes);

  /// Return the largest distance. It is measured at the middle of each triangle and at points that
  /// divide each side into at least two parts, and the face's edges into at least `parts`.
  /// Non-finite points are skipped.
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
