// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection/PatternDeviation.h"

#include "Evaluation/HoleFinder.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Patterns/FacePattern.h"
#include "Patterns/RefinementPattern.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
PatternDeviation::PatternDeviation(const RefinementEvaluator& evaluator, const HoleFinder* holes)
  : Evaluator(evaluator)
  , Holes(holes)
{
}

void PatternDeviation::Refine(int face, const FacePattern& pattern)
{
  const int number = pattern.Pattern->GetNumberOfVertices();
  this->Weights.resize(3 * static_cast<std::size_t>(number));
  this->Points.resize(this->Weights.size());
  for (int i = 0; i < number; ++i)
  {
    const std::size_t at = 3 * static_cast<std::size_t>(i);
    float normal[3];
    pattern.GetWeights(i, &this->Weights[at]);
    this->Evaluator.Evaluate(face, &this->Weights[at], &this->Points[at], normal);
  }
  this->Out.assign(static_cast<std::size_t>(pattern.Pattern->GetNumberOfTriangles()), 0);
  if (this->Holes)
  {
    this->Holes->Find(face, pattern, this->Out.data());
  }
}

double PatternDeviation::Measure(int face, const FacePattern& pattern, int parts)
{
  this->Refine(face, pattern);
  const int* segments = pattern.Pattern->Segments;
  const int least = std::min({ segments[0], segments[1], segments[2] });
  const int partsOfSide = std::max(2, (parts + least - 1) / least);
  double largest = 0.0;
  for (std::size_t t = 0; t < this->Out.size(); ++t)
  {
    if (!this->Out[t])
    {
      largest = std::max(
        largest, this->MeasureTriangle(face, &pattern.Pattern->Triangles[3 * t], partsOfSide));
    }
  }
  return largest;
}

double PatternDeviation::MeasureTriangle(int face, const unsigned int* vertices, int parts) const
{
  const double third = 1.0 / 3.0;
  const double middle[3] = { third, third, third };
  double largest = this->MeasurePoint(face, vertices, middle);
  for (int i = 0; i <= parts; ++i)
  {
    for (int j = 0; i + j <= parts; ++j)
    {
      const int k = parts - i - j;
      if (std::max({ i, j, k }) < parts) // not a corner
      {
        const double whole = parts;
        const double shares[3] = { i / whole, j / whole, k / whole };
        largest = std::max(largest, this->MeasurePoint(face, vertices, shares));
      }
    }
  }
  return largest;
}

double PatternDeviation::MeasurePoint(
  int face, const unsigned int* vertices, const double shares[3]) const
{
  double flat[3] = { 0.0, 0.0, 0.0 };
  double mixed[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t at = 3 * static_cast<std::size_t>(vertices[i]);
    for (int c = 0; c < 3; ++c)
    {
      flat[c] += shares[i] * this->Points[at + c];
      mixed[c] += shares[i] * this->Weights[at + c];
    }
  }
  const float weights[3] = { static_cast<float>(mixed[0]), static_cast<float>(mixed[1]),
    static_cast<float>(mixed[2]) };
  float point[3];
  float normal[3];
  this->Evaluator.Evaluate(face, weights, point, normal);
  const double distance = std::hypot(point[0] - flat[0], point[1] - flat[1], point[2] - flat[2]);
  return std::isfinite(distance) ? distance : 0.0;
}
}
