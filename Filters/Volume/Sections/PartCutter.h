// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PartCutter
 * @brief   cuts the parts of a curved cell, along their own shape
 *
 * A part is divided like an octree, where the surface can be, into pieces whose edges are crossed.
 *
 * Private to the module.
 */
#ifndef PartCutter_h
#define PartCutter_h

#include "Bezier/BezierHexahedron.h"
#include "Sections/CellSection.h"

#include <array>
#include <functional>
#include <map>
#include <unordered_map>

class vtkImplicitFunction;

namespace relevo
{
class PartCutter
{
public:
  /// Computes the weights of the cell's nodes at parameters of the part.
  using Weigher = std::function<void(const dvec3& parameters, double* weights)>;

  /// The tolerance is the largest distance of the pieces from the part, a length.
  PartCutter(vtkImplicitFunction* function, double tolerance);

  /// Set the smallest number of intervals along the directions of the following parts.
  void SetMinimumIntervals(int number) { this->MinimumIntervals = number; }

  /// Adds the section of a part. Outer faces, in the order of GetFace(), are on faces of the cell.
  void Cut(const BezierHexahedron& part, const std::array<bool, 6>& isOuter, const Weigher& weigh,
    CellSection& section);

private:
  int CountIntervals(double deviation) const;
  double GetValue(const dvec3& parameters) const;
  double GetSampleValue(int sample);
  void Descend(const ivec3& low, int size);
  void CutPiece(const ivec3& low, const std::array<int, 8>& samples);
  int AddCrossing(const std::array<int, 2>& samples);

  dvec3 GetParameters(int sample) const;
  int GetSample(const ivec3& at) const;

  vtkImplicitFunction* Function;
  bool IsLinear; // whether the function is a plane
  double Tolerance;
  int MinimumIntervals = 1;

  // The part that is being cut.
  const BezierHexahedron* Part = nullptr;
  const std::array<bool, 6>* IsOuter = nullptr;
  const Weigher* Weigh = nullptr;
  CellSection* Section = nullptr;
  int Intervals = 1;
  double ValueDeviation = 0.0;                 // of the function, with a single interval
  std::unordered_map<int, double> Values;      // at samples
  std::map<std::array<int, 2>, int> Crossings; // points between samples
};
}

#endif
