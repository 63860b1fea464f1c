// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   takes numbers per point from an array that the user names
 *
 * Private to the module's own sources.
 */
#ifndef PointArray_h
#define PointArray_h

#include <string> // for names and errors

class vtkPolyData;

namespace relevo
{
/**
 * Fill `components` floats for each point, `stride` floats apart. False, with an error to show the
 * user, when the mesh has no such point array, or it has another number of components, too few
 * tuples or a number that is not finite.
 */
bool TakePointArray(vtkPolyData* mesh, const std::string& name, int components, float* values,
  int stride, std::string& error);
}

#endif
