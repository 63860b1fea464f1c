// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the unit of an array's values, if the file contains it
 */
#ifndef ArrayUnit_h
#define ArrayUnit_h

#include <string>

class vtkDataArray;

/// vtkDataArray::UNITS_LABEL() of the array, or an empty string.
std::string GetArrayUnit(vtkDataArray* array);

#endif
