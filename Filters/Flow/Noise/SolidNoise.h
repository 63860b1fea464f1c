// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SolidNoise
 * @brief   three-dimensional noise, for surfaces without texture coordinates
 *
 * Private to the module.
 */
#ifndef SolidNoise_h
#define SolidNoise_h

#include "RelevoFiltersFlowModule.h" // for export macro

namespace relevo
{
/// The value at a position does not depend on the surface, the machine or the number of threads.
class RELEVOFILTERSFLOW_EXPORT SolidNoise
{
public:
  /// `grainSize` is the distance of independent values, in units of positions.
  SolidNoise(double grainSize, int seed)
    : GrainSize(grainSize)
    , Seed(seed)
  {
  }

  static constexpr float Mean = 0.5f;

  /// Returns a value in [0, 1) at a finite position.
  float GetValue(const double x[3]) const;

private:
  double GrainSize;
  int Seed;
};
}

#endif
