// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the unit of an array's values, where a file gives it
 */
#ifndef ArrayUnit_h
#define ArrayUnit_h

#include <string>

class vtkDataArray;

/// vtkDataArray::UNITS_LABEL() of the array, "" for none.
std::string GetArrayUnit(vtkDataArray* array);

#endif
