// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the field data that tell where on the earth a mesh lies
 *
 * Private to the module.
 */
#ifndef LocationArrays_h
#define LocationArrays_h

#include <string>

class vtkDataObject;

namespace relevo
{
/// Adds the arrays "Origin", the coordinates of the origin in the coordinate system, and
/// "CoordinateSystem", its definition.
void AddLocationArrays(
  const double origin[3], const std::string& coordinateSystem, vtkDataObject* output);
}

#endif
