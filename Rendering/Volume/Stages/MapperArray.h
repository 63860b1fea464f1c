// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  MapperArray
 * @brief   the settings of vtkAbstractMapper that choose an array
 *
 * Private to the module.
 */
#ifndef MapperArray_h
#define MapperArray_h

#include "Cells/MeshScalars.h"

#include <string>

namespace relevo
{
struct MapperArray
{
  int ScalarMode;
  int ArrayAccessMode;
  int ArrayId;
  std::string ArrayName; // may be empty
};

/// Return the request for an array, with its name if it is chosen by name. `takesAll`: all of its
/// components are drawn.
ArrayRequest MakeArrayRequest(const MapperArray& array, bool takesAll);
}

#endif
