// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   takes numbers per point from an array that the user names
 *
 * Private to the modules' own sources.
 */
#ifndef PointArray_h
#define PointArray_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string> // for names and errors

class vtkDataArray;
class vtkDataSet;

namespace relevo
{
/**
 * The point array of a name. nullptr, with an error to show the user, when the data set has none,
 * or it has another number of components, too few tuples or a number that is not a finite float.
 */
RELEVOFILTERSCORE_EXPORT vtkDataArray* FindPointArray(
  vtkDataSet* data, const std::string& name, int components, std::string& error);

/**
 * Fill `components` floats for each point, `stride` floats apart. False, with an error, as above.
 */
RELEVOFILTERSCORE_EXPORT bool TakePointArray(vtkDataSet* data, const std::string& name,
  int components, float* values, int stride, std::string& error);
}

#endif
