// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ScalarChoice
 * @brief   conversion of array tuples to scalars
 *
 * Private to the modules.
 */
#ifndef ScalarChoice_h
#define ScalarChoice_h

#include "Integral/TransferFunctions.h" // for scalars
#include "RelevoFiltersVolumeModule.h"  // for export macro

#include <vector>

class vtkDataArray;
class vtkVolumeProperty;

namespace relevo
{
class ScalarTable;

struct ScalarChoice
{
  enum
  {
    All = -2,   // all components, at most 4
    Length = -1 // of several components; a single one is taken as it is
  };
  int Component = All;
  double Scale = 1.0;

  bool operator==(const ScalarChoice& other) const
  {
    return this->Component == other.Component && this->Scale == other.Scale;
  }
};

/// Returns the choice for VectorMode and VectorComponent of a mapper and the colour functions.
RELEVOFILTERSVOLUME_EXPORT ScalarChoice ChooseScalars(
  vtkVolumeProperty* property, int vectorMode, int vectorComponent);

/// Converts the tuples of an array and appends the scalars. Fill values become NaN; returns their
/// magnitudes, see FindFillValues().
RELEVOFILTERSVOLUME_EXPORT std::vector<double> AddScalars(
  vtkDataArray* array, const ScalarChoice& choice, ScalarTable& all);
}

#endif
