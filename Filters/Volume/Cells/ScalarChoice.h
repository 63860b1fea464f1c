// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ScalarChoice
 * @brief   which scalars become of the tuples of an array
 *
 * Private to the modules' own sources.
 */
#ifndef ScalarChoice_h
#define ScalarChoice_h

#include "RelevoFiltersVolumeModule.h" // for export macro

class vtkVolumeProperty;

namespace relevo
{
struct ScalarChoice
{
  enum
  {
    All = -2, // at most 4 components
    Length = -1
  };
  int Component = All;
  double Scale = 1.0;

  bool operator==(const ScalarChoice& other) const
  {
    return this->Component == other.Component && this->Scale == other.Scale;
  }
};

/// By the VectorMode and VectorComponent of a mapper, and the mode of the property's colours.
RELEVOFILTERSVOLUME_EXPORT ScalarChoice ChooseScalars(
  vtkVolumeProperty* property, int vectorMode, int vectorComponent);
}

#endif
