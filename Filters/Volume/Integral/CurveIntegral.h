// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveIntegral
 * @brief   integrates the functions of a single component along a ray
 *
 * Results are those of TransferFunctions. Each segment begins its search for a linear piece of the
 * functions at the piece of the previous segment.
 *
 * Private to the module.
 */
#ifndef CurveIntegral_h
#define CurveIntegral_h

#include "Integral/TransferFunctions.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>
#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CurveIntegral
{
public:
  /// For functions that depend on one scalar; see TransferFunctions::DependOnOneScalar().
  explicit CurveIntegral(const TransferFunctions& functions);

  int GetComponent() const { return this->Component; }

  /// The change of colour or opacity per scalar, where it is the largest; jumps are ignored.
  double GetLargestSlope() const { return this->LargestSlope; }

  /// The colours along a ray so far.
  struct State
  {
    dvec4 Seen = dvec4(0.0);
    size_t Piece = 0;
  };
  /// Composites a segment with linear scalars behind the state's colour.
  void Composite(double front, double back, double length, State& state) const;
  /// Adds colour times extinction, and extinction, without absorption.
  void Add(double front, double back, double length, State& state) const;

private:
  struct Piece
  {
    double Begin; // the first piece begins and the last ends at infinity
    double End;
    double InverseWidth; // 0 if the function is constant
    dvec4 First;
    dvec4 Change;
  };
  dvec4 Evaluate(const Piece& piece, double scalar) const;
  template <typename Function>
  void Cut(double front, double back, double length, size_t& piece, const Function& add) const;

  int Component;
  double LargestSlope = 0.0;
  std::vector<Piece> Pieces;
};
}

#endif
