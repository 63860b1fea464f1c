// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DepthTags
 * @brief   depth-tags that the user brings, checked
 */
#ifndef DepthTags_h
#define DepthTags_h

#include "vtkType.h" // for vtkIdType

#include <string> // for errors

class vtkDataArray;

namespace relevo
{
/**
 * Copy an array of depth-tags into `tags`, which has room for one per point. Returns false and sets
 * `error` when it has not exactly one component and one tuple per point, or holds a NaN. Values
 * are limited only so far that the mean of any two is finite.
 */
bool TakeDepthTags(vtkDataArray* array, vtkIdType numberOfPoints, float* tags, std::string& error);
}

#endif
