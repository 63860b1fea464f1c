// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads numbers per point from an array that the user names
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
 * Find the point array of a name. Returns nullptr and an error for the user if there is none, or if
 * it has the wrong number of components, too few tuples or a number that is not a finite float.
 */
RELEVOFILTERSCORE_EXPORT vtkDataArray* FindPointArray(
  vtkDataSet* data, const std::string& name, int components, std::string& error);

/**
 * Copy `components` floats for each point, `stride` floats apart. Returns false and an error as
 * above.
 */
RELEVOFILTERSCORE_EXPORT bool TakePointArray(vtkDataSet* data, const std::string& name,
  int components, float* values, int stride, std::string& error);
}

#endif
