// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SolidNoise
 * @brief   noise that fills space, for surfaces without a parametrization
 *
 * Private to the module's own sources.
 */
#ifndef SolidNoise_h
#define SolidNoise_h

#include "RelevoFiltersFlowModule.h" // for export macro

namespace relevo
{
/// The same at a place in space whatever the surface, the machine and its threads.
class RELEVOFILTERSFLOW_EXPORT SolidNoise
{
public:
  /// A grain, the distance of independent values, in the units of positions.
  SolidNoise(double grainSize, int seed)
    : GrainSize(grainSize)
    , Seed(seed)
  {
  }

  static constexpr float Mean = 0.5f;

  /// In [0, 1), at a finite position.
  float GetValue(const double x[3]) const;

private:
  double GrainSize;
  int Seed;
};
}

#endif
